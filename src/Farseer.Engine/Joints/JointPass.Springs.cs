using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints;

/// <content>Springs of joints: what they do in a substep.</content>
internal sealed unsafe partial class JointPass
{
    /// <summary>
    /// Frequency and damping of a spring are those of the masses it feels, but of no less than this share of what its two ends answer each
    /// by itself, in all directions, or their bodies alone. Where joints leave its row next to no freedom (a body on a hinge, pulled along
    /// its arm; a rail beside a rod) it would else be so stiff that what little of it turns the body throws it about. A heavy body on a
    /// lever is heavy in all directions that there are.
    /// </summary>
    public const double LeastFreedom = 0.125;

    /// <summary>
    /// ωh up to which springs that pull at the same bodies rest where their load says, and from which on they do not look at loads: by then
    /// what they give way is g·h² / 0.06, and of ten springs that pull at one body each takes what the others gave for a load, at which
    /// stiffer ones would swing.
    /// </summary>
    private const double Held = 0.25;
    private const double MostHeld = 0.5;

    /// <summary>
    /// The exact discrete spring v' = (v - κφ)/D with D = exp(2ζωh) and κ = (1 + D - 2√D·cos(ω√(1-ζ²)·h))/h has the frequency and
    /// damping of the continuous one at every h; from half a turn a substep on, the implicit form, which is stable always.
    /// See <see cref="FindSpring"/> for what loads have to do with it.
    /// </summary>
    private static void SetSpring(JointTree* trees, TreeNode* nodes, ActiveJoint* joint, JointRows* r, int k, double h)
    {
        if (r->Type[k] != (byte)RowType.Spring)
        {
            return;
        }

        double own = Own(nodes, joint->Ends.NodeA, r->A + (k * 3)) + Own(nodes, joint->Ends.NodeB, r->B + (k * 3));
        double least = LeastFreedom * (joint->Kind == JointKind.Target ? own : Math.Min(own, Freedom(nodes, joint, r, k)));
        double share = SpringShare(joint->Response[k], least, r->SpringMass);
        double hold = HoldOf(trees, nodes, joint);
        FindSpring(
            share, r->Stiffness[k], r->Damping[k], h, hold, out joint->SpringQ[k], out joint->SpringKappa[k], out joint->SpringLead[k]);
    }

    /// <summary>What the ends of a row answer each by itself: along it and, where the joint holds nothing there, across it.</summary>
    private static double Freedom(TreeNode* nodes, ActiveJoint* joint, JointRows* r, int k)
    {
        double along = RowEnds.OfEnds(nodes, &joint->Ends, r->A + (k * 3), r->B + (k * 3));
        if (joint->Role != JointRole.Iterated || r->Turns(k))
        {
            return along;
        }

        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        a[0] = -r->A[(k * 3) + 1];
        a[1] = r->A[k * 3];
        a[2] = r->AcrossA;
        b[0] = -r->B[(k * 3) + 1];
        b[1] = r->B[k * 3];
        b[2] = r->AcrossB;
        return along + RowEnds.OfEnds(nodes, &joint->Ends, a, b);
    }

    /// <summary>
    /// ωh from which on a spring does not look at loads: never if it is the only one at its bodies' trees. The two springs of a target look
    /// at none: that across would take for a load what the other one pulls past a hinge, and leave it to swing.
    /// </summary>
    public static double HoldOf(JointTree* trees, TreeNode* nodes, ActiveJoint* joint)
    {
        if (joint->Kind == JointKind.Target)
        {
            return double.NegativeInfinity;
        }

        return IsOnly(trees, nodes, joint->Ends.NodeA) && IsOnly(trees, nodes, joint->Ends.NodeB) ? double.PositiveInfinity : MostHeld;
    }

    private static bool IsOnly(JointTree* trees, TreeNode* nodes, int node) =>
        node < 0 || (trees[nodes[node].Tree].SpringRows == 1 && !trees[nodes[node].Tree].Strung);

    /// <summary>The share of its frequency and damping that a spring has, of its response and the least that it feels.</summary>
    public static double SpringShare(double response, double least, double mass)
    {
        // A stiffness ω²/L and a damping 2ζω/L, felt with a response below L. A spring of a given mass m has mω² and 2mζω, whatever mass
        // the row feels: both are in proportion to the root of the ratio.
        return mass > 0 ? Math.Sqrt(mass * Math.Max(0, response)) : response < least ? Math.Sqrt(Math.Max(0, response) / least) : 1;
    }

    /// <summary>
    /// What a spring does in a substep, of that share, frequency and damping ratio. Every v' = (G·v - κφ)/D - (G - 1)·u/D, u being the
    /// speed before the loads of the substep and v that after them, has the exact swing; under a steady load F it rests at G·h·F/κ, which
    /// is the spring's own length for G = κ/(hω²). With κ' = κ/G, 1 + q = D/G and c = (G - 1)/κ that is v' = (v - κ'(φ + c·u))/(1 + q).
    /// </summary>
    public static void FindSpring(
        double share, double stiffness, double damping, double h, double most, out double q, out double kappa, out double lead)
    {
        double omega = stiffness * share;
        double zeta = damping * share;
        double wave = omega * h * Math.Sqrt(Math.Abs(1 - (zeta * zeta)));
        double rest = h * omega * omega;
        lead = 0;
        if ((zeta < 1 && wave >= Math.PI) || (2 * zeta * omega * h) > 50)
        {
            q = h * ((2 * zeta * omega) + rest);
            kappa = rest;
            return;
        }

        double root = StableMath.Exp(zeta * omega * h);
        double half = zeta < 1 ? StableMath.Sin(0.5 * wave) : 0.5 * (StableMath.Exp(0.5 * wave) - StableMath.Exp(-0.5 * wave));
        double square = 4 * root * half * half;
        kappa = (((root - 1) * (root - 1)) + (zeta < 1 ? square : -square)) / h;
        double hold = Math.Max(0, Math.Min(1, (most - (omega * h)) / (MostHeld - Held)));
        double given = rest > 0 ? 1 + (hold * ((kappa / rest) - 1)) : 1;
        lead = kappa > 0 ? (given - 1) / kappa : 0;
        kappa /= given;
        q = (root * root / given) - 1;
    }

    /// <summary>The speed of each spring before gravity and all else that loads it in the substep, times its lead.</summary>
    public void Foresee(ActiveJoint* joint, JointRows* r, BodyStore bodies)
    {
        for (int k = r->Hard; k < r->Count; k++)
        {
            if (r->Type[k] == (byte)RowType.Spring)
            {
                double speed = StartSpeed(bodies, joint->Ends.NodeA, joint->Ends.BodyA, r->A + (k * 3))
                    + StartSpeed(bodies, joint->Ends.NodeB, joint->Ends.BodyB, r->B + (k * 3));
                joint->SpringAhead[k] = joint->SpringLead[k] * speed;
            }
        }
    }

    private double StartSpeed(BodyStore bodies, int node, int body, double* j) =>
        HeldVelocity.StartSpeed(bodies, body, node >= 0, _view.Nodes[Math.Max(0, node)].Velocity, 1, j, 1);
}
