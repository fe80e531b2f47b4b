using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// What the narrow phase does with the pairs of a bundle before and after it finds their manifolds: gathers the sides, sees whether the
/// surfaces touch. The pairs are named by the first columns of the bundle.
/// </summary>
internal static unsafe class PairStage
{
    /// <summary>
    /// Points this share of the smaller extent apart are kept although they cannot touch in this step: a box that rocks by a
    /// hair keeps both points and their impulses.
    /// </summary>
    public const float SkinShare = 0.02f;

    /// <summary>
    /// A pair that would sink into each other by this share of the smaller extent within the step is struck: what touches it must be ready
    /// to be struck on. A smaller blow leaves an overlap of a few percent in the worst case.
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
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            BodyPose* poses = input.Bodies.Pose.Pointer;
            if (Wide.Count <= MatrixTurn.MostLanes)
            {
                BodyTurning.StoreOffsets(poses, row->BodyA + lane, row->BodyB + lane, pairs->OffsetX + lane, pairs->OffsetY + lane);
            }

            BodyLanes.GatherRecords(sides, row->PieceA + lane, (float*)&pairs->A + lane);
            BodyLanes.GatherRecords(sides, row->PieceB + lane, (float*)&pairs->B + lane);
            Wide x;
            Wide y;
            if (Wide.Count <= MatrixTurn.MostLanes)
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
                CoincidentPairs.Part(pairs, row->BodyA, row->BodyB, lane, coincident);
            }

            bits.Exists |= exists << lane;
            WideLanes.Bits(
                AreSolid(both, any),
                WideLanes.Has(any, (int)SideFlags.Heard),
                WideLanes.Has(both, (int)SideFlags.Box),
                WideLanes.Has(both, (int)SideFlags.Circle),
                out int solid,
                out int heard,
                out int boxes,
                out int circles);
            bits.Solid |= solid << lane;
            bits.Heard |= heard << lane;
            bits.Boxes |= boxes << lane;
            bits.Circles |= circles << lane;
            bits.Hulls |= WideLanes.Bits(WideLanes.Has(both, (int)SideFlags.Hull)) << lane;
            WideMask circleFirst = WideLanes.Has(flagsA, (int)SideFlags.Circle) & WideLanes.Has(flagsB, (int)SideFlags.Hull);
            WideMask circleSecond = WideLanes.Has(flagsB, (int)SideFlags.Circle) & WideLanes.Has(flagsA, (int)SideFlags.Hull);
            bits.CircleFirst |= WideLanes.Bits(circleFirst) << lane;
            WideLanes.Bits(
                circleFirst | circleSecond,
                WideLanes.Has(any, (int)SideFlags.Tilted),
                WideLanes.Has(any, (int)SideFlags.NewBox),
                WideLanes.Has(any, (int)SideFlags.Fast),
                out int circleHulls,
                out int tilted,
                out int newBox,
                out int fast);
            bits.CircleHulls |= circleHulls << lane;
            bits.Tilted |= tilted << lane;
            bits.NewBox |= newBox << lane;
            bits.Fast |= fast << lane;
        }

        return bits;
    }

    /// <summary>
    /// Finds the arms of all points, and which pairs touch: those with a point that overlaps or will, with the present velocities
    /// and gravity, within the step. A pair that touched goes on touching up to a small gap, so that the tremor of
    /// an impact is not a row of separations. Pairs that are apart may meet in the step if they close by more than such a gap, or if they
    /// keep points beyond the skin and their motion is as long.
    /// </summary>
    public static TouchBits Touch(in ContactUpdateInput input, ContactBundle* row)
    {
        PairLanes* pairs = input.Pairs;
        TouchBits bits = default;
        Wide gravityX = Wide.Splat(input.Settings.Gravity.X);
        Wide gravityY = Wide.Splat(input.Settings.Gravity.Y);
        Wide dt = Wide.Splat(input.Dt);
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
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
            Wide extent = Wide.Min(Wide.Load(a->Extent + lane), Wide.Load(b->Extent + lane));
            Wide moving = Wide.Select(
                WideLanes.Has(flagsA, (int)SideFlags.Moves),
                Wide.Select(WideLanes.Has(flagsB, (int)SideFlags.Moves), extent, Wide.Load(a->Extent + lane)),
                Wide.Load(b->Extent + lane));
            Wide reach = Wide.Keep(before, Wide.Splat(FastPairs.TouchShare) * moving);
            Wide count = Wide.Load(pairs->Count + lane);
            WideMask touch0 = TouchPoint(pairs, &pairs->Point0, lane, speed, gain, reach, dt, out Wide sunk0);
            WideMask touch1 = TouchPoint(pairs, &pairs->Point1, lane, speed, gain, reach, dt, out Wide sunk1);
            WideMask any = count > Wide.Zero;
            WideMask second = count > Wide.One;
            WideMask touch = any & (touch0 | (second & touch1));
            Wide sunk = Wide.Max(sunk0, Wide.Keep(second, sunk1));
            sunk.Store(pairs->Sinking + lane);
            WideMask blow = touch & (sunk > (Wide.Splat(BlowShare) * extent));
            bits.Blows |= WideLanes.Bits(blow) << lane;
            Wide gap = Wide.Min(
                Wide.Load(pairs->Point0.Separation + lane),
                Wide.Select(second, Wide.Load(pairs->Point1.Separation + lane), Wide.Splat(float.MaxValue)));
            WideMask open = any & (gap > Wide.Zero);
            Wide skin = Wide.Splat(SkinShare) * extent;
            WideMask nears = (sunk > (Wide.Splat(FastPairs.TouchShare) * extent))
                | ((gap > skin) & (gap <= (Wide.Load(pairs->Margin + lane) - skin)));
            bits.Ahead |= WideLanes.Bits(open & nears) << lane;
            WideMask solid = AreSolid(flagsA & flagsB, flagsA | flagsB);
            Wide now =
                Wide.Keep(touch, Wide.FromBits((int)ContactFlags.Touching)) | Wide.Keep(solid, Wide.FromBits((int)ContactFlags.Solid));
            bits.Touching |= WideLanes.Bits(touch) << lane;
            bits.Touched |= WideLanes.Bits(before) << lane;
            bits.Hit |= WideLanes.Bits(any) << lane;
            bits.Same |= WideLanes.Bits(Wide.SameBits(old, now)) << lane;
        }

        return bits;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask TouchPoint(
        PairLanes* pairs, PointLanes* point, int lane, Wide speed, Wide gain, Wide reach, Wide dt, out Wide sunk)
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

    /// <summary>
    /// Pairs that push: <paramref name="both"/> and <paramref name="any"/> are what the flags of their sides share and have.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask AreSolid(Wide both, Wide any) =>
        WideLanes.Has(both, (int)SideFlags.Responds) & WideLanes.Has(any, (int)SideFlags.Moves);
}
