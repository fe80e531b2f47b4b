using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>Trees whose correction went astray: taken back, and projected onto their joints.</summary>
[NotState(Why.Fixed)]
internal sealed unsafe class TreeProjection : JointPart
{
    /// <summary>
    /// Rounds of a projection: first with the bodies' own masses, then with equal ones. A light chain that a heavy load has run beyond
    /// its length bends to and fro about its straight pose by its own masses, until its bends are less than √(m/M), since all others are
    /// easier than to move the load; by equal ones the load comes back at once, by the little that it ran too far. Chains of 2 to 100
    /// links at 1:10⁴ are whole after 80.
    /// </summary>
    private const int Projections = 80;

    public const int TrueProjections = 12;

    /// <summary>Ratio of the heaviest mass of a tree to its lightest from which on equal ones make another problem of it.</summary>
    private const double Uneven = 4;

    /// <summary>The widest turn of a body in a round, rad.</summary>
    private const double WidestTurn = 1;

    public TreeProjection(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>Takes the trees that went astray back to where h·v took them, and projects them onto their joints.</summary>
    /// <returns>True if there were any.</returns>
    public bool ProjectTrees()
    {
        bool any = false;
        for (int at = 0; at < _work.TreeCount; at++)
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

        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (!tree->Astray)
            {
                continue;
            }

            tree->Impelled = ImpelledShare(tree);
            for (int i = tree->First; i < tree->End; i++)
            {
                TreeNode* node = _forest.Nodes + i;
                for (int k = 0; k < 3; k++)
                {
                    node->Velocity[k] = node->PlainVelocity[k] + (tree->Impelled * (ProjectedSpeed(node, k) - node->PlainVelocity[k]));
                }
            }

            if (tree->Levelled && IsFree(tree))
            {
                KeepAngularMomentum(tree);
            }
        }

        RestoreImpulses(true);
        ForgetBendsAstray();
        _solver.Bodies.StoreVelocities();
        return true;
    }

    /// <summary>
    /// Where a tree went astray nothing is foreseen: an error along a taut chain is met by the biased pass only with a far larger bend,
    /// which lost the load of a bridge.
    /// </summary>
    private void ForgetBendsAstray()
    {
        for (int at = 0; at < _work.JointCount; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            if (_forest.Trees[_forest.TreeOf(joint->Ends)].Astray)
            {
                TreePositions.ForgetBends(joint);
            }
        }
    }

    private double ProjectedSpeed(TreeNode* node, int k) => (node->Move[k] - node->StartMove[k]) / _work.Step.Substep;

    /// <summary>
    /// Which share of the displacements' impulses acts on speeds too: all of it, if the speeds of the way to the projected place have no
    /// more energy than the tree had. A chain that is as long as its gap can close an error along itself only by a far larger bend: as a
    /// speed that bend would throw off what lies on it. Then they act as far as they take energy: it is least at a share -v·Md/d·Md of
    /// the change d. They come in pairs, whatever the share, and the relax pass brings the rest into line with the joints.
    /// </summary>
    private double ImpelledShare(JointTree* tree)
    {
        double along = 0;
        double square = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            for (int k = 0; k < 3; k++)
            {
                double inverse = k < 2 ? node->InverseMass : node->InverseInertia;
                double plain = node->PlainVelocity[k];
                double change = ProjectedSpeed(node, k) - plain;
                along += inverse > 0 ? plain * change / inverse : 0;
                square += inverse > 0 ? change * change / inverse : 0;
            }
        }

        return (2 * along) + square <= 0 ? 1 : Math.Max(0, -along / square);
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
            for (int i = 0; i < _work.ContactCount; i++)
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

        for (int i = 0; i < _work.ContactCount; i++)
        {
            ref TreeContact contact = ref _contacts[i];
            if (IsUndone(contact.Ends.NodeA) || IsUndone(contact.Ends.NodeB))
            {
                contact.Point0.Normal = contact.Point0.Plain;
                contact.Point1.Normal = contact.Point1.Plain;
            }
        }

        RestoreImpulses(false);
        for (int at = 0; at < _work.NodeCount; at++)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            JointTree* tree = _forest.Trees + node->Tree;
            if (tree->Undone)
            {
                tree->Astray = tree->Eliminates;
                tree->Levelled = false;
                _solver.Bodies.SetMove(node, node->PlainMove[0], node->PlainMove[1], node->PlainMove[2]);
                node->Velocity[0] = node->PlainVelocity[0];
                node->Velocity[1] = node->PlainVelocity[1];
                node->Velocity[2] = node->PlainVelocity[2];
            }
        }
    }

    /// <summary>
    /// What a correction that is taken back gave through the joints was never given; nor is a projection that does not act on speeds as a
    /// whole.
    /// </summary>
    /// <param name="projected">Of projections; else of corrections.</param>
    private void RestoreImpulses(bool projected)
    {
        for (int at = 0; at < _work.JointCount; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            JointTree* tree = _forest.Trees + _forest.TreeOf(joint->Ends);
            bool goesBack = projected
                ? tree->Astray && (tree->Levelled || tree->Impelled < 1)
                : IsUndone(joint->Ends.NodeA) || IsUndone(joint->Ends.NodeB);
            if (goesBack)
            {
                TreePositions.Copy(joint->PlainLambda, joint->Lambda, JointRows.Most);
                TreePositions.Copy(joint->PlainGiven, joint->Given, 3);
            }
        }
    }

    private bool IsUndone(int node) => node >= 0 && _forest.Trees[_forest.Nodes[node].Tree].Undone;

    /// <summary>
    /// Displaces a tree by its present velocities, and by a share of them if they would turn a body further than the joints' directions
    /// are good for: all of it by the same share, so that its centre of mass stays.
    /// </summary>
    public void MoveTree(JointTree* tree)
    {
        double h = _work.Step.Substep;
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
            _solver.Bodies.SetMove(node, node->Move[0] + (share * v[0]), node->Move[1] + (share * v[1]), node->Move[2] + (share * v[2]));
        }
    }

    /// <summary>Puts a tree back to where h·v took it.</summary>
    private void Recall(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            _solver.Bodies.SetMove(node, node->PlainMove[0], node->PlainMove[1], node->PlainMove[2]);
        }
    }

    /// <summary>See <see cref="Uneven"/>.</summary>
    private bool IsUneven(JointTree* tree)
    {
        double lightest = LightestOf(tree);
        bool uneven = false;
        for (int i = tree->First; i < tree->End; i++)
        {
            double inverse = _forest.Nodes[i].InverseMass;
            uneven |= inverse > 0 && lightest > Uneven * inverse;
        }

        return uneven;
    }

    /// <summary>The inverse mass of the lightest body of a tree.</summary>
    private double LightestOf(JointTree* tree)
    {
        double lightest = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            lightest = Math.Max(lightest, _forest.Nodes[i].InverseMass);
        }

        return lightest;
    }

    /// <summary>Gives all bodies of a tree the mass of its lightest one; radii of gyration stay.</summary>
    private void Level(JointTree* tree)
    {
        double lightest = LightestOf(tree);
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

    /// <summary>
    /// Gives the bodies of a tree their own masses again. Where nothing holds it, displacements by equal masses have kept another centre
    /// than its own.
    /// </summary>
    private void Unlevel(JointTree* tree)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            _solver.Bodies.LoadMass(_forest.Nodes + i);
        }

        if (!IsFree(tree))
        {
            return;
        }

        double mass = 0;
        double x = 0;
        double y = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            double own = 1 / node->InverseMass;
            mass += own;
            x += own * node->Velocity[0];
            y += own * node->Velocity[1];
        }

        for (int i = tree->First; i < tree->End; i++)
        {
            _forest.Nodes[i].Velocity[0] -= x / mass;
            _forest.Nodes[i].Velocity[1] -= y / mass;
        }
    }

    /// <summary>Nothing holds the tree, nor one of its bodies.</summary>
    private bool IsFree(JointTree* tree)
    {
        bool free = tree->AnchorFirst == tree->AnchorEnd;
        for (int i = tree->First; i < tree->End; i++)
        {
            free &= _forest.Nodes[i].InverseMass > 0 && _forest.Nodes[i].InverseInertia > 0;
        }

        return free;
    }

    /// <summary>
    /// Turns a tree that nothing holds as a whole, so that it spins about its centre as it did: displacements by other masses than its
    /// own have kept the momentum of those.
    /// </summary>
    private void KeepAngularMomentum(JointTree* tree)
    {
        double mass = 0;
        double x = 0;
        double y = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            ref BodyPose pose = ref _work.Step.Bodies.Pose[node->Body];
            double own = 1 / node->InverseMass;
            mass += own;
            x += own * (pose.X + node->Move[0]);
            y += own * (pose.Y + node->Move[1]);
        }

        double inertia = 0;
        double missing = 0;
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            ref BodyPose pose = ref _work.Step.Bodies.Pose[node->Body];
            double own = 1 / node->InverseMass;
            double spin = 1 / node->InverseInertia;
            double rx = pose.X + node->Move[0] - (x / mass);
            double ry = pose.Y + node->Move[1] - (y / mass);
            double* v = node->Velocity;
            double* plain = node->PlainVelocity;
            inertia += spin + (own * ((rx * rx) + (ry * ry)));
            missing += (spin * (plain[2] - v[2])) + (own * ((rx * (plain[1] - v[1])) - (ry * (plain[0] - v[0]))));
        }

        double turn = missing / inertia;
        for (int i = tree->First; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            ref BodyPose pose = ref _work.Step.Bodies.Pose[node->Body];
            node->Velocity[0] -= turn * (pose.Y + node->Move[1] - (y / mass));
            node->Velocity[1] += turn * (pose.X + node->Move[0] - (x / mass));
            node->Velocity[2] += turn;
        }
    }

    /// <param name="levelled">As if all bodies were as heavy as the lightest.</param>
    /// <returns>True if an error was left to take out.</returns>
    private bool ProjectOnce(bool levelled)
    {
        bool any = false;
        _solver.Bodies.LoadPoses();
        _solver.Rows.WriteRows(false);
        for (int at = 0; at < _work.TreeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            if (!tree->Astray)
            {
                continue;
            }

            _solver.Rows.SetTargets(tree, TargetKind.Projection);
            if (tree->Worst <= TreePositions.Tolerance || (levelled && !tree->Levelled && !IsUneven(tree)))
            {
                continue;
            }

            any = true;
            if (levelled && !tree->Levelled)
            {
                tree->Levelled = true;
                Recall(tree);
                continue;
            }

            if (tree->Levelled)
            {
                Level(tree);
            }

            for (int attempt = 0; attempt < TreeLimits.LimitRounds; attempt++)
            {
                _solver.Responses.Factor(tree);
                _solver.Positions.Clear(tree);
                _solver.Rows.SetTargets(tree, TargetKind.Projection);
                _loops.Solve(tree);
                if (!tree->HasLimits || !_solver.Limits.ReviseLimits(tree, TargetKind.Projection, false))
                {
                    break;
                }
            }

            TreeReactions.OfSolve(_forest, tree);
            _solver.Responses.Give(tree);
            if (tree->Levelled)
            {
                Unlevel(tree);
            }

            MoveTree(tree);
        }

        return any;
    }
}
