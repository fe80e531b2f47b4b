using System;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>
/// The solution of the trees, and which of their limits hold: an active set, found by the signs of the multipliers. A limit that
/// holds is one more row of its block; no iteration is as stiff.
/// </content>
internal sealed unsafe partial class JointSolver
{
    internal const int LimitRounds = 6;
    internal const int ReleaseRounds = 4;

    /// <summary>Share of the speeds in a row below which a difference is rounding.</summary>
    internal const double SpeedRounding = 1e-9;

    /// <summary>The fastest return from an overrun, rad/s.</summary>
    internal const double FastestReturn = 10;

    /// <param name="kind">What the rows are to reach.</param>
    /// <param name="again">The trees have been solved in this pass: only limits at rows may have changed since.</param>
    /// <returns>True if other limits hold than before.</returns>
    private bool SolveTrees(TargetKind kind, bool again)
    {
        bool refactored = false;
        for (int at = 0; at < _treeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            if (!tree->Eliminates || (again && !(tree->HasLimits && tree->HasRows && LimitsTurn(tree, kind))))
            {
                continue;
            }

            SolveTree(tree, kind);
            refactored |= tree->Refactored;
        }

        if (refactored)
        {
            PrepareAgain();
        }

        return refactored;
    }

    /// <summary>
    /// After rows have pushed: whether a limit that holds would pull, or another is passed. If not, the tree meets its joints as it is,
    /// since impulses go through it along with them, and to solve it again would change nothing but roundings.
    /// </summary>
    private bool LimitsTurn(JointTree* tree, TargetKind kind)
    {
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            for (int r = node->HardRows; r < node->Rows; r++)
            {
                if (_active[node->RowJoint[r]].Lambda[node->RowIndex[r]] < 0)
                {
                    return true;
                }
            }

            if (node->HasLimits && FindPassed(node, kind, out _) >= 0)
            {
                return true;
            }
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = _forest.Anchors + i;
            if (!_active[anchor->Active].BlockLimits)
            {
                continue;
            }

            int hard = _rows[anchor->Active].Hard;
            for (int r = hard; r < anchor->Rows; r++)
            {
                if (_active[anchor->Active].Lambda[anchor->RowIndex[r]] < 0)
                {
                    return true;
                }
            }

            if (FindPassed(anchor, kind) >= 0)
            {
                return true;
            }
        }

        return false;
    }

    private void SolveTree(JointTree* tree, TargetKind kind)
    {
        if (!tree->HasLimits)
        {
            SetTargets(tree, kind);
            _loops.Solve(tree);
            TreeReactions.OfSolve(_forest, tree);
            Give(tree);
            return;
        }

        Save(tree);
        for (int round = 0; ; round++)
        {
            SetTargets(tree, kind);
            _loops.Solve(tree);
            TreeReactions.OfSolve(_forest, tree);
            if (round == LimitRounds - 1 || !ReviseLimits(tree, kind, round < ReleaseRounds))
            {
                break;
            }

            Restore(tree);
            Factor(tree);
            tree->Refactored = true;
        }

        ForgetLetGo(tree);
        Give(tree);
    }

    /// <summary>The masses of trees whose limits changed, and the responses of their rows; their groups are marked.</summary>
    private void PrepareAgain()
    {
        ClearGroups();
        for (int at = 0; at < _treeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            _forest.Trees[tree->Group].GroupActs |= tree->Refactored;
            if (tree->Refactored && tree->HasRows)
            {
                TreeFactor.CompleteMasses(_forest, tree);
            }
        }

        for (int i = 0; i < _agendaCount; i++)
        {
            int item = _agenda[i];
            ref RowEnds ends = ref EndsOf(item);
            if (IsRefactored(ends.NodeA) || IsRefactored(ends.NodeB))
            {
                Prepare(item);
            }
        }

        for (int at = 0; at < _treeCount; at++)
        {
            int i = _trees[at];
            _forest.Trees[i].Refactored = false;
        }
    }

    private bool IsRefactored(int node) => node >= 0 && _forest.Trees[_forest.Nodes[node].Tree].Refactored;

    /// <summary>Multipliers of limits are sums over a substep: they start at 0.</summary>
    private void ForgetLimits()
    {
        for (int at = 0; at < _jointCount; at++)
        {
            int i = _joints[at];
            if (_active[i].BlockLimits && _active[i].Pivot == PivotKind.Limited)
            {
                _active[i].Lambda[LowerRow] = 0;
                _active[i].Lambda[UpperRow] = 0;
            }
            else if (_active[i].BlockLimits)
            {
                for (int k = _rows[i].Hard; k < _rows[i].Count; k++)
                {
                    _active[i].Lambda[k] = _rows[i].Type[k] == (byte)RowType.Limit ? 0 : _active[i].Lambda[k];
                }
            }
        }
    }

    private void Save(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            node->Saved[0] = node->Velocity[0];
            node->Saved[1] = node->Velocity[1];
            node->Saved[2] = node->Velocity[2];
        }
    }

    private void Restore(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            node->Velocity[0] = node->Saved[0];
            node->Velocity[1] = node->Saved[1];
            node->Velocity[2] = node->Saved[2];
        }
    }

    /// <summary>
    /// Lets go of limits that pull, and holds those that are being passed. What was just let go still stands where the limit held it:
    /// whether it is being passed is for the next round to see, not for the rounding of that standstill. A limit that would pull in
    /// all has pushed in an earlier pass of the substep; that push is taken back, or an overrun would go on at the speed of its
    /// return and cross the whole way to the other limit.
    /// </summary>
    /// <returns>True if the set changed.</returns>
    private bool ReviseLimits(JointTree* tree, TargetKind kind, bool release)
    {
        bool changed = false;
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            if (node->HasLimits)
            {
                changed |= (release && ReleaseEdge(node)) || LockEdge(node, kind);
            }
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = _forest.Anchors + i;
            if (_active[anchor->Active].BlockLimits)
            {
                changed |= (release && ReleaseAnchor(anchor)) || LockAnchor(anchor, kind);
            }
        }

        return changed;
    }

    private bool ReleaseEdge(TreeNode* node)
    {
        int kept = node->HardRows;
        for (int r = node->HardRows; r < node->Rows; r++)
        {
            int joint = node->RowJoint[r];
            int row = node->RowIndex[r];
            if (_active[joint].Lambda[row] + node->Edge[r] >= 0)
            {
                node->RowJoint[kept] = joint;
                node->RowIndex[kept++] = row;
            }
            else
            {
                TakeBack(joint, row);
            }
        }

        bool changed = kept != node->Rows;
        node->Rows = kept;
        return changed;
    }

    private bool LockEdge(TreeNode* node, TargetKind kind)
    {
        bool changed = false;
        for (int row = FindPassed(node, kind, out int index); row >= 0; row = FindPassed(node, kind, out index))
        {
            node->RowJoint[node->Rows] = index;
            node->RowIndex[node->Rows++] = row;
            changed = true;
        }

        return changed;
    }

    /// <summary>A limit of an edge that is passed and does not hold yet, if there is room for it.</summary>
    /// <returns>Its row in the joint, -1: none.</returns>
    private int FindPassed(TreeNode* node, TargetKind kind, out int index)
    {
        index = -1;
        for (int k = 0; k < node->EdgeCount && node->Rows < TreeFactor.MostRows; k++)
        {
            index = _forest.EdgeJoints[node->EdgeFirst + k];
            JointRows* rows = _rows.Pointer + index;
            if (_active[index].Pivot == PivotKind.Limited && _active[index].BlockLimits)
            {
                // Two rows of the block are its own, so neither limit holds if there is room.
                int passed = FindTurnedPast(_active.Pointer + index, rows, kind);
                if (passed >= 0)
                {
                    return passed;
                }

                continue;
            }

            for (int row = rows->Hard; row < rows->Count && _active[index].BlockLimits; row++)
            {
                if (!Holds(node, index, rows, row) && IsPassed(_active.Pointer + index, rows, row, kind))
                {
                    return row;
                }
            }
        }

        return -1;
    }

    /// <summary>The limit holds, or that at the other end of its range.</summary>
    private static bool Holds(TreeNode* node, int joint, JointRows* rows, int row)
    {
        for (int r = node->HardRows; r < node->Rows; r++)
        {
            if (node->RowJoint[r] == joint && rows->BoundSame(node->RowIndex[r], row))
            {
                return true;
            }
        }

        return false;
    }

    private bool ReleaseAnchor(TreeAnchor* anchor)
    {
        int hard = _rows[anchor->Active].Hard;
        int kept = hard;
        for (int r = hard; r < anchor->Rows; r++)
        {
            int row = anchor->RowIndex[r];
            if (_active[anchor->Active].Lambda[row] + anchor->Lambda[r] >= 0)
            {
                anchor->RowIndex[kept++] = row;
            }
            else
            {
                TakeBack(anchor->Active, row);
            }
        }

        bool changed = kept != anchor->Rows;
        anchor->Rows = kept;
        return changed;
    }

    /// <summary>Takes what a row gave in the substep from the velocities that the next round starts from.</summary>
    private void TakeBack(int index, int row)
    {
        ActiveJoint* joint = _active.Pointer + index;
        joint->LetGo = _forest.Trees[TreeOf(joint->Ends)].Joined ? row + 1 : 0;
        double push = joint->Lambda[row];
        if (push == 0)
        {
            return;
        }

        JointRows* rows = _rows.Pointer + index;
        TakeBack(joint->Ends.NodeA, rows->A + (row * 3), push);
        TakeBack(joint->Ends.NodeB, rows->B + (row * 3), push);
        for (int i = 0; i < 3; i++)
        {
            joint->Given[i] -= rows->B[(row * 3) + i] * push;
        }

        joint->Lambda[row] = 0;
    }

    private void TakeBack(int node, double* j, double push)
    {
        if (node >= 0)
        {
            TreeNode* n = _forest.Nodes + node;
            n->Saved[0] -= n->InverseMass * j[0] * push;
            n->Saved[1] -= n->InverseMass * j[1] * push;
            n->Saved[2] -= n->InverseInertia * j[2] * push;
        }
    }

    private bool LockAnchor(TreeAnchor* anchor, TargetKind kind)
    {
        bool changed = false;
        for (int row = FindPassed(anchor, kind); row >= 0; row = FindPassed(anchor, kind))
        {
            anchor->RowIndex[anchor->Rows++] = row;
            changed = true;
        }

        return changed;
    }

    private int FindPassed(TreeAnchor* anchor, TargetKind kind)
    {
        JointRows* rows = _rows.Pointer + anchor->Active;
        for (int row = rows->Hard; row < rows->Count && anchor->Rows < TreeFactor.MostRows; row++)
        {
            bool held = false;
            for (int r = rows->Hard; r < anchor->Rows; r++)
            {
                held |= rows->BoundSame(anchor->RowIndex[r], row);
            }

            if (!held && IsPassed(_active.Pointer + anchor->Active, rows, row, kind))
            {
                return row;
            }
        }

        return -1;
    }

    /// <summary>A limit that does not hold is passed within the substep, or is open beyond it and not closing fast enough.</summary>
    private bool IsPassed(ActiveJoint* joint, JointRows* rows, int row, TargetKind kind)
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

        // A limit that is its bodies' only tie holds in a tie as well: a pair that whirls at the end of its rope would be past it by the bend of its way.
        double target = LimitTarget(joint, rows, row, kind);
        return TreeOfLimits(joint) != null ? speed <= target + rounding : speed < target - rounding;
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

        ref Bodies.BodyState state = ref _step.Bodies.State[body];
        v[0] = state.LinearVelocity.X;
        v[1] = state.LinearVelocity.Y;
        v[2] = state.AngularVelocity;
    }

    /// <summary>The speed at which a limit that holds moves: it is reached just now, or an overrun goes back by a share.</summary>
    private double LimitTarget(ActiveJoint* joint, JointRows* rows, int row, TargetKind kind)
    {
        double gap = rows->Error[row];
        double h = _step.Substep;
        if (kind == TargetKind.Pull && TreeOfLimits(joint) != null)
        {
            return -Math.Min(0, PullSpeed(rows, row, _step));
        }

        if (IsDisplacement(kind))
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
        if (HoldsOverrun(joint, -over / rows->SizeOf(row)))
        {
            joint->Goal[row] = gap;
            return 0;
        }

        double back = -JointPass.LimitRecovery * over / h;
        bool turns = rows->A[row * 3] == 0 && rows->A[(row * 3) + 1] == 0;
        back = turns ? Math.Min(back, FastestReturn) : back;
        joint->Goal[row] = gap + (back * h);
        return back;
    }
}
