using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>Trees that are solved side by side: out of the lists for a step, and back.</summary>
internal sealed unsafe partial class TreesOnLanes : JointPart
{
    public TreesOnLanes(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>Trees that can go side by side do.</summary>
    public bool UsesLanes { get; set; } = true;

    /// <summary>Trees that none of the last step's passes gave back.</summary>
    public int TreesSideBySide => UsesLanes ? _lanes.Aside.GivenCount : 0;

    /// <summary>Joints between single bodies that were iterated side by side in the last step.</summary>
    public int JointsSideBySide => UsesLanes ? _loose.JointCount : 0;

    /// <summary>Moves the trees that can be solved side by side out of the lists of the passes.</summary>
    public void TakeToLanes()
    {
        TakeLoose();
        _lanes.Choice.Begin(_forest, _active.Pointer, _rows.Pointer, _work.Step);
        ClearOnLanes();
        MarkTied();
        int touched = 0;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            touched += _forest.Trees[_trees[at]].Touched ? 1 : 0;
        }

        // A tree that contacts touch goes there with another such.
        bool alone = touched == 1;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            bool may = UsesLanes && !_work.Step.Drifts && !tree->IsSuspect && !(alone && tree->Touched);
            tree->OnLanes = tree->Loose || (may && _lanes.Choice.Take(_trees[at]));
        }

        _lanes.Choice.LeaveSingles();
        int kept = 0;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (!tree->OnLanes)
            {
                _trees[kept++] = _trees[at];
            }
            else if (tree->Touched)
            {
                tree->Undone = false;
                tree->Refactored = false;
                _laneTrees[_laneTreeCount++] = _trees[at];
            }
        }

        if (kept == _work.TreeCount)
        {
            return;
        }

        _work.TreeCount = kept;
        DropAside();
        kept = 0;
        for (int i = 0; i < _work.AgendaCount; i++)
        {
            if (!_forest.Trees[_forest.TreeOf(_solver.Sweeps.EndsOf(_agenda[i]))].OnLanes)
            {
                _agenda[kept++] = _agenda[i];
            }
            else if (_forest.Trees[_forest.TreeOf(_solver.Sweeps.EndsOf(_agenda[i]))].Touched)
            {
                _laneAgenda[_laneAgendaCount++] = _agenda[i];
            }
        }

        _work.AgendaCount = kept;
        _lanes.Load();
    }

    /// <summary>Nodes and joints of trees that are solved aside leave the lists.</summary>
    public void DropAside()
    {
        int kept = 0;
        for (int at = 0; at < _work.NodeCount; at++)
        {
            if (!IsAside(_forest.Nodes[_nodes[at]].Tree))
            {
                _nodes[kept++] = _nodes[at];
            }
        }

        _work.NodeCount = kept;
        kept = 0;
        for (int at = 0; at < _work.JointCount; at++)
        {
            if (!IsAside(_forest.TreeOf(_active[_joints[at]].Ends)))
            {
                _joints[kept++] = _joints[at];
            }
        }

        _work.JointCount = kept;
    }

    private bool IsAside(int tree) => _forest.Trees[tree].OnLanes || _forest.Trees[tree].OnChain;

    /// <summary>
    /// Finds the trees with rows that are not of their own joints; and those that only contacts with what cannot move push at.
    /// </summary>
    private void MarkTied()
    {
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->Tied = tree->LoopRows > 0;
            tree->Touched = false;
        }

        for (int i = 0; i < _work.AgendaCount; i++)
        {
            int item = _agenda[i];
            if (item < 0 && IsOrdinary(_contacts.Pointer + ~item))
            {
                _forest.Trees[_forest.TreeOf(_contacts[~item].Ends)].Touched = true;
            }
            else if (item < 0 || !_active[item].IsEliminated)
            {
                ref RowEnds ends = ref _solver.Sweeps.EndsOf(item);
                Tie(ends.NodeA);
                Tie(ends.NodeB);
            }
        }
    }

    private void Tie(int node)
    {
        if (node >= 0)
        {
            _forest.Trees[_forest.Nodes[node].Tree].Tied = true;
        }
    }

    /// <summary>Puts a tree that was on lanes back into the lists.</summary>
    public void TakeFromLanes(int index)
    {
        JointTree* tree = _forest.Trees + index;
        tree->OnLanes = false;
        TakeContactsFromLanes(tree, index);
        _solver.Collection.ChooseTree(index);
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            for (int k = 0; k < node->EdgeCount; k++)
            {
                _joints[_work.JointCount++] = _forest.EdgeJoints[node->EdgeFirst + k];
            }
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            _joints[_work.JointCount++] = _forest.Anchors[i].Active;
        }
    }

    /// <summary>A pass over the trees on lanes; those that it leaves take part in the same pass of the others.</summary>
    public void SolveLanes(SweepKind pass, bool again, int sweeps)
    {
        if (_lanes.Any && !again)
        {
            _lanes.Solve(pass != SweepKind.Biased, sweeps, pass != SweepKind.Settle);
            TakeLeft(_lanes.Aside);
        }
        else if (_lanes.Any)
        {
            _lanes.SolveAgain(pass != SweepKind.Biased, sweeps);
            TakeLeft(_lanes.Aside);
        }

        if (pass != SweepKind.Settle && !again)
        {
            _solver.Chains.SolveChains(pass != SweepKind.Biased);
        }

        SweepOnLanes(pass, sweeps);
        if (_loose.Any)
        {
            _loose.Solve(pass == SweepKind.Biased, sweeps, wishes: pass == SweepKind.Settle, limits: true);
        }
    }

    /// <summary>Trees that leave the lanes within a substep get their rows and factor.</summary>
    public void TakeLeft(TreesAside from)
    {
        for (int k = 0; k < from.GivenCount; k++)
        {
            int index = from.Given(k);
            int firstJoint = _work.JointCount;
            int firstItem = _work.AgendaCount;
            TakeFromLanes(index);
            JointTree* tree = _forest.Trees + index;
            for (int i = tree->First; i < tree->End && from.HasMoved; i++)
            {
                _solver.Bodies.LoadPose(_forest.Nodes + i);
            }

            for (int at = firstJoint; at < _work.JointCount && from.HasMoved; at++)
            {
                _solver.Rows.Rewrite(_joints[at]);
            }

            _solver.Responses.Factor(tree);
            if (tree->HasRows)
            {
                TreeFactor.CompleteMasses(_forest, tree);
                TakeAgenda(from, k);
                PrepareFrom(firstItem);
            }
        }
    }

    /// <summary>The motors and springs of a tree that was on lanes are swept with the others again.</summary>
    private void TakeAgenda(TreesAside from, int given)
    {
        for (int i = 0, joint = from.GivenSoft(given, 0); joint >= 0; joint = from.GivenSoft(given, ++i))
        {
            _agenda[_work.AgendaCount++] = joint;
        }
    }

    public void PrepareFrom(int first)
    {
        for (int i = first; i < _work.AgendaCount; i++)
        {
            _solver.Sweeps.Prepare(_agenda[i]);
        }
    }

    /// <summary>The correction of the trees on lanes; those that went astray are projected with the others.</summary>
    /// <param name="pushed">The store has also moved bodies by velocities that push them apart.</param>
    public void CorrectLanes(bool pushed)
    {
        if (_lanes.Any)
        {
            _lanes.CorrectPositions();
            CorrectOnLanes();
            TakeAstray(_lanes.Aside);
        }

        _solver.Chains.CorrectChains();
        if (_loose.Any)
        {
            _loose.Move(pushed);
        }
    }

    public void TakeAstray(TreesAside from)
    {
        for (int k = 0; k < from.GivenCount; k++)
        {
            int firstJoint = _work.JointCount;
            TakeFromLanes(from.Given(k));
            TakeAgenda(from, k);
            for (int at = firstJoint; at < _work.JointCount; at++)
            {
                SetGoals(_joints[at]);
            }
        }
    }

    /// <summary>Where limits that do not hold were to be by the substep's end, as the biased pass leaves it.</summary>
    private void SetGoals(int index)
    {
        for (int row = _rows[index].Hard; row < _rows[index].Count; row++)
        {
            if (_rows[index].Type[row] != (byte)RowType.Limit)
            {
                continue;
            }

            _solver.Limits.LimitTarget(_active.Pointer + index, _rows.Pointer + index, row, TargetKind.Biased);
        }
    }

    /// <summary>All trees are in the lists again, and their joints tell what they did.</summary>
    public void FinishLanes()
    {
        FinishLoose();
        _lanes.Finish();
        _laneTreeCount = 0;
        _laneAgendaCount = 0;
        for (int k = 0; k < _lanes.Aside.GivenCount; k++)
        {
            int firstJoint = _work.JointCount;
            TakeFromLanes(_lanes.Aside.Given(k));
            JointTree* tree = _forest.Trees + _lanes.Aside.Given(k);
            bool posed = false;
            for (int at = firstJoint; at < _work.JointCount; at++)
            {
                if (double.IsInfinity(_active[_joints[at]].Settings.Breakpoint))
                {
                    continue;
                }

                for (int i = tree->First; i < tree->End && !posed; i++)
                {
                    _solver.Bodies.LoadPose(_forest.Nodes + i);
                }

                posed = true;
                _solver.Rows.WriteJoint(_joints[at]);
            }
        }
    }

    /// <summary>Where a body that the solver does not move is, but for sine and cosine.</summary>
    /// <returns>Its angle.</returns>
    public static double ReadStill(BodyStore bodies, int body, out double x, out double y)
    {
        ref BodyPose pose = ref bodies.Pose[body];
        ref BodyState state = ref bodies.State[body];
        x = pose.X + state.DeltaPosition.X;
        y = pose.Y + state.DeltaPosition.Y;
        bool still = (bodies.Flags[body] & (BodyFlags.Enabled | BodyFlags.Kinematic)) != (BodyFlags.Enabled | BodyFlags.Kinematic);
        return still ? pose.Angle : pose.Angle + ((double)bodies.Motion[body].Turned + bodies.Drive[body].Lead);
    }

    /// <summary>A correction leads astray: see the thresholds.</summary>
    public static bool IsAstray(double worst, double before, double bent, int round)
    {
        bool stuck = worst > TreePositions.Loose && worst > TreePositions.Shrink * before;
        bool failed = TreePositions.IsLate(round) && worst > TreePositions.Failed;
        return bent > TreePositions.LargestBend || stuck || failed || !FloatBits.IsFinite(worst);
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_laneTrees);
        s.Column(_laneAgenda);
        s.Value(ref _laneTreeCount);
        s.Value(ref _laneAgendaCount);
        UsesLanes = s.Value(UsesLanes);
    }
}
