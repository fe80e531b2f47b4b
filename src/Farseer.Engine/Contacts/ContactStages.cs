using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// The stages of the biased and the relax pass. A bundle is one long chain, gather – separations – block – friction – scatter, of some 160
/// cycles and 600 instructions. A processor looks ahead some 150 results, so it never saw the next bundle and waited. Now up to
/// <see cref="ContactWork.MostBundles"/> bundles go through each stage before the next: a stage is short enough for several of them to be
/// under way at once. What stages hand on stays in the nearest cache. No bit changes, for rows of a colour share no body.
/// </summary>
internal static unsafe class ContactStages
{
    /// <summary>
    /// Velocities, and what the biased pass is to make 0. Few bodies turn so far that it is to be found again with limited arms.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void AimBiased<TPoints>(
        in BundleList rows, ContactBundle** some, int count, ContactWork* work, BodyState* bodies, in ContactCoefficients c, bool anyDeep)
        where TPoints : struct, IContactPoints
    {
        if (c.AnyFar || AimBiased<TPoints, WholeTurns>(rows, some, count, work, bodies, c, anyDeep))
        {
            AimBiased<TPoints, LimitedTurns>(rows, some, count, work, bodies, c, anyDeep);
        }
    }

    /// <returns>Some bodies have turned beyond the limit, and it was not kept.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    private static bool AimBiased<TPoints, TTurns>(
        in BundleList rows, ContactBundle** some, int count, ContactWork* work, BodyState* bodies, in ContactCoefficients c, bool anyDeep)
        where TPoints : struct, IContactPoints
        where TTurns : struct, IArmTurns
    {
        Wide least = Wide.One;
        bool two = default(TPoints).AreTwo;
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        Wide biasRate = Wide.Splat(c.BiasRate * c.MassScale);
        Wide massScale = Wide.Splat(c.MassScale);
        Wide leak = Wide.Splat(c.ImpulseScale);
        Wide settleRate = Wide.Splat(c.BiasRate);
        Wide settleShare = Wide.Splat(c.SettleShare);
        ContactWork* end = work + count;
        ContactMoved* moved = Turn(some, count, work, bodies);
        for (; work < end; work++, some++, moved++)
        {
            rows.AskForBiased(some, bodies, two);
            ContactBundle* row = *some;
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                Gather(row, lane, work, moved, bodies, out WideDelta movedA, out WideDelta movedB);
                ContactKernel.Separations(row, lane, movedA, movedB, out Wide s0, out Wide s1, two);

                // What is put down and read again leaves registers to the rest: with sixteen of them, 69 instructions of 508 went to the
                // stack, now 28 of 455.
                s0.Store(work->Value0 + lane);
                if (two)
                {
                    s1.Store(work->Value1 + lane);
                }

                LimitTurns<TTurns>(row, lane, ref movedA, ref movedB, ref least);
                ContactWork.Take(work, lane, out WideVelocity a, out WideVelocity b);
                Wide speed = ContactKernel.VelocityAlong(row, lane, a, b);
                Wide v0 = speed + ContactKernel.TurnedSpin(&row->Point0, lane, a.W, b.W, movedA, movedB);
                Wide v1 = two ? speed + ContactKernel.TurnedSpin(&row->Point1, lane, a.W, b.W, movedA, movedB) : Wide.Zero;
                s0 = Wide.Load(work->Value0 + lane);
                s1 = two ? Wide.Load(work->Value1 + lane) : Wide.Zero;
                Wide lambda0 = Wide.Load(row->Point0.Normal + lane);
                Wide lambda1 = two ? Wide.Load(row->Point1.Normal + lane) : Wide.Zero;
                Wide rest = ContactBundle.RestDepth(row, lane);
                Wide gap0 = s0 - rest;
                Wide gap1 = s1 - rest;
                WideMask apart0 = gap0 > Wide.Zero;
                WideMask apart1 = gap1 > Wide.Zero;
                Wide load = lambda0;
                Wide sink = lambda0 * Wide.Load(row->K11 + lane);
                if (two)
                {
                    WideMask single = ContactBundle.Has(row, lane, ContactBundle.SingleMark);
                    load = Wide.Select(single, load, Wide.Min(lambda0, lambda1));
                    sink = Wide.Select(single, sink, Wide.Min(sink, lambda1 * Wide.Load(row->K22 + lane)));
                }

                sink = settleShare * Wide.Min(sink, load * ContactKernel.Mobility(row, lane));
                Wide slowly = Wide.Min(settleRate * rest, sink);
                Wide closing0 = (gap0 * inverseSubstep) + slowly;
                Wide closing1 = (gap1 * inverseSubstep) + slowly;
                if (anyDeep)
                {
                    WideMask deep = ContactBundle.Has(row, lane, ContactBundle.DeepMark);
                    closing0 = Wide.Select(deep, Wide.Max(gap0, Wide.Zero) * inverseSubstep, closing0);
                    closing1 = Wide.Select(deep, Wide.Max(gap1, Wide.Zero) * inverseSubstep, closing1);
                    apart0 = apart0 | deep;
                    apart1 = apart1 | deep;
                }

                Wide soft0 = (massScale * v0) + Wide.Min(biasRate * s0, sink)
                    + (Wide.Load(row->K11 + lane) * leak * (lambda0 - Wide.Load(row->Point0.Feed + lane)));
                Wide.Select(apart0, v0 + closing0, soft0).Store(work->Value0 + lane);
                if (two)
                {
                    Wide soft1 = (massScale * v1) + Wide.Min(biasRate * s1, sink)
                        + (Wide.Load(row->K22 + lane) * leak * (lambda1 - Wide.Load(row->Point1.Feed + lane)));
                    Wide.Select(apart1, v1 + closing1, soft1).Store(work->Value1 + lane);
                }
            }
        }

        return WideLanes.Any(TurnedArms.IsBeyond(least));
    }

    /// <summary>Limits the turns, or finds the cosine of the largest; what is limited is beyond nothing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void LimitTurns<TTurns>(ContactBundle* row, int lane, ref WideDelta movedA, ref WideDelta movedB, ref Wide least)
        where TTurns : struct, IArmTurns
    {
        if (default(TTurns).AreLimited)
        {
            Wide most = FarSurfaces.LargestSine(row, lane);
            movedA = TurnedArms.Limited(movedA, most);
            movedB = TurnedArms.Limited(movedB, most);
        }

        least = Wide.Min(least, Wide.Min(movedA.Cos, movedB.Cos));
    }

    /// <summary>Velocities, turned arms, and what the relax pass is to make 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void AimRelaxed<TPoints>(
        in BundleList rows, ContactBundle** some, int count, ContactWork* work, BodyState* bodies, in ContactCoefficients c)
        where TPoints : struct, IContactPoints
    {
        if (c.AnyFar || AimRelaxed<TPoints, WholeTurns>(rows, some, count, work, bodies, c))
        {
            AimRelaxed<TPoints, LimitedTurns>(rows, some, count, work, bodies, c);
        }
    }

    /// <returns>Some bodies have turned beyond the limit, and it was not kept.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    private static bool AimRelaxed<TPoints, TTurns>(
        in BundleList rows, ContactBundle** some, int count, ContactWork* work, BodyState* bodies, in ContactCoefficients c)
        where TPoints : struct, IContactPoints
        where TTurns : struct, IArmTurns
    {
        Wide least = Wide.One;
        bool two = default(TPoints).AreTwo;
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        ContactWork* end = work + count;
        ContactMoved* moved = Turn(some, count, work, bodies);
        for (; work < end; work++, some++, moved++)
        {
            rows.AskForRelaxed(some, bodies, two);
            ContactBundle* row = *some;
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                Gather(row, lane, work, moved, bodies, out WideDelta movedA, out WideDelta movedB);
                Wide along = ContactKernel.MovedAlong(row, lane, movedA, movedB);
                Wide rest = ContactBundle.RestDepth(row, lane);
                Wide gap0 = ContactKernel.PointSeparation(&row->Point0, lane, movedA, movedB, along, out Wide armA0, out Wide armB0) - rest;
                Wide armA1 = armA0;
                Wide armB1 = armB0;
                Wide gap1 =
                    two ? ContactKernel.PointSeparation(&row->Point1, lane, movedA, movedB, along, out armA1, out armB1) - rest : gap0;
                LimitTurns<TTurns>(row, lane, ref movedA, ref movedB, ref least);
                if (default(TTurns).AreLimited)
                {
                    // Gaps go by how far the bodies have turned, friction by the arms of the velocities.
                    TurnedArms.Normal(&row->Point0, lane, movedA, movedB, out armA0, out armB0);
                    TurnedArms.Normal(&row->Point1, lane, movedA, movedB, out armA1, out armB1);
                }

                armA0.Store(work->ArmA0 + lane);
                armB0.Store(work->ArmB0 + lane);
                ContactWork.Take(work, lane, out WideVelocity a, out WideVelocity b);
                Wide speed = ContactKernel.VelocityAlong(row, lane, a, b);
                Wide v0 = speed + ContactKernel.TurnedSpin(&row->Point0, lane, a.W, b.W, movedA, movedB);
                Wide v1 = two ? speed + ContactKernel.TurnedSpin(&row->Point1, lane, a.W, b.W, movedA, movedB) : Wide.Zero;
                if (two)
                {
                    armA1.Store(work->ArmA1 + lane);
                    armB1.Store(work->ArmB1 + lane);

                    // Gaps that differ by their rounding are level: else what is left open to the next substep by one point would spin the
                    // body.
                    WideMask flat = Wide.Max(gap0 - gap1, gap1 - gap0) <= rest;
                    Wide mean = Wide.Splat(0.5f) * (gap0 + gap1);
                    gap0 = Wide.Select(flat, mean, gap0);
                    gap1 = Wide.Select(flat, mean, gap1);
                    (v1 + (Wide.Max(gap1, Wide.Zero) * inverseSubstep)).Store(work->Value1 + lane);
                }

                (v0 + (Wide.Max(gap0, Wide.Zero) * inverseSubstep)).Store(work->Value0 + lane);
            }
        }

        return WideLanes.Any(TurnedArms.IsBeyond(least));
    }

    /// <summary>Velocities, and what is to be 0 for the contacts of deep islands to move apart.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void AimApart<TPoints>(
        in BundleList rows, ContactBundle** some, int count, ContactWork* work, BodyState* bodies, in ContactCoefficients c,
        float recoveryRate)
        where TPoints : struct, IContactPoints
    {
        bool two = default(TPoints).AreTwo;
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        Wide usual = Wide.Splat(recoveryRate);
        ContactWork* end = work + count;
        ContactMoved* moved = Turn(some, count, work, bodies);
        for (; work < end; work++, some++, moved++)
        {
            rows.AskForBiased(some, bodies, two);
            ContactBundle* row = *some;
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                Gather(row, lane, work, moved, bodies, out WideDelta movedA, out WideDelta movedB);
                ContactKernel.Separations(row, lane, movedA, movedB, out Wide s0, out Wide s1, two);
                ContactWork.Take(work, lane, out WideVelocity a, out WideVelocity b);
                ContactKernel.NormalVelocities(row, lane, a, b, out Wide v0, out Wide v1, two);
                Wide rate = c.AnyFar ? usual * FarSurfaces.PushShare(row, lane) : usual;
                (v0 + (s0 * Wide.Select(s0 > Wide.Zero, inverseSubstep, rate))).Store(work->Value0 + lane);
                if (two)
                {
                    (v1 + (s1 * Wide.Select(s1 > Wide.Zero, inverseSubstep, rate))).Store(work->Value1 + lane);
                }
            }
        }
    }

    /// <summary>Solves the blocks of contacts of deep islands; the impulses are forgotten.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void PushApart<TPoints>(ContactBundle** some, int count, ContactWork* work)
        where TPoints : struct, IContactPoints
    {
        bool two = default(TPoints).AreTwo;
        for (int i = 0; i < count; i++, work++)
        {
            ContactBundle* row = some[i];
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                WideMask deep = ContactBundle.Has(row, lane, ContactBundle.DeepMark);
                Wide lambda0 = Wide.Load(row->Point0.Normal + lane);
                Wide r0 = Wide.Load(work->Value0 + lane);
                Wide x0;
                if (two)
                {
                    Wide lambda1 = Wide.Load(row->Point1.Normal + lane);
                    ContactKernel.SolveBlock(row, lane, lambda0, lambda1, r0, Wide.Load(work->Value1 + lane), out x0, out Wide x1);
                    Wide.Select(deep, x1 - lambda1, Wide.Zero).Store(work->Value1 + lane);
                }
                else
                {
                    x0 = ContactKernel.SolvePoint(row, lane, lambda0, r0);
                }

                Wide.Select(deep, x0 - lambda0, Wide.Zero).Store(work->Value0 + lane);
            }
        }
    }

    /// <summary>Solves the blocks.</summary>
    /// <param name="some">The bundles.</param>
    /// <param name="fresh">The lanes of each that did not push before; null: ask the rows.</param>
    /// <param name="count">How many.</param>
    /// <param name="work">What the stage before has left; then what the points are pushed with.</param>
    /// <param name="onlyUnfed">Who pushes for long has a feed-forward: only others may be struck.</param>
    /// <param name="feed">The feed-forward follows.</param>
    /// <returns>The bits of the vectors with a lane that may be struck.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static ulong Push<TPoints>(ContactBundle** some, ushort* fresh, int count, ContactWork* work, bool onlyUnfed, bool feed)
        where TPoints : struct, IContactPoints
    {
        bool two = default(TPoints).AreTwo;
        ulong blows = 0;
        for (int i = 0; i < count; i++, work++)
        {
            ContactBundle* row = some[i];
            int known = fresh != null ? fresh[i] : ushort.MaxValue;
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                Wide lambda0 = Wide.Load(row->Point0.Normal + lane);
                Wide r0 = Wide.Load(work->Value0 + lane);
                Wide x0;
                Wide x1 = Wide.Zero;
                Wide push1 = Wide.Zero;
                Wide feed1 = Wide.Zero;
                if (two)
                {
                    Wide lambda1 = Wide.Load(row->Point1.Normal + lane);
                    ContactKernel.SolveBlock(row, lane, lambda0, lambda1, r0, Wide.Load(work->Value1 + lane), out x0, out x1);
                    x1.Store(row->Point1.Normal + lane);
                    push1 = x1 - lambda1;
                    feed1 = Wide.Load(row->Point1.Feed + lane);
                }
                else
                {
                    x0 = ContactKernel.SolvePoint(row, lane, lambda0, r0);
                }

                x0.Store(row->Point0.Normal + lane);
                Wide push0 = x0 - lambda0;
                push0.Store(work->Value0 + lane);
                push1.Store(work->Value1 + lane);
                Wide feed0 = Wide.Load(row->Point0.Feed + lane);
                WideMask blow = (Wide.Abs(push0) + Wide.Abs(push1)) > Wide.Zero;
                if (onlyUnfed)
                {
                    blow = blow & ((feed0 + feed1) <= Wide.Zero);
                }

                // A 1 if any bit is set, without a branch that nobody can guess.
                int struck = WideLanes.Bits(blow) & (known >> lane);
                blows |= (ulong)((uint)-struck >> 31) << ContactWork.Place(i, lane);
                Wide.Keep(blow, Wide.One).Store(work->MayBlow + lane);
                if (feed)
                {
                    // Only the load common to both points is fed forward: with each point's own, random piles creep.
                    Wide load = two ? Wide.Select(ContactBundle.Has(row, lane, ContactBundle.SingleMark), x0, Wide.Min(x0, x1)) : x0;
                    Wide target = Wide.Load(row->FeedShare + lane) * load;
                    Wide rate = Wide.Load(row->FeedRate + lane);
                    Wide.Min(x0, feed0 + (rate * (target - feed0))).Store(row->Point0.Feed + lane);
                    if (two)
                    {
                        Wide.Min(x1, feed1 + (rate * (target - feed1))).Store(row->Point1.Feed + lane);
                    }
                }
            }
        }

        return blows;
    }

    /// <summary>Gives the bodies what they were pushed with.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Give<TScatter, TPoints>(ContactBundle** some, int count, ContactWork* work, BodyState* bodies, ulong blows)
        where TScatter : struct, IVelocityScatter
        where TPoints : struct, IContactPoints
    {
        bool two = default(TPoints).AreTwo;
        for (int i = 0; i < count; i++, work++)
        {
            ContactBundle* row = some[i];
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                TakePushed(row, lane, work, (blows & ContactWork.Bit(i, lane)) != 0, out WideVelocity a, out WideVelocity b, two);
                ContactKernel.StoreVelocities<TScatter>(row, lane, bodies, a, b);
            }
        }
    }

    /// <summary>Friction of bodies that were pushed, which do not know yet.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Rub<TPoints>(ContactBundle** some, int count, ContactWork* work, ulong blows)
        where TPoints : struct, IContactPoints
    {
        bool two = default(TPoints).AreTwo;
        for (int i = 0; i < count; i++, work++)
        {
            ContactBundle* row = some[i];
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                TakePushed(row, lane, work, (blows & ContactWork.Bit(i, lane)) != 0, out WideVelocity a, out WideVelocity b, two);
                ContactWork.Keep(work, lane, a, b);
                Wide slip = ContactFriction.Slip(row, lane, a, b);
                Wide armA0 = Wide.Load(work->ArmA0 + lane);
                Wide armB0 = Wide.Load(work->ArmB0 + lane);
                ContactFriction.WithRadii(row, lane, ref armA0, ref armB0);
                Wide slip0 = ContactFriction.SlipOf(slip, a, b, armA0, armB0);
                Wide normal0 = Wide.Load(row->Point0.Normal + lane);
                Wide rub0 = ContactFriction.Find(row, &row->Point0, lane, slip0, normal0);
                rub0.Store(work->Value0 + lane);
                if (two)
                {
                    Wide armA1 = Wide.Load(work->ArmA1 + lane);
                    Wide armB1 = Wide.Load(work->ArmB1 + lane);
                    ContactFriction.WithRadii(row, lane, ref armA1, ref armB1);
                    Wide slip1 = ContactFriction.SlipOf(slip, a, b, armA1, armB1)
                        + (ContactFriction.Coupling(row, lane, armA0, armB0, armA1, armB1) * rub0);
                    Wide normal1 = Wide.Load(row->Point1.Normal + lane);
                    ContactFriction.Find(row, &row->Point1, lane, slip1, normal1)
                        .Store(work->Value1 + lane);
                }
            }
        }
    }

    /// <summary>Gives the bodies what they were pushed and rubbed with.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void GiveRubbed<TScatter, TPoints>(ContactBundle** some, int count, ContactWork* work, BodyState* bodies, ulong blows)
        where TScatter : struct, IVelocityScatter
        where TPoints : struct, IContactPoints
    {
        bool two = default(TPoints).AreTwo;
        for (int i = 0; i < count; i++, work++)
        {
            ContactBundle* row = some[i];
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                TakeRubbed(row, lane, work, (blows & ContactWork.Bit(i, lane)) != 0, out WideVelocity a, out WideVelocity b, two);
                ContactKernel.StoreVelocities<TScatter>(row, lane, bodies, a, b);
            }
        }
    }

    /// <summary>Where that pays, turns the states of all bundles before any is computed with.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ContactMoved* Turn(ContactBundle** some, int count, ContactWork* work, BodyState* bodies)
    {
        ContactMoved* moved = ContactWork.Moved(work);
        if (Wide.Count <= MatrixTurn.MostLanes)
        {
            for (int i = 0; i < count; i++)
            {
                BodyTurning.TurnStates(bodies, some[i]->BodyA, work[i].VelocityAX, moved[i].AX);
                BodyTurning.TurnStates(bodies, some[i]->BodyB, work[i].VelocityBX, moved[i].BX);
            }
        }

        return moved;
    }

    /// <summary>What the bodies have moved, after the first stage.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void GatherMoved(
        ContactBundle* row, int lane, ContactMoved* moved, BodyState* bodies, out WideDelta movedA, out WideDelta movedB)
    {
        if (Wide.Count <= MatrixTurn.MostLanes)
        {
            movedA = ContactMoved.Take(moved->AX + lane);
            movedB = ContactMoved.Take(moved->BX + lane);
            return;
        }

        BodyLanes.GatherDeltas(bodies, row->BodyA + lane, row->BodyB + lane, out movedA, out movedB);
    }

    /// <summary>What the bodies have moved; their velocities are put down in the work.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Gather(
        ContactBundle* row, int lane, ContactWork* work, ContactMoved* moved, BodyState* bodies, out WideDelta movedA, out WideDelta movedB)
    {
        if (Wide.Count <= MatrixTurn.MostLanes)
        {
            movedA = ContactMoved.Take(moved->AX + lane);
            movedB = ContactMoved.Take(moved->BX + lane);
            return;
        }

        BodyLanes.GatherState(bodies, row->BodyA + lane, out WideVelocity a, out movedA);
        ContactWork.KeepA(work, lane, a);
        BodyLanes.GatherState(bodies, row->BodyB + lane, out WideVelocity b, out movedB);
        ContactWork.KeepB(work, lane, b);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void TakePushed(
        ContactBundle* row, int lane, ContactWork* work, bool isBlow, out WideVelocity a, out WideVelocity b, bool two)
    {
        ContactWork.Take(work, lane, out a, out b);
        Wide push1 = two ? Wide.Load(work->Value1 + lane) : Wide.Zero;
        ContactKernel.ApplyNormal(row, lane, ref a, ref b, Wide.Load(work->Value0 + lane), push1, two);
        if (isBlow)
        {
            AddBlow(work, lane, ref a, ref b);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void TakeRubbed(
        ContactBundle* row, int lane, ContactWork* work, bool isBlow, out WideVelocity a, out WideVelocity b, bool two)
    {
        ContactWork.Take(work, lane, out a, out b);
        Wide rub1 = two ? Wide.Load(work->Value1 + lane) : Wide.Zero;
        ContactKernel.ApplyTangent(row, lane, ref a, ref b, Wide.Load(work->Value0 + lane), rub1, two);
        if (isBlow)
        {
            AddBlow(work, lane, ref a, ref b);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AddBlow(ContactWork* work, int lane, ref WideVelocity a, ref WideVelocity b)
    {
        a.W = a.W + Wide.Load(work->BlowA + lane);
        b.W = b.W + Wide.Load(work->BlowB + lane);
    }
}
