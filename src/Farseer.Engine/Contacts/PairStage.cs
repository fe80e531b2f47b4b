using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Contacts;

/// <summary>What the sides of a bundle's pairs are, a bit for each lane.</summary>
internal struct PairBits
{
    public int Exists;

    /// <summary>Gives impulses: both colliders respond and at least one body can move.</summary>
    public int Solid;
    public int Heard;
    public int Boxes;
    public int Circles;

    /// <summary>Two hulls that lanes can do, boxes included.</summary>
    public int Hulls;

    /// <summary>Such a hull and a circle, and those whose circle is A.</summary>
    public int CircleHulls;
    public int CircleFirst;

    /// <summary>One of the sides is a box whose own axes are not those of its body.</summary>
    public int Tilted;
    public int NewBox;

    /// <summary>A body of the pair is fast.</summary>
    public int Fast;
}

/// <summary>What the manifolds of a bundle's pairs say, a bit for each lane.</summary>
internal struct TouchBits
{
    public int Touching;

    /// <summary>Touched in the step before.</summary>
    public int Touched;

    /// <summary>Has points.</summary>
    public int Hit;

    /// <summary>The flags of an unheard pair are what they were.</summary>
    public int Same;

    /// <summary>Touches and would sink in by more than <see cref="PairStage.BlowShare"/>: it will be struck.</summary>
    public int Blows;
}

/// <summary>
/// The narrow phase of eight pairs side by side: gather the sides, find the manifolds, see whether the surfaces touch. The pairs
/// are named by the first columns of a bundle.
/// </summary>
internal static unsafe class PairStage
{
    /// <summary>
    /// Points this share of the smaller extent apart are kept although they cannot touch in this step: a box that rocks by a
    /// hair keeps both points and their impulses.
    /// </summary>
    public const float SkinShare = 0.02f;

    /// <summary>
    /// A pair that would sink into each other by this share of the smaller extent within the step is struck: what touches it must be ready to
    /// be struck on. A smaller blow leaves an overlap of a few percent in the worst case.
    /// </summary>
    public const float BlowShare = 0.25f;

    /// <summary>Gathers both sides of each pair, their bodies' offset, and the distance from which on points are kept.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static PairBits Load(in ContactUpdateInput input, ContactBundle* row)
    {
        PairLanes* pairs = input.Pairs;
        float* sides = (float*)input.Sides;
        PairBits bits = default;
        Wide pull = Wide.Splat((System.Math.Abs(input.Settings.Gravity.X) + System.Math.Abs(input.Settings.Gravity.Y)) * input.Dt);
        Wide dt = Wide.Splat(input.Dt);
        for (int lane = 0; lane < PairLanes.Lanes; lane += Wide.Count)
        {
            BodyPose* poses = input.Bodies.Pose.Pointer;
            if (MatrixTurn.IsUsed)
            {
                BodyLanes.StoreOffsets(poses, row->BodyA + lane, row->BodyB + lane, pairs->OffsetX + lane, pairs->OffsetY + lane);
            }

            BodyLanes.GatherRecords(sides, row->PieceA + lane, (float*)&pairs->A + lane);
            BodyLanes.GatherRecords(sides, row->PieceB + lane, (float*)&pairs->B + lane);
            Wide x;
            Wide y;
            if (MatrixTurn.IsUsed)
            {
                x = Wide.Load(pairs->OffsetX + lane);
                y = Wide.Load(pairs->OffsetY + lane);
            }
            else
            {
                BodyLanes.GatherOffset(poses, row->BodyA + lane, row->BodyB + lane, out x, out y);
                x.Store(pairs->OffsetX + lane);
                y.Store(pairs->OffsetY + lane);
            }

            Wide.Zero.Store(pairs->NormalOwner + lane);
            Wide.Splat(PairLanes.UnknownGap).Store(pairs->Gap + lane);
            Wide.Zero.Store(pairs->Point0.Owner + lane);
            Wide.Zero.Store(pairs->Point1.Owner + lane);

            Wide speedX = Wide.Load(pairs->B.VelocityX + lane) - Wide.Load(pairs->A.VelocityX + lane);
            Wide speedY = Wide.Load(pairs->B.VelocityY + lane) - Wide.Load(pairs->A.VelocityY + lane);
            Wide motion = Wide.Abs(speedX) + Wide.Abs(speedY)
                + (Wide.Abs(Wide.Load(pairs->A.AngularVelocity + lane)) * Wide.Load(pairs->A.Reach + lane))
                + (Wide.Abs(Wide.Load(pairs->B.AngularVelocity + lane)) * Wide.Load(pairs->B.Reach + lane))
                + pull;
            Wide size = Wide.Min(Wide.Load(pairs->A.Extent + lane), Wide.Load(pairs->B.Extent + lane));
            ((motion * dt) + (Wide.Splat(SkinShare) * size)).Store(pairs->Margin + lane);

            Wide flagsA = Wide.Load((float*)pairs->A.Flags + lane);
            Wide flagsB = Wide.Load((float*)pairs->B.Flags + lane);
            Wide both = flagsA & flagsB;
            Wide any = flagsA | flagsB;
            int exists = WideLanes.Bits(WideLanes.Has(both, (int)SideFlags.Exists));
            int coincident = exists & WideLanes.Bits((Wide.Abs(x) + Wide.Abs(y)) <= Wide.Zero);
            if (coincident != 0)
            {
                CoincidentPairs.Part(pairs, row, lane, coincident);
            }

            bits.Exists |= exists << lane;
            Note(
                lane,
                AreSolid(both, any),
                WideLanes.Has(any, (int)SideFlags.Heard),
                WideLanes.Has(both, (int)SideFlags.Box),
                WideLanes.Has(both, (int)SideFlags.Circle),
                ref bits.Solid,
                ref bits.Heard,
                ref bits.Boxes,
                ref bits.Circles);
            bits.Hulls |= WideLanes.Bits(WideLanes.Has(both, (int)SideFlags.Hull)) << lane;
            WideMask circleFirst = WideLanes.Has(flagsA, (int)SideFlags.Circle) & WideLanes.Has(flagsB, (int)SideFlags.Hull);
            WideMask circleSecond = WideLanes.Has(flagsB, (int)SideFlags.Circle) & WideLanes.Has(flagsA, (int)SideFlags.Hull);
            bits.CircleFirst |= WideLanes.Bits(circleFirst) << lane;
            Note(
                lane,
                circleFirst | circleSecond,
                WideLanes.Has(any, (int)SideFlags.Tilted),
                WideLanes.Has(any, (int)SideFlags.NewBox),
                WideLanes.Has(any, (int)SideFlags.Fast),
                ref bits.CircleHulls,
                ref bits.Tilted,
                ref bits.NewBox,
                ref bits.Fast);
        }

        return bits;
    }

    /// <summary>Keeps points as far apart as the blows of this step may throw the bodies of each pair.</summary>
    public static void Widen(in ContactUpdateInput input, ContactBundle* row)
    {
        if (input.Throws == null)
        {
            return;
        }

        for (int lane = 0; lane < PairLanes.Lanes; lane++)
        {
            if (row->Contact[lane] >= 0)
            {
                input.Pairs->Margin[lane] += input.Throws[row->BodyA[lane]] + input.Throws[row->BodyB[lane]];
            }
        }
    }

    /// <summary>Finds the manifolds of all lanes.</summary>
    public static void Collide(in ContactUpdateInput input, ContactBundle* row, in PairBits bits)
    {
        int left = bits.Exists;
        int hulls = bits.Hulls & left;
        if ((bits.Boxes & left) != 0)
        {
            int corners = WideBoxBox.Collide(input.Pairs);
            left &= ~bits.Boxes | corners;
            hulls &= left;
        }

        if ((bits.Circles & left) != 0)
        {
            WideCircleCircle.Collide(input.Pairs);
            left &= ~bits.Circles;
        }

        if (hulls != 0)
        {
            NameHulls(input, row, &input.Pairs->Hulls.A, hulls, 0, bits.Tilted);
            NameHulls(input, row, &input.Pairs->Hulls.B, hulls, hulls, bits.Tilted);
            WideConvex.Collide(input.Pairs, hulls, input.Shapes.Vertices.Pointer, input.Shapes.Normals.Pointer);
            left &= ~hulls;
        }

        int circleHulls = bits.CircleHulls & left;
        if (circleHulls != 0)
        {
            NameHulls(input, row, &input.Pairs->Hulls.A, circleHulls, bits.CircleFirst, bits.Tilted);
            WideCircleHull.Collide(
                input.Pairs, circleHulls, bits.CircleFirst, input.Shapes.Vertices.Pointer, input.Shapes.Normals.Pointer);
            left &= ~circleHulls;
        }

        for (int lane = 0; left != 0; lane++, left >>= 1)
        {
            if ((left & 1) != 0)
            {
                CollideLane(input, row, lane);
            }
        }
    }

    /// <summary>
    /// Finds the arms of all points, and which pairs touch: those with a point that overlaps or will, with the present velocities
    /// and gravity, within the step. A pair that touched goes on touching up to a gap of the depth of rest, so that the tremor of
    /// an impact is not a row of separations.
    /// </summary>
    public static TouchBits Touch(in ContactUpdateInput input, ContactBundle* row)
    {
        PairLanes* pairs = input.Pairs;
        TouchBits bits = default;
        Wide gravityX = Wide.Splat(input.Settings.Gravity.X);
        Wide gravityY = Wide.Splat(input.Settings.Gravity.Y);
        Wide dt = Wide.Splat(input.Dt);
        Wide rest = Wide.Splat(input.Settings.AllowedPenetration);
        for (int lane = 0; lane < PairLanes.Lanes; lane += Wide.Count)
        {
            SideLanes* a = &pairs->A;
            SideLanes* b = &pairs->B;
            Wide flagsA = Wide.Load((float*)a->Flags + lane);
            Wide flagsB = Wide.Load((float*)b->Flags + lane);
            WideMask pulledA = WideLanes.Has(flagsA, (int)SideFlags.Pulled);
            WideMask pulledB = WideLanes.Has(flagsB, (int)SideFlags.Pulled);
            Wide pullX = (Wide.Keep(pulledB, gravityX) - Wide.Keep(pulledA, gravityX)) * dt;
            Wide pullY = (Wide.Keep(pulledB, gravityY) - Wide.Keep(pulledA, gravityY)) * dt;
            Wide nx = Wide.Load(pairs->NormalX + lane);
            Wide ny = Wide.Load(pairs->NormalY + lane);
            Wide speed = ((Wide.Load(b->VelocityX + lane) - Wide.Load(a->VelocityX + lane)) * nx)
                + ((Wide.Load(b->VelocityY + lane) - Wide.Load(a->VelocityY + lane)) * ny);
            Wide gain = Wide.Min((pullX * nx) + (pullY * ny), Wide.Zero);
            Wide old = Wide.Load((float*)row->Flags + lane) & Wide.FromBits(ContactBundle.FlagBits);
            WideMask before = WideLanes.Has(old, (int)ContactFlags.Touching);
            Wide reach = Wide.Keep(before, rest);
            Wide count = Wide.Load(pairs->Count + lane);
            WideMask touch0 = TouchPoint(pairs, &pairs->Point0, lane, speed, gain, reach, dt, out Wide sunk0);
            WideMask touch1 = TouchPoint(pairs, &pairs->Point1, lane, speed, gain, reach, dt, out Wide sunk1);
            WideMask any = count > Wide.Zero;
            WideMask second = count > Wide.One;
            WideMask touch = any & (touch0 | (second & touch1));
            Wide sunk = Wide.Max(sunk0, Wide.Keep(second, sunk1));
            sunk.Store(pairs->Sinking + lane);
            Wide size = Wide.Min(Wide.Load(a->Extent + lane), Wide.Load(b->Extent + lane));
            WideMask blow = touch & (sunk > (Wide.Splat(BlowShare) * size));
            bits.Blows |= WideLanes.Bits(blow) << lane;
            WideMask solid = AreSolid(flagsA & flagsB, flagsA | flagsB);
            Wide now = Wide.Keep(touch, Wide.FromBits((int)ContactFlags.Touching)) | Wide.Keep(solid, Wide.FromBits((int)ContactFlags.Solid));
            bits.Touching |= WideLanes.Bits(touch) << lane;
            bits.Touched |= WideLanes.Bits(before) << lane;
            bits.Hit |= WideLanes.Bits(any) << lane;
            bits.Same |= WideLanes.Bits(Wide.SameBits(old, now)) << lane;
        }

        return bits;
    }

    /// <summary>
    /// Whether a pair with points, whose arms <see cref="Touch"/> has found, overlaps or will within <paramref name="time"/>.
    /// </summary>
    public static bool WillTouch(in ContactUpdateInput input, int lane, float reach, float time)
    {
        PairLanes* pairs = input.Pairs;
        Vector2 n = new Vector2(pairs->NormalX[lane], pairs->NormalY[lane]);
        Vector2 pull = Vector2.Zero;
        pull += (pairs->B.Flags[lane] & (int)SideFlags.Pulled) != 0 ? input.Settings.Gravity : Vector2.Zero;
        pull -= (pairs->A.Flags[lane] & (int)SideFlags.Pulled) != 0 ? input.Settings.Gravity : Vector2.Zero;
        float speed = ((pairs->B.VelocityX[lane] - pairs->A.VelocityX[lane]) * n.X)
            + ((pairs->B.VelocityY[lane] - pairs->A.VelocityY[lane]) * n.Y)
            + (System.Math.Min(0, (pull.X * n.X) + (pull.Y * n.Y)) * time);
        return WillTouch(pairs, &pairs->Point0, lane, speed, reach, time)
            || (pairs->Count[lane] > 1 && WillTouch(pairs, &pairs->Point1, lane, speed, reach, time));
    }

    private static bool WillTouch(PairLanes* pairs, PointLanes* point, int lane, float speed, float reach, float time)
    {
        float closing = speed + (pairs->B.AngularVelocity[lane] * point->TangentArmB[lane])
            - (pairs->A.AngularVelocity[lane] * point->TangentArmA[lane]);
        return point->Separation[lane] <= reach || point->Separation[lane] + (closing * time) <= 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask TouchPoint(PairLanes* pairs, PointLanes* point, int lane, Wide speed, Wide gain, Wide reach, Wide dt, out Wide sunk)
    {
        Wide nx = Wide.Load(pairs->NormalX + lane);
        Wide ny = Wide.Load(pairs->NormalY + lane);
        Wide x = Wide.Load(point->X + lane);
        Wide y = Wide.Load(point->Y + lane);
        Wide armA = (x * ny) - (y * nx);
        ((x * nx) + (y * ny)).Store(point->NormalArmA + lane);
        armA.Store(point->TangentArmA + lane);
        x = x - Wide.Load(pairs->OffsetX + lane);
        y = y - Wide.Load(pairs->OffsetY + lane);
        Wide armB = (x * ny) - (y * nx);
        ((x * nx) + (y * ny)).Store(point->NormalArmB + lane);
        armB.Store(point->TangentArmB + lane);
        Wide closing = speed + (Wide.Load(pairs->B.AngularVelocity + lane) * armB) - (Wide.Load(pairs->A.AngularVelocity + lane) * armA);
        Wide separation = Wide.Load(point->Separation + lane);
        sunk = Wide.Zero - (Wide.Max(separation, Wide.Zero) + (closing * dt));
        return (separation <= reach) | (separation + ((closing + gain) * dt) <= Wide.Zero);
    }

    /// <summary>Adds the bits of four masks to those of the lanes before.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Note(
        int lane, WideMask a, WideMask b, WideMask c, WideMask d, ref int bitsA, ref int bitsB, ref int bitsC, ref int bitsD)
    {
        WideLanes.Bits(a, b, c, d, out int laneA, out int laneB, out int laneC, out int laneD);
        bitsA |= laneA << lane;
        bitsB |= laneB << lane;
        bitsC |= laneC << lane;
        bitsD |= laneD << lane;
    }

    /// <summary>Pairs that push: <paramref name="both"/> and <paramref name="any"/> are what the flags of their sides share and have.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask AreSolid(Wide both, Wide any) =>
        WideLanes.Has(both, (int)SideFlags.Responds) & WideLanes.Has(any, (int)SideFlags.Moves);

    /// <summary>Names the hulls of some lanes: those of B where a bit of <paramref name="ofB"/> is set, elsewhere those of A.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    private static void NameHulls(in ContactUpdateInput input, ContactBundle* row, HullLanes* hulls, int lanes, int ofB, int tilted)
    {
        PairLanes* pairs = input.Pairs;
        int* pieces = stackalloc int[PairLanes.Lanes];
        for (int lane = 0; lane < PairLanes.Lanes; lane += Wide.Count)
        {
            WideMask b = WideLanes.Mask(ofB >> lane);
            Wide.Select(b, Wide.Load((float*)row->PieceB + lane), Wide.Load((float*)row->PieceA + lane)).Store((float*)pieces + lane);
            Wide.Select(b, Wide.Load(pairs->B.Cos + lane), Wide.Load(pairs->A.Cos + lane)).Store(hulls->Cos + lane);
            Wide.Select(b, Wide.Load(pairs->B.Sin + lane), Wide.Load(pairs->A.Sin + lane)).Store(hulls->Sin + lane);
        }

        HullLanes.Name(hulls, lanes, pieces, input.Hulls);

        // The side of a box has the box's own axis, a hull turns with its body.
        tilted &= lanes;
        for (int lane = 0; tilted != 0; lane++, tilted >>= 1)
        {
            if ((tilted & 1) != 0)
            {
                BodyPose* pose = input.Bodies.Pose.Pointer + (((ofB >> lane) & 1) != 0 ? row->BodyB[lane] : row->BodyA[lane]);
                hulls->Cos[lane] = pose->Cos;
                hulls->Sin[lane] = pose->Sin;
            }
        }
    }

    private static void CollideLane(in ContactUpdateInput input, ContactBundle* row, int lane)
    {
        PairInput pair;
        pair.Vertices = input.Shapes.Vertices.Pointer;
        pair.Normals = input.Shapes.Normals.Pointer;
        pair.OutlineBefore = input.Shapes.OutlineBefore.Pointer;
        pair.OutlineAfter = input.Shapes.OutlineAfter.Pointer;
        pair.PieceA = input.Shapes.Pieces.Pointer + row->PieceA[lane];
        pair.PieceB = input.Shapes.Pieces.Pointer + row->PieceB[lane];
        BodyPose* poseA = input.Bodies.Pose.Pointer + row->BodyA[lane];
        BodyPose* poseB = input.Bodies.Pose.Pointer + row->BodyB[lane];
        pair.RotationA = new Rotation(poseA->Cos, poseA->Sin);
        pair.RotationB = new Rotation(poseB->Cos, poseB->Sin);
        pair.Offset = new Vector2(input.Pairs->OffsetX[lane], input.Pairs->OffsetY[lane]);
        pair.Margin = input.Pairs->Margin[lane];
        Collision.Collide(pair, out Manifold manifold);
        PairLanes.Write(input.Pairs, lane, manifold);
    }
}
