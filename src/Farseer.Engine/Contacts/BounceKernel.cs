using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// Restitution at the moment of impact. A point that approaches fast enough to bounce is held back from the passes of its substep,
/// so the bodies fly on exactly and overlap at its end by what they flew too far. Then the impact is made up for: the way back from the end
/// of the substep (<see cref="WideFlight"/>) tells when the surfaces met, and with what velocities and arms (<see cref="ImpactArms"/>). The
/// impulse that turns the speed of approach w into -e·w changes velocities by Δ and, t being the time since, places by Δ·t. A body is then
/// where the reflected flight has brought it. Two points of a contact that land one after the other are two impacts, in their order; at the
/// same moment they are solved together.
/// </summary>
internal static unsafe class BounceKernel
{
    /// <summary>Impacts slower than this many substeps of outside acceleration are rest, not impact.</summary>
    public const float RestSubsteps = 4f;

    /// <summary>Sweeps over impacts of the same moment that share a body, or a tree of joints.</summary>
    public const int Sweeps = 8;

    /// <summary>Share of the substep within which impacts are at the same moment.</summary>
    public const double SameMoment = 1e-3;

    /// <summary>
    /// Angle, rad, between surfaces that count as parallel: they land at once. What rests is as level as its loads are known, and a box
    /// that lands flat on it would go from corner to corner by the rounding of that.
    /// </summary>
    private const float Parallel = 1e-4f;

    /// <summary>
    /// Share of the speeds of two bodies by which their approach may be wrong, and of a substep by which a moment may be: a few units in
    /// the last place of a float.
    /// </summary>
    private const float Rounding = 1e-6f;

    /// <summary>The least restitution of bounces that are not weak.</summary>
    private const float Strong = 0.5f;

    /// <summary>Newton's steps to the moment of an impact: each doubles the digits.</summary>
    private const int MomentSteps = 6;

    /// <summary>A contact of the bundle can bounce.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Bounces(ContactBundle* row) => BouncingLanes(row) != 0;

    /// <summary>A bit for each lane whose contact can bounce.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int BouncingLanes(ContactBundle* row) => LanesFrom(row, float.Epsilon);

    /// <summary>A bit for each lane whose contact gives back a quarter of the energy or more.</summary>
    public static int StrongLanes(ContactBundle* row) => LanesFrom(row, Strong);

    /// <summary>A bit for each lane with a contact of which nothing presses yet on a point that may meet.</summary>
    /// <param name="row">The bundle.</param>
    /// <param name="whole">Those among them that nothing presses at all.</param>
    public static int UnloadedLanes(ContactBundle* row, out int whole)
    {
        int bits = 0;
        whole = 0;
        Wide none = Wide.Splat(ContactBundle.NoPoint);
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            WideMask bare1 = Wide.Load(row->Point1.Normal + lane) <= Wide.Zero;
            WideMask open0 = (Wide.Load(row->Point0.Normal + lane) <= Wide.Zero) & (Wide.Load(row->Point0.Base + lane) < none);
            WideMask open1 = bare1 & (Wide.Load(row->Point1.Base + lane) < none);
            bits |= WideLanes.Bits(open0 | open1) << lane;
            whole |= WideLanes.Bits(open0 & bare1) << lane;
        }

        return bits;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int LanesFrom(ContactBundle* row, float restitution)
    {
        int bits = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            bits |= WideLanes.Bits(Wide.Load(row->Restitution + lane) >= Wide.Splat(restitution)) << lane;
        }

        return bits;
    }

    /// <summary>The slowest approach that is an impact; a threshold of bounces concerns only what bounces.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Slowest(ContactBundle* row, int lane, BodyDrive* drives, in ContactCoefficients c)
    {
        BodyLanes.Gather(
            (float*)drives, row->BodyA + lane, (float*)drives, row->BodyB + lane, out FourColumns driveA, out FourColumns driveB);
        Wide nx = Wide.Load(row->NormalX + lane);
        Wide ny = Wide.Load(row->NormalY + lane);
        Wide fall = Wide.Max(Wide.Abs((nx * driveA.A) + (ny * driveA.B)), Wide.Abs((nx * driveB.A) + (ny * driveB.B)));
        Wide threshold = Wide.Keep(Wide.Load(row->Restitution + lane) > Wide.Zero, Wide.Splat(c.BounceThreshold));
        return Wide.Max(Wide.Splat(RestSubsteps) * fall, threshold);
    }

    /// <summary>Before a substep: notes where surfaces are, and holds back the points that approach fast.</summary>
    /// <returns>True if there are such points.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool Prepare(BounceLanes* bounce, BodyState* bodies, BodyMotion* motions, BodyDrive* drives, in ContactCoefficients c)
    {
        ContactBundle* row = bounce->Row;
        bounce->Hits = 0;
        bounce->Later = 0;
        bounce->Struck = 0;
        bounce->Held = 0;
        bounce->Met = 0;
        bounce->Heavy = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            var a = WideFlight.AtStart(bodies, motions, drives, row->BodyA + lane, Wide.Splat(c.InverseSubstep));
            var b = WideFlight.AtStart(bodies, motions, drives, row->BodyB + lane, Wide.Splat(c.InverseSubstep));
            ContactKernel.Separations(row, lane, a.Moved, b.Moved, out Wide s0, out Wide s1);
            new ImpactArms(row, lane, a.Moved, b.Moved).Velocities(a.Velocity, b.Velocity, out Wide v0, out Wide v1);

            // A corner that comes round may approach fast only at the end of the substep.
            a.Before(Wide.Splat(-c.Substep), out WideDelta endA, out WideVelocity velocityA);
            b.Before(Wide.Splat(-c.Substep), out WideDelta endB, out WideVelocity velocityB);
            new ImpactArms(row, lane, endA, endB).Velocities(velocityA, velocityB, out Wide end0, out Wide end1);
            v0 = Wide.Min(v0, end0);
            v1 = Wide.Min(v1, end1);
            Wide slow = Slowest(row, lane, drives, c);
            slow.Store(bounce->Slow + lane);
            Wide normal0 = Wide.Load(row->Point0.Normal + lane);
            Wide normal1 = Wide.Load(row->Point1.Normal + lane);
            WideMask can = WideLanes.Mask(bounce->Can >> lane)
                & (((normal0 + normal1) <= Wide.Zero) | WideLanes.Mask(bounce->PointByPoint >> lane));
            Wide rest = ContactBundle.RestDepth(row, lane);
            WideMask held0 = can & (normal0 <= Wide.Zero) & HoldBack(&bounce->Point0, lane, s0 - rest, v0, slow);
            WideMask held1 = can & (normal1 <= Wide.Zero) & HoldBack(&bounce->Point1, lane, s1 - rest, v1, slow);
            Mute(&row->Point0, &bounce->Point0, lane, held0);
            Mute(&row->Point1, &bounce->Point1, lane, held1);
            bounce->Held |= WideLanes.Bits(held0 | held1) << lane;
        }

        return bounce->Held != 0;
    }

    /// <summary>
    /// After the passes: the points that have come through each other, when they met, and at what speed they are to part. A point that
    /// was held back is stopped at least; another bounces if it approaches fast by now, because something else struck its bodies.
    /// </summary>
    /// <param name="bounce">The bundle.</param>
    /// <param name="bodies">States of the bodies.</param>
    /// <param name="motions">What their velocities were at the start of the substep.</param>
    /// <param name="c">Of the substep.</param>
    /// <param name="lanes">Bits of the lanes to look at.</param>
    /// <param name="onlyHeld">
    /// Nothing has been struck yet: what was not held back and approaches all the same is a load that the passes have not found, and no
    /// impact.
    /// </param>
    /// <returns>A bit for each lane with an impact.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static int Find(BounceLanes* bounce, BodyState* bodies, BodyMotion* motions, in ContactCoefficients c, int lanes, bool onlyHeld)
    {
        ContactBundle* row = bounce->Row;
        Wide fastest = Wide.Splat(onlyHeld ? float.MaxValue : 0f);
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        Wide none = Wide.Splat(-1f);
        Wide same = Wide.Splat((float)SameMoment * c.Substep);
        int hits = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            BodyLanes.GatherDeltas(bodies, row->BodyA + lane, row->BodyB + lane, out WideDelta movedA, out WideDelta movedB);
            ContactKernel.Separations(row, lane, movedA, movedB, out Wide s0, out Wide s1);
            BodyLanes.GatherVelocities(bodies, row->BodyA + lane, row->BodyB + lane, out WideVelocity a, out WideVelocity b);
            new ImpactArms(row, lane, movedA, movedB).Velocities(a, b, out Wide v0, out Wide v1);
            Wide rounding = RoundingOf(a, b);
            WideMask can = WideLanes.Mask((bounce->Can & lanes) >> lane);
            Wide slow = Wide.Load(bounce->Slow + lane);
            Wide rest = ContactBundle.RestDepth(row, lane);
            WideMask met0 = can & Met(&bounce->Point0, lane, s0 - rest, v0 + rounding, Wide.Max(slow, fastest));
            WideMask met1 = can & Met(&bounce->Point1, lane, s1 - rest, v1 + rounding, Wide.Max(slow, fastest));
            WideMask met = met0 | met1;
            if (!WideLanes.Any(met))
            {
                continue;
            }

            Moments moments;
            moments.A = WideFlight.AtEnd(
                bodies, motions, row->BodyA + lane, Wide.Load(row->MassA + lane) + Wide.Load(row->InertiaA + lane), inverseSubstep);
            moments.B = WideFlight.AtEnd(
                bodies, motions, row->BodyB + lane, Wide.Load(row->MassB + lane) + Wide.Load(row->InertiaB + lane), inverseSubstep);
            moments.Row = row;
            moments.Lane = lane;
            Wide level0 = rest + Wide.Load(bounce->Point0.Level + lane);
            Wide level1 = rest + Wide.Load(bounce->Point1.Level + lane);
            Wide time0 = Wide.Select(met0, Moment(moments, met0, level0, s0, v0, second: false, c.Substep, out Wide w0), none);
            Wide time1 = Wide.Select(met1, Moment(moments, met1, level1, s1, v1, second: true, c.Substep, out Wide w1), none);

            // Of two points the one that landed first has the first impact; the other comes after it, unless the surfaces are parallel by
            // then.
            Wide time = Wide.Max(time0, time1);
            Wide width = Wide.Abs(Wide.Load(row->Point1.TangentArmA + lane) - Wide.Load(row->Point0.TangentArmA + lane));
            Wide level = Wide.Splat(Parallel) * width;
            met0 = met0 & ((time0 >= (time - same)) | (((time0 - time) * w0) <= level));
            met1 = met1 & ((time1 >= (time - same)) | (((time1 - time) * w1) <= level));
            WideLanes.Replace(met, time, bounce->Time + lane);
            Begin(bounce, &bounce->Point0, lane, met, met0, w0, v0);
            Begin(bounce, &bounce->Point1, lane, met, met1, w1, v1);
            hits |= WideLanes.Bits(met) << lane;
        }

        return hits;
    }

    /// <summary>Solves the impacts of the lanes in <see cref="BounceLanes.Hits"/>.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Apply(BounceLanes* bounce, BodyState* bodies, BodyMotion* motions, in ContactCoefficients c)
    {
        ContactBundle* row = bounce->Row;
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            WideMask any = WideLanes.Mask(bounce->Hits >> lane);
            if (!WideLanes.Any(any))
            {
                continue;
            }

            Wide time = Wide.Keep(any, Wide.Load(bounce->Time + lane));
            var a = WideFlight.AtEnd(
                bodies, motions, row->BodyA + lane, Wide.Load(row->MassA + lane) + Wide.Load(row->InertiaA + lane), inverseSubstep);
            var b = WideFlight.AtEnd(
                bodies, motions, row->BodyB + lane, Wide.Load(row->MassB + lane) + Wide.Load(row->InertiaB + lane), inverseSubstep);
            a.Before(time, out WideDelta movedA, out WideVelocity velocityA);
            b.Before(time, out WideDelta movedB, out WideVelocity velocityB);
            var arms = new ImpactArms(row, lane, movedA, movedB);
            arms.Velocities(velocityA, velocityB, out Wide v0, out Wide v1);
            Wide target0 = Wide.Load(bounce->Point0.Target + lane);
            Wide target1 = Wide.Load(bounce->Point1.Target + lane);
            Wide old0 = Wide.Load(bounce->Point0.Push + lane);
            Wide old1 = Wide.Load(bounce->Point1.Push + lane);
            arms.Solve(
                any & (target0 >= Wide.Zero), any & (target1 >= Wide.Zero), old0, old1, v0 - target0, v1 - target1, out Wide x0,
                out Wide x1);
            x0 = Wide.Select(any, x0, old0);
            x1 = Wide.Select(any, x1, old1);
            arms.Push(x0 - old0, x1 - old1, out WideVelocity changeA, out WideVelocity changeB);
            WideVelocity newA = Sum(velocityA, changeA);
            WideVelocity newB = Sum(velocityB, changeB);
            Note(&row->Point0, &bounce->Point0, lane, x0 - old0, x0);
            Note(&row->Point1, &bounce->Point1, lane, x1 - old1, x1);
            Wide oldRub0 = Wide.Load(bounce->Point0.Rub + lane);
            Wide oldRub1 = Wide.Load(bounce->Point1.Rub + lane);
            Wide rub0 = arms.Rub(&row->Point0, movedA, movedB, Wide.Keep(any, x0), oldRub0, ref newA, ref newB);
            Wide rub1 = arms.Rub(&row->Point1, movedA, movedB, Wide.Keep(any, x1), oldRub1, ref newA, ref newB);
            NoteRub(&row->Point0, &bounce->Point0, lane, any, rub0, rub0 - oldRub0);
            NoteRub(&row->Point1, &bounce->Point1, lane, any, rub1, rub1 - oldRub1);
            WideFlight.CatchUp(bodies, motions, row->BodyA + lane, Difference(any, velocityA, newA), time);
            WideFlight.CatchUp(bodies, motions, row->BodyB + lane, Difference(any, velocityB, newB), time);
        }
    }

    /// <summary>Lanes whose surfaces approach again after their impact: what does not bounce has stopped one of their bodies.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static int FindAgain(BounceLanes* bounce, BodyState* bodies)
    {
        ContactBundle* row = bounce->Row;
        int again = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            BodyLanes.GatherDeltas(bodies, row->BodyA + lane, row->BodyB + lane, out WideDelta movedA, out WideDelta movedB);
            BodyLanes.GatherVelocities(bodies, row->BodyA + lane, row->BodyB + lane, out WideVelocity a, out WideVelocity b);
            new ImpactArms(row, lane, movedA, movedB).Velocities(a, b, out Wide v0, out Wide v1);
            Wide slow = Wide.Zero - Wide.Load(bounce->Slow + lane);
            again |= WideLanes.Bits(
                ((Wide.Load(bounce->Point0.Target + lane) >= Wide.Zero) & (v0 < slow))
                | ((Wide.Load(bounce->Point1.Target + lane) >= Wide.Zero) & (v1 < slow))) << lane;
        }

        return again & bounce->Struck;
    }

    /// <summary>Holds back what was struck, or lets everything take part again.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Hold(BounceLanes* bounce, bool hold)
    {
        ContactBundle* row = bounce->Row;
        Wide none = Wide.Splat(ContactBundle.NoPoint);
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            Hold(&row->Point0, &bounce->Point0, lane, none, hold);
            Hold(&row->Point1, &bounce->Point1, lane, none, hold);
        }
    }

    /// <summary>
    /// After the impacts: their impulses are noted, and let go, for they are not to be repeated. What a contact bears besides it goes on
    /// bearing: a pile in which each blow made its contacts forget their loads sank into itself.
    /// </summary>
    public static void Finish(BounceLanes* bounce)
    {
        ContactBundle* row = bounce->Row;
        for (int lane = 0; bounce->Struck >> lane != 0; lane++)
        {
            if (((bounce->Struck >> lane) & 1) != 0)
            {
                row->Struck[lane] += System.Math.Max(bounce->Point0.Pushed[lane] + bounce->Point1.Pushed[lane], float.Epsilon);
                Release(&row->Point0, &bounce->Point0, lane);
                Release(&row->Point1, &bounce->Point1, lane);
            }
        }
    }

    private static void Release(ContactPointLanes* point, BouncePointLanes* bounce, int lane)
    {
        point->Normal[lane] = System.Math.Max(point->Normal[lane] - bounce->Pushed[lane], 0);
        point->Tangent[lane] -= bounce->Rubbed[lane];
    }

    // Finite speeds only: a point that does not exist has a separation of 1e30 and must not bounce.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask HoldBack(BouncePointLanes* bounce, int lane, Wide gap, Wide v, Wide slow)
    {
        Wide.Min(gap, Wide.Zero).Store(bounce->Level + lane);
        Wide.Splat(-1f).Store(bounce->Target + lane);
        return (v < (Wide.Zero - slow)) & (gap < Wide.Splat(ContactBundle.NoPoint * 0.5f));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Mute(ContactPointLanes* point, BouncePointLanes* bounce, int lane, WideMask held)
    {
        Wide none = Wide.Splat(ContactBundle.NoPoint);
        Wide.Select(held, Wide.Load(point->Base + lane), none).Store(bounce->Base + lane);
        Wide.Select(held, none, Wide.Load(point->Base + lane)).Store(point->Base + lane);
        Wide.Zero.Store(bounce->Normal + lane);
        Wide.Zero.Store(bounce->Tangent + lane);
        Wide.Zero.Store(bounce->Pushed + lane);
        Wide.Zero.Store(bounce->Rubbed + lane);
        Wide.Keep(~held, Wide.Load(point->Normal + lane)).Store(point->Normal + lane);
        Wide.Keep(~held, Wide.Load(point->PreviousNormal + lane)).Store(point->PreviousNormal + lane);
        Wide.Keep(~held, Wide.Load(point->Tangent + lane)).Store(point->Tangent + lane);
        Wide.Keep(~held, Wide.Load(point->PreviousTangent + lane)).Store(point->PreviousTangent + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Hold(ContactPointLanes* point, BouncePointLanes* bounce, int lane, Wide none, bool hold)
    {
        Wide kept = Wide.Load(bounce->Base + lane);
        Wide now = Wide.Load(point->Base + lane);
        if (hold)
        {
            WideMask held = (Wide.Load(bounce->Target + lane) >= Wide.Zero) | (kept < none);
            Wide.Select(held, now, kept).Store(bounce->Base + lane);
            Wide.Select(held, none, now).Store(point->Base + lane);
            Lay(point->Normal + lane, bounce->Normal + lane, held);
            Lay(point->Tangent + lane, bounce->Tangent + lane, held);
        }
        else
        {
            WideMask held = kept < none;
            Wide.Select(held, kept, now).Store(point->Base + lane);
            Lay(bounce->Normal + lane, point->Normal + lane, held);
            Lay(bounce->Tangent + lane, point->Tangent + lane, held);
        }
    }

    /// <summary>Moves the impulses of the lanes that are held from one column to the other.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Lay(float* from, float* to, WideMask held)
    {
        Wide value = Wide.Load(from);
        Wide.Select(held, value, Wide.Load(to)).Store(to);
        Wide.Keep(~held, value).Store(from);
    }

    /// <summary>Speeds below this are rounding of those of the bodies: what has just been stopped does not approach.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide RoundingOf(in WideVelocity a, in WideVelocity b) =>
        Wide.Splat(Rounding) * (Wide.Abs(a.X) + Wide.Abs(a.Y) + Wide.Abs(b.X) + Wide.Abs(b.Y));

    /// <summary>
    /// The surfaces of a point have come through each other and still approach, fast, or as they did when they were held back.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask Met(BouncePointLanes* point, int lane, Wide gap, Wide v, Wide slow)
    {
        WideMask held = Wide.Load(point->Base + lane) < Wide.Splat(ContactBundle.NoPoint);
        return (gap <= Wide.Load(point->Level + lane)) & (v < Wide.Zero) & ((v < (Wide.Zero - slow)) | held);
    }

    /// <summary>
    /// When the surfaces of a point met, as seconds before the end of the substep, and how fast. The overlap at the end is a function of
    /// that time; its root is between 0 and the substep, and found by Newton's steps that are halvings where they would leave what is left
    /// of it. A lane whose time is found keeps it, whatever the others still do.
    /// </summary>
    /// <param name="moments">The bodies.</param>
    /// <param name="open">Lanes in which the surfaces met; the others have no time.</param>
    /// <param name="level">The gap at which they meet.</param>
    /// <param name="gap">The gap at the end of the substep.</param>
    /// <param name="v">The speed at which it grows there.</param>
    /// <param name="second">Of the second point.</param>
    /// <param name="substep">Its length.</param>
    /// <param name="speed">The speed at which the gap grows at that moment.</param>
    [MethodImpl(KernelMethod.Optimized)]
    private static Wide Moment(in Moments moments, WideMask open, Wide level, Wide gap, Wide v, bool second, float substep, out Wide speed)
    {
        Wide after = Wide.Zero;
        Wide before = Wide.Splat(substep);
        Wide near = Wide.Splat(Rounding * substep);
        Wide time = Wide.Zero;
        Wide beyond = gap - level;
        speed = v;
        for (int i = 1; i < MomentSteps; i++)
        {
            WideMask late = beyond < Wide.Zero;
            after = Wide.Select(late, time, after);
            before = Wide.Select(late, before, time);
            Wide next = time + (beyond / Wide.Min(speed, Wide.Splat(-float.Epsilon)));
            WideMask within = (speed < Wide.Zero) & (next >= after) & (next <= before);
            next = Wide.Select(within, next, Wide.Splat(0.5f) * (after + before));
            open = open & (Wide.Abs(next - time) > near);
            if (!WideLanes.Any(open))
            {
                break;
            }

            time = Wide.Select(open, next, time);
            moments.A.Before(time, out WideDelta movedA, out WideVelocity a);
            moments.B.Before(time, out WideDelta movedB, out WideVelocity b);
            ContactKernel.Separations(moments.Row, moments.Lane, movedA, movedB, out Wide s0, out Wide s1);
            new ImpactArms(moments.Row, moments.Lane, movedA, movedB).Velocities(a, b, out Wide v0, out Wide v1);
            beyond = (second ? s1 : s0) - level;
            speed = second ? v1 : v0;
        }

        return time;
    }

    /// <summary>
    /// An impact begins: it has no impulse yet, and a speed at which the surfaces are to part, if the point is struck: that by which they
    /// do not approach any more by the end of the substep, if what drives them on from outside has a bounce of less.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Begin(
        BounceLanes* bounce, BouncePointLanes* point, int lane, WideMask met, WideMask struck, Wide velocity, Wide end)
    {
        Wide slow = Wide.Load(bounce->Slow + lane);
        Wide speed = Wide.Max(Wide.Zero - velocity, Wide.Zero);
        Wide back = Wide.Min(Wide.Load(bounce->Row->Restitution + lane) * speed, Wide.Max(speed, Wide.Load(bounce->Most + lane)));
        Wide driven = Wide.Min(velocity - end, slow);
        Wide target = Wide.Max(Wide.Keep(speed > slow, back), driven);
        WideLanes.Replace(met, Wide.Select(struck, target, Wide.Splat(-1f)), point->Target + lane);
        WideLanes.Replace(met, Wide.Zero, point->Push + lane);
        WideLanes.Replace(met, Wide.Zero, point->Rub + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Note(ContactPointLanes* point, BouncePointLanes* bounce, int lane, Wide more, Wide push)
    {
        (Wide.Load(point->Normal + lane) + more).Store(point->Normal + lane);
        (Wide.Load(bounce->Pushed + lane) + more).Store(bounce->Pushed + lane);
        push.Store(bounce->Push + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void NoteRub(ContactPointLanes* point, BouncePointLanes* bounce, int lane, WideMask any, Wide rub, Wide change)
    {
        Wide more = Wide.Keep(any, change);
        WideLanes.Replace(any, rub, bounce->Rub + lane);
        (Wide.Load(point->Tangent + lane) + more).Store(point->Tangent + lane);
        (Wide.Load(bounce->Rubbed + lane) + more).Store(bounce->Rubbed + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideVelocity Sum(in WideVelocity v, in WideVelocity change)
    {
        WideVelocity sum;
        sum.X = v.X + change.X;
        sum.Y = v.Y + change.Y;
        sum.W = v.W + change.W;
        return sum;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideVelocity Difference(WideMask any, in WideVelocity old, in WideVelocity now)
    {
        WideVelocity change;
        change.X = Wide.Keep(any, now.X - old.X);
        change.Y = Wide.Keep(any, now.Y - old.Y);
        change.W = Wide.Keep(any, now.W - old.W);
        return change;
    }

    /// <summary>Both bodies of some contacts along their way.</summary>
    private ref struct Moments
    {
        public WideFlight A;
        public WideFlight B;
        public ContactBundle* Row;
        public int Lane;
    }
}
