using System;
using System.Numerics;
using Farseer.Engine.Accuracy;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

internal interface IContactVisitor
{
    void Visit(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points);
}

/// <summary>What readers ask of contacts between steps.</summary>
[NotState(Why.OfOneStep)]
internal sealed class ContactReader : WorldPhase
{
    private readonly Removals _removals;
    private readonly ContactStage _contactStage;
    private readonly PushReport _pushes;

    private readonly Column<ulong> _visitKeys = new Column<ulong>();

    private readonly Column<int> _visitContacts = new Column<int>();

    private readonly Column<ContactPoint> _visitPoints = new Column<ContactPoint>();

    public ContactReader(WorldStores stores, Removals removals, ContactStage contactStage, PushReport pushes)
        : base(stores)
    {
        _removals = removals;
        _contactStage = contactStage;
        _pushes = pushes;
    }

    /// <summary>Pairs of pieces in contact.</summary>
    public int Count
    {
        get
        {
            _removals.Purge();
            int count = 0;
            for (int i = 0; i < _contacts.End; i++)
            {
                ref ContactRecord record = ref _contacts.Records[i];
                if (record.PieceA >= 0 && (record.Flags & ContactFlags.Touching) != 0)
                {
                    count++;
                }
            }

            return count;
        }
    }

    /// <summary>The colliders of a pair, by its number; false if there is no such pair.</summary>
    public bool TryGetPair(int contact, out int colliderA, out int colliderB)
    {
        bool exists = contact >= 0 && contact < _contacts.End && _contacts.Records[contact].PieceA >= 0;
        colliderA = exists ? _shapes.ColliderOf(_contacts.Records[contact].PieceA) : -1;
        colliderB = exists ? _shapes.ColliderOf(_contacts.Records[contact].PieceB) : -1;
        return exists;
    }

    /// <summary>World box of a collider at its present pose.</summary>
    public void GetColliderBox(Handle collider, out Vector2 min, out Vector2 max)
    {
        ref ColliderInfo info = ref _shapes.Require(collider, nameof(collider));
        min = new Vector2(float.MaxValue, float.MaxValue);
        max = new Vector2(float.MinValue, float.MinValue);
        for (int piece = info.FirstPiece; piece >= 0; piece = _shapes.NextPiece[piece])
        {
            Box box = _shapes.TightBox(piece, _bodies.Pose[info.Body]);
            min = Vector2.Min(min, new Vector2(box.MinX, box.MinY));
            max = Vector2.Max(max, new Vector2(box.MaxX, box.MaxY));
        }
    }

    /// <summary>
    /// Calls <paramref name="visitor"/> for every pair of colliders that touched in the last step, in the order of the colliders,
    /// with the points at the present poses and the impulses of the last substep taken for the whole step.
    /// </summary>
    public unsafe void Visit(IContactVisitor visitor)
    {
        _removals.Purge();
        int count = 0;
        _visitKeys.EnsureCapacity(Math.Max(1, _contacts.Count));
        _visitContacts.EnsureCapacity(Math.Max(1, _contacts.Count));
        for (int i = 0; i < _contacts.End; i++)
        {
            ref ContactRecord record = ref _contacts.Records[i];
            if (record.PieceA >= 0 && (record.Flags & ContactFlags.Touching) != 0)
            {
                _visitKeys[count] = ((ulong)(uint)_shapes.OrderAt(record.PieceA) << 32)
                    | (uint)_shapes.OrderAt(record.PieceB);
                _visitContacts[count++] = i;
            }
        }

        RadixSort.Sort(_stores.Scratch, _visitKeys.Pointer, _visitContacts.Pointer, count);
        int start = 0;
        while (start < count)
        {
            int end = start;
            int points = 0;
            while (end < count && _visitKeys[end] == _visitKeys[start])
            {
                _visitPoints.EnsureCapacity(points + 2);
                ref ContactRecord record = ref _contacts.Records[_visitContacts[end]];
                Manifold manifold = CollideNow(record);
                points += ContactEvents.WritePoints(_bodies, record, manifold, _visitPoints.Pointer + points);
                AddImpulses(_visitContacts[end], record, points - manifold.Count, manifold.Count);
                end++;
            }

            ref ContactRecord first = ref _contacts.Records[_visitContacts[start]];
            visitor.Visit(
                _shapes.ColliderOf(first.PieceA),
                _shapes.ColliderOf(first.PieceB),
                new ReadOnlySpan<ContactPoint>(_visitPoints.Pointer, points));
            start = end;
        }
    }

    /// <summary>Whether the fat boxes of two colliders of one piece each overlap: the pair then is known, or was refused.</summary>
    public bool AreNear(Handle colliderA, Handle colliderB)
    {
        int a = _shapes.Require(colliderA, nameof(colliderA)).FirstPiece;
        int b = _shapes.Require(colliderB, nameof(colliderB)).FirstPiece;
        return (_proxies.Info[a].Flags & _proxies.Info[b].Flags & ProxyFlags.Alive) != 0
            && Box.Overlap(_proxies.Fat[a], _proxies.Fat[b]);
    }

    /// <summary>
    /// The impulses that a contact point of two colliders of one piece each gave in the last step, if there is such a point: those of
    /// the last substep taken for the whole step.
    /// </summary>
    public unsafe bool TryGetImpulses(Handle colliderA, Handle colliderB, uint feature, out float normal, out float tangent)
    {
        normal = 0;
        tangent = 0;
        ulong key = PairBuffer.Pack(
            _shapes.Require(colliderA, nameof(colliderA)).FirstPiece, _shapes.Require(colliderB, nameof(colliderB)).FirstPiece);
        if (!_contacts.Map.TryGet(key, out int index) || _contacts.Records[index].Color < 0)
        {
            return false;
        }

        ref ContactRecord record = ref _contacts.Records[index];
        ContactBundle* bundle = _graph.BundleOf(record.Row);
        int lane = RowArena.LaneOf(record.Row);
        if (bundle->Id0[lane] == feature)
        {
            normal = ImpulseOf(bundle, lane, bundle->Point0.Normal[lane]);
            tangent = RubOf(index, bundle, lane, bundle->Point0.Tangent[lane]);
            return true;
        }

        if (bundle->Id1[lane] == feature)
        {
            normal = ImpulseOf(bundle, lane, bundle->Point1.Normal[lane]);
            tangent = RubOf(index, bundle, lane, bundle->Point1.Tangent[lane]);
            return true;
        }

        return false;
    }

    private unsafe float RubOf(int contact, ContactBundle* bundle, int lane, float tangent) =>
        (tangent * _settings.Substeps) + (_contactStage.Lone.TangentOf(contact) * ShareOfPoint(bundle, lane));

    private static unsafe float ShareOfPoint(ContactBundle* bundle, int lane) =>
        (bundle->Flags[lane] & ContactBundle.SingleMark) != 0 ? 1f : 0.5f;

    /// <summary>What it bears, and its share of the blows that it had in the step, which are let go when they are over.</summary>
    private unsafe float ImpulseOf(ContactBundle* bundle, int lane, float normal)
    {
        float blow = bundle->Struck[lane] * ShareOfPoint(bundle, lane);
        return (normal * _settings.Substeps) + blow;
    }

    /// <summary>Deepest overlap of two responding colliders at the present poses, 0 if none.</summary>
    public float LargestPenetration()
    {
        _removals.Purge();
        float deepest = 0;
        for (int i = 0; i < _contacts.End; i++)
        {
            ref ContactRecord record = ref _contacts.Records[i];
            if (record.PieceA >= 0 && (record.Flags & ContactFlags.Solid) != 0)
            {
                Manifold manifold = CollideNow(record);
                deepest = manifold.Count > 0 ? Math.Max(deepest, -manifold.Point0.Separation) : deepest;
                deepest = manifold.Count > 1 ? Math.Max(deepest, -manifold.Point1.Separation) : deepest;
            }
        }

        return deepest;
    }

    private Manifold CollideNow(in ContactRecord record)
    {
        ContactProbe.Collide(_bodies, _shapes, record, out Manifold manifold);
        return manifold;
    }

    private unsafe void AddImpulses(int contact, in ContactRecord record, int from, int count)
    {
        // What sleeps bears what it bore when it fell asleep.
        if (_pushes.HasSums && !record.IsDormant)
        {
            _pushes.AddSums(contact, record, _visitPoints.Pointer, from, count);
            return;
        }

        if (record.Color < 0)
        {
            return;
        }

        ContactBundle* bundle = _graph.BundleOf(record.Row);
        int lane = RowArena.LaneOf(record.Row);
        for (int k = from; k < from + count; k++)
        {
            ref ContactPoint point = ref _visitPoints[k];
            if (point.FeatureId == bundle->Id0[lane])
            {
                point.NormalImpulse = bundle->Point0.Normal[lane] * _stores.Substeps;
                point.TangentImpulse = bundle->Point0.Tangent[lane] * _stores.Substeps;
            }
            else if (point.FeatureId == bundle->Id1[lane])
            {
                point.NormalImpulse = bundle->Point1.Normal[lane] * _stores.Substeps;
                point.TangentImpulse = bundle->Point1.Tangent[lane] * _stores.Substeps;
            }
        }
    }
}
