using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>What is known of the gaps of eight pairs that had no points when last looked at, in the order of the idle list.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct IdleBundle
{
    public const int Lanes = WideLanes.BundleLanes;

    public fixed int PieceA[Lanes];
    public fixed int PieceB[Lanes];

    /// <summary>Less than what separates the pieces along the axis that did so when they were looked at.</summary>
    public fixed float Gap[Lanes];

    /// <summary>By how much, at most, a turn of either body by a radian makes the gap less.</summary>
    public fixed float ArmA[Lanes];
    public fixed float ArmB[Lanes];
}

/// <summary>
/// Passes over pairs of which the narrow phase would find again that they have no points. It keeps, for each, a number below the
/// separation along the axis that it found, takes from it what both bodies have moved towards each other since, and looks again only when
/// the rest is no longer more than the margin of contacts. What falls together does not come nearer, so only relative ways count.
/// </summary>
/// <remarks>
/// Of a body's edge with normal n and of the other hull's vertices v, s = min n·(x + v) - const separates the two, x being the way between
/// the centres. A way of length d takes at most d from it, a turn of the other by b at most b·r, if no vertex is farther than r from its
/// centre, and a turn of the edge by a moves the other in its frame by at most a·(|x| + r). The largest of all edges' separations, which
/// the kernels compare with the margin, is at least that of this one. Two circles have no edge, and each turn counts with its own r.
/// What <see cref="FastPairs"/> would look after along the way cannot meet either if the gap is more than both may move.
/// </remarks>
internal static unsafe class IdleGap
{
    /// <summary>
    /// Kept from the gap, in distances of the farthest points and in extents: the kernels' rounding, and the hair by which bodies at one
    /// place are parted.
    /// </summary>
    private const float RoundingShare = 1e-5f;
    private const float HairShare = 5e-4f;

    /// <summary>
    /// Taken from the gap in each step for the rounding of the subtraction, which would lose the smallest motions: four units of the last
    /// place.
    /// </summary>
    private const float Loss = 4.8e-7f;

    /// <summary>The margin is worked out from like numbers in another order.</summary>
    private const float MarginRounding = 1.00001f;

    /// <summary>Gives a pair a place, of whose gap nothing is known.</summary>
    public static void Name(IdleBundle* all, int place, in ContactRecord record)
    {
        IdleBundle* idle = all + (place / IdleBundle.Lanes);
        int lane = place % IdleBundle.Lanes;
        idle->PieceA[lane] = record.PieceA;
        idle->PieceB[lane] = record.PieceB;
        idle->Gap[lane] = PairLanes.UnknownGap;
        idle->ArmA[lane] = 0;
        idle->ArmB[lane] = 0;
    }

    /// <summary>Moves what is known of a pair from one place to another.</summary>
    public static void Move(IdleBundle* all, int from, int to)
    {
        // A bundle is columns of lanes, each four bytes an entry.
        int* source = (int*)(all + (from / IdleBundle.Lanes)) + (from % IdleBundle.Lanes);
        int* target = (int*)(all + (to / IdleBundle.Lanes)) + (to % IdleBundle.Lanes);
        for (int entry = 0; entry < sizeof(IdleBundle) / sizeof(int); entry += IdleBundle.Lanes)
        {
            target[entry] = source[entry];
        }
    }

    /// <summary>Takes the motions of the last step from the gaps of eight pairs.</summary>
    /// <param name="idle">The pairs.</param>
    /// <param name="bodyA">Their bodies.</param>
    /// <param name="bodyB">Likewise.</param>
    /// <param name="steps">Motions, by body.</param>
    /// <param name="pull">Way by which gravity may add to a motion in the step.</param>
    /// <param name="newBoxes">Lanes (a bit each) of which one has new boxes.</param>
    /// <returns>Lanes that must be looked at.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static int Pass(IdleBundle* idle, int* bodyA, int* bodyB, BodyStep* steps, float pull, out int newBoxes)
    {
        int look = 0;
        newBoxes = 0;
        for (int lane = 0; lane < IdleBundle.Lanes; lane += Wide.Count)
        {
            BodyLanes.Gather((float*)steps, bodyA + lane, (float*)steps, bodyB + lane, out FourColumns a, out FourColumns b);
            Wide armA = Wide.Load(idle->ArmA + lane);
            Wide armB = Wide.Load(idle->ArmB + lane);
            Wide gap = Wide.Load(idle->Gap + lane);
            gap = gap - (Wide.Abs(gap) * Wide.Splat(Loss))
                - (Wide.Abs(b.A - a.A) + Wide.Abs(b.B - a.B) + (a.C * armA) + (b.C * armB));
            gap.Store(idle->Gap + lane);
            Wide flags = a.D | b.D;
            newBoxes |= WideLanes.Bits(WideLanes.Has(flags, (int)BodyStepFlags.NewBox)) << lane;
            BodyLanes.Gather((float*)steps + 4, bodyA + lane, (float*)steps + 4, bodyB + lane, out a, out b);
            Wide margin = Wide.Abs(b.A - a.A) + Wide.Abs(b.B - a.B) + (a.C * armA) + (b.C * armB) + Wide.Splat(pull);

            // Those beside a fast body have points from farther off; what comes near to a fast body wakes, wherever it goes.
            Wide ahead = Wide.Max(Wide.Abs(a.A) + Wide.Abs(a.B), Wide.Abs(b.A) + Wide.Abs(b.B));
            margin = margin + Wide.Keep(WideLanes.Has(flags, (int)BodyStepFlags.Fast), ahead);
            WideMask apart = gap > margin * Wide.Splat(MarginRounding);
            WideMask unforeseen = WideLanes.Has(flags, (int)BodyStepFlags.Altered)
                | WideLanes.Has(flags, (int)(BodyStepFlags.Fast | BodyStepFlags.Asleep));
            look |= WideLanes.Bits(~apart | unforeseen) << lane;
        }

        return look;
    }

    /// <summary>
    /// Notes the gaps of pairs that have just been looked at; of those with points or with a listener nothing is to be known.
    /// </summary>
    /// <param name="pairs">What the kernels found.</param>
    /// <param name="all">All idle pairs.</param>
    /// <param name="places">Places of these in the idle list.</param>
    /// <param name="count">How many lanes have a pair.</param>
    public static void Note(PairLanes* pairs, IdleBundle* all, int* places, int count)
    {
        float* found = stackalloc float[3 * PairLanes.Lanes];
        Find(pairs, found);
        for (int lane = 0; lane < count; lane++)
        {
            IdleBundle* idle = all + (places[lane] / IdleBundle.Lanes);
            int at = places[lane] % IdleBundle.Lanes;
            idle->Gap[at] = found[lane];
            idle->ArmA[at] = found[lane + PairLanes.Lanes];
            idle->ArmB[at] = found[lane + (2 * PairLanes.Lanes)];
        }
    }

    [MethodImpl(KernelMethod.Optimized)]
    private static void Find(PairLanes* pairs, float* found)
    {
        for (int lane = 0; lane < PairLanes.Lanes; lane += Wide.Count)
        {
            Wide way = Wide.Abs(Wide.Load(pairs->OffsetX + lane)) + Wide.Abs(Wide.Load(pairs->OffsetY + lane));
            Wide reachA = Wide.Load(pairs->A.Reach + lane);
            Wide reachB = Wide.Load(pairs->B.Reach + lane);
            Wide owner = Wide.Load(pairs->GapOwner + lane);
            Wide gap = Wide.Load(pairs->Gap + lane);
            Wide extent = Wide.Min(Wide.Load(pairs->A.Extent + lane), Wide.Load(pairs->B.Extent + lane));
            Wide less = (Wide.Splat(PairStage.SkinShare + HairShare) * extent) + (Wide.Splat(RoundingShare) * (way + reachA + reachB));
            Wide flags = Wide.Load((float*)pairs->A.Flags + lane) | Wide.Load((float*)pairs->B.Flags + lane);
            WideMask unknown = (Wide.Load(pairs->Count + lane) > Wide.Zero) | WideLanes.Has(flags, (int)SideFlags.Heard);
            Wide.Select(unknown, Wide.Splat(PairLanes.UnknownGap), gap - less).Store(found + lane);

            // The way between the centres may itself become longer, by less than the gap.
            Wide across = way + Wide.Max(gap, Wide.Zero);
            Wide armA = Wide.Select(owner < Wide.Zero, Wide.Max(across + reachB, reachA), reachA);
            Wide armB = Wide.Select(owner > Wide.Zero, Wide.Max(across + reachA, reachB), reachB);
            armA.Store(found + PairLanes.Lanes + lane);
            armB.Store(found + (2 * PairLanes.Lanes) + lane);
        }
    }
}
