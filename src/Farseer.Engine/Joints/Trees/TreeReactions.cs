namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The impulses of eliminated joints, which the elimination itself never forms. An edge's multiplier is E times the residual of the
/// way down. An anchor, eliminated first, answers all that its body gets later: λ = H·residual - H S Y q with the sum q of those
/// impulses. In a walk, what passes through a body has λ = -Gᵀ·through - E Sₚ·(change of the parent).
/// </summary>
internal static unsafe class TreeReactions
{
    /// <summary>Adds the multipliers of the last <see cref="TreeSolve"/> to the joints.</summary>
    public static void AddSolve(JointForest forest, ActiveJoint* active, JointRows* rows)
    {
        Clear(forest);
        Finish(forest, active, rows, true);
    }

    /// <summary>Adds the multipliers of the last walk to the joints.</summary>
    public static void AddWalk(JointForest forest, ActiveJoint* active, JointRows* rows)
    {
        TreeNode* nodes = forest.Nodes;
        double* fall = stackalloc double[3];
        double* answer = stackalloc double[3];
        for (int i = 0; i < forest.Count; i++)
        {
            TreeNode* node = nodes + i;
            if (node->Parent < 0)
            {
                continue;
            }

            TreeNode* parent = nodes + node->Parent;
            for (int r = 0; r < node->Rows; r++)
            {
                double* s = node->ParentS + (r * 3);
                fall[r] = (s[0] * (parent->Velocity[0] - parent->Start[0])) + (s[1] * (parent->Velocity[1] - parent->Start[1]))
                    + (s[2] * (parent->Velocity[2] - parent->Start[2]));
            }

            TreeSolve.Multiply(node->E, fall, node->Rows, answer);
            for (int r = 0; r < node->Rows; r++)
            {
                node->Edge[r] = -SmallMatrix.Dot(node->G + (r * 3), node->Through) - answer[r];
            }
        }

        Finish(forest, active, rows, false);
    }

    private static void Clear(JointForest forest)
    {
        for (int i = 0; i < forest.Count; i++)
        {
            TreeNode* node = forest.Nodes + i;
            node->Got[0] = 0;
            node->Got[1] = 0;
            node->Got[2] = 0;
        }
    }

    private static void Finish(JointForest forest, ActiveJoint* active, JointRows* rows, bool solved)
    {
        TreeNode* nodes = forest.Nodes;
        for (int i = 0; i < forest.Count; i++)
        {
            TreeNode* node = nodes + i;
            if (node->Parent >= 0)
            {
                Push(node->ChildS, node->Edge, node->Rows, node->Got);
                Push(node->ParentS, node->Edge, node->Rows, nodes[node->Parent].Got);
                GiveEdge(node, forest.EdgeJoints, active, rows);
            }
        }

        for (int i = forest.AnchorCount - 1; i >= 0; i--)
        {
            TreeAnchor* anchor = forest.Anchors + i;
            TreeNode* node = nodes + anchor->Node;
            if (solved)
            {
                TreeSolve.Multiply(anchor->H, anchor->Residual, anchor->Rows, anchor->Lambda);
            }

            for (int r = 0; r < anchor->Rows; r++)
            {
                anchor->Lambda[r] = (solved ? anchor->Lambda[r] : 0) - SmallMatrix.Dot(anchor->Gain + (r * 3), node->Got);
            }

            Push(anchor->S, anchor->Lambda, anchor->Rows, node->Got);
            Push(rows[anchor->Active].B, anchor->Lambda, anchor->Rows, active[anchor->Active].Given);
        }
    }

    private static void GiveEdge(TreeNode* node, int* edgeJoints, ActiveJoint* active, JointRows* rows)
    {
        int at = 0;
        for (int k = 0; k < node->EdgeCount; k++)
        {
            int index = edgeJoints[node->EdgeFirst + k];
            Push(rows[index].B, node->Edge + at, rows[index].Hard, active[index].Given);
            at += rows[index].Hard;
        }
    }

    /// <summary>r += sᵀ·λ.</summary>
    private static void Push(double* s, double* lambda, int rows, double* r)
    {
        for (int i = 0; i < rows; i++)
        {
            r[0] += s[i * 3] * lambda[i];
            r[1] += s[(i * 3) + 1] * lambda[i];
            r[2] += s[(i * 3) + 2] * lambda[i];
        }
    }
}
