#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif
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
    /// <summary>Bundles ahead for which memory is asked.</summary>
    private const int Ahead = 3;

    /// <summary>
    /// Applies the impulses of the substep before, extrapolated by a third of their change (a free momentum term for the
    /// block solver), friction kept within its cone.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void WarmStart<TScatter>(in BundleRun rows, BodyState* bodies, in ContactCoefficients c)
        where TScatter : struct, IVelocityScatter
    {
        Wide fall = Wide.Splat(c.Gravity * c.Substep);
        ContactBundle* end = rows.Bundles + rows.Count;
        for (ContactBundle* row = rows.Bundles; row < end; row++)
        {
            AskAhead(rows, row);
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherVelocity(bodies, row->BodyA + lane, out WideVelocity a);
                BodyLanes.GatherVelocity(bodies, row->BodyB + lane, out WideVelocity b);
                Wide friction = Wide.Load(row->Friction + lane);
                Wide weight0 = fall * Wide.Load(row->InverseK11 + lane);
                Wide weight1 = fall * Wide.Load(row->InverseK22 + lane);
                Extrapolate(&row->Point0, lane, friction, weight0, out Wide normal0, out Wide tangent0);
                Extrapolate(&row->Point1, lane, friction, weight1, out Wide normal1, out Wide tangent1);
                ApplyNormal(row, lane, ref a, ref b, normal0, normal1);
                ApplyTangent(row, lane, ref a, ref b, tangent0, tangent1);
                StoreVelocities<TScatter>(row, lane, bodies, a, b);
            }
        }
    }

    /// <summary>
    /// The biased pass: normal impulses that also remove overlap, softly. With φ in place of 0 as the value towards which the
    /// impulse leaks, the static sag is a tenth of the plain soft contact's. The surfaces hold from the moment they touch and
    /// sink from there, slowly, to the depth of rest. Contacts of deep islands are solved hard here;
    /// their overlap goes in <see cref="PushOut"/>.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void SolveBiased<TScatter>(in BundleRun rows, BodyState* bodies, in ContactCoefficients c, bool anyDeep)
        where TScatter : struct, IVelocityScatter
    {
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        Wide biasRate = Wide.Splat(c.BiasRate * ContactCoefficients.MassScale);
        Wide massScale = Wide.Splat(ContactCoefficients.MassScale);
        Wide leak = Wide.Splat(ContactCoefficients.ImpulseScale);
        Wide rest = Wide.Splat(c.Rest);
        Wide settle = Wide.Splat(c.BiasRate * c.Rest);
        Wide settleShare = Wide.Splat(ContactCoefficients.SettleShare);
        ContactBundle* end = rows.Bundles + rows.Count;
        for (ContactBundle* row = rows.Bundles; row < end; row++)
        {
            AskAhead(rows, row);
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherDelta(bodies, row->BodyA + lane, out WideDelta movedA);
                BodyLanes.GatherDelta(bodies, row->BodyB + lane, out WideDelta movedB);
                Separations(row, lane, movedA, movedB, out Wide s0, out Wide s1);
                BodyLanes.GatherVelocity(bodies, row->BodyA + lane, out WideVelocity a);
                BodyLanes.GatherVelocity(bodies, row->BodyB + lane, out WideVelocity b);
                TurnedNormalVelocities(row, lane, a, b, movedA, movedB, out Wide v0, out Wide v1);
                Wide lambda0 = Wide.Load(row->Point0.Normal + lane);
                Wide lambda1 = Wide.Load(row->Point1.Normal + lane);

                Wide gap0 = s0 - rest;
                Wide gap1 = s1 - rest;
                WideMask apart0 = gap0 > Wide.Zero;
                WideMask apart1 = gap1 > Wide.Zero;
                Wide load0 = lambda0 * Wide.Load(row->K11 + lane);
                Wide load1 = lambda1 * Wide.Load(row->K22 + lane);
                Wide sink = settleShare * Wide.Select(Wide.Load(row->Single + lane) > Wide.Zero, load0, Wide.Min(load0, load1));
                Wide slowly = Wide.Min(settle, sink);
                Wide closing0 = (gap0 * inverseSubstep) + slowly;
                Wide closing1 = (gap1 * inverseSubstep) + slowly;
                if (anyDeep)
                {
                    WideMask deep = Wide.Load(row->Deep + lane) > Wide.Zero;
                    closing0 = Wide.Select(deep, Wide.Max(gap0, Wide.Zero) * inverseSubstep, closing0);
                    closing1 = Wide.Select(deep, Wide.Max(gap1, Wide.Zero) * inverseSubstep, closing1);
                    apart0 = apart0 | deep;
                    apart1 = apart1 | deep;
                }

                Wide soft0 = (massScale * v0) + Wide.Min(biasRate * s0, sink)
                    + (Wide.Load(row->K11 + lane) * leak * (lambda0 - Wide.Load(row->Point0.Feed + lane)));
                Wide soft1 = (massScale * v1) + Wide.Min(biasRate * s1, sink)
                    + (Wide.Load(row->K22 + lane) * leak * (lambda1 - Wide.Load(row->Point1.Feed + lane)));
                Wide r0 = Wide.Select(apart0, v0 + closing0, soft0);
                Wide r1 = Wide.Select(apart1, v1 + closing1, soft1);
                SolveBlock(row, lane, lambda0, lambda1, r0, r1, out Wide x0, out Wide x1);
                x0.Store(row->Point0.Normal + lane);
                x1.Store(row->Point1.Normal + lane);
                Wide push0 = x0 - lambda0;
                Wide push1 = x1 - lambda1;
                ApplyNormal(row, lane, ref a, ref b, push0, push1);

                // Who pushes for long has a feed-forward: only others may be struck, and are asked further.
                WideMask blow = ((Wide.Load(row->Point0.Feed + lane) + Wide.Load(row->Point1.Feed + lane)) <= Wide.Zero)
                    & ((Wide.Abs(push0) + Wide.Abs(push1)) > Wide.Zero);
                if (WideLanes.Bits(blow) != 0)
                {
                    BlowKernel.Strike(row, lane, bodies, push0, push1, out Wide spinA, out Wide spinB);
                    a.W = a.W + spinA;
                    b.W = b.W + spinB;
                }

                StoreVelocities<TScatter>(row, lane, bodies, a, b);
            }
        }
    }

    /// <summary>
    /// Moves the contacts of deep islands apart. The velocities found here move the bodies and are then forgotten, and so are
    /// the impulses, so that a deep overlap never becomes speed.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void PushOut<TScatter>(in BundleRun rows, BodyState* bodies, in ContactCoefficients c, float recoveryRate)
        where TScatter : struct, IVelocityScatter
    {
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        Wide rate = Wide.Splat(recoveryRate);
        ContactBundle* end = rows.Bundles + rows.Count;
        for (ContactBundle* row = rows.Bundles; row < end; row++)
        {
            AskAhead(rows, row);
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                WideMask deep = Wide.Load(row->Deep + lane) > Wide.Zero;
                if (WideLanes.Bits(deep) == 0)
                {
                    continue;
                }

                GatherSeparations(row, lane, bodies, out Wide s0, out Wide s1);
                BodyLanes.GatherVelocity(bodies, row->BodyA + lane, out WideVelocity a);
                BodyLanes.GatherVelocity(bodies, row->BodyB + lane, out WideVelocity b);
                NormalVelocities(row, lane, a, b, out Wide v0, out Wide v1);
                Wide lambda0 = Wide.Load(row->Point0.Normal + lane);
                Wide lambda1 = Wide.Load(row->Point1.Normal + lane);
                Wide r0 = v0 + (s0 * Wide.Select(s0 > Wide.Zero, inverseSubstep, rate));
                Wide r1 = v1 + (s1 * Wide.Select(s1 > Wide.Zero, inverseSubstep, rate));
                SolveBlock(row, lane, lambda0, lambda1, r0, r1, out Wide x0, out Wide x1);
                Wide push0 = Wide.Select(deep, x0 - lambda0, Wide.Zero);
                Wide push1 = Wide.Select(deep, x1 - lambda1, Wide.Zero);
                ApplyNormal(row, lane, ref a, ref b, push0, push1);
                StoreVelocities<TScatter>(row, lane, bodies, a, b);
            }
        }
    }

    /// <summary>
    /// The relax pass at the new positions: the same block without bias and softness, so that no push-out velocity is left,
    /// then friction within the cone of the true normal impulses unless <paramref name="rub"/> is false, then the feed-forward follows.
    /// Before it does, in the <paramref name="first"/> sweep, it tells who pushes for long.
    /// Two points at almost the same gap count as level: an impact that begins here would turn their rounding over the substep
    /// into spin. (To leave every open surface to the next substep cured that as well, but cost a tipping box 9e-4 rad/s.)
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Relax<TScatter>(in BundleRun rows, BodyState* bodies, in ContactCoefficients c, bool rub, bool first)
        where TScatter : struct, IVelocityScatter
    {
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        Wide rest = Wide.Splat(c.Rest);
        Wide level = Wide.Splat(c.Level);
        ContactBundle* end = rows.Bundles + rows.Count;
        for (ContactBundle* row = rows.Bundles; row < end; row++)
        {
            AskAhead(rows, row);
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherDelta(bodies, row->BodyA + lane, out WideDelta movedA);
                BodyLanes.GatherDelta(bodies, row->BodyB + lane, out WideDelta movedB);
                Separations(row, lane, movedA, movedB, out Wide s0, out Wide s1);
                BodyLanes.GatherVelocity(bodies, row->BodyA + lane, out WideVelocity a);
                BodyLanes.GatherVelocity(bodies, row->BodyB + lane, out WideVelocity b);
                TurnedNormalVelocities(row, lane, a, b, movedA, movedB, out Wide v0, out Wide v1);
                Wide lambda0 = Wide.Load(row->Point0.Normal + lane);
                Wide lambda1 = Wide.Load(row->Point1.Normal + lane);
                Wide gap0 = s0 - rest;
                Wide gap1 = s1 - rest;
                WideMask flat = Wide.Max(gap0 - gap1, gap1 - gap0) <= level;
                Wide mean = Wide.Splat(0.5f) * (gap0 + gap1);
                gap0 = Wide.Select(flat, mean, gap0);
                gap1 = Wide.Select(flat, mean, gap1);
                Wide r0 = v0 + (Wide.Max(gap0, Wide.Zero) * inverseSubstep);
                Wide r1 = v1 + (Wide.Max(gap1, Wide.Zero) * inverseSubstep);
                SolveBlock(row, lane, lambda0, lambda1, r0, r1, out Wide x0, out Wide x1);
                x0.Store(row->Point0.Normal + lane);
                x1.Store(row->Point1.Normal + lane);
                Wide push0 = x0 - lambda0;
                Wide push1 = x1 - lambda1;
                ApplyNormal(row, lane, ref a, ref b, push0, push1);
                Wide feed0 = Wide.Load(row->Point0.Feed + lane);
                Wide feed1 = Wide.Load(row->Point1.Feed + lane);
                WideMask blow = (Wide.Abs(push0) + Wide.Abs(push1)) > Wide.Zero;
                if (first)
                {
                    blow = blow & ((feed0 + feed1) <= Wide.Zero);
                }

                bool struck = WideLanes.Bits(blow) != 0;
                if (struck)
                {
                    BlowKernel.Strike(row, lane, bodies, push0, push1, out Wide spinA, out Wide spinB);
                    a.W = a.W + spinA;
                    b.W = b.W + spinB;
                }

                if (rub)
                {
                    SolveFriction(row, lane, ref a, ref b, movedA, movedB, x0, x1, WideLanes.AllSet, out Wide rub0, out Wide rub1);
                    if (struck)
                    {
                        BlowKernel.Rub(row, lane, bodies, rub0, rub1, out Wide spinA, out Wide spinB);
                        a.W = a.W + spinA;
                        b.W = b.W + spinB;
                    }
                }

                StoreVelocities<TScatter>(row, lane, bodies, a, b);

                // Only the load common to both points is fed forward: with each point's own, random piles creep.
                Wide single = Wide.Load(row->Single + lane);
                Wide common = Wide.Min(x0, x1);
                Wide load = Wide.Select(single > Wide.Zero, x0, common);
                Wide target = Wide.Load(row->FeedShare + lane) * load;
                Wide feedRate = Wide.Load(row->FeedRate + lane);
                Wide.Min(x0, feed0 + (feedRate * (target - feed0))).Store(row->Point0.Feed + lane);
                Wide.Min(x1, feed1 + (feedRate * (target - feed1))).Store(row->Point1.Feed + lane);
            }
        }
    }

    /// <summary>
    /// Rows of a large world come from memory, and their lines are not read in order, which the processor's own foresight needs. Rows that
    /// are near lose by it (a pyramid of 100: a fifth of the solver's time).
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AskAhead(in BundleRun rows, ContactBundle* row)
    {
        if (Prefetch.IsUseful && rows.IsFar)
        {
            ContactBundle* ahead = row + Ahead;
            long past = ahead - (rows.Bundles + rows.Count);
            ahead = past < 0 ? ahead : rows.Following + past;
            byte* end = (byte*)ahead->Contact;
            for (byte* line = (byte*)ahead; line < end; line += Prefetch.LineBytes)
            {
                Prefetch.Line(line);
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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Extrapolate(
        ContactPointLanes* p, int lane, Wide friction, Wide weight, out Wide normal, out Wide tangent)
    {
        Wide share = Wide.Splat(ContactCoefficients.Extrapolation);
        Wide oldNormal = Wide.Load(p->Normal + lane);
        Wide oldTangent = Wide.Load(p->Tangent + lane);
        Wide previous = Wide.Load(p->PreviousNormal + lane);
        Wide previousTangent = Wide.Load(p->PreviousTangent + lane);
        Wide most = Wide.Splat(ContactCoefficients.LargestGrowth) * (previous + weight);
        WideMask impact = oldNormal > most;
        normal = Wide.Select(impact, previous, Wide.Max(oldNormal + (share * (oldNormal - previous)), Wide.Zero));
        tangent = Wide.Select(impact, previousTangent, oldTangent + (share * (oldTangent - previousTangent)));
        Wide bound = friction * normal;
        tangent = Wide.Max(Wide.Min(tangent, bound), Wide.Zero - bound);
        Wide.Min(oldNormal, most).Store(p->PreviousNormal + lane);
        Wide.Select(impact, tangent, oldTangent).Store(p->PreviousTangent + lane);
        normal.Store(p->Normal + lane);
        tangent.Store(p->Tangent + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void GatherSeparations(ContactBundle* row, int lane, BodyState* bodies, out Wide s0, out Wide s1)
    {
        BodyLanes.GatherDelta(bodies, row->BodyA + lane, out WideDelta a);
        BodyLanes.GatherDelta(bodies, row->BodyB + lane, out WideDelta b);
        Separations(row, lane, a, b, out s0, out s1);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Separations(ContactBundle* row, int lane, in WideDelta a, in WideDelta b, out Wide s0, out Wide s1)
    {
        Wide moved = (Wide.Load(row->NormalX + lane) * (b.X - a.X)) + (Wide.Load(row->NormalY + lane) * (b.Y - a.Y));
        s0 = PointSeparation(&row->Point0, lane, a, b, moved);
        s1 = PointSeparation(&row->Point1, lane, a, b, moved);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide PointSeparation(ContactPointLanes* p, int lane, in WideDelta a, in WideDelta b, Wide moved)
    {
        Wide turnedB = (b.Cos * Wide.Load(p->NormalArmB + lane)) + (b.Sin * Wide.Load(p->TangentArmB + lane));
        Wide turnedA = (a.Cos * Wide.Load(p->NormalArmA + lane)) + (a.Sin * Wide.Load(p->TangentArmA + lane));
        return (Wide.Load(p->Base + lane) + moved) + (turnedB - turnedA);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void NormalVelocities(ContactBundle* row, int lane, in WideVelocity a, in WideVelocity b, out Wide v0, out Wide v1)
    {
        Wide un = (Wide.Load(row->NormalX + lane) * (b.X - a.X)) + (Wide.Load(row->NormalY + lane) * (b.Y - a.Y));
        v0 = un + ((b.W * Wide.Load(row->Point0.TangentArmB + lane)) - (a.W * Wide.Load(row->Point0.TangentArmA + lane)));
        v1 = un + ((b.W * Wide.Load(row->Point1.TangentArmB + lane)) - (a.W * Wide.Load(row->Point1.TangentArmA + lane)));
    }

    /// <summary>
    /// How fast the separations change: with s = s0 + cos a N + sin a T for a turn a, the arm of the spin is cos a T - sin a N.
    /// With the arms of the middle of the step instead, a body that tips over ends each step with the velocity of half a step
    /// before, off by w² r dt / 2, and its contact lifts and drops within the step. The impulses keep the arms of the
    /// middle: that K and the arms agree is what makes the block solve exact, and over a step the mean of the arms is what counts
    /// (for a blow see <see cref="BlowKernel"/>).
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void TurnedNormalVelocities(
        ContactBundle* row, int lane, in WideVelocity a, in WideVelocity b, in WideDelta movedA, in WideDelta movedB, out Wide v0, out Wide v1)
    {
        Wide un = (Wide.Load(row->NormalX + lane) * (b.X - a.X)) + (Wide.Load(row->NormalY + lane) * (b.Y - a.Y));
        v0 = un + TurnedSpin(&row->Point0, lane, a.W, b.W, movedA, movedB);
        v1 = un + TurnedSpin(&row->Point1, lane, a.W, b.W, movedA, movedB);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide TurnedSpin(ContactPointLanes* p, int lane, Wide spinA, Wide spinB, in WideDelta movedA, in WideDelta movedB)
    {
        Wide armA = (movedA.Cos * Wide.Load(p->TangentArmA + lane)) - (movedA.Sin * Wide.Load(p->NormalArmA + lane));
        Wide armB = (movedB.Cos * Wide.Load(p->TangentArmB + lane)) - (movedB.Sin * Wide.Load(p->NormalArmB + lane));
        return (spinB * armB) - (spinA * armA);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void ApplyNormal(ContactBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, Wide p0, Wide p1)
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
        a.W = a.W - (Wide.Load(row->InertiaA + lane)
            * ((Wide.Load(row->Point0.TangentArmA + lane) * p0) + (Wide.Load(row->Point1.TangentArmA + lane) * p1)));
        b.W = b.W + (Wide.Load(row->InertiaB + lane)
            * ((Wide.Load(row->Point0.TangentArmB + lane) * p0) + (Wide.Load(row->Point1.TangentArmB + lane) * p1)));
    }

    // t = (ny, -nx), and r×t = -an.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void ApplyTangent(ContactBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, Wide p0, Wide p1)
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
        a.W = a.W + (Wide.Load(row->InertiaA + lane)
            * ((Wide.Load(row->Point0.NormalArmA + lane) * p0) + (Wide.Load(row->Point1.NormalArmA + lane) * p1)
                + (Wide.Load(row->RadiusA + lane) * sum)));
        b.W = b.W - (Wide.Load(row->InertiaB + lane)
            * ((Wide.Load(row->Point0.NormalArmB + lane) * p0) + (Wide.Load(row->Point1.NormalArmB + lane) * p1)
                - (Wide.Load(row->RadiusB + lane) * sum)));
    }

    /// <summary>
    /// Two friction rows in turn; the second sees the first's change through the coupling of the tangent arms. Lanes that are
    /// not <paramref name="active"/> keep their impulses. The arms turn along as in the normal rows.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void SolveFriction(
        ContactBundle* row,
        int lane,
        ref WideVelocity a,
        ref WideVelocity b,
        in WideDelta movedA,
        in WideDelta movedB,
        Wide normal0,
        Wide normal1,
        WideMask active,
        out Wide change0,
        out Wide change1)
    {
        Wide friction = Wide.Load(row->Friction + lane);
        Wide ut = (Wide.Load(row->NormalY + lane) * (b.X - a.X)) - (Wide.Load(row->NormalX + lane) * (b.Y - a.Y));
        Wide radiusA = Wide.Load(row->RadiusA + lane);
        Wide radiusB = Wide.Load(row->RadiusB + lane);
        Wide armA0 = (movedA.Cos * Wide.Load(row->Point0.NormalArmA + lane)) + (movedA.Sin * Wide.Load(row->Point0.TangentArmA + lane)) + radiusA;
        Wide armB0 = (movedB.Cos * Wide.Load(row->Point0.NormalArmB + lane)) + (movedB.Sin * Wide.Load(row->Point0.TangentArmB + lane)) - radiusB;
        Wide v0 = ut + ((a.W * armA0) - (b.W * armB0));
        Wide old0 = Wide.Load(row->Point0.Tangent + lane);
        Wide bound0 = friction * normal0;
        Wide new0 = Wide.Max(Wide.Min(old0 - (Wide.Load(row->TangentMass0 + lane) * v0), bound0), Wide.Zero - bound0);
        new0 = Wide.Select(active, new0, old0);
        new0.Store(row->Point0.Tangent + lane);
        change0 = new0 - old0;

        Wide armA1 = (movedA.Cos * Wide.Load(row->Point1.NormalArmA + lane)) + (movedA.Sin * Wide.Load(row->Point1.TangentArmA + lane)) + radiusA;
        Wide armB1 = (movedB.Cos * Wide.Load(row->Point1.NormalArmB + lane)) + (movedB.Sin * Wide.Load(row->Point1.TangentArmB + lane)) - radiusB;
        Wide coupling = Wide.Load(row->MassA + lane) + Wide.Load(row->MassB + lane)
            + (Wide.Load(row->InertiaA + lane) * armA0 * armA1) + (Wide.Load(row->InertiaB + lane) * armB0 * armB1);
        Wide v1 = ut + ((a.W * armA1) - (b.W * armB1)) + (coupling * change0);
        Wide old1 = Wide.Load(row->Point1.Tangent + lane);
        Wide bound1 = friction * normal1;
        Wide new1 = Wide.Max(Wide.Min(old1 - (Wide.Load(row->TangentMass1 + lane) * v1), bound1), Wide.Zero - bound1);
        new1 = Wide.Select(active, new1, old1);
        new1.Store(row->Point1.Tangent + lane);
        change1 = new1 - old1;
        ApplyTangent(row, lane, ref a, ref b, change0, change1);
    }

    /// <summary>
    /// Finds x ≥ 0 with w = K(x - λ) + r ≥ 0 and x·w = 0. Written with b = r - Kλ, the four cases are: both points push,
    /// only the first, only the second, none; all are computed and the valid one selected, so there is no branch. Where the
    /// points nearly coincide (the determinant is stored as 0) the rows are solved in turn.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void SolveBlock(
        ContactBundle* row, int lane, Wide lambda0, Wide lambda1, Wide r0, Wide r1, out Wide x0, out Wide x1)
    {
        Wide k11 = Wide.Load(row->K11 + lane);
        Wide k22 = Wide.Load(row->K22 + lane);
        Wide k12 = Wide.Load(row->K12 + lane);
        Wide inverse11 = Wide.Load(row->InverseK11 + lane);
        Wide inverse22 = Wide.Load(row->InverseK22 + lane);
        Wide inverse = Wide.Load(row->InverseDeterminant + lane);
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
        WideMask block = inverse > zero;
        WideMask pair = (both0 >= zero) & (both1 >= zero);
        x0 = Wide.Select(second, zero, turn0);
        x1 = Wide.Select(second, only1, turn1);
        x0 = Wide.Select(first, only0, x0);
        x1 = Wide.Select(first, zero, x1);
        x0 = Wide.Select(none, zero, x0);
        x1 = Wide.Select(none, zero, x1);
        x0 = Wide.Select(pair, both0, x0);
        x1 = Wide.Select(pair, both1, x1);
        x0 = Wide.Select(block, x0, turn0);
        x1 = Wide.Select(block, x1, turn1);
    }
}
