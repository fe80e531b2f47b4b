using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>The impulses that a substep starts from.</content>
internal sealed unsafe partial class TreeContactPass
{
    /// <summary>Extrapolates the impulses of the substep before.</summary>
    public void Extrapolate(TreeContact* contact)
    {
        double fall = (double)_c.Gravity * _c.Substep;
        Extrapolate(&contact->Point0, _c, contact->Friction, contact->K11, fall);
        if (contact->Points > 1)
        {
            Extrapolate(&contact->Point1, _c, contact->Friction, contact->K22, fall);
        }
    }

    /// <summary>Gives the impulses to the bodies' own masses: the trees are solved afterwards.</summary>
    public void Push(TreeContact* contact)
    {
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        Normals(contact, contact->Point0.Normal, contact->Point1.Normal, a, b);
        RowEnds.Push(_view.Nodes, &contact->Ends, a, b);
        Tangents(contact, contact->Point0.Tangent, contact->Point1.Tangent, a, b);
        RowEnds.Push(_view.Nodes, &contact->Ends, a, b);
    }

    /// <summary>Gives the impulses to the bodies with all of their trees, in a walk.</summary>
    public void Carry(TreeContact* contact)
    {
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        RowEnds.Visit(_view, &contact->Ends);
        Normals(contact, contact->Point0.Normal, contact->Point1.Normal, a, b);
        RowEnds.Apply(_view, &contact->Ends, a, b);
        Tangents(contact, contact->Point0.Tangent, contact->Point1.Tangent, a, b);
        RowEnds.Apply(_view, &contact->Ends, a, b);
    }

    /// <summary>The impulses times the present speeds along them.</summary>
    public double Power(TreeContact* contact)
    {
        double* room = stackalloc double[6];
        return Power(
            contact,
            VelocityOf(contact->Ends.NodeA, contact->Ends.BodyA, room),
            VelocityOf(contact->Ends.NodeB, contact->Ends.BodyB, room + 3));
    }

    /// <summary>The same where all that the trees do not move stands still.</summary>
    public double OwnPower(TreeContact* contact)
    {
        double* still = stackalloc double[3];
        still[0] = 0;
        still[1] = 0;
        still[2] = 0;
        TreeNode* nodes = _view.Nodes;
        return Power(
            contact,
            contact->Ends.NodeA >= 0 ? nodes[contact->Ends.NodeA].Velocity : still,
            contact->Ends.NodeB >= 0 ? nodes[contact->Ends.NodeB].Velocity : still);
    }

    private static double Power(TreeContact* contact, double* a, double* b)
    {
        double* impulseA = stackalloc double[3];
        double* impulseB = stackalloc double[3];
        Normals(contact, contact->Point0.Normal, contact->Point1.Normal, impulseA, impulseB);
        double power = SmallMatrix.Dot(impulseA, a) + SmallMatrix.Dot(impulseB, b);
        Tangents(contact, contact->Point0.Tangent, contact->Point1.Tangent, impulseA, impulseB);
        return power + SmallMatrix.Dot(impulseA, a) + SmallMatrix.Dot(impulseB, b);
    }

    public static void Scale(TreeContact* contact, double share)
    {
        contact->Point0.Normal *= share;
        contact->Point0.Tangent *= share;
        contact->Point1.Normal *= share;
        contact->Point1.Tangent *= share;
    }

    private static void Extrapolate(TreeContactPoint* p, in ContactCoefficients c, double friction, double k, double fall)
    {
        const double Share = ContactCoefficients.Extrapolation;
        double most = ContactCoefficients.LargestGrowth * (p->PreviousNormal + (k > 0 ? fall / k : 0));
        bool impact = p->Normal > most;
        double change = p->Normal - p->PreviousNormal;
        double normal = impact ? p->PreviousNormal : Math.Max(0, p->Normal + Math.Min(c.RiseTaken * change, c.FallTaken * change));
        double tangent = impact ? p->PreviousTangent : p->Tangent + (Share * (p->Tangent - p->PreviousTangent));
        double bound = friction * normal;
        tangent = Math.Max(-bound, Math.Min(bound, tangent));
        p->PreviousNormal = Math.Min(p->Normal, Math.Max(most, c.LeastKept));
        p->PreviousTangent = impact ? tangent : p->Tangent;
        p->Normal = normal * p->Reach;
        p->Tangent = tangent * p->Reach;
    }
}
