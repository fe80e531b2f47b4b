namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// Carries the impulses of iterated rows through the trees lazily. Of each tree one body is current: its velocity is up to date;
/// the others wait for a visit. Pending is the impulse of a body's subtree not yet passed up, Seen the parent's velocity at the
/// last crossing of its edge. Row after row this is Gauss–Seidel on the trees' full inverse mass, at the cost of the walks.
/// </summary>
internal static unsafe class TreeWalk
{
    public static void Begin(JointForest forest)
    {
        TreeNode* nodes = forest.Nodes;
        for (int i = 0; i < forest.Count; i++)
        {
            TreeNode* node = nodes + i;
            node->Current = node->Root;
            node->Carries = 0;
            double* parent = node->Parent < 0 ? node->Velocity : nodes[node->Parent].Velocity;
            for (int k = 0; k < 3; k++)
            {
                node->Pending[k] = 0;
                node->Through[k] = 0;
                node->Got[k] = 0;
                node->Start[k] = node->Velocity[k];
                node->Seen[k] = parent[k];
            }
        }
    }

    /// <summary>Makes a body current.</summary>
    public static void Visit(TreeNode* nodes, int target)
    {
        TreeNode* root = nodes + nodes[target].Root;
        int at = root->Current;
        if (at == target)
        {
            return;
        }

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
                meet = nodes[meet].Parent;
            }
        }

        Descend(nodes, target, meet);
        root->Current = target;
    }

    /// <summary>Applies an impulse to the current body of its tree.</summary>
    public static void Apply(TreeNode* nodes, int index, double x, double y, double w)
    {
        TreeNode* node = nodes + index;
        double* change = stackalloc double[3];
        SmallMatrix.Apply(node->FullMass, x, y, w, change);
        for (int k = 0; k < 3; k++)
        {
            node->Velocity[k] += change[k];
        }

        Note(node->Pending, x, y, w);
        Note(node->Through, x, y, w);
        Note(node->Got, x, y, w);
        nodes[node->Root].Carries = 1;
    }

    /// <summary>Brings every velocity up to date.</summary>
    public static void End(JointForest forest)
    {
        TreeNode* nodes = forest.Nodes;
        for (int i = 0; i < forest.Count; i++)
        {
            TreeNode* node = nodes + i;
            if (node->Parent < 0)
            {
                if (node->Carries != 0)
                {
                    Visit(nodes, i);
                }
            }
            else if (nodes[node->Root].Carries != 0)
            {
                Cross(nodes, i);
            }
        }
    }

    private static void Note(double* sum, double x, double y, double w)
    {
        sum[0] += x;
        sum[1] += y;
        sum[2] += w;
    }

    private static void Climb(TreeNode* nodes, int index)
    {
        TreeNode* node = nodes + index;
        TreeNode* parent = nodes + node->Parent;
        double* t = node->T;
        double* d = node->Pending;
        double x = (t[0] * d[0]) + (t[3] * d[1]) + (t[6] * d[2]);
        double y = (t[1] * d[0]) + (t[4] * d[1]) + (t[7] * d[2]);
        double w = (t[2] * d[0]) + (t[5] * d[1]) + (t[8] * d[2]);
        double* change = stackalloc double[3];
        SmallMatrix.Apply(parent->FullMass, x, y, w, change);
        d[0] = 0;
        d[1] = 0;
        d[2] = 0;
        Note(parent->Pending, x, y, w);
        Note(parent->Through, x, y, w);
        for (int k = 0; k < 3; k++)
        {
            parent->Velocity[k] += change[k];
            node->Seen[k] = parent->Velocity[k];
        }
    }

    private static void Descend(TreeNode* nodes, int target, int from)
    {
        for (int i = target; i != from; i = nodes[i].Parent)
        {
            nodes[nodes[i].Parent].Towards = i;
        }

        for (int i = from; i != target;)
        {
            i = nodes[i].Towards;
            Cross(nodes, i);
        }
    }

    /// <summary>Takes the parent's change since the last crossing down to the child.</summary>
    private static void Cross(TreeNode* nodes, int index)
    {
        TreeNode* node = nodes + index;
        TreeNode* parent = nodes + node->Parent;
        double* change = stackalloc double[3];
        SmallMatrix.Apply(
            node->T,
            parent->Velocity[0] - node->Seen[0],
            parent->Velocity[1] - node->Seen[1],
            parent->Velocity[2] - node->Seen[2],
            change);
        for (int k = 0; k < 3; k++)
        {
            node->Velocity[k] += change[k];
            node->Seen[k] = parent->Velocity[k];
        }
    }
}
