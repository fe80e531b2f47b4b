using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>Displacements, and the gaps that they leave.</content>
internal sealed unsafe partial class TreeContactPass
{
    /// <summary>Keeps surfaces out of each other while bodies are pulled about; the impulses count within the pull only.</summary>
    public void Block(TreeContact* contact)
    {
        RowEnds.Visit(_view, &contact->Ends);
        Speeds(contact, out double v0, out double v1);
        double x0 = Block(ref contact->Point0, v0, contact->K11);
        double x1 = contact->Points > 1 ? Block(ref contact->Point1, v1 + (contact->K12 * x0), contact->K22) : 0;
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        Normals(contact, x0, x1, a, b);
        RowEnds.Apply(_view, &contact->Ends, a, b);
    }

    private double Block(ref TreeContactPoint point, double v, double k)
    {
        double old = point.Plain;
        point.Plain = Math.Max(0, old - ((v + (Math.Max(0, point.Separation) * _c.InverseSubstep)) / k));
        return point.Plain - old;
    }

    /// <summary>
    /// Displacements have turned the surfaces, and what they pressed with is none of the load that they have now: in the way in which a
    /// tree gives least it may be a thousand times as much as a blow.
    /// </summary>
    public static void Forget(TreeContact* contact)
    {
        Forget(ref contact->Point0);
        Forget(ref contact->Point1);
    }

    private static void Forget(ref TreeContactPoint point)
    {
        point.Normal = 0;
        point.Tangent = 0;
        point.PreviousNormal = 0;
        point.PreviousTangent = 0;
        point.Feed = 0;
    }

    /// <summary>
    /// Rounding of a gap that the narrow phase finds, as a share of the lengths it is the difference of: four last places of a float.
    /// </summary>
    private const double GapRounding = 2.384185791015625e-7;

    /// <summary>
    /// Before the first substep: points that press go on from the gaps of the last step, if these are what was found within rounding.
    /// </summary>
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

    /// <summary>
    /// The lengths that a gap is the difference of: the arms along the normal, axis by axis, and the size of the smaller body there.
    /// </summary>
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
