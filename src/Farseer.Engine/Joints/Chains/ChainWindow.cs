using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints.Chains;

/// <summary>
/// The bodies of a chain between the first and the last that contacts touch, as a tree by themselves. What hangs at either end of them has
/// been eliminated, D of the joint there, and leaves Y = M⁻¹ - M⁻¹ Sᵀ D⁻¹ S M⁻¹ of the body; with these the masses within and the ways
/// between are those of all of the chain, at the cost of a few bodies.
/// </summary>
internal static unsafe class ChainWindow
{
    /// <summary>Masses, ways and poses for the rows of contacts.</summary>
    /// <param name="forest">The trees.</param>
    /// <param name="places">The chain's bodies and joints.</param>
    /// <param name="chain">Its numbers, factored.</param>
    /// <param name="top">Of these bodies, the one nearest to the root.</param>
    public static void Write(JointForest forest, ChainPlace* places, in ChainView chain, int top)
    {
        TreeNode* nodes = forest.Nodes;
        for (int i = chain.Low; i <= chain.High; i++)
        {
            TreeNode* node = nodes + places[i].Node;
            WriteNode(chain, i, node);
            int joint = i < top ? i : i - 1;
            if (i != top)
            {
                WriteRows(chain, joint, i < top ? node->ChildS : node->ParentS, i < top ? node->ParentS : node->ChildS);
            }
        }

        if (chain.Low > 0)
        {
            TakeOut(chain, chain.Low - 1, true, nodes + places[chain.Low].Node);
        }

        if (chain.High < chain.Joints)
        {
            TakeOut(chain, chain.High, false, nodes + places[chain.High].Node);
        }

        for (int i = chain.Low; i < top; i++)
        {
            HingeFactor.Eliminate(nodes + places[i].Node, nodes + places[i + 1].Node);
        }

        for (int i = chain.High; i > top; i--)
        {
            HingeFactor.Eliminate(nodes + places[i].Node, nodes + places[i - 1].Node);
        }

        TreeNode* root = nodes + places[top].Node;
        for (int k = 0; k < 9; k++)
        {
            root->FullMass[k] = root->SubtreeMass[k];
        }

        for (int i = top - 1; i >= chain.Low; i--)
        {
            HingeFactor.CompleteMass(nodes + places[i].Node, nodes + places[i + 1].Node);
        }

        for (int i = top + 1; i <= chain.High; i++)
        {
            HingeFactor.CompleteMass(nodes + places[i].Node, nodes + places[i - 1].Node);
        }
    }

    /// <summary>The bodies' velocities, or changes of velocities, by the impulses that the joints have found.</summary>
    /// <param name="forest">The trees.</param>
    /// <param name="places">The chain's bodies and joints.</param>
    /// <param name="chain">Its numbers.</param>
    /// <param name="velocity">The column of velocities; null: of changes.</param>
    public static void ShareSolved(JointForest forest, ChainPlace* places, in ChainView chain, double* velocity)
    {
        int s = chain.Stride;
        double* lambda = chain[ChainColumn.Lambda];
        double* low = chain[chain.Arms];
        double* high = low + (2 * s);
        for (int i = chain.Low; i <= chain.High; i++)
        {
            double x = -lambda[i];
            double y = -lambda[i + s];
            double w = -((low[i] * lambda[i + s]) - (low[i + s] * lambda[i]));
            int k = i - 1;
            if (k >= 0)
            {
                x += lambda[k];
                y += lambda[k + s];
                w += (high[k] * lambda[k + s]) - (high[k + s] * lambda[k]);
            }

            double mass = chain[ChainColumn.InverseMass][i];
            double* to = forest.Nodes[places[i].Node].Velocity;
            to[0] = mass * x;
            to[1] = mass * y;
            to[2] = chain[ChainColumn.InverseInertia][i] * w;
            if (velocity != null)
            {
                to[0] += velocity[i];
                to[1] += velocity[i + s];
                to[2] += velocity[i + (2 * s)];
            }
        }
    }

    /// <summary>Begins a walk: see <see cref="TreeWalk"/>.</summary>
    public static void Begin(JointForest forest, ChainPlace* places, Chain* chain)
    {
        JointTree* tree = forest.Trees + chain->Tree;
        tree->Current = places[chain->Top].Node;
        tree->Carries = false;
        for (int i = chain->Low; i <= chain->High; i++)
        {
            int parent = i == chain->Top ? i : i < chain->Top ? i + 1 : i - 1;
            TreeWalk.Begin(forest.Nodes + places[i].Node, forest.Nodes[places[parent].Node].Velocity);
        }
    }

    /// <summary>What contacts gave to the bodies: impulses that the joints are to meet.</summary>
    public static void TakePushes(JointForest forest, ChainPlace* places, in ChainView chain)
    {
        int s = chain.Stride;
        double* push = chain[ChainColumn.Push];
        double* residual = chain[ChainColumn.Residual];
        double* low = chain[chain.Arms];
        double* high = low + (2 * s);
        for (int i = chain.Low; i <= chain.High; i++)
        {
            double* got = forest.Nodes[places[i].Node].Got;
            push[i] = got[0];
            push[i + s] = got[1];
            push[i + (2 * s)] = got[2];
            double mass = chain[ChainColumn.InverseMass][i];
            double x = mass * got[0];
            double y = mass * got[1];
            double w = chain[ChainColumn.InverseInertia][i] * got[2];
            if (i < chain.Joints)
            {
                residual[i] += x - (w * low[i + s]);
                residual[i + s] += y + (w * low[i]);
            }

            int k = i - 1;
            if (k >= 0)
            {
                residual[k] -= x - (w * high[k + s]);
                residual[k + s] -= y + (w * high[k]);
            }
        }
    }

    /// <summary>Contacts gave nothing.</summary>
    public static void ClearPushes(in ChainView chain)
    {
        int s = chain.Stride;
        double* push = chain[ChainColumn.Push];
        for (int i = chain.Low; i <= chain.High; i++)
        {
            push[i] = 0;
            push[i + s] = 0;
            push[i + (2 * s)] = 0;
        }
    }

    private static void WriteNode(in ChainView chain, int i, TreeNode* node)
    {
        int s = chain.Stride;
        double* move = chain[ChainColumn.Move] + i;
        node->Move[0] = move[0];
        node->Move[1] = move[s];
        node->Move[2] = move[2 * s];
        node->TurnSin = chain[ChainColumn.TurnSin][i];
        node->TurnCos = chain[ChainColumn.TurnCos][i];
        node->InverseMass = chain[ChainColumn.InverseMass][i];
        node->InverseInertia = chain[ChainColumn.InverseInertia][i];
        double* y = node->SubtreeMass;
        for (int k = 1; k < 8; k++)
        {
            y[k] = 0;
        }

        y[0] = node->InverseMass;
        y[4] = node->InverseMass;
        y[8] = node->InverseInertia;
    }

    /// <summary>The rows of a joint at its low and at its high body.</summary>
    private static void WriteRows(in ChainView chain, int joint, double* low, double* high)
    {
        int s = chain.Stride;
        double* arm = chain[chain.Arms] + joint;
        WriteRows(low, -1, arm[0], arm[s]);
        WriteRows(high, 1, arm[2 * s], arm[3 * s]);
    }

    private static void WriteRows(double* rows, double sign, double x, double y)
    {
        rows[0] = sign;
        rows[1] = 0;
        rows[2] = -sign * y;
        rows[3] = 0;
        rows[4] = sign;
        rows[5] = sign * x;
    }

    /// <summary>Takes a joint, with all that hangs at it, out of the inverse mass of its high or its low body.</summary>
    private static void TakeOut(in ChainView chain, int joint, bool high, TreeNode* node)
    {
        int s = chain.Stride;
        double* arm = chain[chain.Arms] + joint + (high ? 2 * s : 0);
        double* e = chain[ChainColumn.Inverse] + joint;
        double mass = node->InverseMass;
        double wx = -node->InverseInertia * arm[s];
        double wy = node->InverseInertia * arm[0];
        double xx = e[0];
        double xy = e[s];
        double yy = e[2 * s];
        double gx = (xx * wx) + (xy * wy);
        double gy = (xy * wx) + (yy * wy);
        double* y = node->SubtreeMass;
        y[0] -= mass * xx * mass;
        y[1] -= mass * xy * mass;
        y[2] -= mass * gx;
        y[3] -= mass * xy * mass;
        y[4] -= mass * yy * mass;
        y[5] -= mass * gy;
        y[6] -= mass * gx;
        y[7] -= mass * gy;
        y[8] -= (wx * gx) + (wy * gy);
    }
}
