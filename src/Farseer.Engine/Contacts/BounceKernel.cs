#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// Restitution at the moment of impact. Before a substep the approach speed of every point that may bounce is taken to the
/// surface, v² = v₀² - 2·a·s with the approach velocity v₀ &lt; 0, the outside acceleration a along n and the gap s; after
/// the relax pass points that took an impulse are given the speed e·v, as a 2×2 block, so that a flat box does not turn.
/// </summary>
internal static unsafe class BounceKernel
{
    /// <summary>Impacts slower than this many substeps of outside acceleration are rest, not impact.</summary>
    public const float RestSubsteps = 4f;

    /// <summary>A contact of the bundle can bounce.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Bounces(ContactBundle* row)
    {
        int bits = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            bits |= WideLanes.Bits(Wide.Load(row->Restitution + lane) > Wide.Zero);
        }

        return bits != 0;
    }

    [MethodImpl(KernelMethod.Optimized)]
    public static void Prepare(ContactBundle* bundles, byte* impacts, int count, BodyState* bodies, BodyDrive* drives, in ContactCoefficients c)
    {
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        Wide slowest = Wide.Splat(RestSubsteps);
        Wide rest = Wide.Splat(c.Rest);
        Wide threshold = Wide.Splat(c.BounceThreshold);
        for (int i = 0; i < count; i++)
        {
            ContactBundle* row = bundles + i;
            impacts[i] = 0;
            if (!Bounces(row))
            {
                continue;
            }

            int any = 0;

            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                Wide restitution = Wide.Load(row->Restitution + lane);
                ContactKernel.GatherSeparations(row, lane, bodies, out Wide s0, out Wide s1);
                BodyLanes.GatherVelocity(bodies, row->BodyA + lane, out WideVelocity a);
                BodyLanes.GatherVelocity(bodies, row->BodyB + lane, out WideVelocity b);
                ContactKernel.NormalVelocities(row, lane, a, b, out Wide v0, out Wide v1);
                BodyLanes.Gather((float*)drives, row->BodyA + lane, out Wide driveAX, out Wide driveAY, out _, out _);
                BodyLanes.Gather((float*)drives, row->BodyB + lane, out Wide driveBX, out Wide driveBY, out _, out _);
                Wide nx = Wide.Load(row->NormalX + lane);
                Wide ny = Wide.Load(row->NormalY + lane);
                Wide drive = (nx * (driveBX - driveAX)) + (ny * (driveBY - driveAY));
                Wide slow = slowest * Wide.Max(Wide.Abs((nx * driveAX) + (ny * driveAY)), Wide.Abs((nx * driveBX) + (ny * driveBY)));
                slow = Wide.Max(slow, threshold);
                Wide target0 = Target(v0, s0 - rest, drive * inverseSubstep, slow, restitution);
                Wide target1 = Target(v1, s1 - rest, drive * inverseSubstep, slow, restitution);
                target0.Store(row->Point0.Bounce + lane);
                target1.Store(row->Point1.Bounce + lane);
                any |= WideLanes.Bits((target0 > Wide.Zero) | (target1 > Wide.Zero));
            }

            impacts[i] = any != 0 ? (byte)1 : (byte)0;
        }
    }

    /// <summary>
    /// One sweep over the bundles that have an impact, as <see cref="Prepare"/> or the sweep before noted; the last one also lets go
    /// of the impulses of the points that bounced, which are not to be repeated.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Apply<TScatter>(ContactBundle* bundles, byte* impacts, int count, BodyState* bodies, bool last)
        where TScatter : struct, IVelocityScatter
    {
        for (int i = 0; i < count; i++)
        {
            if (impacts[i] == 0)
            {
                continue;
            }

            ContactBundle* row = bundles + i;
            impacts[i] = 0;
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                Wide target0 = Wide.Load(row->Point0.Bounce + lane);
                Wide target1 = Wide.Load(row->Point1.Bounce + lane);
                Wide lambda0 = Wide.Load(row->Point0.Normal + lane);
                Wide lambda1 = Wide.Load(row->Point1.Normal + lane);
                WideMask hit0 = (target0 > Wide.Zero) & (lambda0 > Wide.Zero);
                WideMask hit1 = (target1 > Wide.Zero) & (lambda1 > Wide.Zero);
                WideMask any = hit0 | hit1;
                if (WideLanes.Bits(any) == 0)
                {
                    // What is about to strike has not done so: nothing below would change, in this sweep or another.
                    continue;
                }

                impacts[i] = 1;

                target0 = Wide.Select(hit0, target0, Wide.Zero);
                target1 = Wide.Select(hit1, target1, Wide.Zero);
                BodyLanes.GatherVelocity(bodies, row->BodyA + lane, out WideVelocity a);
                BodyLanes.GatherVelocity(bodies, row->BodyB + lane, out WideVelocity b);
                BodyLanes.GatherDelta(bodies, row->BodyA + lane, out WideDelta movedA);
                BodyLanes.GatherDelta(bodies, row->BodyB + lane, out WideDelta movedB);
                ContactKernel.TurnedNormalVelocities(row, lane, a, b, movedA, movedB, out Wide v0, out Wide v1);
                ContactKernel.SolveBlock(row, lane, lambda0, lambda1, v0 - target0, v1 - target1, out Wide x0, out Wide x1);
                x0 = Wide.Select(any, x0, lambda0);
                x1 = Wide.Select(any, x1, lambda1);
                ContactKernel.ApplyNormal(row, lane, ref a, ref b, x0 - lambda0, x1 - lambda1);

                // The impact presses harder than the stop alone: friction may use all of it, so a grazing ball takes its full spin.
                ContactKernel.SolveFriction(row, lane, ref a, ref b, movedA, movedB, x0, x1, any);
                ContactKernel.StoreVelocities<TScatter>(row, lane, bodies, a, b);
                x0.Store(row->Point0.Normal + lane);
                x1.Store(row->Point1.Normal + lane);
                if (last)
                {
                    Wide blow = Wide.Max(x0 + x1, Wide.Splat(float.Epsilon));
                    Wide.Select(any, blow, Wide.Load(row->Struck + lane)).Store(row->Struck + lane);
                    Release(ref row->Point0, lane, any);
                    Release(ref row->Point1, lane, any);
                }
            }
        }
    }

    // Finite speeds only: a point that does not exist has a separation of 1e30 and must not bounce.
    private static Wide Target(Wide v, Wide s, Wide acceleration, Wide slow, Wide restitution)
    {
        Wide square = (v * v) - (Wide.Splat(2f) * (acceleration * s));
        Wide speed = Wide.Sqrt(Wide.Max(square, Wide.Zero));
        WideMask impact = (v < (Wide.Zero - slow)) & (s < Wide.Splat(ContactBundle.NoPoint * 0.5f)) & (restitution > Wide.Zero);
        return Wide.Select(impact, restitution * speed, Wide.Zero);
    }

    private static void Release(ref ContactPointLanes point, int lane, WideMask hit)
    {
        fixed (ContactPointLanes* p = &point)
        {
            Wide.Select(hit, Wide.Zero, Wide.Load(p->Normal + lane)).Store(p->Normal + lane);
            Wide.Select(hit, Wide.Zero, Wide.Load(p->PreviousNormal + lane)).Store(p->PreviousNormal + lane);
            Wide.Select(hit, Wide.Zero, Wide.Load(p->Tangent + lane)).Store(p->Tangent + lane);
            Wide.Select(hit, Wide.Zero, Wide.Load(p->PreviousTangent + lane)).Store(p->PreviousTangent + lane);
        }
    }
}
