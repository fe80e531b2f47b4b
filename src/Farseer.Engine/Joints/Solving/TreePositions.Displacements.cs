using System;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints.Solving;

/// <content>
/// Displacements that are no motion: errors that were put into joints from outside, and deep overlaps with trees. The velocities that take
/// them out move the bodies and are forgotten.
/// </content>
internal sealed unsafe partial class TreePositions
{
    private const int PullSweeps = 4;
    private const int PushOutSweeps = 4;

    /// <param name="projected">Trees stand elsewhere than when they were factored.</param>
    /// <param name="pushRate">Share of a deep overlap that goes in this substep.</param>
    private void Displace(bool projected, double pushRate)
    {
        bool disturbed = false;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            disturbed |= _forest.Trees[_trees[at]].Disturbed;
        }

        bool deep = false;
        for (int i = 0; i < _work.ContactCount; i++)
        {
            deep |= _contacts[i].Deep;
        }

        disturbed |= _work.Overruns > 0;
        if (disturbed)
        {
            _solver.Chains.LeavePressed();
        }

        if (_work.AnyLimits && (disturbed || deep))
        {
            _solver.Overruns.NoteLimits();
        }

        if (projected && (disturbed || deep))
        {
            FactorAnew();
        }

        if (disturbed)
        {
            PullTogether();
        }

        if (disturbed && deep)
        {
            FactorAnew();
        }

        if (deep)
        {
            PushOut(pushRate);
        }

        if (_work.AnyLimits && (disturbed || deep))
        {
            _solver.Overruns.FollowDisplacements();
        }
    }

    /// <summary>
    /// Walks want masses and ways of one pose: with the masses of another, sweeps over surfaces that are squeezed between the bodies of a
    /// tree did not settle, and a brick that had broken out of a wall of welds was pushed 10¹⁸ m away.
    /// </summary>
    private void FactorAnew()
    {
        _solver.Bodies.LoadPoses();
        _solver.Rows.WriteRows(false);
        _solver.Sweeps.FactorAll();
    }

    /// <summary>
    /// Pulls the bodies of disturbed trees together at the rate of the bias factor. Surfaces that are in the way stop them, by impulses
    /// of which nothing is kept. As velocities of the biased pass such pulls pressed on surfaces with what one relaxing sweep did not take
    /// back: bodies that a joint was given from afar were shot off at thousands of sizes a second.
    /// </summary>
    private void PullTogether()
    {
        PutVelocitiesAside();
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (tree->Disturbed)
            {
                _solver.Rows.SetTargets(tree, TargetKind.Pull);
                _loops.Solve(tree);
            }
            else
            {
                _loops.ClearTargets(tree);
            }
        }

        for (int i = 0; i < _work.ContactCount; i++)
        {
            _contacts[i].Point0.Plain = 0;
            _contacts[i].Point1.Plain = 0;
        }

        for (int at = 0; at < _work.JointCount; at++)
        {
            for (int k = 0; k < JointRows.Most; k++)
            {
                _active[_joints[at]].PlainLambda[k] = 0;
            }
        }

        _solver.Sweeps.Sweep(SweepKind.Pull, PullSweeps);
        if (_work.Overruns > 0)
        {
            _solver.Overruns.BoundTurns();
        }

        MoveAndForget();
        if (_work.Overruns > 0)
        {
            _solver.Overruns.CloseDisplaced();
            ShortenPushes();
        }
    }

    /// <summary>Moves deep overlaps with trees apart; the velocities that do it are forgotten.</summary>
    private void PushOut(double rate)
    {
        _work.PushRate = rate / _work.Step.Substep;
        PutVelocitiesAside();
        for (int at = 0; at < _work.TreeCount; at++)
        {
            _loops.ClearTargets(_forest.Trees + _trees[at]);
            _forest.Trees[_trees[at]].GroupPulls = false;
        }

        for (int i = 0; i < _work.ContactCount; i++)
        {
            _solver.Contacts.GroupAt(~i)->GroupPulls |= _contacts[i].Deep;
        }

        _solver.Sweeps.Sweep(SweepKind.PushOut, PushOutSweeps);

        MoveAndForget();
        ShortenPushes();
        _solver.Overruns.CloseDisplaced();
    }

    public static bool Yields(JointTree* tree) => tree->HasRows || tree->Disturbed;

    private void PutVelocitiesAside()
    {
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (Yields(tree))
            {
                _solver.Limits.Save(tree);
                Clear(tree);
            }
        }
    }

    /// <summary>The present velocities move the bodies and are forgotten for those put aside.</summary>
    private void MoveAndForget()
    {
        _loose.StoreMoves();
        for (int at = 0; at < _work.NodeCount; at++)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            if (Yields(_forest.Trees + node->Tree))
            {
                double* v = node->Velocity;
                for (int k = 0; k < 3; k++)
                {
                    node->PlainMove[k] = node->Move[k];
                }

                _solver.Bodies.MoveOn(node);
                v[0] = node->Saved[0];
                v[1] = node->Saved[1];
                v[2] = node->Saved[2];
            }
        }
    }

    /// <summary>
    /// A push goes along the joints' directions at its start. Where that leaves a tree out of joint a part of it is taken back: a taut
    /// chain answers a push across with a wide bend, and to put its joints right again would throw off what lies on it. Joints open by the
    /// square of a turn, so that the root of the error allowed goes. Taken back as a whole, pushes never got rings that had been driven
    /// into each other apart.
    /// </summary>
    private void ShortenPushes()
    {
        _solver.Bodies.LoadPoses();
        _solver.Rows.WriteErrors();
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (!tree->HasRows || !tree->Eliminates || tree->Disturbed)
            {
                continue;
            }

            _solver.Rows.SetTargets(tree, TargetKind.Projection);
            if (!(tree->Worst > Failed))
            {
                continue;
            }

            double share = Math.Sqrt(Failed / tree->Worst);
            for (int i = tree->First; i < tree->End; i++)
            {
                TreeNode* node = _forest.Nodes + i;
                _solver.Bodies.SetMove(node, Between(node, 0, share), Between(node, 1, share), Between(node, 2, share));
            }
        }
    }

    private static double Between(TreeNode* node, int k, double share) =>
        node->PlainMove[k] + (share * (node->Move[k] - node->PlainMove[k]));
}
