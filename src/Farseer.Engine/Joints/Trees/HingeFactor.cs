namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The elimination of an edge with two rows (hinges, slides, distances with an angle), as in <see cref="TreeFactor"/> operation by
/// operation, but written out: most edges are such, and the loops over two rows took twice the time of their sums.
/// </summary>
internal static unsafe class HingeFactor
{
    /// <summary>Fills E, G, W and T of the edge and takes its rows out of the parent's inverse mass.</summary>
    public static void Eliminate(TreeNode* node, TreeNode* parent)
    {
        double* s = node->ChildS;
        double* y = node->SubtreeMass;
        double a00 = (s[0] * y[0]) + (s[1] * y[3]) + (s[2] * y[6]);
        double a01 = (s[0] * y[1]) + (s[1] * y[4]) + (s[2] * y[7]);
        double a02 = (s[0] * y[2]) + (s[1] * y[5]) + (s[2] * y[8]);
        double a10 = (s[3] * y[0]) + (s[4] * y[3]) + (s[5] * y[6]);
        double a11 = (s[3] * y[1]) + (s[4] * y[4]) + (s[5] * y[7]);
        double a12 = (s[3] * y[2]) + (s[4] * y[5]) + (s[5] * y[8]);
        double k00 = (a00 * s[0]) + (a01 * s[1]) + (a02 * s[2]);
        double k01 = (a00 * s[3]) + (a01 * s[4]) + (a02 * s[5]);
        double k10 = (a10 * s[0]) + (a11 * s[1]) + (a12 * s[2]);
        double k11 = (a10 * s[3]) + (a11 * s[4]) + (a12 * s[5]);
        double own0 = Own(s, node);
        double own1 = Own(s + 3, node);
        if (!((k00 * k11) - (k01 * k10) > TreeFactor.Singular * (own0 * own1)))
        {
            k00 += TreeFactor.Regular * own0;
            k11 += TreeFactor.Regular * own1;
        }

        double* p = node->ParentS;
        double* z = parent->SubtreeMass;
        double b00 = (p[0] * z[0]) + (p[1] * z[3]) + (p[2] * z[6]);
        double b01 = (p[0] * z[1]) + (p[1] * z[4]) + (p[2] * z[7]);
        double b02 = (p[0] * z[2]) + (p[1] * z[5]) + (p[2] * z[8]);
        double b10 = (p[3] * z[0]) + (p[4] * z[3]) + (p[5] * z[6]);
        double b11 = (p[3] * z[1]) + (p[4] * z[4]) + (p[5] * z[7]);
        double b12 = (p[3] * z[2]) + (p[4] * z[5]) + (p[5] * z[8]);
        double h00 = ((b00 * p[0]) + (b01 * p[1]) + (b02 * p[2])) + k00;
        double h01 = ((b00 * p[3]) + (b01 * p[4]) + (b02 * p[5])) + k01;
        double h10 = ((b10 * p[0]) + (b11 * p[1]) + (b12 * p[2])) + k10;
        double h11 = ((b10 * p[3]) + (b11 * p[4]) + (b12 * p[5])) + k11;
        own0 += Own(p, parent);
        own1 += Own(p + 3, parent);
        if (!((h00 * h11) - (h01 * h10) > TreeFactor.Singular * (own0 * own1)))
        {
            h00 += TreeFactor.Regular * own0;
            h11 += TreeFactor.Regular * own1;
            k00 += TreeFactor.Regular * own0;
            k11 += TreeFactor.Regular * own1;
        }

        double* e = node->E;
        SmallMatrix.InvertTwo(k00, k01, k10, k11, e);
        double* inverse = stackalloc double[4];
        SmallMatrix.InvertTwo(h00, h01, h10, h11, inverse);
        double i00 = inverse[0];
        double i01 = inverse[1];
        double i11 = inverse[3];
        double* g = node->G;
        double* w = node->W;
        g[0] = 0d + (e[0] * a00) + (e[1] * a10);
        g[1] = 0d + (e[0] * a01) + (e[1] * a11);
        g[2] = 0d + (e[0] * a02) + (e[1] * a12);
        g[3] = 0d + (e[2] * a00) + (e[3] * a10);
        g[4] = 0d + (e[2] * a01) + (e[3] * a11);
        g[5] = 0d + (e[2] * a02) + (e[3] * a12);
        w[0] = 0d + (i00 * b00) + (i01 * b10);
        w[1] = 0d + (i00 * b01) + (i01 * b11);
        w[2] = 0d + (i00 * b02) + (i01 * b12);
        w[3] = 0d + (i01 * b00) + (i11 * b10);
        w[4] = 0d + (i01 * b01) + (i11 * b11);
        w[5] = 0d + (i01 * b02) + (i11 * b12);
        z[0] = z[0] - (b00 * w[0]) - (b10 * w[3]);
        z[1] = z[1] - (b00 * w[1]) - (b10 * w[4]);
        z[2] = z[2] - (b00 * w[2]) - (b10 * w[5]);
        z[3] = z[3] - (b01 * w[0]) - (b11 * w[3]);
        z[4] = z[4] - (b01 * w[1]) - (b11 * w[4]);
        z[5] = z[5] - (b01 * w[2]) - (b11 * w[5]);
        z[6] = z[6] - (b02 * w[0]) - (b12 * w[3]);
        z[7] = z[7] - (b02 * w[1]) - (b12 * w[4]);
        z[8] = z[8] - (b02 * w[2]) - (b12 * w[5]);
        double* t = node->T;
        t[0] = 0d - (g[0] * p[0]) - (g[3] * p[3]);
        t[1] = 0d - (g[0] * p[1]) - (g[3] * p[4]);
        t[2] = 0d - (g[0] * p[2]) - (g[3] * p[5]);
        t[3] = 0d - (g[1] * p[0]) - (g[4] * p[3]);
        t[4] = 0d - (g[1] * p[1]) - (g[4] * p[4]);
        t[5] = 0d - (g[1] * p[2]) - (g[4] * p[5]);
        t[6] = 0d - (g[2] * p[0]) - (g[5] * p[3]);
        t[7] = 0d - (g[2] * p[1]) - (g[5] * p[4]);
        t[8] = 0d - (g[2] * p[2]) - (g[5] * p[5]);
    }

    /// <summary>The inverse mass of the child within the whole tree, A = Y - G S Y + T Aₚ Tᵀ.</summary>
    public static void CompleteMass(TreeNode* node, TreeNode* parent)
    {
        double* s = node->ChildS;
        double* y = node->SubtreeMass;
        double* g = node->G;
        double* t = node->T;
        double* p = parent->FullMass;
        double* full = node->FullMass;
        double a00 = (s[0] * y[0]) + (s[1] * y[3]) + (s[2] * y[6]);
        double a01 = (s[0] * y[1]) + (s[1] * y[4]) + (s[2] * y[7]);
        double a02 = (s[0] * y[2]) + (s[1] * y[5]) + (s[2] * y[8]);
        double a10 = (s[3] * y[0]) + (s[4] * y[3]) + (s[5] * y[6]);
        double a11 = (s[3] * y[1]) + (s[4] * y[4]) + (s[5] * y[7]);
        double a12 = (s[3] * y[2]) + (s[4] * y[5]) + (s[5] * y[8]);
        for (int r = 0; r < 3; r++)
        {
            double* u = t + (r * 3);
            double* from = y + (r * 3);
            double* to = full + (r * 3);
            double g0 = g[r];
            double g1 = g[3 + r];
            double b0 = (u[0] * p[0]) + (u[1] * p[3]) + (u[2] * p[6]);
            double b1 = (u[0] * p[1]) + (u[1] * p[4]) + (u[2] * p[7]);
            double b2 = (u[0] * p[2]) + (u[1] * p[5]) + (u[2] * p[8]);
            to[0] = from[0] - (g0 * a00) - (g1 * a10) + ((b0 * t[0]) + (b1 * t[1]) + (b2 * t[2]));
            to[1] = from[1] - (g0 * a01) - (g1 * a11) + ((b0 * t[3]) + (b1 * t[4]) + (b2 * t[5]));
            to[2] = from[2] - (g0 * a02) - (g1 * a12) + ((b0 * t[6]) + (b1 * t[7]) + (b2 * t[8]));
        }
    }

    /// <summary>The response of a body to a row by its own mass.</summary>
    private static double Own(double* s, TreeNode* node) =>
        (((s[0] * s[0]) + (s[1] * s[1])) * node->InverseMass) + (s[2] * s[2] * node->InverseInertia);
}
