using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints.Chains;

/// <content>
/// Chains that contacts press on, such as a bridge under its load. The joints are solved as in other chains; the contacts are swept by the
/// general passes, on the records of the few bodies that they touch, against masses that all of the chain has a part in: see
/// <see cref="ChainWindow"/>. What the contacts give is one more part of what the joints have to meet, so both together are met by one way
/// along the chain.
/// </content>
internal sealed unsafe partial class ChainSolver
{
    /// <summary>Contacts that touch more than this share of a chain make as much work here as in the general passes.</summary>
    private const int LargestShare = 2;

    /// <summary>Chains that contacts press on are solved here in the present passes.</summary>
    public bool AnyPressed { get; private set; }

    /// <summary>No chain has been touched yet.</summary>
    public void ClearTouches(in JointStep step)
    {
        _step = step;
        for (int i = 0; i < _count; i++)
        {
            _chains[i].Low = int.MaxValue;
            _chains[i].High = -1;
            _chains[i].IsPressed = false;
        }

        AnyPressed = false;
    }

    /// <summary>A contact presses on a body of a chain.</summary>
    public void Touch(int tree, int node)
    {
        Chain* chain = _chains.Pointer + _forest.Trees[tree].Chain;
        int k = node - _forest.Trees[tree].First;
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
        Chain* chain = _chains.Pointer + _forest.Trees[tree].Chain;
        if (chain->High < 0 || !HasPlainJoints(chain) || chain->Breaks || HangsAtMoving(chain))
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
            bool nearer = _forest.Nodes[Node(chain, i)].Depth < _forest.Nodes[Node(chain, chain->Top)].Depth;
            chain->Top = nearer ? i : chain->Top;
        }

        chain->IsPressed = true;
        LoadPressed(chain);
        ChainView view = ViewOf(chain);
        ChainFactor.Run(view);
        chain->IsPressed = ChainFactor.IsRegular(view);
        if (chain->IsPressed)
        {
            AnyPressed = true;
            WriteWindow(chain);
        }

        return chain->IsPressed;
    }

    /// <summary>
    /// See <see cref="JointSolver.Enter"/>: velocities by gravity and forces; those of the bodies that contacts touch go to these.
    /// </summary>
    public void EnterPressed()
    {
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            if (_step.Watched)
            {
                EnterWatched(chain, false);
            }
            else
            {
                ChainPoses.Drive(ViewOf(chain), 0);
            }

            ShareVelocities(chain);
        }
    }

    /// <summary>After the contacts' starting impulses.</summary>
    public void TakeWarmStart()
    {
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            ChainView view = ViewOf(chain);
            for (int i = chain->Low; i <= chain->High; i++)
            {
                double* v = _forest.Nodes[Node(chain, i)].Velocity;
                Put(view[ChainColumn.Velocity] + i, view.Stride, v[0], v[1], v[2]);
            }

            ShowVelocities(chain);
        }
    }

    /// <summary>The first half of a pass: what the joints find without what the contacts are going to give.</summary>
    /// <param name="relaxed">The relax pass.</param>
    /// <param name="again">The joints have been solved in this pass.</param>
    public void SolvePressed(bool relaxed, bool again)
    {
        GivenCount = 0;
        HasMoved = true;
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            LookAtVelocities(chain);
            ChainView view = ViewOf(chain);
            if (again)
            {
                Clear(view[ChainColumn.Residual], 2 * view.Stride);
            }
            else if (relaxed)
            {
                ChainSolve.LackRelaxed(view);
            }
            else if (ChainSolve.LackBiased(view, 1 / _step.Substep))
            {
                Clear(view[ChainColumn.Bend], 4 * view.Stride);
                Leave(chain, true);
                continue;
            }
            else
            {
                ChainSolve.LackBends(view, _step.Substep);
            }

            BeginPass(chain, view, view[ChainColumn.Velocity]);
        }
    }

    /// <summary>The contacts may be swept: their bodies have the velocities that the joints give them.</summary>
    public void BeginWalks(bool some)
    {
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            if (Acts(chain, some))
            {
                ChainWindow.Begin(_forest, _places.Pointer + chain->PlaceFirst, chain);
            }
        }
    }

    /// <summary>The second half of a pass: the joints meet what the contacts gave, and all of it goes to the bodies.</summary>
    public void EndWalks(bool some, bool correction)
    {
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            if (!Acts(chain, some))
            {
                continue;
            }

            ChainView view = ViewOf(chain);
            if (_forest.Trees[chain->Tree].Carries)
            {
                ChainWindow.TakePushes(_forest, _places.Pointer + chain->PlaceFirst, view);
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
    public void MovePressed()
    {
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            LookAtVelocities(chain);
            ChainView view = ViewOf(chain);
            ChainPoses.Move(view, _step.Substep);
            ChainPoses.Turn(view);
            chain->Worst = ChainPoses.Place(view);
            chain->Before = double.PositiveInfinity;
            chain->Astray = false;
            ChainSolve.Foresee(view, _step.Substep);
        }
    }

    /// <summary>No group of trees acts.</summary>
    public void ClearGroups()
    {
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            _forest.Trees[chain->Tree].GroupActs = false;
        }
    }

    /// <summary>Finds the chains that take part in a round of the correction.</summary>
    /// <returns>True if any does.</returns>
    public bool ChoosePressed(int round)
    {
        bool any = false;
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            JointTree* tree = _forest.Trees + chain->Tree;
            tree->Corrects = chain->Worst > TreePositions.ToleranceAt(round, pressed: true, rows: true);
            _forest.Trees[tree->Group].GroupActs |= tree->Corrects;
            any |= tree->Corrects;
        }

        return any;
    }

    /// <summary>The first half of a round of the correction.</summary>
    /// <returns>True if a chain takes part.</returns>
    public bool CorrectPressed(bool first)
    {
        bool any = false;
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            if (!_forest.Trees[chain->Tree].Corrects)
            {
                continue;
            }

            ChainView view = ViewOf(chain);
            if (first)
            {
                NotePlain(view);
            }

            ChainSolve.LackErrors(view, 1 / _step.Substep);
            BeginPass(chain, view, null);
            any = true;
        }

        return any;
    }

    /// <summary>After a round: the chains that went astray are given back.</summary>
    public void LeaveAstray()
    {
        GivenCount = 0;
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            if (chain->Astray)
            {
                Clear(ViewOf(chain)[ChainColumn.Bend], 4 * ViewOf(chain).Stride);
                Leave(chain, false);
            }
        }
    }

    /// <summary>All are given back, for what is only done by the general passes.</summary>
    public void LeaveAll()
    {
        GivenCount = 0;
        HasMoved = true;
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            Leave(chain, true);
        }
    }

    /// <summary>The bodies stand where they stay in this substep: factors the chains; those that have become taut are given back.</summary>
    public void EndPressed()
    {
        GivenCount = 0;
        HasMoved = true;
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            chain->Swapped = !chain->Swapped;
            ChainView view = ViewOf(chain);
            ChainFactor.Run(view);
            if (!ChainFactor.IsRegular(view))
            {
                Leave(chain, true);
                continue;
            }

            WriteWindow(chain);
            if (_step.Watched)
            {
                StoreMoves(chain);
                StoreVelocities(chain);
            }
        }
    }

    /// <summary>Gives all back that a step leaves.</summary>
    private void FinishPressed()
    {
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            chain->HasVelocities = true;
            KeepAll(chain);
            GiveVelocities(chain);
            GiveBends(chain);
            chain->IsPressed = false;
            _forest.Trees[chain->Tree].OnChain = false;
        }

        AnyPressed = false;
    }

    private Chain* NextPressed(Chain* chain)
    {
        if (!AnyPressed)
        {
            return null;
        }

        Chain* end = _chains.Pointer + _count;
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

    private bool Acts(Chain* chain, bool some) => !some || _forest.Trees[_forest.Trees[chain->Tree].Group].GroupActs;

    private void BeginPass(Chain* chain, in ChainView view, double* velocity)
    {
        ChainSolve.Gather(view, out chain->Ends);
        ChainSolve.RunWithin(view, view.FirstWithin, view.LastWithin, chain->Ends);
        ChainWindow.ShareSolved(_forest, _places.Pointer + chain->PlaceFirst, view, velocity);
    }

    private void EndRound(Chain* chain, in ChainView view)
    {
        double bent = ChainSolve.Correct(view, _step.Substep);
        ChainPoses.Turn(view);
        chain->Worst = ChainPoses.Place(view);
        chain->Bent = bent;
    }

    /// <summary>Whether the chains went astray in the round.</summary>
    public void FindAstray(int round)
    {
        for (Chain* chain = NextPressed(null); chain != null; chain = NextPressed(chain))
        {
            if (_forest.Trees[chain->Tree].Corrects)
            {
                chain->Astray |= TreesOnLanes.IsAstray(chain->Worst, chain->Before, chain->Bent, round);
                chain->Before = chain->Worst;
            }
        }
    }

    /// <summary>Others may have changed velocities between the passes.</summary>
    private void LookAtVelocities(Chain* chain)
    {
        if (_step.Watched)
        {
            Refresh(chain);
        }
    }

    /// <summary>Others may look at velocities between the passes.</summary>
    private void ShowVelocities(Chain* chain)
    {
        if (_step.Watched)
        {
            StoreVelocities(chain);
        }
    }

    private void ShareVelocities(Chain* chain)
    {
        ChainView view = ViewOf(chain);
        for (int i = chain->Low; i <= chain->High; i++)
        {
            PutBack(view[ChainColumn.Velocity] + i, view.Stride, _forest.Nodes[Node(chain, i)].Velocity);
        }
    }

    /// <summary>What a step begins with: from the records of bodies, nodes and joints.</summary>
    private void LoadPressed(Chain* chain)
    {
        ChainView view = ViewOf(chain);
        int s = view.Stride;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        Clear(view[ChainColumn.Given], 4 * s);
        Clear(view[ChainColumn.Push], 7 * s);
        for (int i = chain->Front; i < chain->Bodies; i++)
        {
            TreeNode* node = _forest.Nodes + places[i].Node;
            BodyPose* pose = _step.Bodies.Pose.Pointer + places[i].Body;
            LoadMotion(view, i, places + i, false);
            Put(view[ChainColumn.Move] + i, s, node->Move[0], node->Move[1], node->Move[2]);
            Put(view[ChainColumn.Place] + i, s, pose->X, pose->Y);
            Put(view[ChainColumn.MiddleSin] + i, s, node->MiddleSin, node->MiddleCos);
            Put(view[ChainColumn.TurnSin] + i, s, node->TurnSin, node->TurnCos);
        }

        for (int i = 0; i < chain->Joints; i++)
        {
            ActiveJoint* joint = _active + places[i].Active;
            double sign = places[i].IsHighB ? 1 : -1;
            Put(view[ChainColumn.Bend] + i, s, sign * joint->Bend[0], sign * joint->Bend[1]);
            Put(view[ChainColumn.Foreseen] + i, s, sign * joint->Foreseen[0], sign * joint->Foreseen[1]);
        }

        if (chain->Front > 0)
        {
            view[ChainColumn.TurnSin][0] = 0;
            view[ChainColumn.TurnCos][0] = 1;
        }

        if (chain->Joints == chain->Bodies)
        {
            view[ChainColumn.TurnSin][chain->Bodies] = 0;
            view[ChainColumn.TurnCos][chain->Bodies] = 1;
        }

        LoadStill(chain);
        if (chain->Front > 0 && LoadStill(chain, 0, ref chain->FrontAngle, out double angle))
        {
            TurnStill(chain, 0, angle);
        }

        ChainPoses.Place(view);
        chain->Swapped = !chain->Swapped;
    }

    /// <summary>
    /// A kinematic body at an end: it has moved by all of the step, and the rows of the first substep are of the time before.
    /// </summary>
    private bool HangsAtMoving(Chain* chain)
    {
        const BodyFlags Moving = BodyFlags.Enabled | BodyFlags.Kinematic;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        bool found = chain->Front > 0 && (_step.Bodies.Flags[places[0].Body] & Moving) == Moving;
        return found || (chain->Joints == chain->Bodies && (_step.Bodies.Flags[places[chain->Bodies].Body] & Moving) == Moving);
    }

    /// <summary>Masses, ways and poses of the bodies that contacts touch.</summary>
    private void WriteWindow(Chain* chain) => ChainWindow.Write(_forest, _places.Pointer + chain->PlaceFirst, ViewOf(chain), chain->Top);

    private void GiveBends(Chain* chain)
    {
        ChainView view = ViewOf(chain);
        int s = view.Stride;
        ChainPlace* places = _places.Pointer + chain->PlaceFirst;
        for (int i = 0; i < chain->Joints; i++)
        {
            ActiveJoint* joint = _active + places[i].Active;
            double sign = places[i].IsHighB ? 1 : -1;
            for (int r = 0; r < 2; r++)
            {
                joint->Bend[r] = sign * view[ChainColumn.Bend][i + (r * s)];
                joint->Foreseen[r] = sign * view[ChainColumn.Foreseen][i + (r * s)];
            }
        }
    }
}
