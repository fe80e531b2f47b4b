using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// The two bodies of an iterated row, a joint's or a contact's, and how impulses along it reach them: through the trees, or not
/// at all where a body cannot move.
/// </summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal unsafe struct RowEnds
{
    /// <summary>
    /// ρ: below this share of its bodies' own response a row has none. The trees are exact to 1e-9 of it; a light link that holds
    /// what is a hundred thousand times as heavy still answers by 1e-5.
    /// </summary>
    public const double Dead = 1e-6;

    /// <summary>
    /// The same of surfaces that touch within one tree. What a group of welds leaves there is the rounding of its blocks times the square
    /// of its length, up to the share 1e-6 and more: divided by that, surfaces within the group gathered impulses ten times as large as the
    /// blow, and when a weld broke these shot its bricks off, with up to 10⁸ times the energy. A body that presses on another from
    /// outside is never so dead: it has a mass of its own.
    /// </summary>
    public const double DeadWithin = 1e-3;

    public int BodyA;
    public int BodyB;

    /// <summary>-1: cannot move.</summary>
    public int NodeA;
    public int NodeB;

    /// <summary>Both nodes are in one tree: moving one moves the other.</summary>
    public bool Coupled;

    /// <summary>Response of body A's velocity to an impulse on B, where coupled.</summary>
    public fixed double Cross[9];

    /// <summary>Brings the velocities of both bodies up to date; B's body is then the current one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Visit(in JointForestView view, RowEnds* ends)
    {
        if (ends->NodeA >= 0)
        {
            TreeWalk.Visit(view, ends->NodeA);
        }

        // With both bodies in one tree the first one's velocity stays right while the walk goes to the second.
        if (ends->NodeB >= 0)
        {
            TreeWalk.Visit(view, ends->NodeB);
        }
    }

    /// <summary>Applies impulses (force x, y and torque) to both bodies. B is current before and after.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Apply(in JointForestView view, RowEnds* ends, double* a, double* b)
    {
        if (ends->NodeB >= 0)
        {
            TreeWalk.Apply(view, ends->NodeB, b[0], b[1], b[2]);
        }

        if (ends->NodeA >= 0)
        {
            if (ends->Coupled)
            {
                TreeWalk.Visit(view, ends->NodeA);
            }

            TreeWalk.Apply(view, ends->NodeA, a[0], a[1], a[2]);
            if (ends->Coupled)
            {
                TreeWalk.Visit(view, ends->NodeB);
            }
        }
    }

    /// <summary>Applies impulses on the bodies' own masses: the trees are solved afterwards.</summary>
    public static void Push(TreeNode* nodes, RowEnds* ends, double* a, double* b)
    {
        Push(nodes, ends->NodeA, a);
        Push(nodes, ends->NodeB, b);
    }

    /// <summary>J A Jᵀ between two rows, each with its Jacobians at both bodies.</summary>
    public static double Response(TreeNode* nodes, RowEnds* ends, double* pA, double* pB, double* qA, double* qB)
    {
        double sum = 0;
        if (ends->NodeA >= 0)
        {
            sum += Form(nodes[ends->NodeA].FullMass, pA, qA);
        }

        if (ends->NodeB >= 0)
        {
            sum += Form(nodes[ends->NodeB].FullMass, pB, qB);
        }

        if (ends->Coupled)
        {
            sum += Form(ends->Cross, pA, qB) + Form(ends->Cross, qA, pB);
        }

        return sum;
    }

    /// <summary>The responses of a row's two bodies, without what one does to the other.</summary>
    public static double OfEnds(TreeNode* nodes, RowEnds* ends, double* a, double* b)
    {
        double sum = 0;
        if (ends->NodeA >= 0)
        {
            sum += Form(nodes[ends->NodeA].FullMass, a, a);
        }

        if (ends->NodeB >= 0)
        {
            sum += Form(nodes[ends->NodeB].FullMass, b, b);
        }

        return sum;
    }

    /// <summary>
    /// The response of a row to itself, as something to divide by. With R what its bodies alone would answer, it is K (1 + (ρR/K)⁴): K
    /// wherever there is a response, and large where a tree leaves none. Surfaces that touch within a rigid group of joints press on
    /// each other with nothing to gain; divided by a rounding of K they would explode. The fourth power lets no impulse gather there
    /// that a breaking joint would set free.
    /// </summary>
    public static double Response(TreeNode* nodes, RowEnds* ends, double* a, double* b, double dead = Dead)
    {
        double own = Own(nodes, ends, a, b);
        double k = Math.Max(Response(nodes, ends, a, b, a, b), dead * dead * own);
        double ratio = k > 0 ? dead * own / k : 0;
        return k * (1 + (ratio * ratio * (ratio * ratio)));
    }

    /// <summary>What the bodies would answer to a row without their trees.</summary>
    public static double Own(TreeNode* nodes, RowEnds* ends, double* a, double* b) =>
        Own(nodes, ends->NodeA, a) + Own(nodes, ends->NodeB, b);

    /// <summary>J·v at a body.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Speed(TreeNode* nodes, BodyState* states, int node, int body, double* j)
    {
        if (node >= 0)
        {
            return SmallMatrix.Dot(j, nodes[node].Velocity);
        }

        BodyState* s = states + body;
        return (j[0] * s->LinearVelocity.X) + (j[1] * s->LinearVelocity.Y) + (j[2] * s->AngularVelocity);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Own(TreeNode* nodes, int node, double* j) => node < 0
        ? 0
        : (((j[0] * j[0]) + (j[1] * j[1])) * nodes[node].InverseMass) + (j[2] * j[2] * nodes[node].InverseInertia);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Push(TreeNode* nodes, int node, double* impulse)
    {
        if (node >= 0)
        {
            TreeNode* n = nodes + node;
            n->Velocity[0] += n->InverseMass * impulse[0];
            n->Velocity[1] += n->InverseMass * impulse[1];
            n->Velocity[2] += n->InverseInertia * impulse[2];
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Form(double* m, double* p, double* q)
    {
        double x = (m[0] * q[0]) + (m[1] * q[1]) + (m[2] * q[2]);
        double y = (m[3] * q[0]) + (m[4] * q[1]) + (m[5] * q[2]);
        double w = (m[6] * q[0]) + (m[7] * q[1]) + (m[8] * q[2]);
        return (p[0] * x) + (p[1] * y) + (p[2] * w);
    }
}

/// <summary>The nodes and trees, as the walks take them along.</summary>
internal readonly unsafe struct JointForestView
{
    public readonly TreeNode* Nodes;
    public readonly JointTree* Trees;

    public JointForestView(TreeNode* nodes, JointTree* trees)
    {
        Nodes = nodes;
        Trees = trees;
    }
}
