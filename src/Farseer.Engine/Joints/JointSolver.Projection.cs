using System;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>Trees whose correction went astray: taken back, and projected onto their joints.</content>
internal sealed unsafe partial class JointSolver
{
    private const int Projections = 12;

    /// <summary>Takes the trees that went astray back to where h·v took them, and projects them onto their joints.</summary>
    /// <returns>True if there were any.</returns>
    private bool Project()
    {
        bool any = false;
        for (int at = 0; at < _treeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->Undone = tree->Astray;
            tree->Strayed = tree->Astray;
            any |= tree->Astray;
        }

        if (!any)
        {
            return false;
        }

        Undo();
        for (int round = 0; round < Projections && ProjectOnce(); round++)
        {
        }

        for (int at = 0; at < _treeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (!tree->Astray)
            {
                continue;
            }

            tree->Gains = GainsByProjection(tree);
            for (int i = tree->First; i < tree->End && !(tree->Gains && tree->Strayed); i++)
            {
                TreeNode* node = _forest.Nodes + i;
                for (int k = 0; k < 3; k++)
                {
                    node->Velocity[k] = tree->Gains ? node->PlainVelocity[k] : ProjectedSpeed(node, k);
                }
            }
        }

        RestoreImpulses(true);
        ForgetBendsAstray();
        StoreVelocities();
        return true;
    }

    /// <summary>
    /// Where a tree went astray nothing is foreseen: an error along a taut chain is met by the biased pass only with a far larger bend, which
    /// lost the load of a bridge.
    /// </summary>
    private void ForgetBendsAstray()
    {
        for (int at = 0; at < _jointCount; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            if (_forest.Trees[TreeOf(joint->Ends)].Astray)
            {
                ForgetBends(joint);
            }
        }
    }

    private double ProjectedSpeed(TreeNode* node, int k) => (node->Move[k] - node->StartMove[k]) / _step.Substep;

    /// <summary>
    /// The way to the projected place, taken as a speed, has more energy than the body had. A chain that is as long as its gap can close an
    /// error along itself only by a far larger bend: as a speed that bend would throw off what lies on it. Such a tree is left with the speeds of
    /// its last correction, which are small; those that only touch it keep the speeds that they had, or a car that drives onto a taut bridge would
    /// stand at once. The relax pass brings both into line with the joints.
    /// </summary>
    private bool GainsByProjection(JointTree* tree)
    {
        double gain = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            for (int k = 0; k < 3; k++)
            {
                double inverse = k < 2 ? node->InverseMass : node->InverseInertia;
                double projected = ProjectedSpeed(node, k);
                double plain = node->PlainVelocity[k];
                gain += inverse > 0 ? ((projected * projected) - (plain * plain)) / inverse : 0;
            }
        }

        return gain > 0;
    }

    /// <summary>
    /// What pressed on a tree that went astray was held against a wrong motion: all that touches it goes back as well, with the
    /// impulses of the surfaces. The trees among them are projected too.
    /// </summary>
    private void Undo()
    {
        // Each round but the last takes back one tree more.
        for (bool more = true; more;)
        {
            more = false;
            for (int i = 0; i < _contactCount; i++)
            {
                ref RowEnds ends = ref _contacts[i].Ends;
                if (ends.NodeA >= 0 && ends.NodeB >= 0)
                {
                    JointTree* a = _forest.Trees + _forest.Nodes[ends.NodeA].Tree;
                    JointTree* b = _forest.Trees + _forest.Nodes[ends.NodeB].Tree;
                    more |= a->Undone != b->Undone;
                    a->Undone |= b->Undone;
                    b->Undone = a->Undone;
                }
            }
        }

        for (int i = 0; i < _contactCount; i++)
        {
            ref TreeContact contact = ref _contacts[i];
            if (IsUndone(contact.Ends.NodeA) || IsUndone(contact.Ends.NodeB))
            {
                contact.Point0.Normal = contact.Point0.Plain;
                contact.Point1.Normal = contact.Point1.Plain;
            }
        }

        RestoreImpulses(false);
        for (int at = 0; at < _nodeCount; at++)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            JointTree* tree = _forest.Trees + node->Tree;
            if (tree->Undone)
            {
                tree->Astray = tree->Eliminates;
                tree->Gains = false;
                SetMove(node, node->PlainMove[0], node->PlainMove[1], node->PlainMove[2]);
                node->Velocity[0] = node->PlainVelocity[0];
                node->Velocity[1] = node->PlainVelocity[1];
                node->Velocity[2] = node->PlainVelocity[2];
            }
        }
    }

    /// <summary>What a correction or a projection that is taken back gave through the joints was never given.</summary>
    /// <param name="projected">Of projections that changed no speeds; else of corrections.</param>
    private void RestoreImpulses(bool projected)
    {
        for (int at = 0; at < _jointCount; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            int node = joint->Ends.NodeA >= 0 ? joint->Ends.NodeA : joint->Ends.NodeB;
            JointTree* tree = _forest.Trees + _forest.Nodes[node].Tree;
            if (projected ? tree->Astray && tree->Gains : IsUndone(joint->Ends.NodeA) || IsUndone(joint->Ends.NodeB))
            {
                Copy(joint->PlainLambda, joint->Lambda, JointRows.Most);
                Copy(joint->PlainGiven, joint->Given, 3);
            }
        }
    }

    private bool IsUndone(int node) => node >= 0 && _forest.Trees[_forest.Nodes[node].Tree].Undone;

    /// <returns>True if an error was left to take out.</returns>
    private bool ProjectOnce()
    {
        bool any = false;
        LoadPoses();
        WriteRows(false);
        for (int at = 0; at < _treeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            if (!tree->Astray)
            {
                continue;
            }

            SetTargets(tree, TargetKind.Projection);
            if (tree->Worst <= Tolerance)
            {
                continue;
            }

            any = true;
            for (int attempt = 0; attempt < LimitRounds; attempt++)
            {
                TreeFactor.Run(_forest, tree, _active.Pointer, _rows.Pointer);
                Clear(tree);
                SetTargets(tree, TargetKind.Projection);
                TreeSolve.Run(_forest, tree);
                if (!tree->HasLimits || !ReviseLimits(tree, TargetKind.Projection, false))
                {
                    break;
                }
            }

            TreeReactions.OfSolve(_forest, tree);
            TreeReactions.Give(_forest, tree, _active.Pointer, _rows.Pointer);
            for (int k = tree->First; k < tree->End; k++)
            {
                MoveOn(_forest.Nodes + k);
            }
        }

        return any;
    }
}
