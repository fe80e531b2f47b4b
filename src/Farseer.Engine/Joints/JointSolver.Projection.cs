using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>Trees whose correction went astray: taken back, and projected onto their joints.</content>
internal sealed unsafe partial class JointSolver
{
    /// <summary>
    /// Rounds of a projection: first with the bodies' own masses, then with equal ones. A light chain that a heavy load has run beyond its length bends to and fro about its straight pose by its
    /// own masses, until its bends are less than √(m/M), since all others are easier than to move the load; by equal ones the load comes back at once, by the little that it ran too far.
    /// Chains of 2 to 100 links at 1:10⁴ are whole after 60.
    /// </summary>
    private const int Projections = 80;
    private const int TrueProjections = 12;

    /// <summary>The widest turn of a body in a round, rad.</summary>
    private const double WidestTurn = 1;

    /// <summary>Takes the trees that went astray back to where h·v took them, and projects them onto their joints.</summary>
    /// <returns>True if there were any.</returns>
    private bool Project()
    {
        bool any = false;
        for (int at = 0; at < _treeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->Undone = tree->Astray;
            any |= tree->Astray;
        }

        if (!any)
        {
            return false;
        }

        Undo();
        bool open = true;
        for (int round = 0; round < Projections && open; round++)
        {
            open = ProjectOnce(round >= TrueProjections);
        }

        for (int at = 0; at < _treeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (!tree->Astray)
            {
                continue;
            }

            tree->Gains = tree->Levelled || GainsByProjection(tree);
            tree->Levelled = false;
            for (int i = tree->First; i < tree->End; i++)
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
    /// error along itself only by a far larger bend: as a speed that bend would throw off what lies on it. Such a tree keeps the speeds that it had, and the relax
    /// pass brings them into line with the joints where they are now: a chain that snaps taut is struck by impulses along itself, which come in pairs.
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

    /// <summary>
    /// Displaces a tree by its present velocities, and by a share of them if they would turn a body further than the joints' directions are good for: all of it by the same share, so that
    /// its centre of mass stays.
    /// </summary>
    private void MoveOn(JointTree* tree)
    {
        double h = _step.Substep;
        double turn = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            turn = Math.Max(turn, Math.Abs(h * _forest.Nodes[i].Velocity[2]));
        }

        double share = h * (turn > WidestTurn ? WidestTurn / turn : 1);
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            double* v = node->Velocity;
            SetMove(node, node->Move[0] + (share * v[0]), node->Move[1] + (share * v[1]), node->Move[2] + (share * v[2]));
        }
    }

    /// <summary>Gives all bodies of a tree the mass of its lightest one; radii of gyration stay.</summary>
    private void Level(JointTree* tree)
    {
        double lightest = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            lightest = Math.Max(lightest, _forest.Nodes[i].InverseMass);
        }

        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            if (node->InverseMass > 0)
            {
                node->InverseInertia *= lightest / node->InverseMass;
                node->InverseMass = lightest;
            }
        }
    }

    /// <summary>Gives the bodies of a tree their own masses again. Where nothing holds it, equal masses have kept another centre than its own.</summary>
    private void Unlevel(JointTree* tree)
    {
        double mass = 0;
        double x = 0;
        double y = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            LoadMass(node);
            double own = node->InverseMass > 0 ? 1 / node->InverseMass : 0;
            mass += own;
            x += own * node->Velocity[0];
            y += own * node->Velocity[1];
        }

        for (int i = tree->First; i < tree->End && tree->AnchorFirst == tree->AnchorEnd && mass > 0; i++)
        {
            _forest.Nodes[i].Velocity[0] -= x / mass;
            _forest.Nodes[i].Velocity[1] -= y / mass;
        }
    }

    /// <param name="levelled">As if all bodies were as heavy as the lightest.</param>
    /// <returns>True if an error was left to take out.</returns>
    private bool ProjectOnce(bool levelled)
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
            if (levelled)
            {
                tree->Levelled = true;
                Level(tree);
            }

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
            if (levelled)
            {
                Unlevel(tree);
            }

            MoveOn(tree);
        }

        return any;
    }
}
