using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints;

/// <summary>
/// The iterated rows: limits, motors, springs, and the blocks of joints that close a loop. Each is solved in turn against the full
/// inverse mass of its bodies' trees.
/// </summary>
internal sealed unsafe class JointPass
{
    /// <summary>Share of an overrun of a limit that is taken away in a substep.</summary>
    private const double LimitRecovery = 0.2;

    /// <summary>An impulse on a limit that changes the speed by less than this share is a tie, decided by rounding.</summary>
    private const double Touching = 1e-2;

    // Blocks of a net are soft, tied to the substep rate as contacts are: ωh = π/2, ζ = 2.
    private const double AngularStep = 1.5707963267948966;
    private const double NetDamping = 4 + AngularStep;
    private const double NetProduct = AngularStep * NetDamping;
    private const double NetBias = AngularStep / NetDamping;

    private BodyState* _states;

    /// <summary>Responses, springs and blocks at the present poses.</summary>
    public void Prepare(JointForest forest, ActiveJoint* active, JointRows* rows, int count, in JointStep step)
    {
        _states = step.Bodies.State.Pointer;
        for (int i = 0; i < count; i++)
        {
            ActiveJoint* joint = active + i;
            if (!joint->HasRows)
            {
                continue;
            }

            JointRows* r = rows + i;
            if (joint->Coupled)
            {
                TreeCross.Write(forest.Nodes, joint->NodeA, joint->NodeB, joint->Cross);
            }

            for (int k = 0; k < r->Count; k++)
            {
                joint->Response[k] = Coupling(forest.Nodes, joint, r, k, k);
                SetSpring(joint, r, k, step.Substep);
            }

            if (joint->Role == JointRole.Iterated && r->Hard > 0)
            {
                PrepareBlock(forest.Nodes, joint, r);
            }
        }
    }

    /// <summary>The impulses of the substep before, on the bodies' own masses: the trees are solved afterwards.</summary>
    public void WarmStart(JointForest forest, ActiveJoint* active, JointRows* rows, int count)
    {
        for (int i = 0; i < count; i++)
        {
            ActiveJoint* joint = active + i;
            if (!joint->HasRows)
            {
                continue;
            }

            JointRows* r = rows + i;
            for (int k = joint->Role == JointRole.Iterated ? 0 : r->Hard; k < r->Count; k++)
            {
                if (r->Type[k] >= (byte)RowType.Spring)
                {
                    joint->Lambda[k] = 0;
                    continue;
                }

                Give(joint, r, k, joint->Lambda[k]);
                Push(forest.Nodes, joint->NodeA, r->A + (k * 3), joint->Lambda[k]);
                Push(forest.Nodes, joint->NodeB, r->B + (k * 3), joint->Lambda[k]);
            }
        }
    }

    public void Sweep(JointForest forest, ActiveJoint* active, JointRows* rows, int count, in JointStep step, bool biased)
    {
        TreeNode* nodes = forest.Nodes;
        for (int i = 0; i < count; i++)
        {
            ActiveJoint* joint = active + i;
            if (!joint->HasRows)
            {
                continue;
            }

            JointRows* r = rows + i;
            if (joint->NodeA >= 0)
            {
                TreeWalk.Visit(nodes, joint->NodeA);
            }

            // With both bodies in one tree the first one's velocity stays right while the walk goes to the second.
            if (joint->NodeB >= 0)
            {
                TreeWalk.Visit(nodes, joint->NodeB);
            }

            for (int k = r->Hard; k < r->Count; k++)
            {
                SolveRow(nodes, joint, r, k, step.Substep, biased);
            }

            if (joint->Role == JointRole.Iterated && r->Hard > 0)
            {
                SolveBlock(nodes, joint, r, step, biased);
            }
        }
    }

    private static void Push(TreeNode* nodes, int node, double* j, double impulse)
    {
        if (node >= 0)
        {
            TreeNode* n = nodes + node;
            n->Velocity[0] += n->InverseMass * j[0] * impulse;
            n->Velocity[1] += n->InverseMass * j[1] * impulse;
            n->Velocity[2] += n->InverseInertia * j[2] * impulse;
        }
    }

    /// <summary>J A Jᵀ between two rows of a joint.</summary>
    private static double Coupling(TreeNode* nodes, ActiveJoint* joint, JointRows* r, int p, int q)
    {
        double* product = stackalloc double[3];
        double sum = 0;
        if (joint->NodeA >= 0)
        {
            double* j = r->A + (q * 3);
            SmallMatrix.Apply(nodes[joint->NodeA].FullMass, j[0], j[1], j[2], product);
            sum += SmallMatrix.Dot(r->A + (p * 3), product);
        }

        if (joint->NodeB >= 0)
        {
            double* j = r->B + (q * 3);
            SmallMatrix.Apply(nodes[joint->NodeB].FullMass, j[0], j[1], j[2], product);
            sum += SmallMatrix.Dot(r->B + (p * 3), product);
        }

        if (joint->Coupled)
        {
            double* j = r->B + (q * 3);
            SmallMatrix.Apply(joint->Cross, j[0], j[1], j[2], product);
            sum += SmallMatrix.Dot(r->A + (p * 3), product);
            j = r->B + (p * 3);
            SmallMatrix.Apply(joint->Cross, j[0], j[1], j[2], product);
            sum += SmallMatrix.Dot(r->A + (q * 3), product);
        }

        return sum;
    }

    /// <summary>
    /// The exact discrete spring v' = (v - κφ)/D with D = exp(2ζωh) and κ = (1 + D - 2√D·cos(ω√(1-ζ²)·h))/h has the frequency and
    /// damping of the continuous one at every h; from half a turn a substep on, the implicit form, which is stable always.
    /// </summary>
    private static void SetSpring(ActiveJoint* joint, JointRows* r, int k, double h)
    {
        if (r->Type[k] != (byte)RowType.Spring)
        {
            return;
        }

        double omega = r->Stiffness[k];
        double zeta = r->Damping[k];
        double wave = omega * h * Math.Sqrt(Math.Abs(1 - (zeta * zeta)));
        if ((zeta < 1 && wave >= Math.PI) || (2 * zeta * omega * h) > 50)
        {
            joint->SpringQ[k] = h * ((2 * zeta * omega) + (h * omega * omega));
            joint->SpringKappa[k] = h * omega * omega;
            return;
        }

        double root = StableMath.Exp(zeta * omega * h);
        double cosine = zeta < 1 ? StableMath.Cos(wave) : 0.5 * (StableMath.Exp(wave) + StableMath.Exp(-wave));
        double d = root * root;
        joint->SpringQ[k] = d - 1;
        joint->SpringKappa[k] = (1 + d - (2 * root * cosine)) / h;
    }

    private static void PrepareBlock(TreeNode* nodes, ActiveJoint* joint, JointRows* r)
    {
        double* k = stackalloc double[9];
        int n = r->Hard;
        for (int p = 0; p < n; p++)
        {
            for (int q = 0; q < n; q++)
            {
                k[(p * n) + q] = Coupling(nodes, joint, r, p, q);
            }
        }

        for (int p = 0; p < n; p++)
        {
            k[(p * n) + p] *= 1 + 1e-9;
        }

        SmallMatrix.Invert(k, n, joint->Block);
    }

    private double Speed(TreeNode* nodes, ActiveJoint* joint, JointRows* r, int k)
    {
        return Speed(nodes, joint->NodeA, joint->BodyA, r->A + (k * 3)) + Speed(nodes, joint->NodeB, joint->BodyB, r->B + (k * 3));
    }

    private double Speed(TreeNode* nodes, int node, int body, double* j)
    {
        if (node >= 0)
        {
            return SmallMatrix.Dot(j, nodes[node].Velocity);
        }

        BodyState* s = _states + body;
        return (j[0] * s->LinearVelocity.X) + (j[1] * s->LinearVelocity.Y) + (j[2] * s->AngularVelocity);
    }

    /// <summary>
    /// Applies an impulse along a row. B is current; the other body of the same tree then is reached by a walk, and B is visited
    /// again for the next row.
    /// </summary>
    private static void Apply(TreeNode* nodes, ActiveJoint* joint, JointRows* r, int k, double impulse)
    {
        if (impulse == 0)
        {
            return;
        }

        Give(joint, r, k, impulse);
        if (joint->NodeB >= 0)
        {
            double* j = r->B + (k * 3);
            TreeWalk.Apply(nodes, joint->NodeB, j[0] * impulse, j[1] * impulse, j[2] * impulse);
        }

        if (joint->NodeA >= 0)
        {
            TreeWalk.Visit(nodes, joint->NodeA);
            double* j = r->A + (k * 3);
            TreeWalk.Apply(nodes, joint->NodeA, j[0] * impulse, j[1] * impulse, j[2] * impulse);
            if (joint->NodeB >= 0)
            {
                TreeWalk.Visit(nodes, joint->NodeB);
            }
        }
    }

    private static void Give(ActiveJoint* joint, JointRows* r, int k, double impulse)
    {
        joint->Given[0] += r->B[k * 3] * impulse;
        joint->Given[1] += r->B[(k * 3) + 1] * impulse;
        joint->Given[2] += r->B[(k * 3) + 2] * impulse;
    }

    private void SolveRow(TreeNode* nodes, ActiveJoint* joint, JointRows* r, int k, double h, bool biased)
    {
        double response = joint->Response[k];
        if (!(response > 0))
        {
            return;
        }

        double v = Speed(nodes, joint, r, k);
        double old = joint->Lambda[k];
        double now;
        switch ((RowType)r->Type[k])
        {
            case RowType.Motor:
                now = old - (r->Share[k] * (v - r->Speed[k] + (r->Damping[k] * old)) / (response + r->Damping[k]));
                now = Math.Max(r->Low[k], Math.Min(r->High[k], now));
                break;
            case RowType.Limit:
                // What is only just reached in this substep holds in the next one: a tie is no impact yet.
                double need = biased ? -(v + (Math.Max(r->Error[k], 0) / h)) : old * response;
                if (old <= 0 && r->Error[k] > 0 && need <= Touching * Math.Abs(v))
                {
                    return;
                }

                if (!biased && need <= Touching * Math.Abs(v))
                {
                    return;
                }

                now = Math.Max(0, old + Limit(joint, r, k, v, h, biased));
                break;
            default:
                if (!biased)
                {
                    return;
                }

                now = old - (((joint->SpringQ[k] * v) + (joint->SpringKappa[k] * r->Error[k]) + (response * old))
                    / (response * (1 + joint->SpringQ[k])));
                now = Math.Max(r->Low[k], Math.Min(r->High[k], now));
                break;
        }

        joint->Lambda[k] = now;
        Apply(nodes, joint, r, k, now - old);
    }

    private static double Limit(ActiveJoint* joint, JointRows* r, int k, double v, double h, bool biased)
    {
        double gap = r->Error[k];
        double response = joint->Response[k];
        if (gap > 0 || !biased)
        {
            return -(v + (Math.Max(gap, 0) / h)) / response;
        }

        double over = Math.Min(0, gap + r->Share[k]);
        return -(v + (LimitRecovery * over / h) + (r->Damping[k] * joint->Lambda[k])) / (response + r->Damping[k]);
    }

    private void SolveBlock(TreeNode* nodes, ActiveJoint* joint, JointRows* r, in JointStep step, bool biased)
    {
        double* residual = stackalloc double[3];
        int n = r->Hard;
        bool soft = !joint->Coupled && biased;
        for (int k = 0; k < n; k++)
        {
            bool servo = r->Type[k] == (byte)RowType.Servo;
            double bias = servo ? -r->Speed[k] : biased ? r->Error[k] * (joint->Coupled ? 1 : NetBias) / step.Substep : 0;
            residual[k] = Speed(nodes, joint, r, k) + bias;
        }

        for (int k = 0; k < n; k++)
        {
            double impulse = 0;
            for (int q = 0; q < n; q++)
            {
                impulse -= joint->Block[(k * n) + q] * residual[q];
            }

            if (soft && r->Type[k] != (byte)RowType.Servo)
            {
                impulse = ((impulse * NetProduct) - joint->Lambda[k]) / (1 + NetProduct);
            }

            joint->Lambda[k] += impulse;
            Apply(nodes, joint, r, k, impulse);
        }
    }
}
