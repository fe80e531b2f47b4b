using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>Impacts of bodies that hang on trees, one after the other: see <see cref="BounceKernel"/>.</summary>
internal sealed unsafe partial class TreeImpacts : JointPart
{
    /// <summary>Impacts one after the other in a substep; a blow that runs on beyond goes on in the next.</summary>
    private const int ImpactRounds = 64;
    private bool _anyHeld;
    private int _hitCount;

    public TreeImpacts(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>A joint acts between two bodies that can move: what happens to one reaches the other.</summary>
    public bool TiesBodies
    {
        get
        {
            bool ties = _nets.Any;
            for (int i = 0; i < _work.Count && !ties; i++)
            {
                ref readonly JointLink link = ref _store.Links[_active[i].Joint];
                ties = (_work.Step.Moves[link.BodyA] & _work.Step.Moves[link.BodyB]) != 0;
            }

            return ties;
        }
    }

    /// <summary>Before a substep: holds back the contacts that are about to bounce.</summary>
    public void PrepareBounce()
    {
        _lanes.Bodies.Refresh();
        _loose.Refresh();
        _solver.Bodies.LoadVelocities();
        _anyHeld = false;
        for (int i = 0; i < _work.ContactCount; i++)
        {
            _anyHeld |= _contactPass.HoldBack(_contacts.Pointer + i);
        }
    }

    /// <summary>After the relax pass.</summary>
    public void Bounce()
    {
        _solver.Contacts.TurnWheels();
        _solver.Bodies.LoadVelocities();
        bool struck = false;
        LeaveOut(-1);
        for (int round = 0; _anyHeld && round < ImpactRounds && FindImpacts(); round++)
        {
            struck = true;
            SaveVelocities();
            int sweeps = _hitCount > 1 ? BounceKernel.Sweeps : 1;
            bool kept = _solver.Limits.KeepBeforeImpact();
            _solver.Sweeps.Sweep(SweepKind.Impact, sweeps);
            for (int again = 0; kept && again < TreeLimits.ReleaseRounds && LetGoOfPulls(); again++)
            {
                _solver.Limits.TakeBackImpact();
                _solver.Sweeps.Sweep(SweepKind.Impact, sweeps, some: true);
            }

            CatchUp();
            for (int i = 0; i < _work.ContactCount; i++)
            {
                _contactPass.Prepare(_contacts.Pointer + i);
            }
        }

        LeaveOut(1);
        if (struck)
        {
            _solver.Bodies.LoadPoses();
            _solver.Rows.WriteRows(false);
            _solver.Limits.LetGoOfOpenLimits();
            _solver.Sweeps.FactorAll();
        }

        if (_anyHeld)
        {
            FinishImpacts();
        }

        _solver.Bodies.StoreVelocities();
    }

    /// <summary>
    /// Lets go of the limits that pull after an impact, which takes them for joints that always hold; the impact of their groups is to be
    /// found again without them. A body between a rope at its end and another body that turns about its own middle could move nowhere: its
    /// limit pulled with ten thousand times its momentum, was let go after all, and the body had that.
    /// </summary>
    /// <returns>True if there are some.</returns>
    private bool LetGoOfPulls()
    {
        bool any = false;
        _solver.Sweeps.ClearGroups();
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->Refactored = tree->HasLimits && tree->Eliminates && _solver.Limits.LetGoOfPulls(tree);
            _forest.GroupOf(tree)->GroupActs |= tree->Refactored;
            any |= tree->Refactored;
        }

        return any;
    }

    /// <summary>What joints give in impacts, between a call with -1 and one with 1, is no tension that lasts (see TreeTension).</summary>
    private void LeaveOut(double sign)
    {
        for (int at = 0; _anyHeld && at < _work.JointCount; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            joint->GivenBefore[0] += sign * joint->Given[0];
            joint->GivenBefore[1] += sign * joint->Given[1];
        }
    }

    /// <summary>What the impacts gave is let go, and stays in the sums of the step.</summary>
    private void FinishImpacts()
    {
        if (_work.Step.Impulses != null)
        {
            AddImpulses(_work.Step.Impulses, 1);
        }

        for (int i = 0; i < _work.ContactCount; i++)
        {
            TreeContactPass.FinishImpact(_contacts.Pointer + i);
        }

        if (_work.Step.Impulses != null)
        {
            AddImpulses(_work.Step.Impulses, -1);
        }
    }

    /// <summary>After impacts that do not see the trees: what they took out of joint is put right.</summary>
    public void Settle()
    {
        _nets.Relax(true);
        _solver.Lanes.SolveLanes(SweepKind.Settle, false, 1);
        _solver.Bodies.LoadVelocities();
        _solver.Limits.SolveTrees(TargetKind.Relaxed, false);
        _solver.Sweeps.Sweep(SweepKind.Settle);
        _solver.Bodies.StoreVelocities();
    }

    /// <summary>Finds the impacts that no other of their trees precedes.</summary>
    private bool FindImpacts()
    {
        for (int at = 0; at < _work.TreeCount; at++)
        {
            _forest.Trees[_trees[at]].Since = -1;
        }

        bool any = false;
        for (int i = 0; i < _work.ContactCount; i++)
        {
            TreeContact* contact = _contacts.Pointer + i;
            contact->Hit = _contactPass.FindImpact(contact);
            if (contact->Hit)
            {
                any = true;
                NoteTime(contact->Ends.NodeA, contact->Since);
                NoteTime(contact->Ends.NodeB, contact->Since);
            }
        }

        _hitCount = 0;
        for (int i = 0; i < _work.ContactCount; i++)
        {
            TreeContact* contact = _contacts.Pointer + i;
            double first = Math.Max(LatestOf(contact->Ends.NodeA), LatestOf(contact->Ends.NodeB));
            contact->Hit &= contact->Since >= first - (BounceKernel.SameMoment * _work.Step.Substep);
            contact->Impact |= contact->Hit;
            _hitCount += contact->Hit ? 1 : 0;
        }

        return any;
    }

    private void NoteTime(int node, double time)
    {
        if (node >= 0)
        {
            ref double since = ref _forest.Trees[_forest.Nodes[node].Tree].Since;
            since = Math.Max(since, time);
        }
    }

    private double LatestOf(int node) => node < 0 ? -1 : _forest.Trees[_forest.Nodes[node].Tree].Since;

    private void SaveVelocities()
    {
        for (int at = 0; at < _work.NodeCount; at++)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            for (int k = 0; k < 3; k++)
            {
                node->Saved[k] = node->Velocity[k];
            }
        }
    }

    /// <summary>Moves the bodies by what the change of their velocities would have brought since the impact.</summary>
    private void CatchUp()
    {
        _solver.Bodies.StoreVelocities();
        for (int at = 0; at < _work.NodeCount; at++)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            double time = _forest.Trees[node->Tree].Since;
            if (time < 0)
            {
                continue;
            }

            double x = node->Velocity[0] - node->Saved[0];
            double y = node->Velocity[1] - node->Saved[1];
            double w = node->Velocity[2] - node->Saved[2];
            if (x != 0 || y != 0 || w != 0)
            {
                _solver.Bodies.SetMove(node, node->Move[0] + (time * x), node->Move[1] + (time * y), node->Move[2] + (time * w));
                ref BodyMotion motion = ref _work.Step.Bodies.Motion[node->Body];
                motion.StartX += (float)x;
                motion.StartY += (float)y;
                motion.StartW += (float)w;
            }
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _anyHeld);
        s.Value(ref _hitCount);
    }
}
