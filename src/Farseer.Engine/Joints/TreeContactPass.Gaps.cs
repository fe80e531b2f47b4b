using System;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Joints;

/// <content>
/// Gaps from step to step. The narrow phase finds them in floats, from offsets and rotations that are floats as well: of a ragdoll that lies still
/// each step found its corners some 10⁻⁷ of their arms higher or lower than the last one had left them, and the passes answered with ten last places of
/// the speed of a substep's fall, whatever their number. So the gap that the solver left stands as long as what is found agrees with it within
/// rounding, as a velocity in double does.
/// </content>
internal sealed unsafe partial class TreeContactPass
{
    /// <summary>Rounding of a gap that the narrow phase finds, as a share of the lengths it is the difference of: four last places of a float.</summary>
    private const double GapRounding = 2.384185791015625e-7;

    /// <summary>Before the first substep: points that press go on from the gaps of the last step, if these are what was found within rounding.</summary>
    public void Recall(TreeContact* contact, in HeldGap held)
    {
        PlacePoints(contact);
        Recall(contact, ref contact->Point0, contact->Bundle->Id0[contact->Lane], held);
        if (contact->Points > 1)
        {
            Recall(contact, ref contact->Point1, contact->Bundle->Id1[contact->Lane], held);
        }
    }

    /// <summary>At the end of a step.</summary>
    public static void Note(TreeContact* contact, ref HeldGap held)
    {
        held.Id0 = contact->Bundle->Id0[contact->Lane];
        held.Gap0 = contact->Point0.Separation;
        held.Id1 = contact->Points > 1 ? contact->Bundle->Id1[contact->Lane] : 0;
        held.Gap1 = contact->Point1.Separation;
    }

    private static void Recall(TreeContact* contact, ref TreeContactPoint point, uint id, in HeldGap held)
    {
        // The impulse has followed its point by the name: one without it is new, or pressed by nothing.
        bool first = id == held.Id0;
        if (point.Normal > 0 && (first || id == held.Id1))
        {
            double change = (first ? held.Gap0 : held.Gap1) - point.Separation;
            if (Math.Abs(change) <= GapRounding * LengthsOf(contact, point))
            {
                point.Base += change;
            }
        }
    }

    /// <summary>The lengths that a gap is the difference of: the arms along the normal, axis by axis, and the size of the smaller body there.</summary>
    private static double LengthsOf(TreeContact* contact, in TreeContactPoint point)
    {
        double a = Math.Abs(point.NormalArmA) + Math.Abs(point.TangentArmA);
        double b = Math.Abs(point.NormalArmB) + Math.Abs(point.TangentArmB);
        return Along(contact, point.NormalArmA, point.TangentArmA) + Along(contact, point.NormalArmB, point.TangentArmB)
            + Math.Min(a, b) + contact->RadiusA + contact->RadiusB;
    }

    /// <summary>|nx·rx| + |ny·ry| of the arm r = an·n + at·t.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Along(TreeContact* contact, double normalArm, double tangentArm)
    {
        double x = (normalArm * contact->NormalX) + (tangentArm * contact->NormalY);
        double y = (normalArm * contact->NormalY) - (tangentArm * contact->NormalX);
        return Math.Abs(contact->NormalX * x) + Math.Abs(contact->NormalY * y);
    }
}
