using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>What contacts start from, and what they give in an impact.</content>
internal sealed unsafe partial class TreeContactPass
{
    /// <summary>Extrapolates the impulses of the substep before.</summary>
    public void Extrapolate(TreeContact* contact)
    {
        Extrapolate(&contact->Point0, _c, contact->Friction, contact->K11, Fall);
        if (contact->Points > 1)
        {
            Extrapolate(&contact->Point1, _c, contact->Friction, contact->K22, Fall);
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

    /// <summary>After the first sweep: the next one begins here.</summary>
    public static void BeginDirection(TreeContact* contact)
    {
        BeginDirection(&contact->Point0);
        BeginDirection(&contact->Point1);
    }

    private static void BeginDirection(TreeContactPoint* p)
    {
        p->SweptFrom = p->Normal;
        p->Direction = 0;
    }

    /// <summary>The square of what the last sweep changed the normal impulses by, as an energy.</summary>
    public static double Residual(TreeContact* contact)
    {
        double change0 = contact->Point0.Normal - contact->Point0.SweptFrom;
        double change1 = contact->Point1.Normal - contact->Point1.SweptFrom;
        return (contact->K11 * change0 * change0) + (contact->K22 * change1 * change1);
    }

    /// <summary>Goes on by a share of the direction so far, and adds to that what the last sweep changed.</summary>
    public void GoOn(TreeContact* contact, double share)
    {
        double change0 = GoOn(&contact->Point0, share);
        double change1 = GoOn(&contact->Point1, share);
        if (change0 != 0 || change1 != 0)
        {
            double* a = stackalloc double[3];
            double* b = stackalloc double[3];
            RowEnds.Visit(_view, &contact->Ends);
            Normals(contact, change0, change1, a, b);
            RowEnds.Apply(_view, &contact->Ends, a, b);
        }
    }

    private static double GoOn(TreeContactPoint* p, double share)
    {
        double change = Math.Max(share * p->Direction, -p->Normal);
        p->Direction = change + (p->Normal - p->SweptFrom);
        p->Normal += change;
        p->SweptFrom = p->Normal;
        return change;
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

    /// <summary>Before a substep: a contact that approaches fast enough to bounce takes no part in its passes.</summary>
    /// <returns>True if it is held back.</returns>
    public bool HoldBack(TreeContact* contact)
    {
        contact->Held = false;
        if (contact->Restitution <= 0)
        {
            return false;
        }

        Speeds(contact, out double v0, out double v1);
        ref BodyDrive a = ref _bodies.Drive[contact->Ends.BodyA];
        ref BodyDrive b = ref _bodies.Drive[contact->Ends.BodyB];
        double driveA = contact->Ends.NodeA < 0 ? 0 : (contact->NormalX * a.X) + (contact->NormalY * a.Y);
        double driveB = contact->Ends.NodeB < 0 ? 0 : (contact->NormalX * b.X) + (contact->NormalY * b.Y);
        contact->Acceleration = (driveB - driveA) * _c.InverseSubstep;
        contact->Slow = Math.Max(BounceKernel.RestSubsteps * Math.Max(Math.Abs(driveA), Math.Abs(driveB)), _c.BounceThreshold);
        bool pressed = contact->Point0.Normal + contact->Point1.Normal > 0;
        contact->Held = !pressed && (v0 < -contact->Slow || (contact->Points > 1 && v1 < -contact->Slow));
        NoteLevel(&contact->Point0);
        NoteLevel(&contact->Point1);
        if (contact->Held)
        {
            Release(&contact->Point0);
            Release(&contact->Point1);
        }

        return contact->Held;
    }

    /// <summary>Whether the surfaces have come through each other, when they met, and at what speed they are to part.</summary>
    public bool FindImpact(TreeContact* contact)
    {
        contact->Since = -1;
        if (contact->Restitution <= 0)
        {
            return false;
        }

        Speeds(contact, out double v0, out double v1);
        FindImpact(contact, &contact->Point0, v0);
        if (contact->Points > 1)
        {
            FindImpact(contact, &contact->Point1, v1);
        }

        return contact->Since >= 0;
    }

    /// <summary>One sweep over an impact.</summary>
    public void Strike(TreeContact* contact)
    {
        if (contact->Hit)
        {
            Trees.RowEnds.Visit(_view, &contact->Ends);
            Speeds(contact, out double v0, out double v1);
            SolveBlock(contact, v0 - Parting(&contact->Point0), v1 - Parting(&contact->Point1), out double x0, out double x1);
            Change(contact, x0, x1);
            Rub(contact, x0, x1);
        }
    }

    /// <summary>The impulses of an impact are noted, and let go, for they are not to be repeated.</summary>
    public static void FinishImpact(TreeContact* contact)
    {
        contact->Held = false;
        if (contact->Impact)
        {
            contact->Impact = false;
            contact->Struck = Math.Max(contact->Point0.Normal + contact->Point1.Normal, float.Epsilon);
            Release(&contact->Point0);
            Release(&contact->Point1);
        }
    }

    private void NoteLevel(TreeContactPoint* p)
    {
        p->Level = Math.Min(p->Separation - p->Rest, 0);
        p->Bounce = -1;
    }

    /// <summary>
    /// How fast a point is to part at least. One that is not struck comes as near as it can in a substep, and where it parted before the
    /// impact it may approach as fast: an impulse x takes -x·(v + v')/2 of the energy, so to stop it sooner would add some.
    /// </summary>
    private double Parting(TreeContactPoint* p) =>
        p->Bounce >= 0 ? p->Bounce : -Math.Max((p->Separation - p->Rest) * _c.InverseSubstep, Math.Max(p->Parted, 0));

    private void FindImpact(TreeContact* contact, TreeContactPoint* p, double v)
    {
        p->Bounce = -1;
        p->Parted = v;
        double beyond = p->Separation - p->Rest - p->Level;
        if (beyond > 0 || v >= 0 || !(contact->Held || v < -contact->Slow))
        {
            return;
        }

        double speed = Math.Sqrt(Math.Max(0, (v * v) - (2 * contact->Acceleration * beyond)));
        double time = Math.Min(-2 * beyond / (speed - v), 1 / _c.InverseSubstep);
        double back = speed > contact->Slow ? contact->Restitution * speed : 0;
        if (contact->Restitution > 1)
        {
            back = Math.Min(back, Math.Max(speed, _c.Driven.SpeedOf(_bodies, contact->Ends.BodyA, contact->Ends.BodyB)));
        }

        p->Bounce = Math.Max(0, back + (contact->Acceleration * time));
        contact->Since = Math.Max(contact->Since, time);
    }

    private static void Release(TreeContactPoint* p)
    {
        p->Normal = 0;
        p->PreviousNormal = 0;
        p->Tangent = 0;
        p->PreviousTangent = 0;
    }
}
