using System;
using System.Numerics;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>What a contact gave in a step, by point of its row, and how fast its surfaces came together before.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct ContactImpulse
{
    public double Normal0;
    public double Normal1;
    public double Tangent0;
    public double Tangent1;

    /// <summary>Both together as a vector, as body B was given it.</summary>
    public double PushX;
    public double PushY;

    /// <summary>Fastest approach of a point while the contact did not push; 0: none.</summary>
    public float Approach;

    /// <summary>1: an impact on the way of a fast body, and where.</summary>
    public int OnWay;
    public double X;
    public double Y;
    public Vector2 Axis;

    public readonly double Normal => Normal0 + Normal1;

    /// <summary>Along t = (ny, -nx).</summary>
    public readonly double Tangent => Tangent0 + Tangent1;

    public void Push(double normal, double tangent, double axisX, double axisY)
    {
        PushX += (normal * axisX) + (tangent * axisY);
        PushY += (normal * axisY) - (tangent * axisX);
    }
}

/// <summary>What the points of a row hold at a moment, and its normal.</summary>
internal struct RowImpulse
{
    public double Normal0;
    public double Normal1;
    public double Tangent0;
    public double Tangent1;
    public double AxisX;
    public double AxisY;
}

/// <summary>
/// Sums the impulses of a step by contact: a row holds those of its last substep alone, and lets those of impacts go. There is none unless
/// somebody reads them. An impulse stays in the row, as it is, until the end of its substep; what is let go or put in its place
/// before, as loads to start from, is taken off again by a second look.
/// </summary>
internal sealed unsafe class ContactImpulses
{
    private readonly Column<ContactImpulse> _given = new Column<ContactImpulse>();

    public void Visit(StateStream s) => s.Column(_given);

    /// <summary>Makes room for so many contacts, and forgets the last step.</summary>
    public void Begin(int contacts)
    {
        _given.EnsureCapacity(contacts);
        new Span<ContactImpulse>(_given.Pointer, _given.Capacity).Clear();
    }

    /// <summary>What a contact gave. One that is younger than the step has a place too.</summary>
    public ref ContactImpulse Of(int contact)
    {
        _given.EnsureCapacity(contact + 1);
        return ref _given[contact];
    }

    /// <summary>Adds what the rows of a bundle hold.</summary>
    /// <param name="row">The bundle.</param>
    /// <param name="sign">1, or -1 to take it off again.</param>
    public void Add(ContactBundle* row, double sign)
    {
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            int contact = row->Contact[lane];
            if (contact >= 0)
            {
                RowImpulse held;
                held.Normal0 = row->Point0.Normal[lane];
                held.Normal1 = row->Point1.Normal[lane];
                held.Tangent0 = row->Point0.Tangent[lane];
                held.Tangent1 = row->Point1.Tangent[lane];
                held.AxisX = row->NormalX[lane];
                held.AxisY = row->NormalY[lane];
                Add(contact, sign, held);
            }
        }
    }

    /// <summary>Adds what the points of a contact hold.</summary>
    public void Add(int contact, double sign, in RowImpulse held)
    {
        ref ContactImpulse given = ref _given[contact];
        given.Normal0 += sign * held.Normal0;
        given.Normal1 += sign * held.Normal1;
        given.Tangent0 += sign * held.Tangent0;
        given.Tangent1 += sign * held.Tangent1;
        given.Push(sign * (held.Normal0 + held.Normal1), sign * (held.Tangent0 + held.Tangent1), held.AxisX, held.AxisY);
    }

    /// <summary>Adds an impulse of one point that its row does not hold.</summary>
    public void AddBeside(ContactBundle* row, int lane, bool second, double normal, double tangent)
    {
        ref ContactImpulse given = ref _given[row->Contact[lane]];
        (second ? ref given.Normal1 : ref given.Normal0) += normal;
        (second ? ref given.Tangent1 : ref given.Tangent0) += tangent;
        given.Push(normal, tangent, row->NormalX[lane], row->NormalY[lane]);
    }

    /// <summary>Adds an impact on the way of a fast body.</summary>
    public void AddOnWay(int contact, in ContactImpulse impact)
    {
        ref ContactImpulse given = ref Of(contact);
        given.Normal0 += impact.Normal0;
        given.Tangent0 += impact.Tangent0;
        given.Push(impact.Normal0, impact.Tangent0, impact.Axis.X, impact.Axis.Y);
        if (impact.Approach > given.Approach)
        {
            given.Approach = impact.Approach;
            given.OnWay = 1;
            given.X = impact.X;
            given.Y = impact.Y;
            given.Axis = impact.Axis;
        }
    }

    /// <summary>As a substep begins: notes how fast the surfaces of those come together that did not.</summary>
    public void Watch(ContactBundle* row, BodyState* bodies)
    {
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            int contact = row->Contact[lane];
            if (contact < 0 || row->Point0.Normal[lane] + row->Point1.Normal[lane] > 0)
            {
                continue;
            }

            BodyState* a = bodies + row->BodyA[lane];
            BodyState* b = bodies + row->BodyB[lane];
            Vector2 v = b->LinearVelocity - a->LinearVelocity;
            float along = (v.X * row->NormalX[lane]) + (v.Y * row->NormalY[lane]);
            NoteApproach(contact, &row->Point0, lane, along, a, b);
            NoteApproach(contact, &row->Point1, lane, along, a, b);
        }
    }

    /// <summary>Notes the speed at which a point comes nearer.</summary>
    public void NoteApproach(int contact, float speed)
    {
        ref ContactImpulse given = ref _given[contact];
        given.Approach = Math.Max(given.Approach, speed);
    }

    private void NoteApproach(int contact, ContactPointLanes* point, int lane, float along, BodyState* a, BodyState* b)
    {
        if (point->Base[lane] < ContactBundle.NoPoint * 0.5f)
        {
            float armA = (a->DeltaCos * point->TangentArmA[lane]) - (a->DeltaSin * point->NormalArmA[lane]);
            float armB = (b->DeltaCos * point->TangentArmB[lane]) - (b->DeltaSin * point->NormalArmB[lane]);
            NoteApproach(contact, -(along + (b->AngularVelocity * armB) - (a->AngularVelocity * armA)));
        }
    }
}
