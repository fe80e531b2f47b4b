using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>What the update of contacts reads: columns and the numbers of this step.</summary>
internal unsafe ref struct ContactUpdateInput
{
    public ShapeStore Shapes;
    public BodyStore Bodies;
    public ContactStore Contacts;
    public Box* Fat;

    /// <summary>1 for a body that the solver may move.</summary>
    public byte* Moves;
    public WorldSettings Settings;
    public float Dt;

    /// <summary>Ratio of this step's substep to the last one's.</summary>
    public float ImpulseScale;
    public ContactCoefficients Coefficients;
}

/// <summary>What is to become of a pair after its update.</summary>
internal enum ContactFate
{
    /// <summary>Stays where it is.</summary>
    Keep,

    /// <summary>Leaves the graph: it has no points any more, or gives no impulses.</summary>
    Lose,

    /// <summary>Enters the graph.</summary>
    Gain,

    /// <summary>The boxes came apart: the pair is forgotten.</summary>
    Drop,
}

/// <summary>
/// The narrow phase of one pair, and the rewriting of its row. Tolerances come from the motion of a step and from the pieces'
/// own extents, never from a unit of length.
/// </summary>
internal static unsafe class ContactUpdate
{
    /// <summary>
    /// Points this share of the smaller extent apart are kept although they cannot touch in this step: a box that rocks by a
    /// hair keeps both points and their impulses.
    /// </summary>
    private const float SkinShare = 0.02f;

    /// <summary>
    /// An island is deep if a point is deeper than this share of the smaller piece or, if less, than this many depths of rest,
    /// beyond three static sags.
    /// </summary>
    private const float DeepShare = 0.02f;
    private const float DeepRests = 2f;
    private const float DeepSags = 3f;

    /// <summary>Updates a pair that has a row.</summary>
    public static ContactFate UpdateRow(in ContactUpdateInput input, ContactBundle* row, int lane)
    {
        int index = row->Contact[lane];
        ref ContactRecord record = ref input.Contacts.Records[index];
        if (!Box.Overlap(input.Fat[record.PieceA], input.Fat[record.PieceB]))
        {
            return ContactFate.Drop;
        }

        SetSolidity(input, ref record);
        uint oldId = row->Point0.Id[lane];
        Vector2 offset = Collide(input, ref record, oldId, out Manifold manifold);
        if (manifold.Count == 0 || (record.Flags & ContactFlags.Solid) == 0)
        {
            input.Contacts.Manifolds[index] = manifold;
            SetTouching(input, ref record, manifold, offset);
            return ContactFate.Lose;
        }

        WriteRow(input, ref record, row, lane, manifold, offset);
        SetTouching(input, ref record, manifold, offset);
        if ((record.Flags & ContactFlags.Heard) != 0)
        {
            input.Contacts.Manifolds[index] = manifold;
        }

        return ContactFate.Keep;
    }

    /// <summary>Updates a pair without a row; its manifold is kept for <see cref="FillRow"/> and for readers.</summary>
    public static ContactFate UpdateIdle(in ContactUpdateInput input, int index)
    {
        ref ContactRecord record = ref input.Contacts.Records[index];
        if (!Box.Overlap(input.Fat[record.PieceA], input.Fat[record.PieceB]))
        {
            return ContactFate.Drop;
        }

        SetSolidity(input, ref record);
        Vector2 offset = Collide(input, ref record, 0, out Manifold manifold);
        input.Contacts.Manifolds[index] = manifold;
        SetTouching(input, ref record, manifold, offset);
        return manifold.Count > 0 && (record.Flags & ContactFlags.Solid) != 0 ? ContactFate.Gain : ContactFate.Keep;
    }

    /// <summary>Writes a row that a pair has just been given.</summary>
    public static void FillRow(in ContactUpdateInput input, int index, ContactBundle* row, int lane)
    {
        ref ContactRecord record = ref input.Contacts.Records[index];
        Vector2 offset = Offset(input, record);
        WriteRow(input, ref record, row, lane, input.Contacts.Manifolds[index], offset);
    }

    public static float MixFriction(in ContactUpdateInput input, in ContactRecord record)
    {
        float a = input.Shapes.Colliders[record.ColliderA].Friction;
        float b = input.Shapes.Colliders[record.ColliderB].Friction;
        return input.Settings.FrictionMix == FrictionMix.Minimum ? Math.Min(a, b) : (a + b) * 0.5f;
    }

    private static void WriteRow(
        in ContactUpdateInput input, ref ContactRecord record, ContactBundle* row, int lane, in Manifold manifold, Vector2 offset)
    {
        ref BodyMass massA = ref input.Bodies.Mass[record.BodyA];
        ref BodyMass massB = ref input.Bodies.Mass[record.BodyB];
        BodyMass effectiveA = input.Moves[record.BodyA] != 0 ? massA : default;
        BodyMass effectiveB = input.Moves[record.BodyB] != 0 ? massB : default;
        ContactRowWriter.Write(
            row, lane, manifold, offset, effectiveA, effectiveB, input.Settings.AllowedPenetration, input.ImpulseScale);
        row->Friction[lane] = input.Settings.FreezePairFriction ? record.FirstFriction : MixFriction(input, record);
        row->Restitution[lane] =
            (input.Shapes.Colliders[record.ColliderA].Restitution + input.Shapes.Colliders[record.ColliderB].Restitution) * 0.5f;
        SetStiffness(input, record, row, lane, manifold);
    }

    /// <summary>How fully the load is fed forward, and deepness: a row stays deep until its depth is under half of what made it so.</summary>
    private static void SetStiffness(in ContactUpdateInput input, in ContactRecord record, ContactBundle* row, int lane, in Manifold manifold)
    {
        float depth = -manifold.Point0.Separation;
        if (manifold.Count == 2)
        {
            depth = Math.Max(depth, -manifold.Point1.Separation);
        }

        depth -= input.Settings.AllowedPenetration;
        float size = 2 * Math.Min(input.Shapes.Pieces[record.PieceA].Extent, input.Shapes.Pieces[record.PieceB].Extent);
        float load = Math.Max(row->Point0.Normal[lane] * row->K11[lane], row->Point1.Normal[lane] * row->K22[lane]);
        row->FeedShare[lane] = input.Coefficients.FeedShare(size);
        float sag = input.Coefficients.Sag(load, 1f);
        float limit = DeepShare * size;
        if (input.Settings.AllowedPenetration > 0)
        {
            limit = Math.Min(limit, DeepRests * input.Settings.AllowedPenetration);
        }

        limit += DeepSags * sag;
        row->Deep[lane] = depth > limit || (row->Deep[lane] > 0 && depth > 0.5f * limit) ? 1 : 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector2 Offset(in ContactUpdateInput input, in ContactRecord record)
    {
        ref BodyPose poseA = ref input.Bodies.Pose[record.BodyA];
        ref BodyPose poseB = ref input.Bodies.Pose[record.BodyB];
        return new Vector2((float)(poseB.X - poseA.X), (float)(poseB.Y - poseA.Y));
    }

    private static Vector2 Collide(in ContactUpdateInput input, ref ContactRecord record, uint oldId, out Manifold manifold)
    {
        ref BodyPose poseA = ref input.Bodies.Pose[record.BodyA];
        ref BodyPose poseB = ref input.Bodies.Pose[record.BodyB];
        PairInput pair;
        pair.Vertices = input.Shapes.Vertices.Pointer;
        pair.Normals = input.Shapes.Normals.Pointer;
        pair.OutlineBefore = input.Shapes.OutlineBefore.Pointer;
        pair.OutlineAfter = input.Shapes.OutlineAfter.Pointer;
        pair.A = input.Shapes.Pieces[record.PieceA];
        pair.B = input.Shapes.Pieces[record.PieceB];
        pair.RotationA = new Rotation(poseA.Cos, poseA.Sin);
        pair.RotationB = new Rotation(poseB.Cos, poseB.Sin);
        pair.Offset = Offset(input, record);
        pair.Margin = Margin(input, record, pair.A, pair.B);
        pair.OldId = oldId;
        Collision.Collide(pair, out manifold);
        return pair.Offset;
    }

    private static float Margin(in ContactUpdateInput input, in ContactRecord record, in Piece a, in Piece b)
    {
        ref BodyState stateA = ref input.Bodies.State[record.BodyA];
        ref BodyState stateB = ref input.Bodies.State[record.BodyB];
        Vector2 speed = stateB.LinearVelocity - stateA.LinearVelocity;
        Vector2 g = input.Settings.Gravity;
        float motion = Math.Abs(speed.X) + Math.Abs(speed.Y)
            + (Math.Abs(stateA.AngularVelocity) * a.Reach) + (Math.Abs(stateB.AngularVelocity) * b.Reach)
            + ((Math.Abs(g.X) + Math.Abs(g.Y)) * input.Dt);
        return (motion * input.Dt) + (SkinShare * Math.Min(a.Extent, b.Extent));
    }

    private static void SetSolidity(in ContactUpdateInput input, ref ContactRecord record)
    {
        ColliderFlags a = input.Shapes.Colliders[record.ColliderA].Flags;
        ColliderFlags b = input.Shapes.Colliders[record.ColliderB].Flags;
        bool solid = (a & b & ColliderFlags.ResponseEnabled) != 0
            && (input.Moves[record.BodyA] | input.Moves[record.BodyB]) != 0;
        bool heard = ((a | b) & (ColliderFlags.WantsContact | ColliderFlags.WantsSeparation)) != 0;
        record.Flags = (record.Flags & ContactFlags.Touching)
            | (solid ? ContactFlags.Solid : ContactFlags.None)
            | (heard ? ContactFlags.Heard : ContactFlags.None);
    }

    /// <summary>
    /// A pair touches if a point overlaps or will, with the present velocities and gravity, within the step. A pair that touched
    /// goes on touching up to a gap of the depth of rest, so that the tremor of an impact is not a row of separations.
    /// </summary>
    private static void SetTouching(in ContactUpdateInput input, ref ContactRecord record, in Manifold manifold, Vector2 offset)
    {
        bool touching = manifold.Count > 0 && (WillTouch(input, record, manifold, manifold.Point0, offset)
            || (manifold.Count == 2 && WillTouch(input, record, manifold, manifold.Point1, offset)));
        record.Flags = touching ? record.Flags | ContactFlags.Touching : record.Flags & ~ContactFlags.Touching;
    }

    private static bool WillTouch(
        in ContactUpdateInput input, in ContactRecord record, in Manifold manifold, in ManifoldPoint point, Vector2 offset)
    {
        float reach = (record.Flags & ContactFlags.Touching) != 0 ? input.Settings.AllowedPenetration : 0;
        if (point.Separation <= reach)
        {
            return true;
        }

        ref BodyState a = ref input.Bodies.State[record.BodyA];
        ref BodyState b = ref input.Bodies.State[record.BodyB];
        Vector2 n = manifold.Normal;
        Vector2 rA = point.Anchor;
        Vector2 rB = point.Anchor - offset;
        Vector2 speed = b.LinearVelocity - a.LinearVelocity;
        float vn = (speed.X * n.X) + (speed.Y * n.Y)
            + (b.AngularVelocity * ((rB.X * n.Y) - (rB.Y * n.X))) - (a.AngularVelocity * ((rA.X * n.Y) - (rA.Y * n.X)));
        Vector2 pull = (Pull(input, record.BodyB) - Pull(input, record.BodyA)) * input.Dt;
        vn += Math.Min(0, (pull.X * n.X) + (pull.Y * n.Y));
        return point.Separation + (vn * input.Dt) <= 0;
    }

    private static Vector2 Pull(in ContactUpdateInput input, int body) =>
        input.Moves[body] != 0 && (input.Bodies.Flags[body] & BodyFlags.IgnoreGravity) == 0 ? input.Settings.Gravity : Vector2.Zero;
}
