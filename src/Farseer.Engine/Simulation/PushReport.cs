using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>What contacts give in a step, and who pushed whom. Nothing of it runs unless somebody asks.</summary>
internal sealed class PushReport : WorldPhase
{
    /// <summary>Substeps of gravity up to whose speed an approach is rest, as for a bounce.</summary>
    private const float RestSubsteps = BounceKernel.RestSubsteps;

    [NotState(Why.OfOneStep)]
    private readonly Column<ulong> _hitKeys = new Column<ulong>();

    [NotState(Why.OfOneStep)]
    private readonly Column<int> _hitContacts = new Column<int>();

    // Where bodies were when the step began, of steps that tell.
    [NotState(Why.OfOneStep)]
    private readonly Column<BodyPose> _hitStarts = new Column<BodyPose>();
    private ContactImpulses? _impulses;
    private bool _sums;
    private bool _tellsPushes;

    public PushReport(WorldStores stores)
        : base(stores)
    {
    }

    /// <summary>Each step sums the impulses of each contact.</summary>
    public bool SumsImpulses { get; set; }

    /// <summary>Each step tells of the pairs that pushed each other: see <see cref="IStepHooks.OnPush"/>. It sums impulses too.</summary>
    public bool TellsPushes { get; set; }

    /// <summary>Slowest approach that is a hit, a speed of the scene; 0: what is no rest.</summary>
    public float HitSpeed { get; set; }

    /// <summary>The sums of this step, or of the last one; null if there are none.</summary>
    public ContactImpulses? Impulses => _sums ? _impulses : null;

    /// <summary>What the points of a row gave in the last step that summed it, if it did.</summary>
    public bool HasSums => Impulses != null;

    private void MakeImpulses() => _impulses ??= new ContactImpulses();

    public unsafe void Begin()
    {
        // As they were when the step began: a handler may switch within it.
        _tellsPushes = TellsPushes;
        _sums = SumsImpulses || TellsPushes;
        if (!_sums)
        {
            return;
        }

        MakeImpulses();
        if (_tellsPushes)
        {
            int end = _bodies.Ids.End;
            _hitStarts.EnsureCapacity(end);
            new ReadOnlySpan<BodyPose>(_bodies.Pose.Pointer, end).CopyTo(new Span<BodyPose>(_hitStarts.Pointer, end));
        }
    }

    /// <summary>The pairs of this step are known.</summary>
    public void MakeRoom() => Impulses?.Begin(_contacts.Records.Capacity);

    /// <summary>Tells of the pairs that pushed each other in the step, in the order of their colliders.</summary>
    public unsafe void Raise(float substep)
    {
        IStepHooks? hooks = _stores.Hooks;
        if (!_tellsPushes || hooks == null)
        {
            return;
        }

        Vector2 g = _settings.Gravity;
        float rest = RestSubsteps * substep * (float)Math.Sqrt(((double)g.X * g.X) + ((double)g.Y * g.Y));
        float least = Math.Max(HitSpeed, rest);
        int count = 0;
        _hitKeys.EnsureCapacity(Math.Max(1, _contacts.End));
        _hitContacts.EnsureCapacity(Math.Max(1, _contacts.End));
        for (int i = 0; i < _contacts.End; i++)
        {
            ref ContactImpulse given = ref _impulses!.Of(i);
            ref ContactRecord record = ref _contacts.Records[i];
            if (given.Normal > 0 && record.PieceA >= 0)
            {
                _hitKeys[count] = ((ulong)(uint)_shapes.OrderAt(record.PieceA) << 32) | (uint)_shapes.OrderAt(record.PieceB);
                _hitContacts[count++] = i;
            }
        }

        RadixSort.Sort(_stores.Scratch, _hitKeys.Pointer, _hitContacts.Pointer, count);
        int start = 0;
        while (start < count)
        {
            int end = start + 1;
            while (end < count && _hitKeys[end] == _hitKeys[start])
            {
                end++;
            }

            PushRecord push = Gather(start, end);
            push.IsHit = push.Approach > least;
            ref ContactRecord record = ref _contacts.Records[_hitContacts[start]];
            hooks.OnPush(_shapes.ColliderOf(record.PieceA), _shapes.ColliderOf(record.PieceB), push);
            start = end;
        }
    }

    /// <summary>What a pair of colliders gave each other; its point is that of the hardest push.</summary>
    private PushRecord Gather(int start, int end)
    {
        PushRecord hit = default;
        double hardest = -1;
        double normal = 0;
        double tangent = 0;
        for (int i = start; i < end; i++)
        {
            int contact = _hitContacts[i];
            ref ContactImpulse given = ref _impulses!.Of(contact);
            hit.Approach = Math.Max(hit.Approach, given.Approach);
            normal += given.Normal;
            tangent += given.Tangent;
            hit.PushX += given.PushX;
            hit.PushY += given.PushY;
            if (given.Normal > hardest)
            {
                hardest = given.Normal;
                Place(contact, given, ref hit);
            }
        }

        hit.NormalImpulse = (float)normal;
        hit.TangentImpulse = (float)tangent;
        return hit;
    }

    private void Place(int contact, in ContactImpulse given, ref PushRecord hit)
    {
        if (given.OnWay != 0)
        {
            hit.X = given.X;
            hit.Y = given.Y;
            hit.Normal = given.Axis;
            return;
        }

        // On the surface of the one that moves less by then, where the step found it, as if it had carried the point along.
        ref ContactRecord record = ref _contacts.Records[contact];
        Manifold manifold = _contacts.Manifolds[contact];
        ManifoldPoint point = given.Normal1 > given.Normal0 ? manifold.Point1 : manifold.Point0;
        bool onB = _bodies.Mass[record.BodyB].InverseMass < _bodies.Mass[record.BodyA].InverseMass;
        BodyPose a = _hitStarts[record.BodyA];
        Vector2 offset = point.Anchor + ((onB ? 0.5f : -0.5f) * point.Separation * manifold.Normal);
        BodyPose before = _hitStarts[onB ? record.BodyB : record.BodyA];
        BodyPose after = _bodies.Pose[onB ? record.BodyB : record.BodyA];
        double x = a.X + offset.X - before.X;
        double y = a.Y + offset.Y - before.Y;
        double cos = ((double)after.Cos * before.Cos) + ((double)after.Sin * before.Sin);
        double sin = ((double)after.Sin * before.Cos) - ((double)after.Cos * before.Sin);
        hit.X = after.X + (cos * x) - (sin * y);
        hit.Y = after.Y + (sin * x) + (cos * y);
        hit.Normal = manifold.Normal;
    }

    /// <summary>
    /// The impulses of the last step for the points of a reader. What a point gave that is there no more goes to the first one.
    /// </summary>
    public unsafe void AddSums(int contact, in ContactRecord record, ContactPoint* points, int from, int count)
    {
        if (count == 0)
        {
            return;
        }

        ContactImpulse given = Impulses!.Of(contact);
        ContactBundle* bundle = record.Color < 0 ? null : _graph.BundleOf(record.Row);
        int lane = bundle == null ? 0 : RowArena.LaneOf(record.Row);
        int place0 = from;
        int place1 = from;
        for (int k = from; k < from + count && bundle != null; k++)
        {
            uint id = points[k].FeatureId;
            place0 = id == bundle->Id0[lane] ? k : place0;
            place1 = id == bundle->Id1[lane] ? k : place1;
        }

        points[place0].NormalImpulse += (float)given.Normal0;
        points[place0].TangentImpulse += (float)given.Tangent0;
        points[place1].NormalImpulse += (float)given.Normal1;
        points[place1].TangentImpulse += (float)given.Tangent1;
    }

    /// <summary>Writes, or reads, what readers of contacts see, and what is to be summed.</summary>
    public void Visit(StateStream s)
    {
        SumsImpulses = s.Of(nameof(PushReport)).Value(SumsImpulses);
        TellsPushes = s.Value(TellsPushes);
        HitSpeed = s.Value(HitSpeed);
        s.Value(ref _sums);
        s.Value(ref _tellsPushes);
        if (s.Lacks(_impulses))
        {
            MakeImpulses();
        }

        s.Reference(ref _impulses);
        _impulses?.Visit(s.Of(nameof(_impulses)));
    }
}
