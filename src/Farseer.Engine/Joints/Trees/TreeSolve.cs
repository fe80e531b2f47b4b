using System;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The velocities nearest to the present ones, weighted by mass, that satisfy all rows of a tree's blocks, S v + Sₚ vₚ = t: up
/// from the leaves with the residuals, then down from the root.
/// </summary>
internal static unsafe class TreeSolve
{
    /// <summary>A few units in the last place.</summary>
    internal const double Rounding = 1e-15;

    public static void Run(JointForest forest, JointTree* tree)
    {
        TreeNode* nodes = forest.Nodes;
        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = forest.Anchors + i;
            Meet(anchor, nodes[anchor->Node].Velocity);
        }

        double* r = stackalloc double[3];
        for (int i = tree->End - 1; i > tree->First; i--)
        {
            TreeNode* node = nodes + i;
            double* parent = nodes[node->Parent].Velocity;
            if (node->Rows == 2)
            {
                Spread(node->W, Lack(node, parent, 0), Lack(node, parent, 1), parent);
                continue;
            }

            Residual(node, parent, r);
            Spread(node->W, r, node->Rows, parent);
        }

        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = nodes + i;
            double* parent = nodes[node->Parent].Velocity;
            double* e = node->E;
            if (node->Rows == 2)
            {
                // Hinges have two rows: a loop over so few costs as much as what it does.
                double r0 = Lack(node, parent, 0);
                double r1 = Lack(node, parent, 1);
                Spread(node->G, r0, r1, node->Velocity);
                node->Edge[0] = (e[0] * r0) + (e[1] * r1);
                node->Edge[1] = (e[2] * r0) + (e[3] * r1);
                continue;
            }

            Residual(node, parent, r);
            Spread(node->G, r, node->Rows, node->Velocity);
            Multiply(e, r, node->Rows, node->Edge);
        }
    }

    private static void Residual(TreeNode* node, double* parent, double* r)
    {
        for (int i = 0; i < node->Rows; i++)
        {
            r[i] = Lack(node, parent, i);
        }
    }

    /// <summary>What a row of an edge is short of its target by.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Lack(TreeNode* node, double* parent, int row) =>
        node->Target[row] - SmallMatrix.Dot(node->ChildS + (row * 3), node->Velocity) - SmallMatrix.Dot(node->ParentS + (row * 3), parent);

    private static void Meet(TreeAnchor* anchor, double* v)
    {
        for (int i = 0; i < anchor->Rows; i++)
        {
            anchor->Residual[i] = anchor->Target[i] - SmallMatrix.Dot(anchor->S + (i * 3), v);
        }

        // What the terms leave of each other by rounding is nothing: a body that an anchor holds stands still.
        for (int k = 0; k < 3; k++)
        {
            double sum = v[k];
            double terms = Math.Abs(sum);
            for (int i = 0; i < anchor->Rows; i++)
            {
                double term = anchor->Gain[(i * 3) + k] * anchor->Residual[i];
                sum += term;
                terms += Math.Abs(term);
            }

            v[k] = Math.Abs(sum) <= Rounding * terms ? 0 : sum;
        }
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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Spread(double* m, double r0, double r1, double* v)
    {
        v[0] = v[0] + (m[0] * r0) + (m[3] * r1);
        v[1] = v[1] + (m[1] * r0) + (m[4] * r1);
        v[2] = v[2] + (m[2] * r0) + (m[5] * r1);
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
