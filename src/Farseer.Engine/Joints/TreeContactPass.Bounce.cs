using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;

namespace Farseer.Engine.Joints;

/// <content>Restitution, as in <see cref="BounceKernel"/>: with the trees' masses too.</content>
internal sealed unsafe partial class TreeContactPass
{
    public void PrepareBounce(TreeContact* contact)
    {
        if (contact->Restitution <= 0)
        {
            return;
        }

        Speeds(contact, out double v0, out double v1);
        ref BodyDrive a = ref _bodies.Drive[contact->Ends.BodyA];
        ref BodyDrive b = ref _bodies.Drive[contact->Ends.BodyB];
        double driveA = contact->Ends.NodeA < 0 ? 0 : (contact->NormalX * a.X) + (contact->NormalY * a.Y);
        double driveB = contact->Ends.NodeB < 0 ? 0 : (contact->NormalX * b.X) + (contact->NormalY * b.Y);
        double acceleration = (driveB - driveA) * _c.InverseSubstep;
        double slow = Math.Max(BounceKernel.RestSubsteps * Math.Max(Math.Abs(driveA), Math.Abs(driveB)), _c.BounceThreshold);
        contact->Point0.Bounce = Target(contact->Point0, v0, acceleration, slow, contact->Restitution);
        contact->Point1.Bounce = contact->Points > 1 ? Target(contact->Point1, v1, acceleration, slow, contact->Restitution) : 0;
    }

    /// <summary>One sweep; the last one also lets go of the impulses of the points that bounced, which are not to be repeated.</summary>
    public void Bounce(TreeContact* contact, bool last)
    {
        TreeContactPoint* p0 = &contact->Point0;
        TreeContactPoint* p1 = &contact->Point1;
        bool hit0 = p0->Bounce > 0 && p0->Normal > 0;
        bool hit1 = p1->Bounce > 0 && p1->Normal > 0;
        if (!hit0 && !hit1)
        {
            return;
        }

        Trees.RowEnds.Visit(_view, &contact->Ends);
        Speeds(contact, out double v0, out double v1);
        SolveBlock(contact, v0 - (hit0 ? p0->Bounce : 0), v1 - (hit1 ? p1->Bounce : 0), out double x0, out double x1);
        Change(contact, x0, x1);
        Rub(contact, x0, x1);
        if (last)
        {
            contact->Struck = Math.Max(x0 + x1, float.Epsilon);
            Release(p0);
            Release(p1);
        }
    }

    private double Target(in TreeContactPoint p, double v, double acceleration, double slow, double restitution)
    {
        double square = (v * v) - (2 * acceleration * (p.Separation - _c.Rest));
        return v < -slow ? restitution * Math.Sqrt(Math.Max(square, 0)) : 0;
    }

    private static void Release(TreeContactPoint* p)
    {
        p->Normal = 0;
        p->PreviousNormal = 0;
        p->Tangent = 0;
        p->PreviousTangent = 0;
    }
}
