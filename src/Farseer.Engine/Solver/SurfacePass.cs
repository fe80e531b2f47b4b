using System;
using System.Numerics;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// Friction of contacts whose surfaces run past their bodies, and the torque that resists rolling: one by one, in the order of the
/// contacts, after the relax pass of each substep and the impacts, whose normal impulses bound both. Their rows have no friction. A substep
/// starts from the forces of the one before, so what lasts is exact: a belt drives as hard as it can until nothing slips, and a ball on a
/// slope that its resistance holds stands still.
/// </summary>
internal sealed unsafe class SurfacePass
{
    private readonly Column<Entry> _entries = new Column<Entry>();
    private readonly Column<ulong> _keys = new Column<ulong>();
    private readonly Column<int> _order = new Column<int>();
    private readonly RadixSort _sort = new RadixSort();
    private PairSurfaces _surfaces = null!;
    private BodyStore _bodies = null!;
    private ContactImpulses? _impulses;
    private float _substep;
    private int _count;

    /// <summary>Lets go of the world.</summary>
    public void Forget()
    {
        _surfaces = null!;
        _bodies = null!;
        _impulses = null;
    }

    /// <summary>Lists the contacts of a solve, after trees have taken theirs.</summary>
    public void Begin(in SolverInput input)
    {
        _count = 0;
        _surfaces = input.Surfaces!;
        _bodies = input.Bodies;
        _impulses = input.Impulses;
        _substep = input.Substep;
        for (int i = 0; i < input.Colors.Length; i++)
        {
            foreach (ContactBundle* row in input.Colors[i].Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    int contact = row->Contact[lane];
                    if (contact >= 0 && _surfaces[contact].IsSpecial)
                    {
                        List(row, lane, contact);
                    }
                }
            }
        }

        _sort.Reserve(Math.Max(1, _count));
        _sort.Sort(_keys.Pointer, _order.Pointer, _count);
        for (int i = 0; input.Joints != null && i < input.Joints.Impacts.TakenCount; i++)
        {
            TreeContact* taken = input.Joints.Impacts.Taken(i);
            int place = new ReadOnlySpan<ulong>(_keys.Pointer, _count).BinarySearch((ulong)(uint)taken->Bundle->Contact[taken->Lane]);
            if (place >= 0)
            {
                _entries[_order[place]].Held = taken;
            }
        }
    }

    /// <summary>As a substep begins: the forces of the last one go on.</summary>
    public void WarmStart()
    {
        for (int i = 0; i < _count; i++)
        {
            ref Entry e = ref _entries[_order[i]];
            ref PairSurface surface = ref _surfaces[e.Contact];
            Give(ref e, 0, surface.Rub0 * _substep, Arms(e, false));
            Give(ref e, 1, surface.Rub1 * _substep, Arms(e, true));
            Turn(e, surface.Roll * _substep);
        }
    }

    public void Solve()
    {
        for (int i = 0; i < _count; i++)
        {
            ref Entry e = ref _entries[_order[i]];
            ref PairSurface surface = ref _surfaces[e.Contact];
            NormalsOf(e, out double normal0, out double normal1);
            surface.Rub0 = (float)(Rub(ref e, 0, surface.Rub0 * _substep, surface, normal0) / _substep);
            surface.Rub1 = (float)(Rub(ref e, 1, surface.Rub1 * _substep, surface, normal1) / _substep);
            surface.Roll = (float)(Roll(e, surface.Roll * _substep, surface.RollingArm * (normal0 + normal1)) / _substep);
        }
    }

    private void List(ContactBundle* row, int lane, int contact)
    {
        _entries.EnsureCapacity(_count + 1);
        _keys.EnsureCapacity(_count + 1);
        _order.EnsureCapacity(_count + 1);
        ref Entry e = ref _entries[_count];
        e = default;
        e.Row = row;
        e.Lane = lane;
        e.Contact = contact;
        _keys[_count] = (ulong)(uint)contact;
        _order[_count] = _count;
        _count++;

        // Other points than in the last step: what they rubbed is not known.
        ref PairSurface surface = ref _surfaces[contact];
        bool crossed = row->Id0[lane] == surface.Id1 || row->Id1[lane] == surface.Id0;
        (float rub0, float rub1) = crossed ? (surface.Rub1, surface.Rub0) : (surface.Rub0, surface.Rub1);
        surface.Rub0 = row->Id0[lane] == surface.Id0 || row->Id0[lane] == surface.Id1 ? rub0 : 0;
        surface.Rub1 = row->Id1[lane] == surface.Id1 || row->Id1[lane] == surface.Id0 ? rub1 : 0;
        surface.Id0 = row->Id0[lane];
        surface.Id1 = row->Id1[lane];
    }

    private void NormalsOf(in Entry e, out double normal0, out double normal1)
    {
        normal0 = Math.Max(0, e.Held != null ? e.Held->Point0.Normal : e.Row->Point0.Normal[e.Lane]);
        normal1 = Math.Max(0, e.Held == null ? e.Row->Point1.Normal[e.Lane] : e.Held->Points > 1 ? e.Held->Point1.Normal : 0);
    }

    private double Rub(ref Entry e, int point, double old, in PairSurface surface, double normal)
    {
        RubArms arms = Arms(e, point == 1);
        ref BodyState a = ref _bodies.State[e.Row->BodyA[e.Lane]];
        ref BodyState b = ref _bodies.State[e.Row->BodyB[e.Lane]];
        double nx = e.Row->NormalX[e.Lane];
        double ny = e.Row->NormalY[e.Lane];
        double slip = (ny * ((double)b.LinearVelocity.X - a.LinearVelocity.X)) - (nx * ((double)b.LinearVelocity.Y - a.LinearVelocity.Y))
            + (a.AngularVelocity * arms.A) - (b.AngularVelocity * arms.B) - surface.Speed;
        double response = e.Row->MassA[e.Lane] + e.Row->MassB[e.Lane]
            + (e.Row->InertiaA[e.Lane] * arms.A * arms.A) + (e.Row->InertiaB[e.Lane] * arms.B * arms.B);
        double bound = surface.Friction * normal;
        double found = response > 0 ? Math.Max(-bound, Math.Min(bound, old - (slip / response))) : 0;
        Give(ref e, point, found - old, arms);
        return found;
    }

    private double Roll(in Entry e, double old, double bound)
    {
        double spin = (double)_bodies.State[e.Row->BodyB[e.Lane]].AngularVelocity - _bodies.State[e.Row->BodyA[e.Lane]].AngularVelocity;
        double response = e.Row->InertiaA[e.Lane] + e.Row->InertiaB[e.Lane];
        double found = response > 0 ? Math.Max(-bound, Math.Min(bound, old - (spin / response))) : 0;
        Turn(e, found - old);
        return found;
    }

    /// <summary>Gives both bodies an impulse along the tangent.</summary>
    private void Give(ref Entry e, int point, double p, in RubArms arms)
    {
        if (p == 0)
        {
            return;
        }

        ContactBundle* row = e.Row;
        double px = row->NormalY[e.Lane] * p;
        double py = -row->NormalX[e.Lane] * p;
        Push(row->BodyA[e.Lane], -row->MassA[e.Lane], px, py, row->InertiaA[e.Lane] * arms.A * p);
        Push(row->BodyB[e.Lane], row->MassB[e.Lane], px, py, -row->InertiaB[e.Lane] * arms.B * p);
        _impulses?.AddBeside(row, e.Lane, point == 1, 0, p);
    }

    private void Turn(in Entry e, double p)
    {
        if (p != 0)
        {
            Push(e.Row->BodyA[e.Lane], 0, 0, 0, -e.Row->InertiaA[e.Lane] * p);
            Push(e.Row->BodyB[e.Lane], 0, 0, 0, e.Row->InertiaB[e.Lane] * p);
        }
    }

    private void Push(int body, double mass, double px, double py, double spin)
    {
        if (mass != 0 || spin != 0)
        {
            ref BodyState state = ref _bodies.State[body];
            state.LinearVelocity =
                new Vector2((float)(state.LinearVelocity.X + (mass * px)), (float)(state.LinearVelocity.Y + (mass * py)));
            state.AngularVelocity = (float)(state.AngularVelocity + spin);
        }
    }

    /// <summary>Arms of friction, from the bodies to the surfaces.</summary>
    private RubArms Arms(in Entry e, bool second)
    {
        ContactBundle* row = e.Row;
        int lane = e.Lane;
        double normalA;
        double tangentA;
        double normalB;
        double tangentB;
        if (e.Held != null)
        {
            TreeContactPoint* point = second ? &e.Held->Point1 : &e.Held->Point0;
            (normalA, tangentA, normalB, tangentB) = (point->NormalArmA, point->TangentArmA, point->NormalArmB, point->TangentArmB);
        }
        else
        {
            ContactPointLanes* point = second ? &row->Point1 : &row->Point0;
            (normalA, tangentA, normalB, tangentB) =
                (point->NormalArmA[lane], point->TangentArmA[lane], point->NormalArmB[lane], point->TangentArmB[lane]);
        }

        ref BodyState a = ref _bodies.State[row->BodyA[lane]];
        ref BodyState b = ref _bodies.State[row->BodyB[lane]];
        RubArms arms;
        arms.A = (a.DeltaCos * normalA) + (a.DeltaSin * tangentA) + row->RadiusA[lane];
        arms.B = (b.DeltaCos * normalB) + (b.DeltaSin * tangentB) - row->RadiusB[lane];
        return arms;
    }

    private struct RubArms
    {
        public double A;
        public double B;
    }

    /// <summary>A contact of the pass.</summary>
    [StructLayout(LayoutKind.Sequential)]
    private struct Entry
    {
        public ContactBundle* Row;

        /// <summary>The same contact where a tree holds it, or null.</summary>
        public TreeContact* Held;
        public int Lane;
        public int Contact;
    }
}
