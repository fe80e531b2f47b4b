using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>
/// The impulses with which a small island of level contacts would rest, solved for directly. Passes over the contacts take as many
/// sweeps as a box is lighter than what stands on it until they find the load, and meanwhile it is squeezed: 1:10⁴ sank by 83 mm,
/// and with twice the iterations the box was thrown out. Given once, when a resting island begins without any impulse; the passes go on
/// from there.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class StartingLoads
{
    /// <summary>Contacts of the largest island: its matrix has twice as many rows, and is solved within 0.2 ms.</summary>
    private const int MostContacts = ContactSystem.MostPoints / 2;

    /// <summary>Cosine to gravity from which on a contact is level: a steeper one needs its friction, which is not solved for.</summary>
    private const float LeastSteepness = 0.99f;

    private readonly Column<Entry> _entries = new Column<Entry>();
    private readonly Column<int> _heads = new Column<int>();
    private readonly ContactSystem _system = new ContactSystem();
    private int _count;

    /// <summary>Forgets the contacts of the last time.</summary>
    public void Begin(int islands)
    {
        _heads.EnsureCapacity(Math.Max(islands, 1));
        for (int i = 0; i < islands; i++)
        {
            _heads[i] = -1;
        }

        _count = 0;
    }

    public void Add(int island, ContactBundle* bundle, int lane)
    {
        _entries.EnsureCapacity(_count + 1);
        _entries[_count] = new Entry { Bundle = bundle, Lane = lane, Next = _heads[island] };
        _heads[island] = _count++;
    }

    /// <summary>Gives the contacts of an island their impulses, if all are level and without any.</summary>
    /// <param name="island">The island.</param>
    /// <param name="bodies">The store.</param>
    /// <param name="gravity">Gravity of the world.</param>
    /// <param name="c">Of the step's own substep.</param>
    public void Give(int island, BodyStore bodies, Vector2 gravity, in ContactCoefficients c)
    {
        if (!Collect(island, bodies, gravity, c) || !_system.Solve())
        {
            return;
        }

        Feed(_system);
    }

    /// <summary>
    /// Gives contacts the impulses that were found. All of them are fed forward, so that nothing sinks at first, and swings; what is to be
    /// left of the sag comes with the island's own pace. That follows from the loads, and was found in this step before there were any.
    /// </summary>
    public static void Feed(ContactSystem system)
    {
        for (int i = 0; i < system.Count; i++)
        {
            ref SystemPoint point = ref system[i];
            float load = (float)Math.Max(point.Impulse, 0);
            point.Lanes->Normal[point.Lane] = load;
            point.Lanes->PreviousNormal[point.Lane] = load;
        }

        for (int i = 0; i < system.Count; i++)
        {
            ref SystemPoint point = ref system[i];
            ContactBundle* bundle = point.Bundle;
            int lane = point.Lane;
            float shared = bundle->Point0.Normal[lane];
            shared = (bundle->Flags[lane] & ContactBundle.SingleMark) != 0 ? shared : Math.Min(shared, bundle->Point1.Normal[lane]);
            point.Lanes->Feed[lane] = shared;
            bundle->FeedRate[lane] = 0;
        }
    }

    /// <returns>False: it is not an island to be given loads.</returns>
    private bool Collect(int island, BodyStore bodies, Vector2 gravity, in ContactCoefficients c)
    {
        _system.Clear();
        for (int k = _heads[island]; k >= 0; k = _entries[k].Next)
        {
            ref Entry entry = ref _entries[k];
            ContactBundle* bundle = entry.Bundle;
            int lane = entry.Lane;
            if (_system.Count + 2 > 2 * MostContacts
                || !IsLevel(bundle, lane, gravity, c.Gravity)
                || bundle->Point0.Normal[lane] + bundle->Point1.Normal[lane] != 0)
            {
                return false;
            }

            // The points of a contact that is still open, or that does not exist, carry nothing.
            Vector2 fall = (Fall(bodies, bundle->BodyB[lane], bundle->MassB[lane], gravity)
                - Fall(bodies, bundle->BodyA[lane], bundle->MassA[lane], gravity)) * c.Substep;
            float approach = (bundle->NormalX[lane] * fall.X) + (bundle->NormalY[lane] * fall.Y);
            AddPoint(bundle, lane, second: false, approach);
            if ((bundle->Flags[lane] & ContactBundle.SingleMark) == 0)
            {
                AddPoint(bundle, lane, second: true, approach);
            }
        }

        return _system.Count > 0;
    }

    /// <summary>A steeper contact needs its friction, which is not solved for.</summary>
    public static bool IsLevel(ContactBundle* bundle, int lane, Vector2 gravity, float strength) =>
        Math.Abs((bundle->NormalX[lane] * gravity.X) + (bundle->NormalY[lane] * gravity.Y)) >= LeastSteepness * strength;

    private static Vector2 Fall(BodyStore bodies, int body, float inverseMass, Vector2 gravity) =>
        inverseMass > 0 && (bodies.Flags[body] & BodyFlags.IgnoreGravity) == 0 ? gravity : Vector2.Zero;

    private void AddPoint(ContactBundle* bundle, int lane, bool second, float approach)
    {
        SystemPoint point = default;
        point.Bundle = bundle;
        point.Lane = lane;
        point.Second = second;
        point.ArmA = point.Lanes->TangentArmA[lane];
        point.ArmB = point.Lanes->TangentArmB[lane];
        point.Excess = approach;
        _system.Add(point);
    }

    private struct Entry
    {
        public ContactBundle* Bundle;
        public int Lane;
        public int Next;
    }
}
