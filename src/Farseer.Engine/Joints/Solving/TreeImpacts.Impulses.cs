using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;

namespace Farseer.Engine.Joints.Solving;

/// <content>What contacts with trees give: see <see cref="ContactImpulses"/>.</content>
internal sealed unsafe partial class TreeImpacts
{
    /// <summary>Contacts that trees took out of their lanes.</summary>
    public int TakenCount => _work.ContactCount;

    /// <summary>One of them.</summary>
    public TreeContact* Taken(int index) => _contacts.Pointer + index;

    /// <summary>Adds what the contacts with trees hold.</summary>
    /// <param name="impulses">The sums.</param>
    /// <param name="sign">1, or -1 to take it off again.</param>
    public void AddImpulses(ContactImpulses impulses, double sign)
    {
        for (int i = 0; i < _work.ContactCount; i++)
        {
            TreeContact* contact = _contacts.Pointer + i;
            bool two = contact->Points > 1;
            RowImpulse held;
            held.Normal0 = contact->Point0.Normal;
            held.Normal1 = two ? contact->Point1.Normal : 0;
            held.Tangent0 = contact->Point0.Tangent;
            held.Tangent1 = two ? contact->Point1.Tangent : 0;
            held.AxisX = contact->NormalX;
            held.AxisY = contact->NormalY;
            impulses.Add(contact->Bundle->Contact[contact->Lane], sign, held);
        }
    }

    /// <summary>As a substep begins: notes how fast the surfaces of those come together that did not.</summary>
    public void WatchApproaches(ContactImpulses impulses)
    {
        for (int i = 0; i < _work.ContactCount; i++)
        {
            TreeContact* contact = _contacts.Pointer + i;
            if (contact->Point0.Normal + contact->Point1.Normal > 0)
            {
                continue;
            }

            ref BodyState a = ref _work.Step.Bodies.State[contact->Ends.BodyA];
            ref BodyState b = ref _work.Step.Bodies.State[contact->Ends.BodyB];
            double along = ((b.LinearVelocity.X - a.LinearVelocity.X) * contact->NormalX)
                + ((b.LinearVelocity.Y - a.LinearVelocity.Y) * contact->NormalY);
            double speed = Approach(contact->Point0, along, a.AngularVelocity, b.AngularVelocity);
            speed = contact->Points > 1 ? Math.Max(speed, Approach(contact->Point1, along, a.AngularVelocity, b.AngularVelocity)) : speed;
            impulses.NoteApproach(contact->Bundle->Contact[contact->Lane], (float)speed);
        }
    }

    private static double Approach(in TreeContactPoint point, double along, double spinA, double spinB) =>
        -(along + (spinB * point.TangentArmB) - (spinA * point.TangentArmA));
}
