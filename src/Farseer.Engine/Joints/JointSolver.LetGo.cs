using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>Limits that are let go before they would pull: those that joints from outside push open, and those that the move left open.</content>
internal sealed unsafe partial class JointSolver
{
    /// <summary>
    /// A joint that pushed at a tree found its impulse with the limits that held. Let go by it, the tree answers more, by a thousand times if the push goes past a
    /// light body's centre, and would be at the other end of its range within the substep. So before that end holds, the joint is asked again. (Held there, the
    /// joint pushed back with the mass of all that hangs on it, the limit was let go, and so on in each sweep: an arm of 0.1 kg left at a kilometre a second.)
    /// </summary>
    private static bool IsJustLetGo(ActiveJoint* joint, int row) => joint->LetGo != 0 && joint->LetGo != row + 1;

    private void ForgetLetGo(JointTree* tree)
    {
        if (!tree->Joined)
        {
            return;
        }

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
    }

    /// <summary>
    /// Notes the trees that an iterated joint pushes at, and those of soft points, whose own limits may be the ones that they open: a body of 0.3 kg at its stop, 4 m off its
    /// soft pivot, left at a kilometre a second.
    /// </summary>
    private void Join(int index)
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
    /// After the move: limits that are open again have nothing to hold. Kept as rows that close at gap over h, what else pushes at the tree would
    /// find them as drives: limbs that lay on each other at the end of a long substep were turned at forty radians a second.
    /// </summary>
    private void LetGoOfOpenLimits()
    {
        for (int at = 0; at < _treeCount && _anyLimits; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            for (int i = tree->First + 1; i < tree->End && tree->HasLimits; i++)
            {
                TreeNode* node = _forest.Nodes + i;
                int kept = node->HardRows;
                for (int r = node->HardRows; r < node->Rows; r++)
                {
                    if (!LetGoIfOpen(node->RowJoint[r], node->RowIndex[r]))
                    {
                        node->RowJoint[kept] = node->RowJoint[r];
                        node->RowIndex[kept++] = node->RowIndex[r];
                    }
                }

                node->Rows = kept;
            }

            for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
            {
                TreeAnchor* anchor = _forest.Anchors + i;
                int kept = 0;
                for (int r = 0; r < anchor->Rows; r++)
                {
                    if (anchor->RowIndex[r] < _rows[anchor->Active].Hard || !LetGoIfOpen(anchor->Active, anchor->RowIndex[r]))
                    {
                        anchor->RowIndex[kept++] = anchor->RowIndex[r];
                    }
                }

                anchor->Rows = kept;
            }
        }
    }

    private bool LetGoIfOpen(int joint, int row)
    {
        bool open = IsOpen(_rows.Pointer + joint, row);
        _active[joint].Lambda[row] = open ? 0 : _active[joint].Lambda[row];
        return open;
    }

    private static bool IsOpen(JointRows* rows, int row) => rows->Error[row] > Small * rows->SizeOf(row);
}
