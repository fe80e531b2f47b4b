using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Chains;

/// <summary>
/// Chains that contacts press on, such as a bridge under its load. The joints are solved as in other chains; the contacts are swept by the
/// general passes, on the records of the few bodies that they touch, against masses that all of the chain has a part in: see
/// <see cref="ChainWindow"/>. What the contacts give is one more part of what the joints have to meet, so both together are met by one way
/// along the chain.
/// </summary>
[NotState(Why.Fixed)]
internal sealed unsafe class PressedChains : ChainPart
{
    /// <summary>Contacts that touch more than this share of a chain make as much work here as in the general passes.</summary>
    private const int LargestShare = 2;

    private readonly ChainChoice _choice;
    private readonly ChainExchange _exchange;

    public PressedChains(ChainWork work, ChainChoice choice, ChainExchange exchange)
        : base(work)
    {
        _choice = choice;
        _exchange = exchange;
    }

    /// <summary>No chain has been touched yet.</summary>
    public void ClearTouches(in JointStep step)
    {
        _work.Step = step;
        for (int i = 0; i < _work.Count; i++)
        {
            _chains[i].Low = int.MaxValue;
            _chains[i].High = -1;
            _chains[i].IsPressed = false;
        }

        _work.AnyPressed = false;
    }

    /// <summary>A contact presses on a body of a chain.</summary>
    public void Touch(int tree, int node)
    {
        Chain* chain = _chains.Pointer + _work.Forest.Trees[tree].Chain;
        int k = node - _work.Forest.Trees[tree].First;
        int at = (k <= chain->Bend ? chain->Bend - k : k) + chain->Front;
        chain->Low = Math.Min(chain->Low, at);
        chain->High = Math.Max(chain->High, at);
    }

    /// <summary>
    /// Takes a chain that contacts press on, if its joints are plain hinges at nothing that moves by itself, it is not taut, and they touch
    /// a small part of it.
    /// </summary>
    /// <returns>True if it is solved here.</returns>
    public bool Press(int tree)
    {
        Chain* chain = _chains.Pointer + _work.Forest.Trees[tree].Chain;
        if (chain->High < 0 || !_choice.HasPlainJoints(chain) || chain->Breaks || HangsAtMoving(chain))
        {
            return false;
        }

        // A joint between two of them, at which the eliminations from both ends meet.
        if (chain->High == chain->Low)
        {
            chain->Low -= chain->Low > chain->Front ? 1 : 0;
            chain->High += chain->High == chain->Low ? 1 : 0;
        }

        if ((chain->High - chain->Low + 1) * LargestShare > chain->Bodies - chain->Front)
        {
            return false;
        }

        chain->Middle = Math.Max(chain->Low, Math.Min(chain->High - 1, chain->Joints / 2));
        chain->Top = chain->Low;
        for (int i = chain->Low; i <= chain->High; i++)
        {
            bool nearer = _work.Forest.Nodes[Node(chain, i)].Depth < _work.Forest.Nodes[Node(chain, chain->Top)].Depth;
            chain->Top = nearer ? i : chain->Top;
        }

        chain->IsPressed = true;
        _exchange.LoadPressed(chain);
        ChainView view = _work.ViewOf(chain);
        ChainFactor.Run(view);
        chain->IsPressed = ChainFactor.IsRegular(view);
        if (chain->IsPressed)
        {
            _work.AnyPressed = true;
            WriteWindow(chain);
        }

        return chain->IsPressed;
    }

    /// <summary>
    /// See <see cref="JointSolver.Enter"/>: velocities by gravity and forces; those of the bodies that contacts touch go to these.
    /// </summary>
    public void Enter()
    {
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            if (_work.Step.Watched)
            {
                _exchange.EnterWatched(chain, false);
            }
            else
            {
                ChainPoses.Drive(_work.ViewOf(chain), 0);
            }

            ShareVelocities(chain);
        }
    }

    /// <summary>After the contacts' starting impulses.</summary>
    public void TakeWarmStart()
    {
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            ChainView view = _work.ViewOf(chain);
            for (int i = chain->Low; i <= chain->High; i++)
            {
                double* v = _work.Forest.Nodes[Node(chain, i)].Velocity;
                ChainExchange.Put(view[ChainColumn.Velocity] + i, view.Stride, v[0], v[1], v[2]);
            }

            ShowVelocities(chain);
        }
    }

    /// <summary>The first half of a pass: what the joints find without what the contacts are going to give.</summary>
    /// <param name="relaxed">The relax pass.</param>
    /// <param name="again">The joints have been solved in this pass.</param>
    public void Solve(bool relaxed, bool again)
    {
        _work.GivenCount = 0;
        _work.HasMoved = true;
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            LookAtVelocities(chain);
            ChainView view = _work.ViewOf(chain);
            if (again)
            {
                ChainWork.Clear(view[ChainColumn.Residual], 2 * view.Stride);
            }
            else if (relaxed)
            {
                ChainSolve.LackRelaxed(view);
            }
            else if (ChainSolve.LackBiased(view, 1 / _work.Step.Substep))
            {
                ChainWork.Clear(view[ChainColumn.Bend], 4 * view.Stride);
                _exchange.Leave(chain, true);
                continue;
            }
            else
            {
                ChainSolve.LackBends(view, _work.Step.Substep);
            }

            BeginPass(chain, view, view[ChainColumn.Velocity]);
        }
    }

    /// <summary>The contacts may be swept: their bodies have the velocities that the joints give them.</summary>
    public void BeginWalks(bool some)
    {
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            if (Acts(chain, some))
            {
                ChainWindow.Begin(_work.Forest, _places.Pointer + chain->PlaceFirst, chain);
            }
        }
    }

    /// <summary>The second half of a pass: the joints meet what the contacts gave, and all of it goes to the bodies.</summary>
    public void EndWalks(bool some, bool correction)
    {
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            if (!Acts(chain, some))
            {
                continue;
            }

            ChainView view = _work.ViewOf(chain);
            if (_work.Forest.Trees[chain->Tree].Carries)
            {
                ChainWindow.TakePushes(_work.Forest, _places.Pointer + chain->PlaceFirst, view);
                ChainSolve.RunWithin(view, view.FirstWithin, view.LastWithin, chain->Ends);
            }
            else
            {
                ChainWindow.ClearPushes(view);
            }

            ChainSolve.Spread(view);
            if (correction)
            {
                EndRound(chain, view);
            }
            else
            {
                ChainSolve.Give(view);
                ShowVelocities(chain);
            }
        }
    }

    /// <summary>After the biased pass: the way of the substep, and the errors and bends that it leaves.</summary>
    public void Move()
    {
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            LookAtVelocities(chain);
            ChainView view = _work.ViewOf(chain);
            ChainPoses.Move(view, _work.Step.Substep);
            ChainPoses.Turn(view);
            chain->Worst = ChainPoses.Place(view);
            chain->Before = double.PositiveInfinity;
            chain->Astray = false;
            ChainSolve.Foresee(view, _work.Step.Substep);
        }
    }

    /// <summary>No group of trees acts.</summary>
    public void ClearGroups()
    {
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            _work.Forest.Trees[chain->Tree].GroupActs = false;
        }
    }

    /// <summary>Finds the chains that take part in a round of the correction.</summary>
    /// <returns>True if any does.</returns>
    public bool Choose(int round)
    {
        bool any = false;
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            JointTree* tree = _work.Forest.Trees + chain->Tree;
            tree->Corrects = chain->Worst > TreePositions.ToleranceAt(round, pressed: true, rows: true);
            _work.Forest.Trees[tree->Group].GroupActs |= tree->Corrects;
            any |= tree->Corrects;
        }

        return any;
    }

    /// <summary>The first half of a round of the correction.</summary>
    /// <returns>True if a chain takes part.</returns>
    public bool Correct(bool first)
    {
        bool any = false;
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            if (!_work.Forest.Trees[chain->Tree].Corrects)
            {
                continue;
            }

            ChainView view = _work.ViewOf(chain);
            if (first)
            {
                ChainSolve.NotePlain(view);
            }

            ChainSolve.LackErrors(view, 1 / _work.Step.Substep);
            BeginPass(chain, view, null);
            any = true;
        }

        return any;
    }

    /// <summary>After a round: the chains that went astray are given back.</summary>
    public void LeaveAstray()
    {
        _work.GivenCount = 0;
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            if (chain->Astray)
            {
                ChainWork.Clear(_work.ViewOf(chain)[ChainColumn.Bend], 4 * _work.ViewOf(chain).Stride);
                _exchange.Leave(chain, false);
            }
        }
    }

    /// <summary>All are given back, for what is only done by the general passes.</summary>
    public void LeaveAll()
    {
        _work.GivenCount = 0;
        _work.HasMoved = true;
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            _exchange.Leave(chain, true);
        }
    }

    /// <summary>The bodies stand where they stay in this substep: factors the chains; those that have become taut are given back.</summary>
    public void EndSubstep()
    {
        _work.GivenCount = 0;
        _work.HasMoved = true;
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            chain->Swapped = !chain->Swapped;
            ChainView view = _work.ViewOf(chain);
            ChainFactor.Run(view);
            if (!ChainFactor.IsRegular(view))
            {
                _exchange.Leave(chain, true);
                continue;
            }

            WriteWindow(chain);
            if (_work.Step.Watched)
            {
                _exchange.StoreMoves(chain);
                _exchange.StoreVelocities(chain);
            }
        }
    }

    /// <summary>Gives all back that a step leaves.</summary>
    public void Finish()
    {
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            chain->HasVelocities = true;
            _exchange.KeepAll(chain);
            _exchange.GiveVelocities(chain);
            _exchange.GiveBends(chain);
            chain->IsPressed = false;
            _work.Forest.Trees[chain->Tree].OnChain = false;
        }

        _work.AnyPressed = false;
    }

    private Chain* Next(Chain* chain)
    {
        if (!_work.AnyPressed)
        {
            return null;
        }

        Chain* end = _chains.Pointer + _work.Count;
        for (chain = chain == null ? _chains.Pointer : chain + 1; chain < end; chain++)
        {
            if (chain->IsPressed)
            {
                return chain;
            }
        }

        return null;
    }

    private int Node(Chain* chain, int at) => _places[chain->PlaceFirst + at].Node;

    private bool Acts(Chain* chain, bool some) => !some || _work.Forest.Trees[_work.Forest.Trees[chain->Tree].Group].GroupActs;

    private void BeginPass(Chain* chain, in ChainView view, double* velocity)
    {
        ChainSolve.Gather(view, out chain->Ends);
        ChainSolve.RunWithin(view, view.FirstWithin, view.LastWithin, chain->Ends);
        ChainWindow.ShareSolved(_work.Forest, _places.Pointer + chain->PlaceFirst, view, velocity);
    }

    private void EndRound(Chain* chain, in ChainView view)
    {
        double bent = ChainSolve.Correct(view, _work.Step.Substep);
        ChainPoses.Turn(view);
        chain->Worst = ChainPoses.Place(view);
        chain->Bent = bent;
    }

    /// <summary>Whether the chains went astray in the round.</summary>
    public void FindAstray(int round)
    {
        for (Chain* chain = Next(null); chain != null; chain = Next(chain))
        {
            if (_work.Forest.Trees[chain->Tree].Corrects)
            {
                chain->Astray |= TreesOnLanes.IsAstray(chain->Worst, chain->Before, chain->Bent, round);
                chain->Before = chain->Worst;
            }
        }
    }

    /// <summary>Others may have changed velocities between the passes.</summary>
    private void LookAtVelocities(Chain* chain)
    {
        if (_work.Step.Watched)
        {
            _exchange.Refresh(chain);
        }
    }

    /// <summary>Others may look at velocities between the passes.</summary>
    private void ShowVelocities(Chain* chain)
    {
        if (_work.Step.Watched)
        {
            _exchange.StoreVelocities(chain);
        }
    }

    private void ShareVelocities(Chain* chain)
    {
        ChainView view = _work.ViewOf(chain);
        for (int i = chain->Low; i <= chain->High; i++)
        {
            ChainExchange.PutBack(view[ChainColumn.Velocity] + i, view.Stride, _work.Forest.Nodes[Node(chain, i)].Velocity);
        }
    }

    /// <summary>
    /// A kinematic body at an end: it has moved by all of the step, and the rows of the first substep are of the time before.
    /// </summary>
    private bool HangsAtMoving(Chain* chain)
    {
        const BodyFlags Moving = BodyFlags.Enabled | BodyFlags.Kinematic;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        bool found = chain->Front > 0 && (_work.Step.Bodies.Flags[places[0].Body] & Moving) == Moving;
        return found || (chain->Joints == chain->Bodies && (_work.Step.Bodies.Flags[places[chain->Bodies].Body] & Moving) == Moving);
    }

    /// <summary>Masses, ways and poses of the bodies that contacts touch.</summary>
    private void WriteWindow(Chain* chain) =>
        ChainWindow.Write(_work.Forest, _places.Pointer + chain->PlaceFirst, _work.ViewOf(chain), chain->Top);
}
