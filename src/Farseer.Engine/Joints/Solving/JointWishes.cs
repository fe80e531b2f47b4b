using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>
/// What joints without hard rows between single bodies wish for: that a body be somewhere, or move at some speed. Contacts are solved
/// after them, so that no body moves with a speed that a surface in its way has not seen. The other way round a body went into a wall by
/// F·h²/m in each substep, and its velocity read 0. Joints of trees are solved together with their contacts; and a limit is no wish: it
/// holds as hard as a surface does, and comes after the contacts as before.
/// </summary>
[NotState(Why.Fixed)]
internal sealed unsafe class JointWishes : JointPart
{
    /// <summary>
    /// How hard a touching body is wished along at most: by what brings it from rest by half this share of its reach in a step, and by this
    /// many times its weight besides. A box of 1 m has 800 m/s² at sixty steps a second.
    /// </summary>
    private const double WishShare = 0.25;
    private const double WishLoads = 16;

    public JointWishes(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>What loose joints do in the biased pass or the relax pass, before the contacts.</summary>
    public void SolveWishes(bool biased)
    {
        if (_loose.Any)
        {
            _loose.Solve(biased, 1, wishes: true, limits: false);
        }

        if (_work.AnyWishes)
        {
            _work.Wishing = true;
            ExchangeWished(store: false);
            _solver.Sweeps.Sweep(biased ? SweepKind.Biased : SweepKind.Relaxed);
            ExchangeWished(store: true);
            _work.Wishing = false;
        }
    }

    /// <summary>
    /// The velocities of single bodies, from the store or back: whether others are asked between the passes would show in their last
    /// places.
    /// </summary>
    private void ExchangeWished(bool store)
    {
        for (int at = 0; at < _work.NodeCount; at++)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            if (!_forest.Trees[_forest.Trees[node->Tree].Group].Wishes)
            {
                continue;
            }

            BodyState* state = _work.Step.Bodies.State.Pointer + node->Body;
            if (store)
            {
                state->LinearVelocity.X = (float)node->Velocity[0];
                state->LinearVelocity.Y = (float)node->Velocity[1];
                state->AngularVelocity = (float)node->Velocity[2];
            }
            else
            {
                node->Velocity[0] = HeldVelocity.Refresh(node->Velocity[0], state->LinearVelocity.X);
                node->Velocity[1] = HeldVelocity.Refresh(node->Velocity[1], state->LinearVelocity.Y);
                node->Velocity[2] = HeldVelocity.Refresh(node->Velocity[2], state->AngularVelocity);
            }
        }
    }

    /// <summary>A single body that is solved as loose ones are, of which a joint is not of limits alone.</summary>
    public bool IsPushed(TreeNode* node)
    {
        JointTree* tree = _forest.Trees + node->Tree;
        return _work.AnyWishes && tree->Wished && _forest.Trees[tree->Group].Wishes;
    }

    public void MarkWished(int node)
    {
        if (node >= 0)
        {
            _forest.Trees[_forest.Nodes[node].Tree].Wished = true;
        }
    }

    /// <summary>It has rows of a wish, not limits alone.</summary>
    public bool IsWish(int item)
    {
        bool wishes = false;
        for (int k = 0; item >= 0 && k < _rows[item].Count; k++)
        {
            wishes |= _rows.Pointer[item].Type[k] != (byte)RowType.Limit;
        }

        return wishes;
    }

    /// <summary>
    /// Bounds what a joint of any force gives a body that touches something. One sweep a substep is all that contacts have to find such an
    /// impulse, and what is wanted without a bound would gather against them without one: soft contacts let three parts in a hundred of it
    /// through, and give the rest back when the joint goes. The bound is the same acceleration at any number of substeps. Between two
    /// bodies that move, the mass of the other one is the bound.
    /// </summary>
    public void BoundWishes()
    {
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            if (_active[i].Role == JointRole.Iterated && _rows[i].Hard == 0)
            {
                BoundWish(_active[i].Ends, _rows.Pointer + i);
            }
        }
    }

    private void BoundWish(in RowEnds ends, JointRows* rows)
    {
        bool fromA = ends.NodeA >= 0;
        int node = fromA ? ends.NodeA : ends.NodeB;
        if (node < 0 || (fromA && ends.NodeB >= 0) || _forest.Trees[_forest.Nodes[node].Tree].Eliminates)
        {
            return;
        }

        int body = _forest.Nodes[node].Body;
        if (_work.Step.Touches[body] == 0)
        {
            return;
        }

        ref BodyMass mass = ref _work.Step.Bodies.Mass[body];
        BodySize size = _work.Step.Bodies.Size[body];
        ref BodyDrive drive = ref _work.Step.Bodies.Drive[body];
        double load = Math.Sqrt((drive.X * drive.X) + (drive.Y * drive.Y));
        double most = (WishShare * size.Reach * _work.Step.Substep / (_work.Step.Dt * _work.Step.Dt)) + (WishLoads * load);
        for (int k = 0; k < rows->Count; k++)
        {
            double* j = (fromA ? rows->A : rows->B) + (k * 3);
            double straight = mass.InverseMass * Math.Sqrt((j[0] * j[0]) + (j[1] * j[1]));
            double given = straight + (size.Reach * mass.InverseInertia * Math.Abs(j[2]));
            bool soft = rows->Type[k] == (byte)RowType.Motor && rows->Damping[k] > 0;
            if (given > 0 && rows->Type[k] != (byte)RowType.Limit && !soft)
            {
                double bound = most / given;
                rows->High[k] = Math.Min(rows->High[k], bound);
                rows->Low[k] = Math.Max(rows->Low[k], -bound);
            }
        }
    }
}
