using System;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>Joints that close a loop within a tree.</content>
internal sealed unsafe partial class JointPass
{
    /// <summary>
    /// ρ of a loop's block in terms of its rows' own responses; blocks are iterated, so a soft direction still closes. To move a row by
    /// its error takes the energy v²/2K: at 1e-4 a loop of welds with errors of a blow doubled the energy of its wall.
    /// </summary>
    private const double DeadLoop = 1e-3;

    /// <summary>
    /// As of a tree's rows: a large error came from outside and goes by displacements alone. As speeds such errors of loops that had drifted
    /// apart by ten sizes were contradicted by the tree, and threw bodies off at thousands of sizes a second.
    /// </summary>
    private double Bias(ActiveJoint* joint, JointRows* r, int k, in JointStep step)
    {
        double error = r->Error[k];
        if (!joint->Ends.Coupled)
        {
            double fastest = NetHurry * r->SizeOf(k) / step.Dt;
            return Math.Max(-fastest, Math.Min(fastest, error * NetBias / step.Substep));
        }

        JointTree* tree = _view.Trees + _view.Nodes[joint->Ends.NodeA].Tree;
        tree->Disturbed |= tree->IsOutside(Math.Abs(error) / r->SizeOf(k));
        return tree->Disturbed ? 0 : error / step.Substep;
    }

    /// <summary>While bodies are displaced: what closes a loop takes part, and limits that stand aside; no impulse of it is kept.</summary>
    public void Pull(ActiveJoint* joint, JointRows* r, in JointStep step)
    {
        if (joint->Overrun && !joint->BlockLimits)
        {
            PullLimits(joint, r, step);
        }

        if (joint->Role != JointRole.Iterated || r->Hard == 0 || !joint->Ends.Coupled)
        {
            return;
        }

        RowEnds.Visit(_view, &joint->Ends);
        double* residual = stackalloc double[3];
        double* impulse = stackalloc double[3];
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        for (int k = 0; k < r->Hard; k++)
        {
            bool servo = r->Type[k] == (byte)RowType.Servo;
            residual[k] = RowSpeed(joint, r, k) + (servo ? 0 : JointSolver.PullSpeed(r, k, step));
        }

        TreeSolve.Multiply(joint->Block, residual, r->Hard, impulse);
        for (int k = 0; k < r->Hard; k++)
        {
            Scale(r->A + (k * 3), -impulse[k], a);
            Scale(r->B + (k * 3), -impulse[k], b);
            RowEnds.Apply(_view, &joint->Ends, a, b);
        }
    }

    /// <summary>Limits that stand aside are pulled to their places; by nothing else, and no further.</summary>
    private void PullLimits(ActiveJoint* joint, JointRows* r, in JointStep step)
    {
        RowEnds.Visit(_view, &joint->Ends);
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        for (int k = r->Hard; k < r->Count; k++)
        {
            if (r->Type[k] != (byte)RowType.Limit || !(joint->Outside[k] < 0) || !(joint->Response[k] > 0))
            {
                continue;
            }

            double v = Displacing(joint->Ends.NodeA, r->A + (k * 3)) + Displacing(joint->Ends.NodeB, r->B + (k * 3));
            double old = joint->PlainLambda[k];
            double pull = JointSolver.PullSpeed(joint->Outside[k], r, k, step);
            joint->PlainLambda[k] = Math.Max(0, old - ((v + pull) / joint->Response[k]));
            Scale(r->A + (k * 3), joint->PlainLambda[k] - old, a);
            Scale(r->B + (k * 3), joint->PlainLambda[k] - old, b);
            RowEnds.Apply(_view, &joint->Ends, a, b);
        }
    }

    /// <summary>What cannot be moved is not displaced, though it may be moving.</summary>
    private double Displacing(int node, double* j) => node >= 0 ? SmallMatrix.Dot(j, _view.Nodes[node].Velocity) : 0;

    /// <summary>In the position correction: a joint that closes a loop takes out its own error.</summary>
    public void Correct(ActiveJoint* joint, JointRows* r, double h)
    {
        if (r->SoftPoint)
        {
            HoldPoint(joint, r);
        }

        if (joint->Role != JointRole.Iterated || r->Hard == 0 || !joint->Ends.Coupled)
        {
            return;
        }

        RowEnds.Visit(_view, &joint->Ends);
        bool disturbed = _view.Trees[_view.Nodes[joint->Ends.NodeA].Tree].Disturbed;
        double* residual = stackalloc double[3];
        for (int k = 0; k < r->Hard; k++)
        {
            bool servo = r->Type[k] == (byte)RowType.Servo;
            bool large = disturbed || Math.Abs(r->Error[k]) > JointSolver.Small * r->SizeOf(k);
            residual[k] = RowSpeed(joint, r, k) + (servo || large ? 0 : r->Error[k] / h);
        }

        for (int k = 0; k < r->Hard; k++)
        {
            double impulse = 0;
            for (int q = 0; q < r->Hard; q++)
            {
                impulse -= joint->Block[(k * r->Hard) + q] * residual[q];
            }

            joint->Lambda[k] += impulse;
            Apply(joint, r, k, impulse);
        }
    }

    /// <summary>
    /// Of the impulses of a block that closes a loop, those that move nothing are dropped: K (K² + ρ²)⁻¹ K is 1 where there is a
    /// response and 0 where there is none. They gather in groups of welds, a million times as large as any blow, and when a joint of such
    /// a group broke, its bodies were shot off by them.
    /// </summary>
    private void ForgetDead(ActiveJoint* joint, JointRows* r)
    {
        double* speed = stackalloc double[3];
        int n = r->Hard;
        if (_view.Trees[_view.Nodes[joint->Ends.NodeA].Tree].Disturbed)
        {
            // Displacements have turned the rows since.
            for (int p = 0; p < n; p++)
            {
                joint->Lambda[p] = 0;
            }

            return;
        }

        for (int p = 0; p < n; p++)
        {
            speed[p] = 0;
            for (int q = 0; q < n; q++)
            {
                speed[p] += Coupling(joint, r, p, q) * joint->Lambda[q];
            }
        }

        TreeSolve.Multiply(joint->Block, speed, n, joint->Lambda);
    }

    /// <summary>
    /// Of a block that closes a loop: with K in terms of the rows' own responses, K (K² + ρ²)⁻¹ is the inverse wherever there is a
    /// response, and goes to 0 with it. In a grid of welds the tree alone holds what the block would, and a linkage has dead
    /// centres; the plain inverse would divide rounding by rounding there. See <see cref="RowEnds.Dead"/>.
    /// </summary>
    private void InvertWithin(ActiveJoint* joint, JointRows* r, double* k, int n)
    {
        double* scale = stackalloc double[3];
        double* square = stackalloc double[9];
        double* inverse = stackalloc double[9];
        for (int p = 0; p < n; p++)
        {
            double own = RowEnds.Own(_view.Nodes, &joint->Ends, r->A + (p * 3), r->B + (p * 3));
            scale[p] = own > 0 ? 1 / Math.Sqrt(own) : 0;
        }

        for (int i = 0; i < n * n; i++)
        {
            k[i] *= scale[i / n] * scale[i % n];
        }

        for (int p = 0; p < n; p++)
        {
            for (int q = 0; q < n; q++)
            {
                double sum = p == q ? DeadLoop * DeadLoop : 0;
                for (int i = 0; i < n; i++)
                {
                    sum += k[(p * n) + i] * k[(i * n) + q];
                }

                square[(p * n) + q] = sum;
            }
        }

        SmallMatrix.Invert(square, n, inverse);
        for (int p = 0; p < n; p++)
        {
            for (int q = 0; q < n; q++)
            {
                double sum = 0;
                for (int i = 0; i < n; i++)
                {
                    sum += k[(p * n) + i] * inverse[(i * n) + q];
                }

                joint->Block[(p * n) + q] = scale[p] * sum * scale[q];
            }
        }
    }
}
