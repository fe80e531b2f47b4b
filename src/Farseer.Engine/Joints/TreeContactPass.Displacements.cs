using System;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>While the bodies of trees are displaced.</content>
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
    /// Displacements have turned the surfaces, and what they pressed with is none of the load that they have now: in the way in which a tree gives least it may
    /// be a thousand times as much as a blow.
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
}
