using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>Speeds at which the surfaces of the points of a bundle are to part if they meet in a substep, by Newton's rule.</summary>
internal unsafe struct ReboundSpeeds
{
    public fixed float First[ContactBundle.Lanes];
    public fixed float Second[ContactBundle.Lanes];
}

/// <summary>
/// Restitution by Newton's rule, for weak bounces in large piles: the passes of the substep stop what approaches, all of it together, and
/// afterwards contacts that they stopped part with e times their speed of approach. Held back and taken one by one
/// (<see cref="BounceKernel"/>) the impacts of such a pile do not end within a substep; what was still held back carried nothing, and the
/// pile ran through itself. A contact that pressed before is pressed, not struck, and does not bounce.
/// </summary>
internal static unsafe class ReboundKernel
{
    /// <summary>A bounce that gives back less than a quarter of the energy is weak: in a pile it is gone after the next contact.</summary>
    private const float Weak = 0.5f;

    /// <summary>Bits of the lanes whose contacts bounce weakly.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static int WeakLanes(ContactBundle* row)
    {
        int bits = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            Wide restitution = Wide.Load(row->Restitution + lane);
            bits |= WideLanes.Bits((restitution > Wide.Zero) & (restitution < Wide.Splat(Weak))) << lane;
        }

        return bits;
    }

    /// <summary>Asks for what the speeds of approach of a bundle are read from.</summary>
    public static void AskFor(ContactBundle* row)
    {
        Prefetch.Line(row->BodyA);
        Prefetch.Line(row->NormalX);
        AskFor(&row->Point0);
        AskFor(&row->Point1);
    }

    /// <summary>Bits of the lanes whose surfaces approach fast enough to bounce.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static int FastLanes(ContactBundle* row, BodyState* bodies, BodyDrive* drives, in ContactCoefficients c)
    {
        int bits = 0;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            Speeds(row, lane, bodies, drives, c, out Wide v0, out Wide v1, out Wide slow);
            bits |= WideLanes.Bits(Wide.Min(v0, v1) < slow) << lane;
        }

        return bits;
    }

    /// <summary>Contacts of these islands that bounce weakly are to do so by Newton's rule.</summary>
    /// <returns>True if there are some.</returns>
    public static bool Take(ContactBundle* row, byte* inTurmoil, int* islandOfSlot)
    {
        bool any = false;
        int weak = WeakLanes(row);
        for (int lane = 0; weak >> lane != 0; lane++)
        {
            if (((weak >> lane) & 1) != 0 && inTurmoil[islandOfSlot[row->Slot[lane]]] != 0)
            {
                row->Restitution[lane] = -row->Restitution[lane];
                any = true;
            }
        }

        return any;
    }

    /// <summary>Before a substep: notes at what speed the surfaces are to part if they meet in it.</summary>
    /// <returns>True if some approach fast enough.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool Note(ContactBundle* row, ReboundSpeeds* speeds, BodyState* bodies, BodyDrive* drives, in ContactCoefficients c)
    {
        bool any = false;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            Wide restitution = Wide.Zero - Wide.Load(row->Restitution + lane);
            Wide load = Wide.Load(row->Point0.Normal + lane) + Wide.Load(row->Point1.Normal + lane);
            WideMask can = (restitution > Wide.Zero) & (load <= Wide.Zero);
            Wide speed0 = Wide.Zero;
            Wide speed1 = Wide.Zero;
            if (WideLanes.Any(can))
            {
                Speeds(row, lane, bodies, drives, c, out Wide v0, out Wide v1, out Wide slow);
                speed0 = Wide.Keep(can & (v0 < slow), Wide.Zero - (restitution * v0));
                speed1 = Wide.Keep(can & (v1 < slow), Wide.Zero - (restitution * v1));
                any |= WideLanes.Any(Wide.Max(speed0, speed1) > Wide.Zero);
            }

            speed0.Store(speeds->First + lane);
            speed1.Store(speeds->Second + lane);
        }

        return any;
    }

    /// <summary>Asks for the impulses of a bundle.</summary>
    public static void AskForImpulses(ContactBundle* row)
    {
        Prefetch.Line(row->Point0.Normal);
        Prefetch.Line(row->Point1.Normal);
    }

    /// <summary>After the passes: whether they have stopped any of what approached.</summary>
    public static bool HaveMet(ContactBundle* row, ReboundSpeeds* speeds)
    {
        bool any = false;
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            any |= WideLanes.Any(Met(row, speeds, lane, out _, out _));
        }

        return any;
    }

    /// <summary>What they have stopped parts. The impulses are let go, for they are not to be repeated.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Part(ContactBundle* row, ReboundSpeeds* speeds, BodyState* bodies, in ContactCoefficients c)
    {
        Wide inverseSubstep = Wide.Splat(c.InverseSubstep);
        Wide rest = Wide.Splat(c.Rest);
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            Wide lambda0 = Wide.Load(row->Point0.Normal + lane);
            Wide lambda1 = Wide.Load(row->Point1.Normal + lane);
            WideMask parts = Met(row, speeds, lane, out Wide speed0, out Wide speed1);
            if (!WideLanes.Any(parts))
            {
                continue;
            }

            BodyLanes.GatherVelocities(bodies, row->BodyA + lane, row->BodyB + lane, out WideVelocity a, out WideVelocity b);
            BodyLanes.GatherDeltas(bodies, row->BodyA + lane, row->BodyB + lane, out WideDelta movedA, out WideDelta movedB);
            ContactKernel.Separations(row, lane, movedA, movedB, out Wide s0, out Wide s1);
            TurnedArms.NormalVelocities(row, lane, a, b, movedA, movedB, out Wide v0, out Wide v1);
            Wide r0 = v0 + Wide.Select(speed0 > Wide.Zero, Wide.Zero - speed0, Wide.Max(s0 - rest, Wide.Zero) * inverseSubstep);
            Wide r1 = v1 + Wide.Select(speed1 > Wide.Zero, Wide.Zero - speed1, Wide.Max(s1 - rest, Wide.Zero) * inverseSubstep);
            ContactKernel.SolveBlock(row, lane, lambda0, lambda1, r0, r1, out Wide x0, out Wide x1);
            x0 = Wide.Select(parts, x0, lambda0);
            x1 = Wide.Select(parts, x1, lambda1);
            ContactKernel.ApplyNormal(row, lane, ref a, ref b, x0 - lambda0, x1 - lambda1);
            ContactFriction.Solve(row, lane, ref a, ref b, movedA, movedB, x0, x1, parts);
            BodyLanes.ScatterVelocity(bodies, row->BodyA + lane, a);
            BodyLanes.ScatterVelocity(bodies, row->BodyB + lane, b);
            WideLanes.Replace(parts, x0 + x1, row->Struck + lane);
            Release(&row->Point0, lane, parts);
            Release(&row->Point1, lane, parts);
        }
    }

    /// <summary>Lanes of which a point approached and was stopped, and the speeds at which such points are to part.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideMask Met(ContactBundle* row, ReboundSpeeds* speeds, int lane, out Wide speed0, out Wide speed1)
    {
        speed0 = Wide.Keep(Wide.Load(row->Point0.Normal + lane) > Wide.Zero, Wide.Load(speeds->First + lane));
        speed1 = Wide.Keep(Wide.Load(row->Point1.Normal + lane) > Wide.Zero, Wide.Load(speeds->Second + lane));
        return Wide.Max(speed0, speed1) > Wide.Zero;
    }

    /// <summary>At what speeds the surfaces of the points part, and below which they strike.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Speeds(
        ContactBundle* row, int lane, BodyState* bodies, BodyDrive* drives, in ContactCoefficients c, out Wide v0, out Wide v1, out Wide slow)
    {
        BodyLanes.GatherVelocities(bodies, row->BodyA + lane, row->BodyB + lane, out WideVelocity a, out WideVelocity b);
        ContactKernel.NormalVelocities(row, lane, a, b, out v0, out v1);
        slow = Wide.Zero - BounceKernel.Slowest(row, lane, drives, c);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AskFor(ContactPointLanes* point)
    {
        Prefetch.Line(point->TangentArmA);
        Prefetch.Line(point->TangentArmB);
        Prefetch.Line(point->Normal);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Release(ContactPointLanes* point, int lane, WideMask parts)
    {
        WideLanes.Replace(parts, Wide.Zero, point->Normal + lane);
        WideLanes.Replace(parts, Wide.Zero, point->PreviousNormal + lane);
        WideLanes.Replace(parts, Wide.Zero, point->Tangent + lane);
        WideLanes.Replace(parts, Wide.Zero, point->PreviousTangent + lane);
    }
}
