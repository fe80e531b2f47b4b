using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// Restitution at the moment of impact. A point that approaches fast enough to bounce is held back from the passes of its substep,
/// so the bodies fly on exactly and overlap at its end by what they flew too far. Then the impact is made up for: with the velocity w of
/// the pair, its acceleration a and the overlap s at the end of the substep, the surfaces met a time t before it, s - w·t + a·t²/2 = 0,
/// at the velocity w - a·t. The impulse that turns this into -e·(w - a·t), both points as a 2×2 block, changes velocities by Δ and
/// places by Δ·t. A ball is then where the reflected flight has brought it, to rounding.
/// </summary>
internal static unsafe class BounceKernel
{
    /// <summary>Impacts slower than this many substeps of outside acceleration are rest, not impact.</summary>
    public const float RestSubsteps = 4f;

    /// <summary>Sweeps over impacts of the same moment that share a body, or a tree of joints.</summary>
    public const int Sweeps = 8;

    /// <summary>Share of the substep within which impacts are at the same moment.</summary>
    public const double SameMoment = 1e-3;

    /// <summary>A contact of the bundle can bounce.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Bounces(ContactBundle* row) => BouncingLanes(row) != 0;

    /// <summary>A bit for each lane whose contact can bounce.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int BouncingLanes(ContactBundle* row)
    {
        int bits = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            bits |= WideLanes.Bits(Wide.Load(row->Restitution + lane) > Wide.Zero) << lane;
        }

        return bits;
    }

    /// <summary>The slowest approach that is an impact.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Slowest(ContactBundle* row, int lane, BodyDrive* drives, in ContactCoefficients c)
    {
        BodyLanes.Gather((float*)drives, row->BodyA + lane, (float*)drives, row->BodyB + lane, out FourColumns driveA, out FourColumns driveB);
        Wide nx = Wide.Load(row->NormalX + lane);
        Wide ny = Wide.Load(row->NormalY + lane);
        Wide fall = Wide.Max(Wide.Abs((nx * driveA.A) + (ny * driveA.B)), Wide.Abs((nx * driveB.A) + (ny * driveB.B)));
        return Wide.Max(Wide.Splat(RestSubsteps) * fall, Wide.Splat(c.BounceThreshold));
    }

    /// <summary>Before a substep: notes where surfaces are, and holds back the points that approach fast.</summary>
    /// <returns>True if there are such points.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool Prepare(BounceLanes* bounce, BodyState* bodies, BodyDrive* drives, in ContactCoefficients c)
    {
        ContactBundle* row = bounce->Row;
        Wide rest = Wide.Splat(c.Rest);
        bounce->Hits = 0;
        bounce->Struck = 0;
        bounce->Held = 0;
        bounce->Met = 0;
        bounce->Heavy = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            Wide restitution = Wide.Load(row->Restitution + lane);
            ContactKernel.GatherSeparations(row, lane, bodies, out Wide s0, out Wide s1);
            BodyLanes.GatherVelocities(bodies, row->BodyA + lane, row->BodyB + lane, out WideVelocity a, out WideVelocity b);
            ContactKernel.NormalVelocities(row, lane, a, b, out Wide v0, out Wide v1);
            Wide slow = Slowest(row, lane, drives, c);
            slow.Store(bounce->Slow + lane);
            WideMask can = restitution > Wide.Zero;
            WideMask held0 = can & HoldBack(&bounce->Point0, lane, s0 - rest, v0, slow);
            WideMask held1 = can & HoldBack(&bounce->Point1, lane, s1 - rest, v1, slow);
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
    /// <returns>A bit for each lane with an impact.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static int Find(BounceLanes* bounce, BodyState* bodies, BodyMotion* motions, in ContactCoefficients c, int lanes)
    {
        ContactBundle* row = bounce->Row;
        Wide rest = Wide.Splat(c.Rest);
        int hits = 0;
        float* wanted = stackalloc float[ContactBundle.Lanes];
        Choose(lanes, wanted);
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            BodyLanes.GatherDeltas(bodies, row->BodyA + lane, row->BodyB + lane, out WideDelta movedA, out WideDelta movedB);
            ContactKernel.Separations(row, lane, movedA, movedB, out Wide s0, out Wide s1);
            BodyLanes.GatherVelocities(bodies, row->BodyA + lane, row->BodyB + lane, out WideVelocity a, out WideVelocity b);
            TurnedArms.NormalVelocities(row, lane, a, b, movedA, movedB, out Wide v0, out Wide v1);
            Wide restitution = Wide.Keep(Wide.Load(wanted + lane) > Wide.Zero, Wide.Load(row->Restitution + lane));
            Wide slow = Wide.Load(bounce->Slow + lane);
            WideMask met = (Met(&bounce->Point0, lane, s0 - rest, v0, slow) | Met(&bounce->Point1, lane, s1 - rest, v1, slow))
                & (restitution > Wide.Zero);
            if (!WideLanes.Any(met))
            {
                continue;
            }

            WideVelocity startA = StartOf(motions, row->BodyA + lane, a, Wide.Load(row->MassA + lane) + Wide.Load(row->InertiaA + lane));
            WideVelocity startB = StartOf(motions, row->BodyB + lane, b, Wide.Load(row->MassB + lane) + Wide.Load(row->InertiaB + lane));
            TurnedArms.NormalVelocities(row, lane, startA, startB, movedA, movedB, out Wide start0, out Wide start1);
            Wide time0 = Meeting(&bounce->Point0, lane, s0 - rest, v0, v0 - start0, restitution, slow, c, out Wide target0);
            Wide time1 = Meeting(&bounce->Point1, lane, s1 - rest, v1, v1 - start1, restitution, slow, c, out Wide target1);
            Wide time = Wide.Max(time0, time1);
            WideMask hit = (time >= Wide.Zero) & (restitution > Wide.Zero);
            Wide.Select(hit, time, Wide.Load(bounce->Time + lane)).Store(bounce->Time + lane);
            Wide.Select(hit, target0, Wide.Load(bounce->Point0.Target + lane)).Store(bounce->Point0.Target + lane);
            Wide.Select(hit, target1, Wide.Load(bounce->Point1.Target + lane)).Store(bounce->Point1.Target + lane);
            hits |= WideLanes.Bits(hit) << lane;
        }

        return hits;
    }

    /// <summary>Solves the impacts of the lanes in <see cref="BounceLanes.Hits"/>.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Apply(BounceLanes* bounce, BodyState* bodies, BodyMotion* motions, in ContactCoefficients c)
    {
        ContactBundle* row = bounce->Row;
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        Wide rest = Wide.Splat(c.Rest);
        float* active = stackalloc float[ContactBundle.Lanes];
        Choose(bounce->Hits, active);

        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            WideMask any = Wide.Load(active + lane) > Wide.Zero;
            Wide target0 = Wide.Load(bounce->Point0.Target + lane);
            Wide target1 = Wide.Load(bounce->Point1.Target + lane);
            Wide lambda0 = Wide.Load(row->Point0.Normal + lane);
            Wide lambda1 = Wide.Load(row->Point1.Normal + lane);
            BodyLanes.GatherVelocities(bodies, row->BodyA + lane, row->BodyB + lane, out WideVelocity a, out WideVelocity b);
            BodyLanes.GatherDeltas(bodies, row->BodyA + lane, row->BodyB + lane, out WideDelta movedA, out WideDelta movedB);
            ContactKernel.Separations(row, lane, movedA, movedB, out Wide s0, out Wide s1);
            TurnedArms.NormalVelocities(row, lane, a, b, movedA, movedB, out Wide v0, out Wide v1);

            // A point without an impact may still come to push, but not before it touches.
            Wide r0 = v0 + Wide.Select(target0 >= Wide.Zero, Wide.Zero - target0, Wide.Max(s0 - rest, Wide.Zero) * inverseSubstep);
            Wide r1 = v1 + Wide.Select(target1 >= Wide.Zero, Wide.Zero - target1, Wide.Max(s1 - rest, Wide.Zero) * inverseSubstep);
            ContactKernel.SolveBlock(row, lane, lambda0, lambda1, r0, r1, out Wide x0, out Wide x1);
            x0 = Wide.Select(any, x0, lambda0);
            x1 = Wide.Select(any, x1, lambda1);
            WideVelocity oldA = a;
            WideVelocity oldB = b;
            ContactKernel.ApplyNormal(row, lane, ref a, ref b, x0 - lambda0, x1 - lambda1);
            ContactFriction.Solve(row, lane, ref a, ref b, movedA, movedB, x0, x1, any);
            x0.Store(row->Point0.Normal + lane);
            x1.Store(row->Point1.Normal + lane);
            Wide time = Wide.Keep(any, Wide.Load(bounce->Time + lane));
            BodyLanes.ScatterVelocity(bodies, row->BodyA + lane, a);
            CatchUp(bodies, motions, row->BodyA + lane, Change(oldA, a), movedA, time);
            BodyLanes.ScatterVelocity(bodies, row->BodyB + lane, b);
            CatchUp(bodies, motions, row->BodyB + lane, Change(oldB, b), movedB, time);
        }
    }

    /// <summary>Lanes whose surfaces approach again after their impact: something that does not bounce has stopped one of their bodies.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static int FindAgain(BounceLanes* bounce, BodyState* bodies)
    {
        ContactBundle* row = bounce->Row;
        int again = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            BodyLanes.GatherDeltas(bodies, row->BodyA + lane, row->BodyB + lane, out WideDelta movedA, out WideDelta movedB);
            BodyLanes.GatherVelocities(bodies, row->BodyA + lane, row->BodyB + lane, out WideVelocity a, out WideVelocity b);
            TurnedArms.NormalVelocities(row, lane, a, b, movedA, movedB, out Wide v0, out Wide v1);
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

    /// <summary>After the impacts: their impulses are noted, and let go, for they are not to be repeated.</summary>
    public static void Finish(BounceLanes* bounce)
    {
        ContactBundle* row = bounce->Row;
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            if (((bounce->Struck >> lane) & 1) != 0)
            {
                row->Struck[lane] = System.Math.Max(row->Point0.Normal[lane] + row->Point1.Normal[lane], float.Epsilon);
                Release(&row->Point0, lane);
                Release(&row->Point1, lane);
            }
        }
    }

    /// <summary>A 1 for each bit.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Choose(int bits, float* lanes)
    {
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            lanes[lane] = (bits >> lane) & 1;
        }
    }

    private static void Release(ContactPointLanes* point, int lane)
    {
        point->Normal[lane] = 0;
        point->PreviousNormal[lane] = 0;
        point->Tangent[lane] = 0;
        point->PreviousTangent[lane] = 0;
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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideVelocity StartOf(BodyMotion* motions, int* index, in WideVelocity now, Wide answer)
    {
        // What cannot move is not integrated: its start is of another time.
        BodyLanes.Gather((float*)motions, index, out Wide x, out Wide y, out Wide w, out _);
        WideMask moves = answer > Wide.Zero;
        WideVelocity start = now;
        start.X = Wide.Select(moves, x, now.X);
        start.Y = Wide.Select(moves, y, now.Y);
        start.W = Wide.Select(moves, w, now.W);
        return start;
    }

    /// <summary>The surfaces of a point have come through each other and still approach, fast, or as they did when they were held back.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask Met(BouncePointLanes* point, int lane, Wide gap, Wide v, Wide slow)
    {
        WideMask held = Wide.Load(point->Base + lane) < Wide.Splat(ContactBundle.NoPoint);
        return (gap <= Wide.Load(point->Level + lane)) & (v < Wide.Zero) & ((v < (Wide.Zero - slow)) | held);
    }

    /// <summary>When the surfaces of a point met, before the end of the substep; -1: they did not, or not fast.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Meeting(
        BouncePointLanes* point, int lane, Wide gap, Wide v, Wide change, Wide restitution, Wide slow, in ContactCoefficients c, out Wide target)
    {
        Wide a = change * Wide.Splat(c.InverseSubstep);
        Wide beyond = gap - Wide.Load(point->Level + lane);
        WideMask met = Met(point, lane, gap, v, slow);
        Wide speed = Wide.Sqrt(Wide.Max((v * v) - (Wide.Splat(2f) * (a * beyond)), Wide.Zero));
        Wide zero = Wide.Zero;
        Wide sum = speed - v;
        Wide time = Wide.Min(Wide.Max((Wide.Splat(-2f) * beyond) / sum, zero), Wide.Splat(c.Substep));
        Wide back = Wide.Min(restitution * speed, Wide.Max(speed, Wide.Splat(c.MostDriven)));
        back = Wide.Select(speed > slow, back, zero);
        target = Wide.Select(met, Wide.Max(back + (a * time), zero), Wide.Splat(-1f));
        return Wide.Select(met, time, Wide.Splat(-1f));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideVelocity Change(in WideVelocity old, in WideVelocity now)
    {
        WideVelocity change;
        change.X = now.X - old.X;
        change.Y = now.Y - old.Y;
        change.W = now.W - old.W;
        return change;
    }

    /// <summary>
    /// Moves bodies by what their change of velocity would have brought since the impact, and takes the change into the velocity of the
    /// substep's start, so that the next one sees the steady acceleration alone.
    /// </summary>
    /// <remarks>By value, for a local whose place is given away stays in memory; and by itself, for twice within <see cref="Apply"/> was more than the compiler takes in.</remarks>
    [MethodImpl(KernelMethod.Optimized)]
    private static void CatchUp(BodyState* bodies, BodyMotion* motions, int* index, WideVelocity change, WideDelta moved, Wide time)
    {
        WideDelta d = moved;
        d.X = d.X + (change.X * time);
        d.Y = d.Y + (change.Y * time);
        BodyLanes.Gather((float*)motions, index, out Wide startX, out Wide startY, out Wide startW, out Wide turned);
        turned = turned + (change.W * time);
        BodyLanes.Scatter((float*)motions, index, startX + change.X, startY + change.Y, startW + change.W, turned);
        Integrator.Show(turned, ref d);
        WideMask turns = Wide.Abs(change.W * time) > Wide.Zero;
        d.Sin = Wide.Select(turns, d.Sin, moved.Sin);
        d.Cos = Wide.Select(turns, d.Cos, moved.Cos);
        BodyLanes.ScatterDelta(bodies, index, d);
    }
}
