namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The inverse mass between two bodies of one tree: A_ab = P A Qᵀ with A of the node where the ways meet, at the root at the latest, P and
/// Q the products of T down to a and b.
/// </summary>
internal static unsafe class TreeCross
{
    public static void Write(TreeNode* nodes, int a, int b, double* result)
    {
        double* p = stackalloc double[9];
        double* q = stackalloc double[9];
        double* product = stackalloc double[9];
        Unit(p);
        Unit(q);
        while (a != b)
        {
            if (nodes[a].Depth >= nodes[b].Depth)
            {
                SmallMatrix.Multiply(p, 3, nodes[a].T, product);
                Copy(product, p);
                a = nodes[a].Parent;
            }
            else
            {
                SmallMatrix.Multiply(q, 3, nodes[b].T, product);
                Copy(product, q);
                b = nodes[b].Parent;
            }
        }

        SmallMatrix.Multiply(p, 3, nodes[a].FullMass, product);
        SmallMatrix.MultiplyTransposed(product, q, 3, result);
    }

    private static void Unit(double* m)
    {
        for (int i = 0; i < 9; i++)
        {
            m[i] = i % 4 == 0 ? 1 : 0;
        }
    }

    private static void Copy(double* from, double* to)
    {
        for (int i = 0; i < 9; i++)
        {
            to[i] = from[i];
        }
    }
}
