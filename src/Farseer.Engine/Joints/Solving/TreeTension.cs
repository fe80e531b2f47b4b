using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>
/// Joints under tension hold a body in line. A force f that a joint gives to a body at the arm r has the moment r × f, and a turn by dθ
/// changes it by -(r·f)·dθ: the body turns against a spring of stiffness k = Σ r·f. A substep takes that moment as it is at its start,
/// which holds nothing where the body could swing faster than the substep sees, ω² = k/I > 1/h²: planks of a taut bridge turned out of
/// the way of a load of a thousand of them. The joints' rows say nothing of k, so there the inertia counts as h²k, with which the body
/// swings just as fast as substeps can follow.
/// It changes before the substep begins, while velocities fulfil the rows: what a correction adds and the relax pass takes out again must
/// go by one mass. And where it grows the body keeps its angular momentum, not its speed, or energy would be made.
/// Only trees on which contacts press have it: these are solved against what the tree bears. Without them the substep keeps the energy of
/// a swing of any frequency, and would not if masses changed.
/// </summary>
[NotState(Why.Fixed)]
internal sealed unsafe class TreeTension : JointPart
{
    public TreeTension(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>
    /// Before a substep, by what the joints gave in the one before; first by their mean forces in the step before, without which a taut
    /// bridge trembles twenty times as fast. Trees whose inertia changes are factored anew.
    /// </summary>
    public void Stiffen()
    {
        bool any = false;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (tree->Pressed && tree->Eliminates && Stiffen(tree))
            {
                _solver.Responses.Factor(tree);
                TreeFactor.CompleteMasses(_forest, tree);
                any = true;
            }
        }

        if (any)
        {
            _solver.Lanes.PrepareFrom(0);
        }
    }

    /// <summary>The same of the trees that are solved side by side.</summary>
    public void StiffenOnLanes()
    {
        if (_lanes.Stiffen())
        {
            _solver.Lanes.PrepareOnLanes(false);
        }
    }

    /// <summary>Takes the larger of a body's own inertia and that of its tension.</summary>
    /// <param name="bodies">The store that has its own.</param>
    /// <param name="node">With Σ r·p of the impulses p that joints gave to it in the last substep.</param>
    /// <param name="substep">Its length.</param>
    /// <param name="spin">The body's.</param>
    /// <returns>True if it is another than before.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Stiffen(BodyStore bodies, TreeNode* node, double substep, ref double spin)
    {
        double own = bodies.Mass[node->Body].InverseInertia;
        double inertia = substep * node->Tension;
        double inverse = inertia * own > 1 ? 1 / inertia : own;
        double before = node->InverseInertia;
        node->InverseInertia = inverse;
        if (inverse < before)
        {
            ref float stored = ref bodies.State[node->Body].AngularVelocity;
            spin = HeldVelocity.Refresh(spin, stored) * (inverse / before);
            stored = (float)spin;
        }

        return inverse != before;
    }

    private bool Stiffen(JointTree* tree)
    {
        TreeNode* nodes = _forest.Nodes;
        for (int i = tree->First; i < tree->End; i++)
        {
            nodes[i].Tension = 0;
        }

        for (int i = tree->First + 1; i < tree->End; i++)
        {
            for (int k = 0; k < nodes[i].EdgeCount; k++)
            {
                Pull(_forest.EdgeJoints[nodes[i].EdgeFirst + k]);
            }
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            Pull(_forest.Anchors[i].Active);
        }

        for (int i = tree->LoopFirst; i < tree->LoopEnd; i++)
        {
            Pull(_loops.JointAt(i));
        }

        bool any = false;
        for (int i = tree->First; i < tree->End; i++)
        {
            any |= Stiffen(_work.Step.Bodies, nodes + i, _work.Step.Substep, ref nodes[i].Velocity[2]);
        }

        return any;
    }

    /// <summary>What a joint that holds a point gave in the substep, at both of its bodies.</summary>
    private void Pull(int index)
    {
        ActiveJoint* joint = _active.Pointer + index;
        JointRows* rows = _rows.Pointer + index;
        double x = joint->Given[0] - joint->GivenBefore[0];
        double y = joint->Given[1] - joint->GivenBefore[1];
        joint->GivenBefore[0] = joint->Given[0];
        joint->GivenBefore[1] = joint->Given[1];
        if (rows->Hard < JointRows.OfPoint || rows->B[0] != 1 || rows->B[4] != 1)
        {
            return;
        }

        // The rows are x and y of anchor B less anchor A: (-1, 0, a.y), (0, -1, -a.x) at A and (1, 0, -b.y), (0, 1, b.x) at B.
        Pull(joint->Ends.NodeA, (rows->A[5] * x) - (rows->A[2] * y));
        Pull(joint->Ends.NodeB, (rows->B[5] * x) - (rows->B[2] * y));
    }

    private void Pull(int node, double tension)
    {
        if (node >= 0)
        {
            _forest.Nodes[node].Tension += tension;
        }
    }
}
