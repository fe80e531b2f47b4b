using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Lanes;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints;

/// <content>Trees that are solved side by side: out of the lists for a step, and back.</content>
internal sealed unsafe partial class JointSolver
{
    private readonly TreeLanes _lanes = new TreeLanes();

    /// <summary>Trees that can go side by side do.</summary>
    public bool UsesLanes { get; set; } = true;

    /// <summary>Trees that none of the last step's passes gave back.</summary>
    public int TreesSideBySide => UsesLanes ? _lanes.GivenCount : 0;

    /// <summary>Joints between single bodies that were iterated side by side in the last step.</summary>
    public int JointsSideBySide => UsesLanes ? _loose.JointCount : 0;

    /// <summary>Moves the trees that can be solved side by side out of the lists of the passes.</summary>
    private void TakeToLanes()
    {
        TakeLoose();
        _lanes.Begin(_forest, _active.Pointer, _rows.Pointer, _step, _active.Capacity);
        ClearOnLanes();
        MarkTied();
        int touched = 0;
        for (int at = 0; at < _treeCount; at++)
        {
            touched += _forest.Trees[_trees[at]].Touched ? 1 : 0;
        }

        // A tree that contacts touch goes there with another such.
        bool alone = touched == 1;
        for (int at = 0; at < _treeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            bool may = UsesLanes && !_step.Drifts && !tree->Disturbed && !(alone && tree->Touched);
            tree->OnLanes = tree->Loose || (may && _lanes.Take(_trees[at]));
        }

        _lanes.LeaveSingles();
        int kept = 0;
        for (int at = 0; at < _treeCount; at++)
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

        if (kept == _treeCount)
        {
            return;
        }

        _treeCount = kept;
        DropAside();
        kept = 0;
        for (int i = 0; i < _agendaCount; i++)
        {
            if (!_forest.Trees[TreeOf(EndsOf(_agenda[i]))].OnLanes)
            {
                _agenda[kept++] = _agenda[i];
            }
            else if (_forest.Trees[TreeOf(EndsOf(_agenda[i]))].Touched)
            {
                _laneAgenda[_laneAgendaCount++] = _agenda[i];
            }
        }

        _agendaCount = kept;
        _lanes.Load();
    }

    /// <summary>Nodes and joints of trees that are solved aside leave the lists.</summary>
    private void DropAside()
    {
        int kept = 0;
        for (int at = 0; at < _nodeCount; at++)
        {
            if (!IsAside(_forest.Nodes[_nodes[at]].Tree))
            {
                _nodes[kept++] = _nodes[at];
            }
        }

        _nodeCount = kept;
        kept = 0;
        for (int at = 0; at < _jointCount; at++)
        {
            if (!IsAside(TreeOf(_active[_joints[at]].Ends)))
            {
                _joints[kept++] = _joints[at];
            }
        }

        _jointCount = kept;
    }

    private bool IsAside(int tree) => _forest.Trees[tree].OnLanes || _forest.Trees[tree].OnChain;

    /// <summary>Finds the trees with rows that are not of their own joints; and those that only contacts with what cannot move push at.</summary>
    private void MarkTied()
    {
        for (int at = 0; at < _treeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->Tied = tree->LoopRows > 0;
            tree->Touched = false;
        }

        for (int i = 0; i < _agendaCount; i++)
        {
            int item = _agenda[i];
            if (item < 0 && IsOrdinary(_contacts.Pointer + ~item))
            {
                _forest.Trees[TreeOf(_contacts[~item].Ends)].Touched = true;
            }
            else if (item < 0 || !_active[item].IsEliminated)
            {
                ref RowEnds ends = ref EndsOf(item);
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

    private int TreeOf(in RowEnds ends) => _forest.Nodes[ends.NodeA >= 0 ? ends.NodeA : ends.NodeB].Tree;

    /// <summary>Puts a tree that was on lanes back into the lists.</summary>
    private void TakeFromLanes(int index)
    {
        JointTree* tree = _forest.Trees + index;
        tree->OnLanes = false;
        TakeContactsFromLanes(tree, index);
        ChooseTree(index);
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            for (int k = 0; k < node->EdgeCount; k++)
            {
                _joints[_jointCount++] = _forest.EdgeJoints[node->EdgeFirst + k];
            }
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            _joints[_jointCount++] = _forest.Anchors[i].Active;
        }
    }

    /// <summary>A pass over the trees on lanes; those that it leaves take part in the same pass of the others.</summary>
    private void SolveLanes(Pass pass, bool again, int sweeps)
    {
        if (_lanes.Any && !again)
        {
            _lanes.Solve(pass != Pass.Biased, sweeps, pass != Pass.Settle);
            TakeLeft(_lanes);
        }
        else if (_lanes.Any)
        {
            _lanes.SolveAgain(pass != Pass.Biased, sweeps);
            TakeLeft(_lanes);
        }

        if (pass != Pass.Settle && !again)
        {
            SolveChains(pass != Pass.Biased);
        }

        SweepOnLanes(pass, sweeps);
        if (_loose.Any)
        {
            _loose.Solve(pass == Pass.Biased, sweeps, wishes: pass == Pass.Settle, limits: true);
        }
    }

    /// <summary>Trees that leave the lanes within a substep get their rows and factor.</summary>
    private void TakeLeft(TreesAside from)
    {
        for (int k = 0; k < from.GivenCount; k++)
        {
            int index = from.Given(k);
            int firstJoint = _jointCount;
            int firstItem = _agendaCount;
            TakeFromLanes(index);
            JointTree* tree = _forest.Trees + index;
            for (int i = tree->First; i < tree->End && from.HasMoved; i++)
            {
                LoadPose(_forest.Nodes + i);
            }

            for (int at = firstJoint; at < _jointCount && from.HasMoved; at++)
            {
                Rewrite(_joints[at]);
            }

            Factor(tree);
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
            _agenda[_agendaCount++] = joint;
        }
    }

    private void PrepareFrom(int first)
    {
        for (int i = first; i < _agendaCount; i++)
        {
            Prepare(_agenda[i]);
        }
    }

    /// <summary>The correction of the trees on lanes; those that went astray are projected with the others.</summary>
    /// <param name="pushed">The store has also moved bodies by velocities that push them apart.</param>
    private void CorrectLanes(bool pushed)
    {
        if (_lanes.Any)
        {
            _lanes.CorrectPositions();
            CorrectOnLanes();
            TakeAstray(_lanes);
        }

        CorrectChains();
        if (_loose.Any)
        {
            _loose.Move(pushed);
        }
    }

    private void TakeAstray(TreesAside from)
    {
        for (int k = 0; k < from.GivenCount; k++)
        {
            int firstJoint = _jointCount;
            TakeFromLanes(from.Given(k));
            TakeAgenda(from, k);
            for (int at = firstJoint; at < _jointCount; at++)
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

            LimitTarget(_active.Pointer + index, _rows.Pointer + index, row, TargetKind.Biased);
        }
    }

    /// <summary>All trees are in the lists again, and their joints tell what they did.</summary>
    private void FinishLanes()
    {
        FinishLoose();
        _lanes.Finish();
        _laneTreeCount = 0;
        _laneAgendaCount = 0;
        for (int k = 0; k < _lanes.GivenCount; k++)
        {
            int firstJoint = _jointCount;
            TakeFromLanes(_lanes.Given(k));
            JointTree* tree = _forest.Trees + _lanes.Given(k);
            bool posed = false;
            for (int at = firstJoint; at < _jointCount; at++)
            {
                if (double.IsInfinity(_active[_joints[at]].Settings.Breakpoint))
                {
                    continue;
                }

                for (int i = tree->First; i < tree->End && !posed; i++)
                {
                    LoadPose(_forest.Nodes + i);
                }

                posed = true;
                WriteJoint(_joints[at]);
            }
        }
    }

    /// <summary>Where a body that the solver does not move is, but for sine and cosine.</summary>
    /// <returns>Its angle.</returns>
    internal static double ReadStill(BodyStore bodies, int body, out double x, out double y)
    {
        ref BodyPose pose = ref bodies.Pose[body];
        ref BodyState state = ref bodies.State[body];
        x = pose.X + state.DeltaPosition.X;
        y = pose.Y + state.DeltaPosition.Y;
        bool still = (bodies.Flags[body] & (BodyFlags.Enabled | BodyFlags.Kinematic)) != (BodyFlags.Enabled | BodyFlags.Kinematic);
        return still ? pose.Angle : pose.Angle + ((double)bodies.Motion[body].Turned + bodies.Drive[body].Lead);
    }

    /// <summary>A correction leads astray: see the thresholds.</summary>
    internal static bool IsAstray(double worst, double before, double bent, bool last)
    {
        bool stuck = worst > Loose && worst > Shrink * before;
        return bent > LargestBend || stuck || (last && worst > Failed) || !FloatBits.IsFinite(worst);
    }
}
