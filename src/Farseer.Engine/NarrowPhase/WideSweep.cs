using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.NarrowPhase;

/// <summary>What <see cref="WideSweep"/> says of a bundle's pairs, a bit for each lane.</summary>
internal struct SweepBits
{
    /// <summary>One piece passes the other by more than its own size in the step.</summary>
    public int Fast;

    /// <summary>They may meet on their ways.</summary>
    public int Meets;

    /// <summary>Contacts can move both.</summary>
    public int BothMove;
}

/// <summary>
/// A cheap look at where the pairs of a bundle will go in the step: whether one piece moves fast as the other sees it, and whether
/// the two can meet at all. Separating axes of two boxes of which one is swept along the straight relative way of their centres;
/// what turning and gravity add to that is a width around both.
/// </summary>
internal static unsafe class WideSweep
{
    /// <summary>A pair is fast if its relative motion is more than this share of the extent of what moves.</summary>
    private const float FastShare = 1f;

    /// <summary>Of the extents: far above the rounding of the sums below, far below anything that matters.</summary>
    private const float Slack = 1e-3f;

    /// <param name="pairs">Sides and offsets.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="pull">Most that gravity adds to a speed within the step.</param>
    [MethodImpl(KernelMethod.Optimized)]
    public static SweepBits Look(PairLanes* pairs, float dt, float pull)
    {
        SweepBits bits = default;
        for (int lane = 0; lane < PairLanes.Lanes; lane += Wide.Count)
        {
            Look(pairs, lane, Wide.Splat(dt), Wide.Splat(pull), out WideMask fast, out WideMask apart);
            bits.Fast |= WideLanes.Bits(fast) << lane;
            bits.Meets |= WideLanes.Bits(~apart) << lane;
            Wide both = Wide.Load((float*)pairs->A.Flags + lane) & Wide.Load((float*)pairs->B.Flags + lane);
            bits.BothMove |= WideLanes.Bits(WideLanes.Has(both, (int)SideFlags.Moves)) << lane;
        }

        return bits;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Look(PairLanes* pairs, int lane, Wide dt, Wide pull, out WideMask fast, out WideMask apart)
    {
        Side a = new Side(&pairs->A, lane, dt);
        Side b = new Side(&pairs->B, lane, dt);
        Wide dx = b.VelocityX - a.VelocityX;
        Wide dy = b.VelocityY - a.VelocityY;
        Wide fall = pull * dt;
        Wide motion = Wide.Abs(dx) + Wide.Abs(dy) + a.Turn * a.Reach + b.Turn * b.Reach + fall;
        Wide extent = Wide.Min(a.Extent, b.Extent);
        fast = motion > Wide.Splat(FastShare) * extent;

        // From centre to centre of the pieces, whose speeds have a part from turning.
        Wide offX = Wide.Load(pairs->OffsetX + lane) + b.X - a.X;
        Wide offY = Wide.Load(pairs->OffsetY + lane) + b.Y - a.Y;
        dx = dx - (b.Angle * b.Y) + (a.Angle * a.Y);
        dy = dy + (b.Angle * b.X) - (a.Angle * a.X);
        Wide width = a.Width + b.Width + fall + (Wide.Splat(Slack) * extent);

        Wide cos = Wide.Abs((a.Cos * b.Cos) + (a.Sin * b.Sin));
        Wide sin = Wide.Abs((a.Cos * b.Sin) - (a.Sin * b.Cos));
        apart = Apart(a.Cos, a.Sin, offX, offY, dx, dy, width + a.HalfX + (cos * b.HalfX) + (sin * b.HalfY))
            | Apart(Wide.Zero - a.Sin, a.Cos, offX, offY, dx, dy, width + a.HalfY + (sin * b.HalfX) + (cos * b.HalfY))
            | Apart(b.Cos, b.Sin, offX, offY, dx, dy, width + b.HalfX + (cos * a.HalfX) + (sin * a.HalfY))
            | Apart(Wide.Zero - b.Sin, b.Cos, offX, offY, dx, dy, width + b.HalfY + (sin * a.HalfX) + (cos * a.HalfY));

        // Across the way. The length of the axis may be overestimated: |dx| + |dy|.
        Wide across = Wide.Abs((offX * dy) - (offY * dx));
        Wide half = (a.HalfX * Wide.Abs((a.Cos * dy) - (a.Sin * dx))) + (a.HalfY * Wide.Abs((a.Sin * dy) + (a.Cos * dx)))
            + (b.HalfX * Wide.Abs((b.Cos * dy) - (b.Sin * dx))) + (b.HalfY * Wide.Abs((b.Sin * dy) + (b.Cos * dx)));
        apart = apart | (across > half + (width * (Wide.Abs(dx) + Wide.Abs(dy))));
    }

    /// <summary>Whether the way from one offset to the other stays on one side of the axis, farther out than the sum of the halves.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask Apart(Wide nx, Wide ny, Wide x, Wide y, Wide dx, Wide dy, Wide halves)
    {
        Wide start = (nx * x) + (ny * y);
        Wide end = start + (nx * dx) + (ny * dy);
        return (Wide.Min(start, end) > halves) | (Wide.Max(start, end) < Wide.Zero - halves);
    }

    /// <summary>A piece as a box, or as the circle around it; motions and turns are those of the step.</summary>
    private readonly struct Side
    {
        public readonly Wide X;
        public readonly Wide Y;
        public readonly Wide Cos;
        public readonly Wide Sin;
        public readonly Wide HalfX;
        public readonly Wide HalfY;
        public readonly Wide VelocityX;
        public readonly Wide VelocityY;
        public readonly Wide Angle;
        public readonly Wide Turn;
        public readonly Wide Reach;

        /// <summary>Of what a contact or the flight can move; of the rest it does not count.</summary>
        public readonly Wide Extent;

        /// <summary>Rounding, and how far turning may take a point off the straight way of the centre.</summary>
        public readonly Wide Width;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Side(SideLanes* side, int lane, Wide dt)
        {
            Wide flags = Wide.Load((float*)side->Flags + lane);
            WideMask turns = WideLanes.Has(flags, (int)SideFlags.Turns);
            WideMask box = WideLanes.Has(flags, (int)SideFlags.Box);
            Reach = Wide.Load(side->Reach + lane);
            X = Wide.Load(side->X + lane);
            Y = Wide.Load(side->Y + lane);
            Cos = Wide.Select(box, Wide.Load(side->Cos + lane), Wide.One);
            Sin = Wide.Keep(box, Wide.Load(side->Sin + lane));
            Wide halfX = Wide.Load(side->HalfX + lane);
            Wide halfY = Wide.Load(side->HalfY + lane);
            HalfX = Wide.Keep(box, halfX);
            HalfY = Wide.Keep(box, halfY);

            // A static body that has a velocity does not move by it: it drags along what touches it.
            VelocityX = Wide.Keep(turns, Wide.Load(side->VelocityX + lane)) * dt;
            VelocityY = Wide.Keep(turns, Wide.Load(side->VelocityY + lane)) * dt;
            Angle = Wide.Keep(turns, Wide.Load(side->AngularVelocity + lane)) * dt;
            Turn = Wide.Abs(Angle);
            Extent = Wide.Select(WideLanes.Has(flags, (int)SideFlags.Moves), Wide.Load(side->Extent + lane), Wide.Splat(float.MaxValue));

            // The points turn about the piece's centre, and that about the body's: off its tangent by half the square of the turn.
            WideMask circle = WideLanes.Has(flags, (int)SideFlags.Circle);
            Wide round = Wide.Select(box, Wide.Zero, halfY);
            Wide own = Wide.Select(circle, Wide.Zero, Wide.Select(box, halfX + halfY, halfY)) * Turn;
            Wide bend = (Wide.Abs(X) + Wide.Abs(Y)) * Turn * Turn * Wide.Splat(0.5f);
            Width = round + own + bend;
        }
    }
}
