namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The velocities nearest to the present ones, weighted by mass, that satisfy all hard rows of the trees, S v + Sₚ vₚ = t: up
/// from the leaves with the residuals, then down from the roots.
/// </summary>
internal static unsafe class TreeSolve
{
    /// <summary>Solves for the velocities, or for the velocity changes of the position correction.</summary>
    public static void Run(JointForest forest, bool correction)
    {
        TreeNode* nodes = forest.Nodes;
        for (int i = 0; i < forest.AnchorCount; i++)
        {
            TreeAnchor* anchor = forest.Anchors + i;
            double* v = Vector(nodes + anchor->Node, correction);
            Meet(anchor, v);
        }

        double* r = stackalloc double[3];
        for (int i = forest.Count - 1; i >= 0; i--)
        {
            TreeNode* node = nodes + i;
            if (node->Parent < 0)
            {
                continue;
            }

            double* parent = Vector(nodes + node->Parent, correction);
            Residual(node, Vector(node, correction), parent, r);
            Spread(node->W, r, node->Rows, parent);
        }

        for (int i = 0; i < forest.Count; i++)
        {
            TreeNode* node = nodes + i;
            if (node->Parent >= 0)
            {
                double* v = Vector(node, correction);
                Residual(node, v, Vector(nodes + node->Parent, correction), r);
                Spread(node->G, r, node->Rows, v);
                Multiply(node->E, r, node->Rows, node->Edge);
            }
        }
    }

    private static double* Vector(TreeNode* node, bool correction) => correction ? node->Correction : node->Velocity;

    private static void Residual(TreeNode* node, double* child, double* parent, double* r)
    {
        for (int i = 0; i < node->Rows; i++)
        {
            r[i] = node->Target[i] - SmallMatrix.Dot(node->ChildS + (i * 3), child) - SmallMatrix.Dot(node->ParentS + (i * 3), parent);
        }
    }

    private static void Meet(TreeAnchor* anchor, double* v)
    {
        for (int i = 0; i < anchor->Rows; i++)
        {
            anchor->Residual[i] = anchor->Target[i] - SmallMatrix.Dot(anchor->S + (i * 3), v);
        }

        Spread(anchor->Gain, anchor->Residual, anchor->Rows, v);
    }

    /// <summary>r = m·v of n×n.</summary>
    internal static void Multiply(double* m, double* v, int n, double* r)
    {
        for (int i = 0; i < n; i++)
        {
            double sum = 0;
            for (int k = 0; k < n; k++)
            {
                sum += m[(i * n) + k] * v[k];
            }

            r[i] = sum;
        }
    }

    private static void Spread(double* m, double* r, int rows, double* v)
    {
        for (int i = 0; i < rows; i++)
        {
            v[0] += m[i * 3] * r[i];
            v[1] += m[(i * 3) + 1] * r[i];
            v[2] += m[(i * 3) + 2] * r[i];
        }
    }
}
