using System.Runtime.CompilerServices;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// Carries the impulses of iterated rows through the trees lazily. Of each tree one body is current: its velocity is up to date;
/// the others wait for a visit. Pending is the impulse of a body's subtree not yet passed up, Seen the parent's velocity at the
/// last crossing of its edge. Row after row this is Gauss–Seidel on the trees' full inverse mass, at the cost of the walks.
/// </summary>
internal static unsafe class TreeWalk
{
    public static void Begin(in JointForestView view, JointTree* tree)
    {
        TreeNode* nodes = view.Nodes;
        tree->Current = tree->First;
        tree->Carries = false;
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = nodes + i;
            if (node->Bears)
            {
                Begin(node, node->Parent < 0 ? node->Velocity : nodes[node->Parent].Velocity);
            }
            else
            {
                BeginUnvisited(node);
            }
        }
    }

    /// <summary>Begins at a node that walks come by.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Begin(TreeNode* node, double* parent)
    {
        BeginUnvisited(node);
        for (int k = 0; k < 3; k++)
        {
            node->Pending[k] = 0;
            node->Seen[k] = parent[k];
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void BeginUnvisited(TreeNode* node)
    {
        for (int k = 0; k < 3; k++)
        {
            node->Through[k] = 0;
            node->Got[k] = 0;
            node->Start[k] = node->Velocity[k];
        }
    }

    /// <summary>
    /// Makes a body current. The current one is of the same tree, so that both ways end where they meet, at the root at the latest.
    /// </summary>
    public static void Visit(in JointForestView view, int target)
    {
        TreeNode* nodes = view.Nodes;
        JointTree* tree = view.Trees + nodes[target].Tree;
        int at = tree->Current;
        if (at == target)
        {
            return;
        }

        System.Diagnostics.Debug.Assert(nodes[at].Tree == nodes[target].Tree, "a walk stays in its tree");
        tree->Current = target;
        int meet = target;
        int up = at;
        while (up != meet)
        {
            if (nodes[up].Depth >= nodes[meet].Depth)
            {
                Climb(nodes, up);
                up = nodes[up].Parent;
            }
            else
            {
                nodes[nodes[meet].Parent].Towards = meet;
                meet = nodes[meet].Parent;
            }
        }

        while (meet != target)
        {
            meet = nodes[meet].Towards;
            Cross(nodes, meet);
        }
    }

    /// <summary>Applies an impulse to the current body of its tree.</summary>
    public static void Apply(in JointForestView view, int index, double x, double y, double w)
    {
        TreeNode* node = view.Nodes + index;
        double* a = node->FullMass;
        node->Velocity[0] += (a[0] * x) + (a[1] * y) + (a[2] * w);
        node->Velocity[1] += (a[3] * x) + (a[4] * y) + (a[5] * w);
        node->Velocity[2] += (a[6] * x) + (a[7] * y) + (a[8] * w);
        Note(node->Pending, x, y, w);
        Note(node->Through, x, y, w);
        Note(node->Got, x, y, w);
        view.Trees[node->Tree].Carries = true;
    }

    /// <summary>Brings every velocity up to date.</summary>
    public static void End(in JointForestView view, JointTree* tree)
    {
        if (tree->Carries)
        {
            Visit(view, tree->First);
            for (int i = tree->First + 1; i < tree->End; i++)
            {
                Follow(view.Nodes, i);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Note(double* sum, double x, double y, double w)
    {
        sum[0] += x;
        sum[1] += y;
        sum[2] += w;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Climb(TreeNode* nodes, int index)
    {
        TreeNode* node = nodes + index;
        TreeNode* parent = nodes + node->Parent;
        double* t = node->T;
        double* d = node->Pending;
        double x = (t[0] * d[0]) + (t[3] * d[1]) + (t[6] * d[2]);
        double y = (t[1] * d[0]) + (t[4] * d[1]) + (t[7] * d[2]);
        double w = (t[2] * d[0]) + (t[5] * d[1]) + (t[8] * d[2]);
        d[0] = 0;
        d[1] = 0;
        d[2] = 0;
        Note(parent->Pending, x, y, w);
        Note(parent->Through, x, y, w);
        double* a = parent->FullMass;
        double* v = parent->Velocity;
        v[0] += (a[0] * x) + (a[1] * y) + (a[2] * w);
        v[1] += (a[3] * x) + (a[4] * y) + (a[5] * w);
        v[2] += (a[6] * x) + (a[7] * y) + (a[8] * w);
        node->Seen[0] = v[0];
        node->Seen[1] = v[1];
        node->Seen[2] = v[2];
    }

    /// <summary>At the end of a walk: takes the parent's change down to the child, where no walk came by all of it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Follow(TreeNode* nodes, int index)
    {
        TreeNode* node = nodes + index;
        if (node->Bears)
        {
            Cross(nodes, index);
            return;
        }

        TreeNode* parent = nodes + node->Parent;
        Take(node, parent->Velocity[0] - parent->Start[0], parent->Velocity[1] - parent->Start[1], parent->Velocity[2] - parent->Start[2]);
    }

    /// <summary>Takes the parent's change since the last crossing down to the child.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Cross(TreeNode* nodes, int index)
    {
        TreeNode* node = nodes + index;
        double* v = nodes[node->Parent].Velocity;
        double* seen = node->Seen;
        double x = v[0] - seen[0];
        double y = v[1] - seen[1];
        double w = v[2] - seen[2];
        Take(node, x, y, w);
        seen[0] = v[0];
        seen[1] = v[1];
        seen[2] = v[2];
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Take(TreeNode* node, double x, double y, double w)
    {
        double* t = node->T;
        node->Velocity[0] += (t[0] * x) + (t[1] * y) + (t[2] * w);
        node->Velocity[1] += (t[3] * x) + (t[4] * y) + (t[5] * w);
        node->Velocity[2] += (t[6] * x) + (t[7] * y) + (t[8] * w);
    }
}
