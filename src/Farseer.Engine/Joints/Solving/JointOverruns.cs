using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>
/// Overruns of limits that came from outside: a body was put elsewhere, a limit was set anew, a joint came late. As a speed, a fifth of the
/// overrun a substep, such a return turned what it pulled at faster than one relaxing pass follows, and what was left of it flew on: 0.1 kg
/// put 2.4 beyond a slider's end at up to 144 a second. So the limit stands where it was found, and goes back to its place by
/// displacements.
/// </summary>
[NotState(Why.Fixed)]
internal sealed unsafe partial class JointOverruns : JointPart
{
    public JointOverruns(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>
    /// Where the step begins: what a limit is past by a jump since the end of the step before came from outside. What a body's own way
    /// brought is not among it: a pair that whirls at its slider's end is past that by the bend of its way in each substep, and would lose
    /// its momentum.
    /// </summary>
    public void FindOverruns()
    {
        for (int i = 0; i < _work.Count && _chains.QuietJoints < _work.Count; i++)
        {
            if (_active[i].Limited && !_solver.Chains.IsQuiet(i) && !_work.Step.Drifts && !IsEdge(_active.Pointer + i))
            {
                FindOverrun(_active.Pointer + i, _rows.Pointer + i, ref _store.Ranges[_active[i].Joint]);
            }
        }
    }

    /// <summary>Its limits belong to the blocks of a tree with edges of limits, which displaces them itself.</summary>
    private bool IsEdge(ActiveJoint* joint) => joint->BlockLimits && TreeOfLimits(joint) != null;

    private static void FindOverrun(ActiveJoint* joint, JointRows* rows, ref JointRange range)
    {
        for (int k = rows->Hard, limit = 0; k < rows->Count && limit < JointRange.MostLimits; k++)
        {
            if (!IsRigidLimit(rows, k))
            {
                continue;
            }

            double least = TreeRows.Small * rows->SizeOf(k);
            double gap = rows->Error[k];
            double outside = range.Outside[limit];
            if (range.Known)
            {
                double jump = gap - range.Gap[limit];
                outside += jump < -least ? jump : 0;
            }
            else
            {
                outside = gap < -least ? gap : 0;
            }

            joint->Outside[k] = Math.Max(outside, Overrun(rows, k, gap));
            joint->Overrun |= joint->Outside[k] < 0;
            limit++;
        }

        for (int k = rows->Hard; k < rows->Count && joint->Overrun; k++)
        {
            rows->Error[k] -= joint->Outside[k];
        }
    }

    private static bool IsRigidLimit(JointRows* rows, int k) => rows->Type[k] == (byte)RowType.Limit && rows->Damping[k] == 0;

    /// <summary>How far a limit is past its slack; 0: not.</summary>
    private static double Overrun(JointRows* rows, int k, double gap) => Math.Min(0, gap + rows->Share[k]);

    /// <summary>
    /// Limits that stand aside are rows of the tree and not of its blocks: of several that contradict each other a block would make one far
    /// displacement, a few sweeps make none.
    /// </summary>
    public void FreeOverruns()
    {
        _work.Overruns = 0;
        _work.AnyLimits = false;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            _forest.Trees[_trees[at]].Overrun = false;
        }

        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            _work.AnyLimits |= _active[i].Limited;
            if (_active[i].Overrun)
            {
                _work.Overruns++;
                MarkOverrun(_active[i].Ends.NodeA);
                MarkOverrun(_active[i].Ends.NodeB);
                if (_active[i].BlockLimits)
                {
                    _active[i].BlockLimits = false;
                    LetGo(i);
                }
            }
        }
    }

    private void MarkOverrun(int node)
    {
        if (node >= 0)
        {
            _forest.Trees[_forest.Nodes[node].Tree].Overrun = true;
        }
    }

    /// <summary>
    /// Displacements go along the joints' directions at their start: where one would turn a body further than that is good for, its group
    /// goes a share of the way. A chain that is almost straight answers a pull along itself by a far wider bend.
    /// </summary>
    public void BoundTurns()
    {
        double h = _work.Step.Substep;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            _forest.Trees[_trees[at]].Turned = 0;
            _forest.Trees[_trees[at]].GroupPulls = false;
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            JointTree* group = _forest.Trees + tree->Group;
            group->GroupPulls |= tree->Overrun;
            for (int i = tree->First; i < tree->End && TreePositions.Yields(tree); i++)
            {
                group->Turned = Math.Max(group->Turned, Math.Abs(h * _forest.Nodes[i].Velocity[2]));
            }
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            JointTree* group = _forest.Trees + tree->Group;
            for (int i = tree->First; i < tree->End && group->GroupPulls && group->Turned > TreePositions.LargestBend; i++)
            {
                double share = TreePositions.LargestBend / group->Turned;
                double* v = _forest.Nodes[i].Velocity;
                v[0] *= share;
                v[1] *= share;
                v[2] *= share;
            }
        }
    }

    /// <summary>
    /// What displacements along straight lines left of the joints of a tree is taken out at once: it would be a speed in the next substep.
    /// </summary>
    public void CloseDisplaced()
    {
        for (int at = 0; at < _work.TreeCount; at++)
        {
            if (IsClosed(_forest.Trees + _trees[at]))
            {
                _solver.Limits.Save(_forest.Trees + _trees[at]);
            }
        }

        bool any = true;
        for (int round = 0; round < TreeProjection.TrueProjections && any; round++)
        {
            any = false;
            _solver.Bodies.LoadPoses();
            _solver.Rows.WriteRows(false);
            for (int at = 0; at < _work.TreeCount; at++)
            {
                JointTree* tree = _forest.Trees + _trees[at];
                any |= IsClosed(tree) && Close(tree);
            }
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            if (IsClosed(_forest.Trees + _trees[at]))
            {
                _solver.Limits.Restore(_forest.Trees + _trees[at]);
            }
        }
    }

    private bool IsClosed(JointTree* tree) => tree->Eliminates && !tree->Disturbed && _forest.Trees[tree->Group].GroupPulls;

    /// <returns>True if there was something to close.</returns>
    private bool Close(JointTree* tree)
    {
        _solver.Rows.SetTargets(tree, TargetKind.Projection);
        if (tree->Worst <= TreePositions.Tolerance)
        {
            return false;
        }

        _solver.Responses.Factor(tree);
        _solver.Positions.Clear(tree);
        _solver.Rows.SetTargets(tree, TargetKind.Projection);
        _loops.Solve(tree);
        _solver.Projection.MoveTree(tree);
        return true;
    }

    /// <summary>No limit of a joint holds in its block.</summary>
    private void LetGo(int index)
    {
        JointTree* tree = _forest.Trees + _forest.TreeOf(_active[index].Ends);
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            int kept = node->HardRows;
            for (int r = node->HardRows; r < node->Rows; r++)
            {
                if (node->RowJoint[r] != index)
                {
                    node->RowJoint[kept] = node->RowJoint[r];
                    node->RowIndex[kept++] = node->RowIndex[r];
                }
            }

            node->Rows = kept;
        }

        for (int row = tree->FirstLoopLimit, end = _loops.ReleaseAll(tree); row < end; row++)
        {
            if (_loops.JointOf(row) != index)
            {
                _loops.Keep(tree, row);
            }
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = _forest.Anchors + i;
            if (anchor->Active == index)
            {
                anchor->Rows = _rows[index].Hard;
            }
        }
    }

    /// <summary>Before bodies are displaced: where the limits stand.</summary>
    public void NoteLimits()
    {
        _solver.Bodies.LoadPoses();
        _solver.Rows.WriteErrors();
        for (int at = 0; at < _work.JointCount; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            if (joint->Limited)
            {
                TreePositions.Copy(_rows.Pointer[_joints[at]].Error, joint->Stood, JointRows.Most);
            }
        }
    }

    /// <summary>What displacements did to the limits is none of the bodies' motion either.</summary>
    public void FollowDisplacements()
    {
        _solver.Bodies.LoadPoses();
        _solver.Rows.WriteErrors();
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            if (!_active[i].Limited || _work.Step.Drifts || IsEdge(_active.Pointer + i))
            {
                continue;
            }

            ActiveJoint* joint = _active.Pointer + i;
            JointRows* rows = _rows.Pointer + i;
            for (int k = rows->Hard; k < rows->Count; k++)
            {
                double change = rows->Error[k] - joint->Stood[k];
                if (IsRigidLimit(rows, k) && (joint->Outside[k] < 0 || change < -TreePositions.Loose * rows->SizeOf(k)))
                {
                    SetOutside(joint, rows, k, joint->Outside[k] + change);
                }
            }
        }
    }

    /// <summary>A limit that its body comes back from by itself follows it.</summary>
    public void EaseOverruns()
    {
        for (int at = 0; at < _work.JointCount && _work.AnyLimits; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            JointRows* rows = _rows.Pointer + _joints[at];
            for (int k = rows->Hard; k < rows->Count && joint->Overrun; k++)
            {
                if (joint->Outside[k] < 0)
                {
                    SetOutside(joint, rows, k, joint->Outside[k]);
                }
            }

            if (joint->Limited)
            {
                TreePositions.Copy(rows->Error, joint->Stood, JointRows.Most);
            }
        }
    }

    /// <summary>A limit stands so far aside, but not further than it is past.</summary>
    private static void SetOutside(ActiveJoint* joint, JointRows* rows, int k, double outside)
    {
        double gap = rows->Error[k] + joint->Outside[k];
        outside = Math.Max(Math.Min(0, outside), Overrun(rows, k, gap));
        rows->Error[k] = gap - outside;
        joint->Outside[k] = outside;
        joint->Overrun |= outside < 0;
    }

    /// <summary>Keeps for the next step where the limits are, and how far they stand aside.</summary>
    public void KeepRange(int index)
    {
        ActiveJoint* joint = _active.Pointer + index;
        JointRows* rows = _rows.Pointer + index;
        ref JointRange range = ref _store.Ranges[joint->Joint];
        for (int k = rows->Hard, limit = 0; k < rows->Count && limit < JointRange.MostLimits; k++)
        {
            if (IsRigidLimit(rows, k))
            {
                range.Gap[limit] = joint->Stood[k] + joint->Outside[k];
                range.Outside[limit++] = joint->Outside[k];
                joint->Outside[k] = 0;
            }
        }

        range.Known = true;
        joint->Overrun = false;
        joint->BlockLimits = _solver.Collection.HasRoom(index);
    }
}
