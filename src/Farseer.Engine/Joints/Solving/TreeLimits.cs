using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>
/// The solution of the trees, and which of their limits hold: an active set, found by the signs of the multipliers. A limit that
/// holds is one more row of its block; no iteration is as stiff.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe partial class TreeLimits : JointPart
{
    public const int LimitRounds = 6;

    internal const int ReleaseRounds = 4;

    /// <summary>Share of the speeds in a row below which a difference is rounding.</summary>
    public const double SpeedRounding = 1e-9;

    /// <summary>The fastest return from an overrun, rad/s.</summary>
    internal const double FastestReturn = 10;

    private readonly Func<int, int, bool> _letGoIfOpen;
    private readonly Func<int, int, bool> _pulls;

    public TreeLimits(JointSolver solver, JointWork work)
        : base(solver, work)
    {
        _letGoIfOpen = LetGoIfOpen;
        _pulls = Pulls;
    }

    /// <param name="kind">What the rows are to reach.</param>
    /// <param name="again">The trees have been solved in this pass: only limits at rows may have changed since.</param>
    /// <returns>True if other limits hold than before.</returns>
    public bool SolveTrees(TargetKind kind, bool again)
    {
        bool refactored = false;
        for (int at = 0; at < _work.TreeCount; at++)
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

        return _solver.LoopLimits.Turn(tree, kind);
    }

    public void SolveTree(JointTree* tree, TargetKind kind)
    {
        if (!tree->HasLimits)
        {
            _solver.Rows.SetTargets(tree, kind);
            _loops.Solve(tree);
            TreeReactions.OfSolve(_forest, tree);
            _solver.Responses.Give(tree);
            return;
        }

        Save(tree);
        for (int round = 0; ; round++)
        {
            _solver.Rows.SetTargets(tree, kind);
            _loops.Solve(tree);
            TreeReactions.OfSolve(_forest, tree);
            if (round == LimitRounds - 1 || !ReviseLimits(tree, kind, round < ReleaseRounds))
            {
                if (round > 0)
                {
                    ForgetLetGo(tree);
                }

                break;
            }

            Restore(tree);
            _solver.Responses.Factor(tree);
            tree->Refactored = true;
        }

        _solver.Responses.Give(tree);
    }

    /// <summary>The masses of trees whose limits changed, and the responses of their rows; their groups are marked.</summary>
    private void PrepareAgain()
    {
        _solver.Sweeps.ClearGroups();
        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            _forest.Trees[tree->Group].GroupActs |= tree->Refactored;
            if (tree->Refactored && tree->HasRows)
            {
                TreeFactor.CompleteMasses(_forest, tree);
            }
        }

        for (int i = 0; i < _work.AgendaCount; i++)
        {
            int item = _agenda[i];
            ref RowEnds ends = ref _solver.Sweeps.EndsOf(item);
            if (IsRefactored(ends.NodeA) || IsRefactored(ends.NodeB))
            {
                _solver.Sweeps.Prepare(item);
            }
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            _forest.Trees[i].Refactored = false;
        }
    }

    private bool IsRefactored(int node) => node >= 0 && _forest.Trees[_forest.Nodes[node].Tree].Refactored;

    /// <summary>Multipliers of limits are sums over a substep: they start at 0.</summary>
    public void ForgetLimits()
    {
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            if (_active[i].BlockLimits && _active[i].Pivot == PivotKind.Limited)
            {
                _active[i].Lambda[TreeRows.LowerRow] = 0;
                _active[i].Lambda[TreeRows.UpperRow] = 0;
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

    public void Save(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            node->Saved[0] = node->Velocity[0];
            node->Saved[1] = node->Velocity[1];
            node->Saved[2] = node->Velocity[2];
        }
    }

    public void Restore(JointTree* tree)
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
    public bool ReviseLimits(JointTree* tree, TargetKind kind, bool release)
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

        return (release && _solver.LoopLimits.Release(tree)) || _solver.LoopLimits.Lock(tree, kind) || changed;
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
                int passed = _solver.Rows.FindTurnedPast(_active.Pointer + index, rows, kind);
                if (passed >= 0)
                {
                    return passed;
                }

                continue;
            }

            for (int row = rows->Hard; row < rows->Count && _active[index].BlockLimits; row++)
            {
                if (!HoldsRow(node, index, rows, row) && IsPassed(_active.Pointer + index, rows, row, kind))
                {
                    return row;
                }
            }
        }

        return -1;
    }

    /// <summary>The limit holds, or that at the other end of its range.</summary>
    private static bool HoldsRow(TreeNode* node, int joint, JointRows* rows, int row)
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
    public void TakeBack(int index, int row)
    {
        ActiveJoint* joint = _active.Pointer + index;
        joint->LetGo = IsPushed(_forest.Trees + _forest.TreeOf(joint->Ends)) ? row + 1 : 0;
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
}
