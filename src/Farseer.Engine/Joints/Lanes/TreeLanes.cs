using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// Trees of rigid joints with their limits, motors and springs, up to four of equal shape side by side for a step. Each lane gives the bits
/// of the passes of <see cref="JointSolver"/>. A tree that is put out of joint from outside, or whose correction goes astray, is given back
/// before that pass and is solved there for the rest of the step.
/// </summary>
internal sealed unsafe class TreeLanes
{
    private const int AllLanes = (1 << DoubleLanes.BundleLanes) - 1;

    private readonly LaneWork _work;
    private readonly Column<LaneNode> _nodes;
    private readonly Column<LaneTrees> _bundles;
    private readonly LaneActiveSet _activeSet;
    private readonly LaneExchange _exchange;

    public TreeLanes(LaneWork work)
    {
        _work = work;
        _nodes = work.Nodes;
        _bundles = work.Bundles;
        Choice = new LaneChoice(work);
        Bodies = new LaneBodies(work);
        SoftRows = new LaneSoftRows(work);
        Contacts = new LaneContacts(work, Bodies);
        _activeSet = new LaneActiveSet(work, SoftRows, Contacts);
        _exchange = new LaneExchange(work, Bodies, SoftRows, _activeSet);
    }

    /// <summary>Which trees go side by side.</summary>
    public LaneChoice Choice { get; }

    /// <summary>The bodies of the trees.</summary>
    public LaneBodies Bodies { get; }

    /// <summary>Motors and springs.</summary>
    public LaneSoftRows SoftRows { get; }

    /// <summary>Trees with contacts.</summary>
    public LaneContacts Contacts { get; }

    /// <summary>The trees that are given back.</summary>
    public TreesAside Aside => _work;

    public bool Any => _work.Count > 0;

    /// <summary>Loads the trees that were taken, at the start of a step.</summary>
    public void Load()
    {
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            _exchange.Load(trees);
            Bodies.LoadStill(trees);
            Place(trees);
            _exchange.LoadAnchorRows(trees);
            SoftRows.LoadSofts(trees);
            Factor(trees, true);
        }
    }

    /// <summary>See <see cref="JointSolver.Enter"/>.</summary>
    public void Enter()
    {
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            for (int lane = 0; lane < trees->Count; lane++)
            {
                if (LaneWork.IsLive(trees, lane))
                {
                    SoftRows.Foresee(trees, lane);
                    Bodies.Enter(trees, lane);
                }
            }

            if (trees->SweepsSofts)
            {
                SoftRows.WarmStart(trees);
                Bodies.StoreVelocities(trees);
            }

            if (trees->HasLimits)
            {
                _activeSet.ForgetPushes(trees);
            }
        }
    }

    /// <summary>See <see cref="TreeTension"/>.</summary>
    /// <returns>True if any tree is factored anew.</returns>
    public bool Stiffen()
    {
        bool any = false;
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (LaneWork.IsTouched(trees)
                && LaneTension.Stiffen(_work.BundleOf(trees), trees, _work.Forest, _work.Step.Bodies, _work.Step.Substep))
            {
                Factor(trees, !_work.HasMoved);
                any = true;
            }
        }

        return any;
    }

    /// <summary>The biased pass or the relax pass; the trees that are given back are as they were before it.</summary>
    /// <param name="relaxed">The relax pass.</param>
    /// <param name="sweeps">Over motors and springs.</param>
    /// <param name="turns">What they push at limits is looked at.</param>
    public void Solve(bool relaxed, int sweeps, bool turns)
    {
        _work.GivenCount = 0;
        Bodies.Refresh();
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            LaneBundle bundle = _work.BundleOf(trees);
            Bodies.LoadStill(trees);
            int leaves = _activeSet.WriteGoals(trees, relaxed) | trees->Stalled;
            if (trees->HasLimits || leaves != 0)
            {
                LaneBodies.PutAside(bundle.Nodes, bundle.Count);
            }

            if (trees->HasRows)
            {
                SoftRows.PutGivenAside(trees);
            }

            _exchange.LeaveBefore(trees, leaves & trees->Live);
            if (trees->HasLimits)
            {
                _activeSet.PrepareTurned(trees, _activeSet.SolveLimits(trees, relaxed, trees->Live));
            }
            else
            {
                LaneSolve.Run(bundle);
            }

            LaneSolve.Give(bundle);
            Sweep(trees, relaxed, sweeps, turns);
            StoreUntouched(trees);
        }
    }

    /// <summary>Another iteration of the pass: of trees without rows it changes nothing.</summary>
    /// <param name="relaxed">The relax pass.</param>
    /// <param name="sweeps">Over motors and springs.</param>
    public void SolveAgain(bool relaxed, int sweeps)
    {
        _work.GivenCount = 0;
        Bodies.Refresh();
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (trees->HasRows)
            {
                Bodies.LoadStill(trees);
                if (trees->HasLimits)
                {
                    _activeSet.SolveTurned(trees, relaxed);
                }

                Sweep(trees, relaxed, sweeps, true);
                StoreUntouched(trees);
            }
        }
    }

    /// <summary>
    /// Motors and springs. If one drives a tree against a limit or away from one, that tree is solved once more, and they are.
    /// </summary>
    private void Sweep(LaneTrees* trees, bool relaxed, int sweeps, bool turns)
    {
        if (!trees->SweepsSofts)
        {
            return;
        }

        SoftRows.SweepIn(trees, AllLanes, relaxed, sweeps);
        int refactored = turns && trees->HasLimits ? _activeSet.SolveTurned(trees, relaxed) : 0;
        if (refactored != 0)
        {
            SoftRows.SweepIn(trees, refactored, relaxed, 1);
        }
    }

    /// <summary>
    /// See <see cref="TreePositions.CorrectPositions"/>; the trees that are given back went astray, and are to be projected. Of trees with
    /// contacts the rounds follow: see <see cref="BeginRound"/>.
    /// </summary>
    public void CorrectPositions()
    {
        _work.GivenCount = 0;
        _work.HasMoved = true;
        Bodies.Refresh();
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (trees->Live == 0)
            {
                continue;
            }

            LanePoses.Move(_nodes.Pointer + trees->First, trees->Nodes, _work.Step.Substep);
            Bodies.LoadStill(trees);
            FindErrors(trees);
            for (int round = 0; !trees->Touched && Choose(trees, round); round++)
            {
                Correct(trees);
                EndRound(trees, round);
            }

            if (!trees->Touched)
            {
                EndCorrection(trees);
            }
        }
    }

    private void EndCorrection(LaneTrees* trees)
    {
        _exchange.LeaveAstray(trees);
        _activeSet.LetGoOfOpenLimits(trees);
        Factor(trees, false);
        Bodies.EndSubstep(trees);
        if (trees->SweepsSofts)
        {
            SoftRows.Resume(trees);
            Bodies.StoreVelocities(trees);
        }
    }

    private void FindErrors(LaneTrees* trees)
    {
        LaneBundle bundle = _work.BundleOf(trees);
        _exchange.NoteGiven(trees);
        Place(trees);
        LaneGoals.FindWorst(bundle, _work.Step.Substep, trees);
        if (trees->HasRows)
        {
            LaneGoals.Foresee(bundle, _work.WalksOrNone(trees), _work.Step.Substep);
        }

        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
        {
            trees->Before[lane] = double.PositiveInfinity;
            trees->Astray[lane] = false;
        }
    }

    /// <summary>The velocity changes that take the errors away in the lanes that take part, as velocities.</summary>
    private void Correct(LaneTrees* trees)
    {
        LaneBundle bundle = _work.BundleOf(trees);
        LaneBodies.PutAside(bundle.Nodes, bundle.Count);
        LaneBodies.ClearVelocities(bundle.Nodes, bundle.Count);
        LaneGoals.Correction(bundle, _work.Step.Substep, trees);
        LaneSolve.Run(bundle);
        LaneSolve.Give(bundle);
    }

    /// <summary>A round of the correction of trees with contacts, which are to be swept over then.</summary>
    /// <returns>True if any takes part.</returns>
    public bool BeginRound(int round)
    {
        bool any = false;
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (!LaneWork.IsTouched(trees))
            {
                continue;
            }

            int lanes = 0;
            if (Choose(trees, round))
            {
                Correct(trees);
                for (int lane = 0; lane < trees->Count; lane++)
                {
                    lanes |= trees->Corrects[lane] != 0 ? 1 << lane : 0;
                }
            }

            Contacts.ShareVelocities(trees, lanes);
            any |= lanes != 0;
        }

        return any;
    }

    public void EndRound(int round)
    {
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (LaneWork.IsTouched(trees) && trees->Acting != 0)
            {
                Contacts.TakeSwept(trees);
                EndRound(trees, round);
            }
        }
    }

    /// <summary>After the rounds.</summary>
    public void EndRounds()
    {
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (LaneWork.IsTouched(trees))
            {
                EndCorrection(trees);
            }
        }
    }

    /// <summary>After a sweep: solves the trees again of which it turned a limit.</summary>
    /// <returns>True if other limits hold than before: their contacts are to be prepared, and swept once more.</returns>
    public bool SolveTouched(bool relaxed)
    {
        bool any = false;
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (LaneWork.IsTouched(trees))
            {
                int changed = trees->HasLimits ? _activeSet.SolveTurned(trees, relaxed) : 0;
                Contacts.ShareVelocities(trees, changed);
                any |= changed != 0;
            }
        }

        return any;
    }

    private void EndRound(LaneTrees* trees, int round)
    {
        LaneBundle bundle = _work.BundleOf(trees);
        LanePoses.MoveOn(bundle.Nodes, bundle.Count, _work.Step.Substep, trees);
        Place(trees);
        LaneGoals.FindWorst(bundle, _work.Step.Substep, trees);
        FindAstray(trees, round);
    }

    private static bool Choose(LaneTrees* trees, int round)
    {
        bool any = false;
        double tolerance = TreePositions.ToleranceAt(round, trees->Touched, trees->HasRows);
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
        {
            bool takes = LaneWork.IsLive(trees, lane) && trees->Worst[lane] > tolerance && !trees->Astray[lane];
            trees->Corrects[lane] = takes ? -1 : 0;
            any |= takes;
        }

        return any;
    }

    private static void FindAstray(LaneTrees* trees, int round)
    {
        for (int lane = 0; lane < trees->Count; lane++)
        {
            if (trees->Corrects[lane] != 0)
            {
                double worst = trees->Worst[lane];
                trees->Astray[lane] |= TreesOnLanes.IsAstray(worst, trees->Before[lane], trees->Bent[lane], round);
                trees->Before[lane] = worst;
            }
        }
    }

    private void Place(LaneTrees* trees) => LanePoses.Place(_work.BundleOf(trees));

    private void Factor(LaneTrees* trees, bool begin)
    {
        LaneFactor.Run(_work.BundleOf(trees), begin);
        SoftRows.PrepareSofts(trees);
        if (trees->Touched)
        {
            Contacts.ShareMasses(trees, trees->Live);
        }
    }

    private void StoreUntouched(LaneTrees* trees)
    {
        if (!trees->Touched)
        {
            Bodies.StoreVelocities(trees);
        }
    }

    /// <summary>Gives all back that a step leaves: velocities, displacements and impulses.</summary>
    public void Finish()
    {
        _work.GivenCount = 0;
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            for (int lane = 0; lane < trees->Count; lane++)
            {
                if (LaneWork.IsLive(trees, lane))
                {
                    _exchange.Finish(trees, lane);
                }
            }
        }

        _work.Count = 0;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _work.Visit(s);
        Choice.Visit(s);
    }
}
