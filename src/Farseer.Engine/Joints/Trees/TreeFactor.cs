using System.Runtime.CompilerServices;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// Eliminates the hard rows of the trees, leaves first. With Y the inverse mass of a body together with its subtree (at first
/// its own), an anchor with Jacobian S and H = (S Y Sᵀ + ε)⁻¹ leaves Y - Y Sᵀ H S Y. An edge with S at the child, Sₚ at the
/// parent and K = S Y Sᵀ + ε has E = K⁻¹ and G = Y Sᵀ E, and with H = (K + Sₚ Yₚ Sₚᵀ)⁻¹ leaves the parent
/// Yₚ - (Sₚ Yₚ)ᵀ H Sₚ Yₚ. Inverse masses, never masses: what cannot move needs no special case.
/// ε, 1e-9 of the bodies' own response, keeps a tree with two anchors regular: there the far end has nothing left to give. Where a
/// block is regular by itself it is left exact: a slide under load would creep by ε of the load in each substep.
/// </summary>
internal static unsafe class TreeFactor
{
    /// <summary>A body in the plane has no more than three ways to move.</summary>
    public const int MostRows = 3;

    public const double Regular = 1e-9;

    /// <summary>Share of the determinant by the bodies' own masses below which a block counts as singular.</summary>
    public const double Singular = 1e-6;

    /// <summary>Factors a tree at the poses of <paramref name="rows"/>.</summary>
    public static void Run(JointForest forest, JointTree* tree, ActiveJoint* active, JointRows* rows)
    {
        TreeNode* nodes = forest.Nodes;
        for (int i = tree->First; i < tree->End; i++)
        {
            Reset(nodes[i].SubtreeMass, nodes[i].InverseMass, nodes[i].InverseInertia);
            FillEdge(nodes + i, active, rows);
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = forest.Anchors + i;
            ActiveJoint* joint = active + anchor->Active;
            double* from = joint->Ends.NodeA == anchor->Node ? rows[anchor->Active].A : rows[anchor->Active].B;
            for (int r = 0; r < anchor->Rows; r++)
            {
                CopyRow(from + (anchor->RowIndex[r] * 3), anchor->S + (r * 3));
            }

            EliminateAnchor(anchor, nodes + anchor->Node);
        }

        for (int i = tree->End - 1; i > tree->First; i--)
        {
            EliminateEdge(nodes + i, nodes + nodes[i].Parent);
        }
    }

    /// <summary>Inverse mass within the whole tree, root first: A = Y - G S Y + T Aₚ Tᵀ. Only where walks come by.</summary>
    public static void CompleteMasses(JointForest forest, JointTree* tree)
    {
        TreeNode* nodes = forest.Nodes;
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = nodes + i;
            if (!node->Bears)
            {
                continue;
            }

            if (node->Parent >= 0 && node->Rows == 2)
            {
                HingeFactor.CompleteMass(node, nodes + node->Parent);
                continue;
            }

            for (int k = 0; k < 9; k++)
            {
                node->FullMass[k] = node->SubtreeMass[k];
            }

            if (node->Parent >= 0)
            {
                CompleteMass(node, nodes + node->Parent);
            }
        }
    }

    private static void CompleteMass(TreeNode* node, TreeNode* parent)
    {
        // G S Y: both factors are kept row by row of the edge.
        double* product = stackalloc double[9];
        int n = node->Rows;
        SmallMatrix.Multiply(node->ChildS, n, node->SubtreeMass, product);
        SmallMatrix.SubtractOuter(node->FullMass, node->G, product, n);
        SmallMatrix.Multiply(node->T, 3, parent->FullMass, product);
        for (int r = 0; r < 3; r++)
        {
            for (int c = 0; c < 3; c++)
            {
                node->FullMass[(r * 3) + c] += SmallMatrix.Dot(product + (r * 3), node->T + (c * 3));
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Reset(double* y, double mass, double inertia)
    {
        for (int i = 1; i < 8; i++)
        {
            y[i] = 0;
        }

        y[0] = mass;
        y[4] = mass;
        y[8] = inertia;
    }

    private static void FillEdge(TreeNode* node, ActiveJoint* active, JointRows* rows)
    {
        for (int r = 0; r < node->Rows; r++)
        {
            int joint = node->RowJoint[r];
            int at = node->RowIndex[r] * 3;
            bool childIsA = active[joint].Ends.BodyA == node->Body;
            CopyRow((childIsA ? rows[joint].A : rows[joint].B) + at, node->ChildS + (r * 3));
            CopyRow((childIsA ? rows[joint].B : rows[joint].A) + at, node->ParentS + (r * 3));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void CopyRow(double* from, double* to)
    {
        to[0] = from[0];
        to[1] = from[1];
        to[2] = from[2];
    }

    /// <summary>Makes k invertible where it is not, and leaves it exact where it is.</summary>
    /// <returns>True if it was not.</returns>
    private static bool MakeRegular(double* k, int n, double* own)
    {
        double scale = 1;
        for (int i = 0; i < n; i++)
        {
            scale *= own[i];
        }

        if (SmallMatrix.Determinant(k, n) > Singular * scale)
        {
            return false;
        }

        AddRegular(k, n, own);
        return true;
    }

    private static void AddRegular(double* k, int n, double* own)
    {
        for (int i = 0; i < n; i++)
        {
            k[(i * n) + i] += Regular * own[i];
        }
    }

    /// <summary>r += the responses of a body to the rows by its own mass.</summary>
    private static void AddOwn(double* s, int n, TreeNode* node, double* r)
    {
        for (int i = 0; i < n; i++)
        {
            double x = s[i * 3];
            double y = s[(i * 3) + 1];
            double w = s[(i * 3) + 2];
            r[i] += (((x * x) + (y * y)) * node->InverseMass) + (w * w * node->InverseInertia);
        }
    }

    private static void EliminateAnchor(TreeAnchor* anchor, TreeNode* node)
    {
        double* sy = stackalloc double[9];
        double* k = stackalloc double[9];
        double* h = anchor->H;
        int n = anchor->Rows;
        SmallMatrix.Multiply(anchor->S, n, node->SubtreeMass, sy);
        SmallMatrix.MultiplyTransposed(sy, anchor->S, n, k);
        double* own = stackalloc double[3] { 0, 0, 0 };
        AddOwn(anchor->S, n, node, own);
        MakeRegular(k, n, own);
        SmallMatrix.Invert(k, n, h);
        SmallMatrix.MultiplySquare(h, n, sy, anchor->Gain);
        SmallMatrix.SubtractOuter(node->SubtreeMass, sy, anchor->Gain, n);
    }

    private static void EliminateEdge(TreeNode* node, TreeNode* parent)
    {
        if (node->Rows == 2)
        {
            HingeFactor.Eliminate(node, parent);
            return;
        }

        double* sy = stackalloc double[9];
        double* spy = stackalloc double[9];
        double* k = stackalloc double[9];
        double* h = stackalloc double[9];
        int n = node->Rows;
        SmallMatrix.Multiply(node->ChildS, n, node->SubtreeMass, sy);
        SmallMatrix.MultiplyTransposed(sy, node->ChildS, n, k);
        double* own = stackalloc double[3] { 0, 0, 0 };
        AddOwn(node->ChildS, n, node, own);
        MakeRegular(k, n, own);
        SmallMatrix.Multiply(node->ParentS, n, parent->SubtreeMass, spy);
        SmallMatrix.MultiplyTransposed(spy, node->ParentS, n, h);
        for (int i = 0; i < n * n; i++)
        {
            h[i] += k[i];
        }

        // What makes the sum regular is part of K as well: E of the way down and H of the way up would else tell the two bodies of two
        // forces, by as much as 3 to 1 along a taut bridge.
        AddOwn(node->ParentS, n, parent, own);
        if (MakeRegular(h, n, own))
        {
            AddRegular(k, n, own);
        }

        SmallMatrix.Invert(k, n, node->E);
        SmallMatrix.MultiplySquare(node->E, n, sy, node->G);
        for (int i = 0; i < n * n; i++)
        {
            k[i] = h[i];
        }

        SmallMatrix.Invert(k, n, h);
        SmallMatrix.MultiplySquare(h, n, spy, node->W);
        SmallMatrix.SubtractOuter(parent->SubtreeMass, spy, node->W, n);
        Reset(node->T, 0, 0);
        SmallMatrix.SubtractOuter(node->T, node->G, node->ParentS, n);
    }
}
