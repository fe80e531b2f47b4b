using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints.Solving;

/// <content>
/// Limits that are let go before they would pull: those that joints from outside push open, and those that the move left open.
/// </content>
internal sealed unsafe partial class TreeLimits
{
    /// <summary>
    /// A joint or contact that pushed at a tree found its impulse with the limits that held. Let go by it, the tree answers more, by a
    /// thousand times if the push goes past a light body's centre, and would be at the other end of its range within the substep. So before
    /// that end holds, the joint or contact is asked again. (Held there, a joint pushed back with the mass of all that hangs on it, the
    /// limit was let go, and so on in each sweep: an arm of 0.1 kg left at a kilometre a second. A box that pressed on a linkage at its
    /// stop sent its links, of a hundredth of the box's mass, to the other one, met them there, and left with four times the energy.)
    /// </summary>
    public static bool IsJustLetGo(ActiveJoint* joint, int row) => joint->LetGo != 0 && joint->LetGo != row + 1;

    private static bool IsPushed(JointTree* tree) => tree->Joined || tree->Pressed;

    private void ForgetLetGo(JointTree* tree)
    {
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            for (int k = 0; k < node->EdgeCount; k++)
            {
                _active[_forest.EdgeJoints[node->EdgeFirst + k]].LetGo = 0;
            }
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            _active[_forest.Anchors[i].Active].LetGo = 0;
        }

        for (int at = tree->LoopFirst; at < tree->LoopEnd; at++)
        {
            _active[_loops.JointAt(at)].LetGo = 0;
        }
    }

    /// <summary>
    /// Notes the trees that an iterated joint pushes at, and those of soft points, whose own limits may be the ones that they open: a body
    /// of 0.3 kg at its stop, 4 m off its soft pivot, left at a kilometre a second.
    /// </summary>
    public void Join(int index)
    {
        ActiveJoint* joint = _active.Pointer + index;
        if (joint->Role == JointRole.Iterated || _rows[index].SoftPoint)
        {
            JoinTree(joint->Ends.NodeA);
            JoinTree(joint->Ends.NodeB);
        }
    }

    private void JoinTree(int node)
    {
        if (node >= 0)
        {
            _forest.Trees[_forest.Nodes[node].Tree].Joined = true;
        }
    }

    /// <summary>
    /// After the move: limits that are open again have nothing to hold. Kept as rows that close at gap over h, what else pushes at the tree
    /// would find them as drives: limbs that lay on each other at the end of a long substep were turned at forty radians a second.
    /// </summary>
    public void LetGoOfOpenLimits()
    {
        for (int at = 0; at < _work.TreeCount && _work.AnyLimits; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (tree->HasLimits)
            {
                LetGoWhere(tree, _letGoIfOpen);
            }
        }
    }

    /// <summary>Lets go of the limits of a tree that would have pulled.</summary>
    /// <returns>True if there were some.</returns>
    public bool LetGoOfPulls(JointTree* tree) => LetGoWhere(tree, _pulls);

    private bool LetGoWhere(JointTree* tree, Func<int, int, bool> goes)
    {
        bool any = false;
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            int held = node->Rows;
            node->Rows = node->HardRows;
            for (int r = node->Rows; r < held; r++)
            {
                if (!goes(node->RowJoint[r], node->RowIndex[r]))
                {
                    node->RowJoint[node->Rows] = node->RowJoint[r];
                    node->RowIndex[node->Rows++] = node->RowIndex[r];
                }
            }

            any |= node->Rows != held;
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = _forest.Anchors + i;
            int held = anchor->Rows;
            anchor->Rows = 0;
            for (int r = 0; r < held; r++)
            {
                if (anchor->RowIndex[r] < _rows[anchor->Active].Hard || !goes(anchor->Active, anchor->RowIndex[r]))
                {
                    anchor->RowIndex[anchor->Rows++] = anchor->RowIndex[r];
                }
            }

            any |= anchor->Rows != held;
        }

        return _solver.LoopLimits.LetGoWhere(tree, goes) || any;
    }

    private bool Pulls(int joint, int row) => _active[joint].Lambda[row] < 0;

    private bool LetGoIfOpen(int joint, int row)
    {
        bool open = IsOpen(_rows.Pointer + joint, row);
        _active[joint].Lambda[row] = open ? 0 : _active[joint].Lambda[row];
        return open;
    }

    /// <summary>It holds at the speed which closes its gap.</summary>
    public static bool IsOpen(JointRows* rows, int row) => rows->Error[row] > TreeRows.Small * rows->SizeOf(row);

    /// <summary>A limit that does not hold is passed within the substep, or is open beyond it and not closing fast enough.</summary>
    public bool IsPassed(ActiveJoint* joint, JointRows* rows, int row, TargetKind kind)
    {
        if (rows->Type[row] != (byte)RowType.Limit || IsJustLetGo(joint, row))
        {
            return false;
        }

        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        Velocity(joint->Ends.NodeA, joint->Ends.BodyA, a);
        Velocity(joint->Ends.NodeB, joint->Ends.BodyB, b);
        double* ja = rows->A + (row * 3);
        double* jb = rows->B + (row * 3);
        double speed = SmallMatrix.Dot(ja, a) + SmallMatrix.Dot(jb, b);
        double terms = Math.Abs(ja[0] * a[0]) + Math.Abs(ja[1] * a[1]) + Math.Abs(ja[2] * a[2])
            + Math.Abs(jb[0] * b[0]) + Math.Abs(jb[1] * b[1]) + Math.Abs(jb[2] * b[2]);
        double rounding = SpeedRounding * terms;

        // A limit that is its bodies' only tie holds in a tie as well: a pair that whirls at the end of its rope would be past it by the
        // bend of its way.
        double target = LimitTarget(joint, rows, row, kind);
        return _solver.Overruns.TreeOfLimits(joint) != null ? speed <= target + rounding : speed < target - rounding;
    }

    private void Velocity(int node, int body, double* v)
    {
        if (node >= 0)
        {
            double* from = _forest.Nodes[node].Velocity;
            v[0] = from[0];
            v[1] = from[1];
            v[2] = from[2];
            return;
        }

        ref Bodies.BodyState state = ref _work.Step.Bodies.State[body];
        v[0] = state.LinearVelocity.X;
        v[1] = state.LinearVelocity.Y;
        v[2] = state.AngularVelocity;
    }

    /// <summary>The speed at which a limit that holds moves: it is reached just now, or an overrun goes back by a share.</summary>
    public double LimitTarget(ActiveJoint* joint, JointRows* rows, int row, TargetKind kind)
    {
        double gap = rows->Error[row];
        double h = _work.Step.Substep;
        if (kind == TargetKind.Pull && _solver.Overruns.TreeOfLimits(joint) != null)
        {
            return -Math.Min(0, TreeRows.PullSpeed(rows, row, _work.Step));
        }

        if (TreeRows.IsDisplacement(kind))
        {
            return (joint->Goal[row] - gap) / h;
        }

        if (gap > 0)
        {
            joint->Goal[row] = 0;
            return kind == TargetKind.Relaxed && IsOpen(rows, row) ? double.NegativeInfinity : -gap / h;
        }

        if (kind == TargetKind.Relaxed)
        {
            return 0;
        }

        double over = Math.Min(0, gap + rows->Share[row]);
        if (_solver.Overruns.HoldsOverrun(joint, -over / rows->SizeOf(row)))
        {
            joint->Goal[row] = gap;
            return 0;
        }

        double back = -_work.Step.Pace.Recovery * over / h;
        bool turns = rows->A[row * 3] == 0 && rows->A[(row * 3) + 1] == 0;
        back = turns ? Math.Min(back, FastestReturn) : back;
        joint->Goal[row] = gap + (back * h);
        return back;
    }
}
