using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints;

/// <content>Springs of joints: what they do in a substep.</content>
internal sealed unsafe partial class JointPass
{
    /// <summary>
    /// Frequency and damping of a spring are those of the masses it feels, but of no less than this share of its bodies' own. Where
    /// joints leave its row next to no freedom (a body on a hinge, pulled along its arm) it would else be so stiff that what little
    /// of it turns the body throws it about. A rod that is welded at its end feels 1/4.
    /// </summary>
    private const double LeastFreedom = 0.125;

    /// <summary>
    /// ωh up to which a spring rests where its load says, and from which on it does not look at loads: by then what it gives way is g·h² / 0.06,
    /// and of ten springs that pull at one body each takes what the others gave for a load, at which stiffer ones would swing.
    /// </summary>
    private const double Held = 0.25;
    private const double MostHeld = 0.5;

    /// <summary>
    /// The exact discrete spring v' = (v - κφ)/D with D = exp(2ζωh) and κ = (1 + D - 2√D·cos(ω√(1-ζ²)·h))/h has the frequency and
    /// damping of the continuous one at every h; from half a turn a substep on, the implicit form, which is stable always.
    /// See <see cref="FindSpring"/> for what loads have to do with it.
    /// </summary>
    private static void SetSpring(TreeNode* nodes, ActiveJoint* joint, JointRows* r, int k, double h)
    {
        if (r->Type[k] != (byte)RowType.Spring)
        {
            return;
        }

        double own = Own(nodes, joint->Ends.NodeA, r->A + (k * 3)) + Own(nodes, joint->Ends.NodeB, r->B + (k * 3));
        double share = SpringShare(joint->Response[k], own, r->SpringMass);
        FindSpring(share, r->Stiffness[k], r->Damping[k], h, joint->Kind != JointKind.Target, out joint->SpringQ[k], out joint->SpringKappa[k], out joint->SpringLead[k]);
    }

    /// <summary>The share of its frequency and damping that a spring has, of its response and that of the bodies alone.</summary>
    public static double SpringShare(double response, double own, double mass)
    {
        // A stiffness ω²/L and a damping 2ζω/L, felt with a response below L. A spring of a given mass m has mω² and 2mζω, whatever mass
        // the row feels: both are in proportion to the root of the ratio.
        double least = LeastFreedom * own;
        return mass > 0 ? Math.Sqrt(mass * Math.Max(0, response)) : response < least ? Math.Sqrt(Math.Max(0, response) / least) : 1;
    }

    /// <summary>
    /// What a spring does in a substep, of that share, frequency and damping ratio. Every v' = (G·v - κφ)/D - (G - 1)·u/D, u being the speed
    /// before the loads of the substep and v that after them, has the exact swing; under a steady load F it rests at G·h·F/κ, which is
    /// the spring's own length for G = κ/(hω²). With κ' = κ/G, 1 + q = D/G and c = (G - 1)/κ that is v' = (v - κ'(φ + c·u))/(1 + q).
    /// The two springs of a target are not <paramref name="alone"/>: that across would take for a load what the other one pulls past a hinge, and leave it to swing.
    /// </summary>
    public static void FindSpring(double share, double stiffness, double damping, double h, bool alone, out double q, out double kappa, out double lead)
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
        double hold = Math.Max(0, Math.Min(1, (MostHeld - (omega * h)) / (MostHeld - Held)));
        double given = rest > 0 && alone ? 1 + (hold * ((kappa / rest) - 1)) : 1;
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
