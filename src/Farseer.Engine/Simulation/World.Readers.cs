using System;
using System.Numerics;
using Farseer.Engine.Accuracy;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

internal interface IContactVisitor
{
    void Visit(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points);
}

/// <summary>What readers ask of the world between steps.</summary>
internal sealed partial class World
{
    [NotState(Why.OfOneStep)]
    private readonly Column<ulong> _visitKeys = new Column<ulong>();
    [NotState(Why.OfOneStep)]
    private readonly Column<int> _visitContacts = new Column<int>();
    [NotState(Why.OfOneStep)]
    private readonly Column<ContactPoint> _visitPoints = new Column<ContactPoint>();

    /// <summary>World box of a collider at its present pose.</summary>
    public void GetColliderBox(Handle collider, out Vector2 min, out Vector2 max)
    {
        ref ColliderInfo info = ref Collider(collider);
        min = new Vector2(float.MaxValue, float.MaxValue);
        max = new Vector2(float.MinValue, float.MinValue);
        for (int piece = info.FirstPiece; piece >= 0; piece = Shapes.NextPiece[piece])
        {
            Box box = Shapes.TightBox(piece, Bodies.Pose[info.Body]);
            min = Vector2.Min(min, new Vector2(box.MinX, box.MinY));
            max = Vector2.Max(max, new Vector2(box.MaxX, box.MaxY));
        }
    }

    /// <summary>
    /// Calls <paramref name="visitor"/> for every pair of colliders that touched in the last step, in the order of the colliders,
    /// with the points at the present poses and the impulses of the last substep taken for the whole step.
    /// </summary>
    public unsafe void VisitContacts(IContactVisitor visitor)
    {
        Purge();
        int count = 0;
        _visitKeys.EnsureCapacity(Math.Max(1, _contacts.Count));
        _visitContacts.EnsureCapacity(Math.Max(1, _contacts.Count));
        for (int i = 0; i < _contacts.End; i++)
        {
            ref ContactRecord record = ref _contacts.Records[i];
            if (record.PieceA >= 0 && (record.Flags & ContactFlags.Touching) != 0)
            {
                _visitKeys[count] = ((ulong)(uint)Shapes.OrderAt(record.PieceA) << 32)
                    | (uint)Shapes.OrderAt(record.PieceB);
                _visitContacts[count++] = i;
            }
        }

        RadixSort.Sort(Scratch, _visitKeys.Pointer, _visitContacts.Pointer, count);
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
                points += ContactEvents.WritePoints(this, record, manifold, _visitPoints.Pointer + points);
                AddImpulses(_visitContacts[end], record, points - manifold.Count, manifold.Count);
                end++;
            }

            ref ContactRecord first = ref _contacts.Records[_visitContacts[start]];
            visitor.Visit(Shapes.ColliderOf(first.PieceA), Shapes.ColliderOf(first.PieceB), new ReadOnlySpan<ContactPoint>(_visitPoints.Pointer, points));
            start = end;
        }
    }

    /// <summary>Whether the fat boxes of two colliders of one piece each overlap: the pair then is known, or was refused.</summary>
    public bool AreNear(Handle colliderA, Handle colliderB)
    {
        int a = Collider(colliderA).FirstPiece;
        int b = Collider(colliderB).FirstPiece;
        return (Proxies.Info[a].Flags & Proxies.Info[b].Flags & ProxyFlags.Alive) != 0
            && Box.Overlap(Proxies.Fat[a], Proxies.Fat[b]);
    }

    /// <summary>
    /// The impulses that a contact point of two colliders of one piece each gave in the last step, if there is such a point: those of
    /// the last substep taken for the whole step.
    /// </summary>
    public unsafe bool TryGetImpulses(Handle colliderA, Handle colliderB, uint feature, out float normal, out float tangent)
    {
        normal = 0;
        tangent = 0;
        ulong key = PairBuffer.Pack(Collider(colliderA).FirstPiece, Collider(colliderB).FirstPiece);
        if (!_contacts.Map.TryGet(key, out int index) || _contacts.Records[index].Color < 0)
        {
            return false;
        }

        ref ContactRecord record = ref _contacts.Records[index];
        ContactBundle* bundle = _graph.BundleOf(record.Row);
        int lane = Graph.RowArena.LaneOf(record.Row);
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
        (tangent * Settings.Substeps) + (_contactStage.Lone.TangentOf(contact) * ShareOfPoint(bundle, lane));

    private static unsafe float ShareOfPoint(ContactBundle* bundle, int lane) => (bundle->Flags[lane] & ContactBundle.SingleMark) != 0 ? 1f : 0.5f;

    /// <summary>What it bears, and its share of the blows that it had in the step, which are let go when they are over.</summary>
    private unsafe float ImpulseOf(ContactBundle* bundle, int lane, float normal)
    {
        float blow = bundle->Struck[lane] * ShareOfPoint(bundle, lane);
        return (normal * Settings.Substeps) + blow;
    }

    /// <summary>64-bit hash (FNV-1a) of the poses and velocities of all live bodies, in order; equal on every platform.</summary>
    public unsafe ulong MotionHash()
    {
        ulong hash = 14695981039346656037UL;
        for (int body = 1; body < Bodies.Ids.End; body++)
        {
            if ((Bodies.Flags[body] & BodyFlags.Alive) != 0)
            {
                BodyPose pose = Bodies.Pose[body];
                BodyState state = Bodies.State[body];
                hash = Hash(hash, *(ulong*)&pose.X);
                hash = Hash(hash, *(ulong*)&pose.Y);
                hash = Hash(hash, *(ulong*)&pose.Angle);
                hash = Hash(hash, (uint)FloatBits.ToInt(state.LinearVelocity.X));
                hash = Hash(hash, (uint)FloatBits.ToInt(state.LinearVelocity.Y));
                hash = Hash(hash, (uint)FloatBits.ToInt(state.AngularVelocity));
            }
        }

        return hash;
    }

    /// <summary>Deepest overlap of two responding colliders at the present poses, 0 if none.</summary>
    public float LargestPenetration()
    {
        Purge();
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

    private static ulong Hash(ulong hash, ulong value)
    {
        for (int i = 0; i < 8; i++)
        {
            hash = (hash ^ (value & 0xFF)) * 1099511628211UL;
            value >>= 8;
        }

        return hash;
    }

    private Manifold CollideNow(in ContactRecord record)
    {
        ContactProbe.Collide(Bodies, Shapes, record, out Manifold manifold);
        return manifold;
    }

    private unsafe void AddImpulses(int contact, in ContactRecord record, int from, int count)
    {
        // What sleeps bears what it bore when it fell asleep.
        if (HasSums && !record.IsDormant)
        {
            AddSums(contact, record, from, count);
            return;
        }

        if (record.Color < 0)
        {
            return;
        }

        ContactBundle* bundle = _graph.BundleOf(record.Row);
        int lane = Graph.RowArena.LaneOf(record.Row);
        for (int k = from; k < from + count; k++)
        {
            ref ContactPoint point = ref _visitPoints[k];
            if (point.FeatureId == bundle->Id0[lane])
            {
                point.NormalImpulse = bundle->Point0.Normal[lane] * _substeps;
                point.TangentImpulse = bundle->Point0.Tangent[lane] * _substeps;
            }
            else if (point.FeatureId == bundle->Id1[lane])
            {
                point.NormalImpulse = bundle->Point1.Normal[lane] * _substeps;
                point.TangentImpulse = bundle->Point1.Tangent[lane] * _substeps;
            }
        }
    }
}
