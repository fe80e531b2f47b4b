using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

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

    /// <summary>Adds those of pairs beside these.</summary>
    /// <param name="beside">What they do.</param>
    /// <param name="lane">The lane of the first of them.</param>
    public void AddBeside(in SweepBits beside, int lane)
    {
        Fast |= beside.Fast << lane;
        Meets |= beside.Meets << lane;
        BothMove |= beside.BothMove << lane;
    }
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

    /// <summary>
    /// Gap in extents up to which two that fly side by side are kept from running into each other. A wider one has room for a third
    /// body, which would be met first.
    /// </summary>
    private const float RoomShare = 1f;

    /// <summary>
    /// Sets the margins of the pairs with a fast body. Those that cannot meet need no points. Those that fly side by side need them from
    /// farther off: if something stops one of them, the other runs into it within the step.
    /// </summary>
    /// <param name="pairs">Sides, offsets and margins.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="pull">Most that gravity adds to a speed within the step.</param>
    /// <param name="skinShare">Share of the smaller extent up to which a gap is a contact.</param>
    [MethodImpl(KernelMethod.Optimized)]
    public static SweepBits Look(PairLanes* pairs, float dt, float pull, float skinShare)
    {
        SweepBits bits = default;
        Wide fall = Wide.Splat(pull) * Wide.Splat(dt);
        for (int lane = 0; lane < PairLanes.Lanes; lane += Wide.Count)
        {
            Wide flagsA = Wide.Load((float*)pairs->A.Flags + lane);
            Wide flagsB = Wide.Load((float*)pairs->B.Flags + lane);
            Side a = new Side(&pairs->A, lane, flagsA, Wide.Splat(dt));
            Side b = new Side(&pairs->B, lane, flagsB, Wide.Splat(dt));
            Wide extent = Wide.Min(a.Extent, b.Extent);
            Wide x = Wide.Load(pairs->OffsetX + lane) + b.X - a.X;
            Wide y = Wide.Load(pairs->OffsetY + lane) + b.Y - a.Y;
            Wide aX = a.VelocityX - (a.Angle * a.Y);
            Wide aY = a.VelocityY + (a.Angle * a.X);
            Wide bX = b.VelocityX - (b.Angle * b.Y);
            Wide bY = b.VelocityY + (b.Angle * b.X);
            Halves halves = new Halves(a, b, a.Width + b.Width + fall + (Wide.Splat(skinShare) * extent));
            WideMask apart = Apart(a, b, halves, x, y, bX - aX, bY - aY);
            WideMask alone = apart & Apart(a, b, halves, x, y, bX, bY) & Apart(a, b, halves, x, y, Wide.Zero - aX, Wide.Zero - aY);

            Wide motion = Wide.Abs(b.VelocityX - a.VelocityX) + Wide.Abs(b.VelocityY - a.VelocityY)
                + (a.Turn * a.Reach) + (b.Turn * b.Reach) + fall;
            WideMask fast = motion > Wide.Splat(FastShare) * extent;
            WideMask flagged = WideLanes.Has(flagsA | flagsB, (int)SideFlags.Fast);
            WideMask both = WideLanes.Has(flagsA & flagsB, (int)SideFlags.Moves);
            WideMask beside = flagged & both & ~fast;
            Wide way = Wide.Max(Wide.Abs(a.VelocityX) + Wide.Abs(a.VelocityY), Wide.Abs(b.VelocityX) + Wide.Abs(b.VelocityY));
            Wide margin = Wide.Load(pairs->Margin + lane);
            margin = Wide.Select(beside, margin + Wide.Min(way, Wide.Splat(RoomShare) * extent), margin);
            margin = Wide.Select((beside & alone) | (flagged & fast & apart), Wide.Splat(float.MinValue), margin);
            margin.Store(pairs->Margin + lane);
            bits.Fast |= WideLanes.Bits(fast) << lane;
            bits.Meets |= WideLanes.Bits(~apart) << lane;
            bits.BothMove |= WideLanes.Bits(both) << lane;
        }

        return bits;
    }

    /// <summary>Whether the two stay apart when B's centre goes from an offset along a way as A sees it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask Apart(in Side a, in Side b, in Halves halves, Wide x, Wide y, Wide dx, Wide dy)
    {
        WideMask apart = Apart(a.Cos, a.Sin, x, y, dx, dy, halves.AX)
            | Apart(Wide.Zero - a.Sin, a.Cos, x, y, dx, dy, halves.AY)
            | Apart(b.Cos, b.Sin, x, y, dx, dy, halves.BX)
            | Apart(Wide.Zero - b.Sin, b.Cos, x, y, dx, dy, halves.BY);

        // Across the way. The length of the axis may be overestimated: |dx| + |dy|.
        Wide across = Wide.Abs((x * dy) - (y * dx));
        Wide half = (a.HalfX * Wide.Abs((a.Cos * dy) - (a.Sin * dx))) + (a.HalfY * Wide.Abs((a.Sin * dy) + (a.Cos * dx)))
            + (b.HalfX * Wide.Abs((b.Cos * dy) - (b.Sin * dx))) + (b.HalfY * Wide.Abs((b.Sin * dy) + (b.Cos * dx)));
        return apart | (across > half + (halves.Width * (Wide.Abs(dx) + Wide.Abs(dy))));
    }

    /// <summary>
    /// Whether the way from one offset to the other stays on one side of the axis, farther out than the sum of the halves.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask Apart(Wide nx, Wide ny, Wide x, Wide y, Wide dx, Wide dy, Wide halves)
    {
        Wide start = (nx * x) + (ny * y);
        Wide end = start + (nx * dx) + (ny * dy);
        return (Wide.Min(start, end) > halves) | (Wide.Max(start, end) < Wide.Zero - halves);
    }

    /// <summary>Sums of the half sides along the axes of A and of B, and what is around both.</summary>
    private readonly struct Halves
    {
        public readonly Wide AX;
        public readonly Wide AY;
        public readonly Wide BX;
        public readonly Wide BY;
        public readonly Wide Width;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Halves(in Side a, in Side b, Wide width)
        {
            Wide cos = Wide.Abs((a.Cos * b.Cos) + (a.Sin * b.Sin));
            Wide sin = Wide.Abs((a.Cos * b.Sin) - (a.Sin * b.Cos));
            AX = width + a.HalfX + (cos * b.HalfX) + (sin * b.HalfY);
            AY = width + a.HalfY + (sin * b.HalfX) + (cos * b.HalfY);
            BX = width + b.HalfX + (cos * a.HalfX) + (sin * a.HalfY);
            BY = width + b.HalfY + (sin * a.HalfX) + (cos * a.HalfY);
            Width = width;
        }
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
        public Side(SideLanes* side, int lane, Wide flags, Wide dt)
        {
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
