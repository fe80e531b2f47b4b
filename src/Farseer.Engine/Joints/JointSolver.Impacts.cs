using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>Impacts of bodies that hang on trees, one after the other: see <see cref="BounceKernel"/>.</content>
internal sealed unsafe partial class JointSolver
{
    /// <summary>Impacts one after the other in a substep; a blow that runs on beyond goes on in the next.</summary>
    private const int ImpactRounds = 64;

    private bool _anyHeld;
    private int _hitCount;

    /// <summary>A joint acts between two bodies that can move: what happens to one reaches the other.</summary>
    public bool TiesBodies
    {
        get
        {
            bool ties = _nets.Any;
            for (int i = 0; i < _count && !ties; i++)
            {
                ref readonly JointLink link = ref _store.Links[_active[i].Joint];
                ties = (_step.Moves[link.BodyA] & _step.Moves[link.BodyB]) != 0;
            }

            return ties;
        }
    }

    /// <summary>Before a substep: holds back the contacts that are about to bounce.</summary>
    public void PrepareBounce()
    {
        _lanes.Refresh();
        _loose.Refresh();
        LoadVelocities();
        _anyHeld = false;
        for (int i = 0; i < _contactCount; i++)
        {
            _anyHeld |= _contactPass.HoldBack(_contacts.Pointer + i);
        }
    }

    /// <summary>After the relax pass.</summary>
    public void Bounce()
    {
        TurnWheels();
        LoadVelocities();
        bool struck = false;
        for (int round = 0; _anyHeld && round < ImpactRounds && FindImpacts(); round++)
        {
            struck = true;
            SaveVelocities();
            int sweeps = _hitCount > 1 ? BounceKernel.Sweeps : 1;
            Sweep(Pass.Impact, sweeps);
            CatchUp();
            for (int i = 0; i < _contactCount; i++)
            {
                _contactPass.Prepare(_contacts.Pointer + i);
            }
        }

        if (struck)
        {
            LoadPoses();
            WriteRows(false);
            LetGoOfOpenLimits();
            Factor();
        }

        if (_anyHeld)
        {
            FinishImpacts();
        }

        StoreVelocities();
    }

    /// <summary>What the impacts gave is let go, and stays in the sums of the step.</summary>
    private void FinishImpacts()
    {
        if (_step.Impulses != null)
        {
            AddImpulses(_step.Impulses, 1);
        }

        for (int i = 0; i < _contactCount; i++)
        {
            TreeContactPass.FinishImpact(_contacts.Pointer + i);
        }

        if (_step.Impulses != null)
        {
            AddImpulses(_step.Impulses, -1);
        }
    }

    /// <summary>After impacts that do not see the trees: what they took out of joint is put right.</summary>
    public void Settle()
    {
        _nets.Relax(true);
        SolveLanes(Pass.Settle, false, 1);
        LoadVelocities();
        SolveTrees(TargetKind.Relaxed, false);
        Sweep(Pass.Settle);
        StoreVelocities();
    }

    /// <summary>Finds the impacts that no other of their trees precedes.</summary>
    private bool FindImpacts()
    {
        for (int at = 0; at < _treeCount; at++)
        {
            _forest.Trees[_trees[at]].Since = -1;
        }

        bool any = false;
        for (int i = 0; i < _contactCount; i++)
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
        for (int i = 0; i < _contactCount; i++)
        {
            TreeContact* contact = _contacts.Pointer + i;
            double first = Math.Max(LatestOf(contact->Ends.NodeA), LatestOf(contact->Ends.NodeB));
            contact->Hit &= contact->Since >= first - (BounceKernel.SameMoment * _step.Substep);
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
        for (int at = 0; at < _nodeCount; at++)
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
        StoreVelocities();
        for (int at = 0; at < _nodeCount; at++)
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
                SetMove(node, node->Move[0] + (time * x), node->Move[1] + (time * y), node->Move[2] + (time * w));
                ref BodyMotion motion = ref _step.Bodies.Motion[node->Body];
                motion.StartX += (float)x;
                motion.StartY += (float)y;
                motion.StartW += (float)w;
            }
        }
    }
}
