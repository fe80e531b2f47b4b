using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// The passes of a substep over the contacts of a colour, on lanes. Both points of a contact are solved together as a 2×2
/// complementarity problem: solving them in turn gives a small one-sided torque each pass and tall stacks rock (stack of 40:
/// 166 mm instead of 35). Friction acts in the relax pass only: in the biased pass its bound contains the push-out impulse
/// and large pyramids shake for ever.
/// </summary>
internal static unsafe class ContactKernel
{
    /// <summary>
    /// 1/mass times this is the response of the corners of two boxes of that mass: of equal bodies the bound takes nothing.
    /// </summary>
    private const float MobilityOfPair = 5f;

    /// <summary>
    /// Applies the impulses of the substep before, extrapolated by a third of their change (a free momentum term for the
    /// block solver), friction kept within its cone.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void WarmStart<TScatter, TPoints>(in BundleList rows, BodyState* bodies, in ContactCoefficients c)
        where TScatter : struct, IVelocityScatter
        where TPoints : struct, IContactPoints
    {
        if (Wide.Count <= MatrixTurn.MostLanes)
        {
            WarmStartTurned<TScatter, TPoints>(rows, bodies, c);
            return;
        }

        bool two = default(TPoints).AreTwo;
        Wide fall = Wide.Splat(c.Gravity * c.Substep);
        for (int i = 0; i < rows.Count; i++)
        {
            rows.AskForStart(rows.Bundles + i, bodies, two);
            ContactBundle* row = rows.Bundles[i];
            int fresh = 0;
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherVelocities(bodies, row->BodyA + lane, row->BodyB + lane, out WideVelocity a, out WideVelocity b);
                fresh |= WideLanes.Bits(ApplyStart<TPoints>(row, lane, c, fall, ref a, ref b)) << lane;
                StoreVelocities<TScatter>(row, lane, bodies, a, b);
            }

            rows.Fresh[i] = (ushort)fresh;
        }
    }

    [MethodImpl(KernelMethod.Optimized)]
    private static void WarmStartTurned<TScatter, TPoints>(in BundleList rows, BodyState* bodies, in ContactCoefficients c)
        where TScatter : struct, IVelocityScatter
        where TPoints : struct, IContactPoints
    {
        Wide fall = Wide.Splat(c.Gravity * c.Substep);
        byte* memory = stackalloc byte[ContactWork.Bytes];
        ContactWork* work = ContactWork.In(memory);
        for (int done = 0; done < rows.Count; done += rows.Stride)
        {
            ContactBundle** some = rows.Bundles + done;
            int count = Math.Min(rows.Stride, rows.Count - done);
            for (int i = 0; i < count; i++)
            {
                BodyTurning.TurnVelocities(bodies, some[i]->BodyA, work[i].VelocityAX);
                BodyTurning.TurnVelocities(bodies, some[i]->BodyB, work[i].VelocityBX);
            }

            for (int i = 0; i < count; i++)
            {
                ContactBundle* row = some[i];
                int fresh = 0;
                for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
                {
                    ContactWork.Take(work + i, lane, out WideVelocity a, out WideVelocity b);
                    fresh |= WideLanes.Bits(ApplyStart<TPoints>(row, lane, c, fall, ref a, ref b)) << lane;
                    StoreVelocities<TScatter>(row, lane, bodies, a, b);
                }

                rows.Fresh[done + i] = (ushort)fresh;
            }
        }
    }

    /// <returns>The lanes that did not push before.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static WideMask ApplyStart<TPoints>(
        ContactBundle* row, int lane, in ContactCoefficients c, Wide fall, ref WideVelocity a, ref WideVelocity b)
        where TPoints : struct, IContactPoints
    {
        bool two = default(TPoints).AreTwo;
        Wide friction = Wide.Load(row->Friction + lane);
        Wide weight0 = fall * (Wide.One / Wide.Load(row->K11 + lane));
        Wide before = Extrapolate(&row->Point0, lane, c, friction, weight0, out Wide normal0, out Wide tangent0);
        Wide normal1 = Wide.Zero;
        Wide tangent1 = Wide.Zero;
        if (two)
        {
            Wide weight1 = fall * (Wide.One / Wide.Load(row->K22 + lane));
            before = before + Extrapolate(&row->Point1, lane, c, friction, weight1, out normal1, out tangent1);
        }

        ApplyNormal(row, lane, ref a, ref b, normal0, normal1, two);
        ApplyTangent(row, lane, ref a, ref b, tangent0, tangent1, two);
        return before <= Wide.Zero;
    }

    /// <summary>
    /// The biased pass: normal impulses that also remove overlap, softly. With φ in place of 0 as the value towards which the
    /// impulse leaks, the static sag is a tenth of the plain soft contact's. The surfaces hold from the moment they touch and
    /// sink from there, slowly, to the depth of rest. Contacts of deep islands are solved hard here;
    /// their overlap goes in <see cref="PushOut"/>.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void SolveBiased<TScatter, TPoints>(in BundleList rows, BodyState* bodies, in ContactCoefficients c, bool anyDeep)
        where TScatter : struct, IVelocityScatter
        where TPoints : struct, IContactPoints
    {
        byte* memory = stackalloc byte[ContactWork.Bytes];
        ContactWork* work = ContactWork.In(memory);
        for (int done = 0; done < rows.Count; done += rows.Stride)
        {
            ContactBundle** some = rows.Bundles + done;
            int count = Math.Min(rows.Stride, rows.Count - done);
            ContactStages.AimBiased<TPoints>(rows, some, count, work, bodies, c, anyDeep);

            // Who pushes for long has a feed-forward: only others may be struck, and are asked further.
            ulong blows = ContactStages.Push<TPoints>(some, rows.Fresh + done, count, work, onlyUnfed: true, feed: false);
            if (blows != 0)
            {
                blows = BlowKernel.Strike(some, count, work, bodies, blows);
            }

            ContactStages.Give<TScatter, TPoints>(some, count, work, bodies, blows);
        }
    }

    /// <summary>
    /// Moves the contacts of deep islands apart. The velocities found here move the bodies and are then forgotten, and so are
    /// the impulses, so that a deep overlap never becomes speed.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void PushOut<TScatter, TPoints>(in BundleList rows, BodyState* bodies, in ContactCoefficients c, float recoveryRate)
        where TScatter : struct, IVelocityScatter
        where TPoints : struct, IContactPoints
    {
        byte* memory = stackalloc byte[ContactWork.Bytes];
        ContactWork* work = ContactWork.In(memory);
        for (int done = 0; done < rows.Count;)
        {
            ContactBundle** some = rows.Bundles + done;
            int count = CountDeep(some, Math.Min(rows.Stride, rows.Count - done));
            if (count > 0)
            {
                ContactStages.AimApart<TPoints>(rows, some, count, work, bodies, c, recoveryRate);
                ContactStages.PushApart<TPoints>(some, count, work);
                ContactStages.Give<TScatter, TPoints>(some, count, work, bodies, blows: 0);
            }

            done += Math.Max(count, 1);
        }
    }

    /// <summary>
    /// Speed per load of a point at which the heavier of two bodies that move may sink: the response of a light one under it is far more,
    /// and at that pace the heavy one would come down faster than the light one can stop. A body on what cannot move has no such bound.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Wide Mobility(ContactBundle* row, int lane)
    {
        Wide lesser = Wide.Min(Wide.Load(row->MassA + lane), Wide.Load(row->MassB + lane));
        return Wide.Select(lesser > Wide.Zero, Wide.Splat(MobilityOfPair) * lesser, Wide.Splat(ContactBundle.NoPoint));
    }

    /// <summary>How many bundles from the first on have a contact of a deep island.</summary>
    private static int CountDeep(ContactBundle** some, int most)
    {
        for (int i = 0; i < most; i++)
        {
            if (ContactBundle.LanesWith(some[i], ContactBundle.DeepMark) == 0)
            {
                return i;
            }
        }

        return most;
    }

    /// <summary>
    /// The relax pass at the new positions: the same block without bias and softness, so that no push-out velocity is left,
    /// then friction within the cone of the true normal impulses unless <paramref name="rub"/> is false, then the feed-forward follows.
    /// Before it does, in the <paramref name="first"/> sweep, it tells who pushes for long.
    /// Two points at almost the same gap count as level: an impact that begins here would turn their rounding over the substep
    /// into spin. (To leave every open surface to the next substep cured that as well, but cost a tipping box 9e-4 rad/s.)
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Relax<TScatter, TPoints>(in BundleList rows, BodyState* bodies, in ContactCoefficients c, bool rub, bool first)
        where TScatter : struct, IVelocityScatter
        where TPoints : struct, IContactPoints
    {
        byte* memory = stackalloc byte[ContactWork.Bytes];
        ContactWork* work = ContactWork.In(memory);
        for (int done = 0; done < rows.Count; done += rows.Stride)
        {
            ContactBundle** some = rows.Bundles + done;
            int count = Math.Min(rows.Stride, rows.Count - done);
            ContactStages.AimRelaxed<TPoints>(rows, some, count, work, bodies, c);

            // After impacts the rows that bounced are fresh as well.
            ulong blows = ContactStages.Push<TPoints>(some, first ? rows.Fresh + done : null, count, work, onlyUnfed: first, feed: true);
            if (blows != 0)
            {
                blows = BlowKernel.Strike(some, count, work, bodies, blows);
            }

            if (rub)
            {
                ContactStages.Rub<TPoints>(some, count, work, blows);
                if (blows != 0)
                {
                    BlowKernel.Rub(some, count, work, bodies, blows);
                }

                ContactStages.GiveRubbed<TScatter, TPoints>(some, count, work, bodies, blows);
            }
            else
            {
                ContactStages.Give<TScatter, TPoints>(some, count, work, bodies, blows);
            }
        }
    }

    /// <summary>Gives the bodies their new velocities.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void StoreVelocities<TScatter>(ContactBundle* row, int lane, BodyState* bodies, in WideVelocity a, in WideVelocity b)
        where TScatter : struct, IVelocityScatter
    {
        default(TScatter).Scatter(bodies, row->BodyA + lane, a, row->MassA + lane, row->InertiaA + lane);
        default(TScatter).Scatter(bodies, row->BodyB + lane, b, row->MassB + lane, row->InertiaB + lane);
    }

    /// <returns>What the point pushed with before, as it is kept.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Extrapolate(
        ContactPointLanes* p, int lane, in ContactCoefficients c, Wide friction, Wide weight, out Wide normal, out Wide tangent)
    {
        Wide share = Wide.Splat(ContactCoefficients.Extrapolation);
        Wide oldNormal = Wide.Load(p->Normal + lane);
        Wide oldTangent = Wide.Load(p->Tangent + lane);
        Wide previous = Wide.Load(p->PreviousNormal + lane);
        Wide previousTangent = Wide.Load(p->PreviousTangent + lane);
        Wide most = Wide.Splat(ContactCoefficients.LargestGrowth) * (previous + weight);
        WideMask impact = oldNormal > most;
        Wide change = oldNormal - previous;
        change = Wide.Min(Wide.Splat(c.RiseTaken) * change, Wide.Splat(c.FallTaken) * change);
        normal = Wide.Select(impact, previous, Wide.Max(oldNormal + change, Wide.Zero));
        tangent = Wide.Select(impact, previousTangent, oldTangent + (share * (oldTangent - previousTangent)));
        Wide bound = friction * normal;
        tangent = Wide.Max(Wide.Min(tangent, bound), Wide.Zero - bound);
        Wide kept = Wide.Min(oldNormal, Wide.Max(most, Wide.Splat(c.LeastKept)));
        kept.Store(p->PreviousNormal + lane);
        Wide.Select(impact, tangent, oldTangent).Store(p->PreviousTangent + lane);
        normal.Store(p->Normal + lane);
        tangent.Store(p->Tangent + lane);
        return kept;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void GatherSeparations(ContactBundle* row, int lane, BodyState* bodies, out Wide s0, out Wide s1, bool two = true)
    {
        BodyLanes.GatherDeltas(bodies, row->BodyA + lane, row->BodyB + lane, out WideDelta a, out WideDelta b);
        Separations(row, lane, a, b, out s0, out s1, two);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Separations(
        ContactBundle* row, int lane, in WideDelta a, in WideDelta b, out Wide s0, out Wide s1, bool two = true)
    {
        Wide moved = MovedAlong(row, lane, a, b);
        s0 = PointSeparation(&row->Point0, lane, a, b, moved, out _, out _);
        s1 = two ? PointSeparation(&row->Point1, lane, a, b, moved, out _, out _) : Wide.Zero;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Wide MovedAlong(ContactBundle* row, int lane, in WideDelta a, in WideDelta b) =>
        (Wide.Load(row->NormalX + lane) * (b.X - a.X)) + (Wide.Load(row->NormalY + lane) * (b.Y - a.Y));

    /// <summary>The separation of a point, and its turned normal arms, which friction turns the bodies with.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Wide PointSeparation(
        ContactPointLanes* p, int lane, in WideDelta a, in WideDelta b, Wide moved, out Wide turnedA, out Wide turnedB)
    {
        TurnedArms.Normal(p, lane, a, b, out turnedA, out turnedB);
        return (Wide.Load(p->Base + lane) + moved) + (turnedB - turnedA);
    }

    /// <summary>How fast the bodies part along the normal, without their spins.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Wide VelocityAlong(ContactBundle* row, int lane, in WideVelocity a, in WideVelocity b) =>
        (Wide.Load(row->NormalX + lane) * (b.X - a.X)) + (Wide.Load(row->NormalY + lane) * (b.Y - a.Y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void NormalVelocities(
        ContactBundle* row, int lane, in WideVelocity a, in WideVelocity b, out Wide v0, out Wide v1, bool two = true)
    {
        Wide un = VelocityAlong(row, lane, a, b);
        v0 = un + ((b.W * Wide.Load(row->Point0.TangentArmB + lane)) - (a.W * Wide.Load(row->Point0.TangentArmA + lane)));
        v1 = two ? un + ((b.W * Wide.Load(row->Point1.TangentArmB + lane)) - (a.W * Wide.Load(row->Point1.TangentArmA + lane))) : Wide.Zero;
    }

    /// <summary>
    /// By how much the spins change a separation: with s = s0 + cos a N + sin a T for a turn a, the arm of the spin is cos a T - sin a N.
    /// With the arms of the middle of the step instead, a body that tips over ends each step with the velocity of half a step
    /// before, off by w² r dt / 2, and its contact lifts and drops within the step. The impulses keep the arms of the
    /// middle: that K and the arms agree is what makes the block solve exact, and over a step the mean of the arms is what counts
    /// (for a blow see <see cref="BlowKernel"/>). How far they may be turned: see <see cref="TurnedArms"/>.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Wide TurnedSpin(ContactPointLanes* p, int lane, Wide spinA, Wide spinB, in WideDelta movedA, in WideDelta movedB)
    {
        Wide armA = (movedA.Cos * Wide.Load(p->TangentArmA + lane)) - (movedA.Sin * Wide.Load(p->NormalArmA + lane));
        Wide armB = (movedB.Cos * Wide.Load(p->TangentArmB + lane)) - (movedB.Sin * Wide.Load(p->NormalArmB + lane));
        return (spinB * armB) - (spinA * armA);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void ApplyNormal(
        ContactBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, Wide p0, Wide p1, bool two = true)
    {
        Wide sum = p0 + p1;
        Wide px = Wide.Load(row->NormalX + lane) * sum;
        Wide py = Wide.Load(row->NormalY + lane) * sum;
        Wide massA = Wide.Load(row->MassA + lane);
        Wide massB = Wide.Load(row->MassB + lane);
        a.X = a.X - (massA * px);
        a.Y = a.Y - (massA * py);
        b.X = b.X + (massB * px);
        b.Y = b.Y + (massB * py);
        Wide secondA = two ? Wide.Load(row->Point1.TangentArmA + lane) * p1 : Wide.Zero;
        Wide secondB = two ? Wide.Load(row->Point1.TangentArmB + lane) * p1 : Wide.Zero;
        a.W = a.W - (Wide.Load(row->InertiaA + lane) * ((Wide.Load(row->Point0.TangentArmA + lane) * p0) + secondA));
        b.W = b.W + (Wide.Load(row->InertiaB + lane) * ((Wide.Load(row->Point0.TangentArmB + lane) * p0) + secondB));
    }

    // t = (ny, -nx), and r×t = -an.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void ApplyTangent(
        ContactBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, Wide p0, Wide p1, bool two = true)
    {
        Wide sum = p0 + p1;
        Wide px = Wide.Load(row->NormalY + lane) * sum;
        Wide py = Wide.Zero - (Wide.Load(row->NormalX + lane) * sum);
        Wide massA = Wide.Load(row->MassA + lane);
        Wide massB = Wide.Load(row->MassB + lane);
        a.X = a.X - (massA * px);
        a.Y = a.Y - (massA * py);
        b.X = b.X + (massB * px);
        b.Y = b.Y + (massB * py);
        Wide secondA = two ? Wide.Load(row->Point1.NormalArmA + lane) * p1 : Wide.Zero;
        Wide secondB = two ? Wide.Load(row->Point1.NormalArmB + lane) * p1 : Wide.Zero;
        a.W = a.W + (Wide.Load(row->InertiaA + lane)
            * ((Wide.Load(row->Point0.NormalArmA + lane) * p0) + secondA + (Wide.Load(row->RadiusA + lane) * sum)));
        b.W = b.W - (Wide.Load(row->InertiaB + lane)
            * ((Wide.Load(row->Point0.NormalArmB + lane) * p0) + secondB - (Wide.Load(row->RadiusB + lane) * sum)));
    }

    /// <summary>
    /// How fast one point is pushed along its normal by an impulse at the other, k12 = mA + mB + iA·atA1·atA2 + iB·atB1·atB2.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide NormalCoupling(ContactBundle* row, int lane) =>
        Wide.Load(row->MassA + lane) + Wide.Load(row->MassB + lane)
            + (Wide.Load(row->InertiaA + lane) * Wide.Load(row->Point0.TangentArmA + lane) * Wide.Load(row->Point1.TangentArmA + lane))
            + (Wide.Load(row->InertiaB + lane) * Wide.Load(row->Point0.TangentArmB + lane) * Wide.Load(row->Point1.TangentArmB + lane));

    /// <summary>Finds x ≥ 0 with w = k11(x - λ) + r ≥ 0 and x·w = 0: the block of a contact with one point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Wide SolvePoint(ContactBundle* row, int lane, Wide lambda, Wide r)
    {
        Wide k11 = Wide.Load(row->K11 + lane);
        Wide b = r - (k11 * lambda);
        return Wide.Max((Wide.Zero - b) * (Wide.One / k11), Wide.Zero);
    }

    /// <summary>
    /// Finds x ≥ 0 with w = K(x - λ) + r ≥ 0 and x·w = 0. Written with b = r - Kλ, the four cases are: both points push,
    /// only the first, only the second, none; all are computed and the valid one selected, so there is no branch. Where the
    /// points nearly coincide the rows are solved in turn. What the block is divided by is found anew each time: a division while others
    /// wait for memory costs less than another column that is read.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void SolveBlock(
        ContactBundle* row, int lane, Wide lambda0, Wide lambda1, Wide r0, Wide r1, out Wide x0, out Wide x1)
    {
        Wide k11 = Wide.Load(row->K11 + lane);
        Wide k22 = Wide.Load(row->K22 + lane);
        WideMask block = ContactBundle.Has(row, lane, ContactBundle.BlockMark);
        var responses = new PointResponses(k11, k22, NormalCoupling(row, lane), block);
        SolveResponses(responses, lambda0, lambda1, r0, r1, out x0, out x1);
    }

    /// <summary>The same for given responses.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void SolveResponses(
        in PointResponses responses, Wide lambda0, Wide lambda1, Wide r0, Wide r1, out Wide x0, out Wide x1)
    {
        Wide k11 = responses.K11;
        Wide k22 = responses.K22;
        Wide k12 = responses.K12;
        Wide inverse11 = Wide.One / k11;
        Wide inverse22 = Wide.One / k22;
        Wide inverse = Wide.One / ((k11 * k22) - (k12 * k12));
        Wide zero = Wide.Zero;
        Wide b0 = r0 - ((k11 * lambda0) + (k12 * lambda1));
        Wide b1 = r1 - ((k12 * lambda0) + (k22 * lambda1));

        Wide both0 = inverse * ((k12 * b1) - (k22 * b0));
        Wide both1 = inverse * ((k12 * b0) - (k11 * b1));
        Wide only0 = Wide.Max((zero - b0) * inverse11, zero);
        Wide only1 = Wide.Max((zero - b1) * inverse22, zero);

        // Row by row from the present impulses; also what stands where rounding leaves no case exactly valid.
        Wide turn0 = Wide.Max((zero - (b0 + (k12 * lambda1))) * inverse11, zero);
        Wide turn1 = Wide.Max((zero - (b1 + (k12 * turn0))) * inverse22, zero);

        WideMask second = (b0 + (k12 * only1)) >= zero;
        WideMask first = (b1 + (k12 * only0)) >= zero;
        WideMask none = (b0 >= zero) & (b1 >= zero);
        WideMask pair = (both0 >= zero) & (both1 >= zero);
        x0 = Wide.Select(second, zero, turn0);
        x1 = Wide.Select(second, only1, turn1);
        x0 = Wide.Select(first, only0, x0);
        x1 = Wide.Select(first, zero, x1);
        x0 = Wide.Select(none, zero, x0);
        x1 = Wide.Select(none, zero, x1);
        x0 = Wide.Select(pair, both0, x0);
        x1 = Wide.Select(pair, both1, x1);
        x0 = Wide.Select(responses.Block, x0, turn0);
        x1 = Wide.Select(responses.Block, x1, turn1);
    }
}

/// <summary>How fast the two points of a contact are pushed along the normal by impulses there: the matrix K.</summary>
internal readonly struct PointResponses
{
    public readonly Wide K11;
    public readonly Wide K22;
    public readonly Wide K12;

    /// <summary>The lanes that are solved as a block; the others are solved row by row.</summary>
    public readonly WideMask Block;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public PointResponses(Wide k11, Wide k22, Wide k12, WideMask block)
    {
        K11 = k11;
        K22 = k22;
        K12 = k12;
        Block = block;
    }
}
