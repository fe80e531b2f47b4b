using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
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
internal sealed unsafe partial class TreeLanes : TreesAside
{
    private const int AllLanes = (1 << DoubleLanes.BundleLanes) - 1;

    private readonly Column<LaneNode> _nodes = new Column<LaneNode>();
    private readonly Column<LanePlace> _places = new Column<LanePlace>();
    private readonly Column<LaneAnchor> _anchors = new Column<LaneAnchor>();
    private readonly Column<LanePlace> _anchorPlaces = new Column<LanePlace>();
    private readonly Column<LaneTrees> _bundles = new Column<LaneTrees>();
    private readonly Column<int> _given = new Column<int>();
    private readonly Column<int> _givenFrom = new Column<int>();
    [NotState(Why.Elsewhere)]
    private JointForest _forest = null!;
    private ActiveJoint* _active;
    private JointRows* _rows;
    private JointStep _step;
    private int _count;
    private int _nodeCount;
    private int _anchorCount;

    public bool Any => _count > 0;

    public override int Given(int index) => _given[index];

    /// <summary>The velocities in double stand as long as the store has their rounding.</summary>
    public void Refresh()
    {
        BodyState* states = _step.Bodies.State.Pointer;
        for (int b = 0; b < _count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            for (int i = 0; i < trees->Nodes; i++)
            {
                Refresh(states, trees, i);
            }
        }
    }

    private void Refresh(BodyState* states, LaneTrees* trees, int i)
    {
        LaneNode* node = _nodes.Pointer + trees->First + i;
        LanePlace* place = _places.Pointer + trees->First + i;
        for (int lane = 0; lane < trees->Count; lane++)
        {
            BodyState* state = states + place->Body[lane];
            Refresh(node->Velocity + lane, state->LinearVelocity.X);
            Refresh(node->Velocity + 4 + lane, state->LinearVelocity.Y);
            Refresh(node->Velocity + 8 + lane, state->AngularVelocity);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Refresh(double* held, float stored)
    {
        if ((float)*held != stored)
        {
            *held = stored;
        }
    }

    /// <summary>See <see cref="JointSolver.Enter"/>.</summary>
    public void Enter()
    {
        BodyState* states = _step.Bodies.State.Pointer;
        BodyMotion* motions = _step.Bodies.Motion.Pointer;
        BodyDrive* drives = _step.Bodies.Drive.Pointer;
        for (int b = 0; b < _count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            for (int lane = 0; lane < trees->Count; lane++)
            {
                if (!IsLive(trees, lane))
                {
                    continue;
                }

                Foresee(trees, lane);
                bool free = _forest.Trees[trees->Tree[lane]].Free;
                for (int i = 0; i < trees->Nodes; i++)
                {
                    LaneNode* node = DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane);
                    int body = _places[trees->First + i].Body[lane];
                    BodyState* state = states + body;
                    BodyMotion* motion = motions + body;
                    BodyDrive* drive = drives + body;
                    motion->ChangeX = 0;
                    motion->ChangeY = 0;
                    motion->ChangeW = 0;
                    node->StartMove[0] = node->Move[0];
                    node->StartMove[4] = node->Move[4];
                    node->StartMove[8] = node->Move[8];
                    HeldVelocity.Drive(ref node->Velocity[0], ref state->LinearVelocity.X, motion->StartX, drive->LinearKeep, drive->X);
                    HeldVelocity.Drive(ref node->Velocity[4], ref state->LinearVelocity.Y, motion->StartY, drive->LinearKeep, drive->Y);
                    HeldVelocity.Drive(ref node->Velocity[8], ref state->AngularVelocity, motion->StartW, drive->AngularKeep, drive->W);
                    Kick(node, state, drive, free ? -0.5f : 0);
                }
            }

            if (trees->SweepsSofts)
            {
                WarmStart(trees);
            }

            if (trees->HasLimits)
            {
                ForgetPushes(trees);
            }
        }
    }

    /// <summary>See <see cref="TreeTension"/>.</summary>
    /// <returns>True if any tree is factored anew.</returns>
    public bool Stiffen()
    {
        bool any = false;
        for (int b = 0; b < _count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (IsTouched(trees) && LaneTension.Stiffen(BundleOf(trees), trees, _forest, _step.Bodies, _step.Substep))
            {
                Factor(trees, !HasMoved);
                any = true;
            }
        }

        return any;
    }

    /// <summary>A share of gravity and forces; see <see cref="JointSolver"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Kick(LaneNode* node, BodyState* state, BodyDrive* drive, float share)
    {
        if (share != 0)
        {
            HeldVelocity.Kick(ref node->Velocity[0], ref state->LinearVelocity.X, share * (double)drive->X);
            HeldVelocity.Kick(ref node->Velocity[4], ref state->LinearVelocity.Y, share * (double)drive->Y);
            HeldVelocity.Kick(ref node->Velocity[8], ref state->AngularVelocity, share * (double)drive->W);
            return;
        }

        Refresh(node->Velocity, state->LinearVelocity.X);
        Refresh(node->Velocity + 4, state->LinearVelocity.Y);
        Refresh(node->Velocity + 8, state->AngularVelocity);
    }

    /// <summary>The biased pass or the relax pass; the trees that are given back are as they were before it.</summary>
    /// <param name="relaxed">The relax pass.</param>
    /// <param name="sweeps">Over motors and springs.</param>
    /// <param name="turns">What they push at limits is looked at.</param>
    public void Solve(bool relaxed, int sweeps, bool turns)
    {
        GivenCount = 0;
        Refresh();
        for (int b = 0; b < _count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            LaneBundle bundle = BundleOf(trees);
            LoadStill(trees);
            int leaves = WriteGoals(trees, relaxed) | trees->Stalled;
            if (trees->HasLimits || leaves != 0)
            {
                PutAside(bundle.Nodes, bundle.Count);
            }

            if (trees->HasRows)
            {
                PutGivenAside(trees);
            }

            LeaveBefore(trees, leaves & trees->Live);
            if (trees->HasLimits)
            {
                PrepareTurned(trees, SolveLimits(trees, relaxed, trees->Live));
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
        GivenCount = 0;
        Refresh();
        for (int b = 0; b < _count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (trees->HasRows)
            {
                LoadStill(trees);
                if (trees->HasLimits)
                {
                    SolveTurned(trees, relaxed);
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

        SweepIn(trees, AllLanes, relaxed, sweeps);
        int refactored = turns && trees->HasLimits ? SolveTurned(trees, relaxed) : 0;
        if (refactored != 0)
        {
            SweepIn(trees, refactored, relaxed, 1);
        }
    }

    /// <summary>Sweeps over the motors and springs of some lanes.</summary>
    private void SweepIn(LaneTrees* trees, int lanes, bool relaxed, int sweeps)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
        {
            trees->Sweeps[lane] = (lanes & (1 << lane)) != 0 ? -1 : 0;
        }

        bool any = false;
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneSoftPlace* places = _softPlaces.Pointer + trees->SoftFirst;
            any |= LaneSweep.Run(
                WalksOf(trees, lane), _softs.Pointer + trees->SoftFirst, places, trees->Softs, !relaxed, sweeps, lane, trees->Sweeps);
        }

        if (any)
        {
            LaneSolve.Give(BundleOf(trees));
        }
    }

    /// <summary>
    /// See <see cref="TreePositions.CorrectPositions"/>; the trees that are given back went astray, and are to be projected. Of trees with
    /// contacts the rounds follow: see <see cref="BeginRound"/>.
    /// </summary>
    public void CorrectPositions()
    {
        GivenCount = 0;
        HasMoved = true;
        Refresh();
        for (int b = 0; b < _count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (trees->Live == 0)
            {
                continue;
            }

            LanePoses.Move(_nodes.Pointer + trees->First, trees->Nodes, _step.Substep);
            LoadStill(trees);
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
        LeaveAstray(trees);
        LetGoOfOpenLimits(trees);
        Factor(trees, false);
        EndSubstep(trees);
        if (trees->SweepsSofts)
        {
            Resume(trees);
        }
    }

    private void FindErrors(LaneTrees* trees)
    {
        LaneBundle bundle = BundleOf(trees);
        NoteGiven(trees);
        Place(trees);
        LaneGoals.FindWorst(bundle, _step.Substep, trees);
        if (trees->HasRows)
        {
            LaneGoals.Foresee(bundle, WalksOrNone(trees), _step.Substep);
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
        LaneBundle bundle = BundleOf(trees);
        PutAside(bundle.Nodes, bundle.Count);
        ClearVelocities(bundle.Nodes, bundle.Count);
        LaneGoals.Correction(bundle, _step.Substep, trees);
        LaneSolve.Run(bundle);
        LaneSolve.Give(bundle);
    }

    private void EndRound(LaneTrees* trees, int round)
    {
        LaneBundle bundle = BundleOf(trees);
        LanePoses.MoveOn(bundle.Nodes, bundle.Count, _step.Substep, trees);
        Place(trees);
        LaneGoals.FindWorst(bundle, _step.Substep, trees);
        FindAstray(trees, round);
    }

    private static bool Choose(LaneTrees* trees, int round)
    {
        bool any = false;
        double tolerance = TreePositions.ToleranceAt(round, trees->Touched, trees->HasRows);
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
        {
            bool takes = IsLive(trees, lane) && trees->Worst[lane] > tolerance && !trees->Astray[lane];
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

    private LaneBundle BundleOf(LaneTrees* trees) => new LaneBundle
    {
        Nodes = _nodes.Pointer + trees->First,
        Places = _places.Pointer + trees->First,
        Count = trees->Nodes,
        Anchors = _anchors.Pointer + trees->AnchorFirst,
        AnchorPlaces = _anchorPlaces.Pointer + trees->AnchorFirst,
        AnchorCount = trees->Anchors,
    };

    private static bool IsLive(LaneTrees* trees, int lane) => (trees->Live & (1 << lane)) != 0;

    private void Place(LaneTrees* trees) => LanePoses.Place(BundleOf(trees));

    private void Factor(LaneTrees* trees, bool begin)
    {
        LaneFactor.Run(BundleOf(trees), begin);
        PrepareSofts(trees);
        if (trees->Touched)
        {
            ShareMasses(trees, trees->Live);
        }
    }

    private void PrepareSofts(LaneTrees* trees)
    {
        trees->Stalled = 0;
        for (int lane = 0; lane < DoubleLanes.BundleLanes && trees->SweepsSofts; lane += WideDouble.Count)
        {
            LaneSoftPlace* places = _softPlaces.Pointer + trees->SoftFirst;
            LaneSoft* softs = _softs.Pointer + trees->SoftFirst;
            trees->Stalled |= LaneSweep.Prepare(WalksOf(trees, lane), softs, places, trees->Softs, _step.Substep, lane);
        }
    }

    private void WarmStart(LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneSoftPlace* places = _softPlaces.Pointer + trees->SoftFirst;
            LaneSweep.WarmStart(WalksOf(trees, lane), _softs.Pointer + trees->SoftFirst, places, trees->Softs, lane);
        }

        StoreVelocities(trees);
    }

    private void Resume(LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneSoftPlace* places = _softPlaces.Pointer + trees->SoftFirst;
            LaneSweep.Resume(WalksOf(trees, lane), _softs.Pointer + trees->SoftFirst, places, trees->Softs, lane);
        }

        StoreVelocities(trees);
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_nodes);
        s.Column(_places);
        s.Column(_anchors);
        s.Column(_anchorPlaces);
        s.Column(_bundles);
        s.Column(_given);
        s.Column(_givenFrom);
        s.Value(ref _count);
        s.Value(ref _nodeCount);
        s.Value(ref _anchorCount);
        s.Column(_softs);
        s.Column(_softPlaces);
        s.Column(_walks);
        s.Column(_drafts);
        s.Column(_draftKeys);
        s.Value(ref _draftCount);
        s.Value(ref _softCount);
    }
}
