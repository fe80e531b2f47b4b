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
            Residual(node, parent, r);
            Spread(node->W, r, node->Rows, parent);
        }

        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = nodes + i;
            Residual(node, nodes[node->Parent].Velocity, r);
            Spread(node->G, r, node->Rows, node->Velocity);
            if (node->Rows == 2)
            {
                double* e = node->E;
                node->Edge[0] = (e[0] * r[0]) + (e[1] * r[1]);
                node->Edge[1] = (e[2] * r[0]) + (e[3] * r[1]);
            }
            else
            {
                Multiply(node->E, r, node->Rows, node->Edge);
            }
        }
    }

    /// <summary>Hinges have two rows: written out, since a loop over so few costs as much as what it does.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Residual(TreeNode* node, double* parent, double* r)
    {
        double* c = node->ChildS;
        double* p = node->ParentS;
        double* v = node->Velocity;
        if (node->Rows == 2)
        {
            r[0] = node->Target[0] - ((c[0] * v[0]) + (c[1] * v[1]) + (c[2] * v[2]))
                - ((p[0] * parent[0]) + (p[1] * parent[1]) + (p[2] * parent[2]));
            r[1] = node->Target[1] - ((c[3] * v[0]) + (c[4] * v[1]) + (c[5] * v[2]))
                - ((p[3] * parent[0]) + (p[4] * parent[1]) + (p[5] * parent[2]));
            return;
        }

        for (int i = 0; i < node->Rows; i++)
        {
            r[i] = node->Target[i] - SmallMatrix.Dot(c + (i * 3), v) - SmallMatrix.Dot(p + (i * 3), parent);
        }
    }

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
    private static void Spread(double* m, double* r, int rows, double* v)
    {
        if (rows == 2)
        {
            v[0] = v[0] + (m[0] * r[0]) + (m[3] * r[1]);
            v[1] = v[1] + (m[1] * r[0]) + (m[4] * r[1]);
            v[2] = v[2] + (m[2] * r[0]) + (m[5] * r[1]);
            return;
        }

        for (int i = 0; i < rows; i++)
        {
            v[0] += m[i * 3] * r[i];
            v[1] += m[(i * 3) + 1] * r[i];
            v[2] += m[(i * 3) + 2] * r[i];
        }
    }
}
