using System.Runtime.CompilerServices;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The impulses of eliminated joints, which the elimination itself never forms. An edge's multiplier is E times the residual of the
/// way down. An anchor, eliminated first, answers all that its body gets later: λ = H·residual - H S Y q with the sum q of those
/// impulses. In a walk, what passes through a body has λ = -Gᵀ·through - E Sₚ·(change of the parent).
/// </summary>
internal static unsafe class TreeReactions
{
    /// <summary>Finds the multipliers of the last <see cref="TreeSolve"/>.</summary>
    public static void OfSolve(JointForest forest, JointTree* tree)
    {
        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeNode* node = forest.Nodes + forest.Anchors[i].Node;
            node->Got[0] = 0;
            node->Got[1] = 0;
            node->Got[2] = 0;
        }

        Finish(forest, tree, true);
    }

    /// <summary>
    /// Ends a walk and adds its multipliers to the joints. Velocities, multipliers and what they give are one way down the tree: a node is
    /// a thousand bytes, and to come by again costs as much as the sums.
    /// </summary>
    public static void EndWalk(JointForest forest, JointTree* tree, ActiveJoint* active, JointRows* rows)
    {
        TreeNode* nodes = forest.Nodes;
        TreeWalk.Visit(forest.View, tree->First);
        bool anchored = tree->AnchorEnd > tree->AnchorFirst;
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = nodes + i;
            TreeNode* parent = nodes + node->Parent;
            OfWalk(node, parent);
            TreeWalk.Follow(nodes, i);
            if (anchored)
            {
                PushEnds(node, parent);
            }

            GiveEdge(node, active, rows);
        }

        FinishAnchors(forest, tree, false);
        GiveAnchors(forest, tree, active, rows);
    }

    /// <summary>Finds the multipliers that answer impulses which anchored bodies got from elsewhere, and did not follow.</summary>
    public static void OfLoads(JointForest forest, JointTree* tree) => Finish(forest, tree, false);

    /// <summary>Adds the multipliers found last to the joints; those of limits that hold also to their rows.</summary>
    public static void Give(JointForest forest, JointTree* tree, ActiveJoint* active, JointRows* rows)
    {
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            GiveEdge(forest.Nodes + i, active, rows);
        }

        GiveAnchors(forest, tree, active, rows);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void OfWalk(TreeNode* node, TreeNode* parent)
    {
        double x = parent->Velocity[0] - parent->Start[0];
        double y = parent->Velocity[1] - parent->Start[1];
        double w = parent->Velocity[2] - parent->Start[2];
        double* s = node->ParentS;
        double* e = node->E;
        if (node->Rows == 2)
        {
            double fall0 = (s[0] * x) + (s[1] * y) + (s[2] * w);
            double fall1 = (s[3] * x) + (s[4] * y) + (s[5] * w);
            node->Edge[0] = -Passed(node, 0) - (0d + (e[0] * fall0) + (e[1] * fall1));
            node->Edge[1] = -Passed(node, 1) - (0d + (e[2] * fall0) + (e[3] * fall1));
        }
        else
        {
            OfWalk(node, x, y, w);
        }
    }

    private static void OfWalk(TreeNode* node, double x, double y, double w)
    {
        double* fall = stackalloc double[3];
        double* answer = stackalloc double[3];
        double* s = node->ParentS;
        for (int r = 0; r < node->Rows; r++)
        {
            fall[r] = (s[r * 3] * x) + (s[(r * 3) + 1] * y) + (s[(r * 3) + 2] * w);
        }

        TreeSolve.Multiply(node->E, fall, node->Rows, answer);
        for (int r = 0; r < node->Rows; r++)
        {
            node->Edge[r] = -Passed(node, r) - answer[r];
        }
    }

    /// <summary>What a row of the edge answers to the impulses that a walk took through the child.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Passed(TreeNode* node, int row) => node->Bears ? SmallMatrix.Dot(node->G + (row * 3), node->Through) : 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GiveEdge(TreeNode* node, ActiveJoint* active, JointRows* rows)
    {
        int first = 0;
        if (node->HardRows == 2 && node->RowJoint[0] == node->RowJoint[1])
        {
            // Both rows of a hinge, which are the first of its joint.
            double* given = active[node->RowJoint[0]].Given;
            double* j = rows[node->RowJoint[0]].B;
            given[0] = given[0] + (j[0] * node->Edge[0]) + (j[3] * node->Edge[1]);
            given[1] = given[1] + (j[1] * node->Edge[0]) + (j[4] * node->Edge[1]);
            given[2] = given[2] + (j[2] * node->Edge[0]) + (j[5] * node->Edge[1]);
            first = 2;
        }

        for (int r = first; r < node->Rows; r++)
        {
            int joint = node->RowJoint[r];
            Give(active + joint, rows + joint, node->RowIndex[r], node->Edge[r]);
        }
    }

    private static void GiveAnchors(JointForest forest, JointTree* tree, ActiveJoint* active, JointRows* rows)
    {
        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = forest.Anchors + i;
            for (int r = 0; r < anchor->Rows; r++)
            {
                Give(active + anchor->Active, rows + anchor->Active, anchor->RowIndex[r], anchor->Lambda[r]);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Give(ActiveJoint* joint, JointRows* rows, int row, double lambda)
    {
        double* j = rows->B + (row * 3);
        joint->Given[0] += j[0] * lambda;
        joint->Given[1] += j[1] * lambda;
        joint->Given[2] += j[2] * lambda;
        if (row >= rows->Hard)
        {
            joint->Lambda[row] += lambda;
        }
    }

    private static void Finish(JointForest forest, JointTree* tree, bool solved)
    {
        if (tree->AnchorEnd == tree->AnchorFirst)
        {
            return;
        }

        TreeNode* nodes = forest.Nodes;
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            PushEnds(nodes + i, nodes + nodes[i].Parent);
        }

        FinishAnchors(forest, tree, solved);
    }

    /// <summary>Anchored bodies note what the edge's multipliers give them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void PushEnds(TreeNode* node, TreeNode* parent)
    {
        if (node->Anchored)
        {
            Push(node->ChildS, node->Edge, node->Rows, node->Got);
        }

        if (parent->Anchored)
        {
            Push(node->ParentS, node->Edge, node->Rows, parent->Got);
        }
    }

    private static void FinishAnchors(JointForest forest, JointTree* tree, bool solved)
    {
        TreeNode* nodes = forest.Nodes;
        for (int i = tree->AnchorEnd - 1; i >= tree->AnchorFirst; i--)
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
        }
    }

    /// <summary>r += sᵀ·λ.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
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
