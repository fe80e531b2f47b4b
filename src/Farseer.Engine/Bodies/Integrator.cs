using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Bodies;

/// <summary>
/// Advances the bodies that have constraints, on lanes, one substep at a time. The list is padded to whole bundles with the
/// dummy body 0.
/// </summary>
internal static unsafe class Integrator
{
    /// <summary>
    /// Contacts see a body turned by no more than this since the foreseen middle of the step, radians. Their impulses keep the arms
    /// of that middle; beyond, the two have so little to do with each other that a pile hit by a bullet gains energy without end.
    /// </summary>
    public const float LargestTurn = 1f;
    private const double SineOfLargest = 0.8414709848078965;
    private const double CosineOfLargest = 0.5403023058681398;

    /// <summary>
    /// v ← v·keep + drive. Before that the change of the last substep is noted: where a body accelerates steadily (falls,
    /// slides, rolls) it is what <see cref="IntegratePositions"/> needs to be exact. Lane by lane of the records themselves: to turn eight
    /// of them into lanes and back took twice as long.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void IntegrateVelocities(int* list, int count, BodyState* states, BodyMotion* motions, BodyDrive* drives)
    {
        // The padding is one body again and again, each time waiting for the time before.
        while (count > 0 && list[count - 1] == 0)
        {
            count--;
        }

        for (int i = 0; i < count; i++)
        {
            var state = (Vector4*)(states + list[i]);
            var motion = (Vector4*)(motions + list[i]);
            var drive = (Vector4*)(drives + list[i]);
            Vector4 v = state[0];
            Vector4 start = motion[0];
            motion[1] = v - start;
            state[0] = (v * drive[1]) + drive[0];
            v.W = start.W;
            motion[0] = v;
        }
    }

    /// <summary>
    /// x += h·v - ½h·a·h, with a·h the smaller of the velocity changes of this substep and the last (0 if they disagree in
    /// sign). Under constant acceleration, also by friction, that is the exact x += h·(v₀ + v₁)/2: a sliding box stops
    /// within 1e-6 of v²/2μg instead of 0.1 %. In an impact the two changes disagree and the step is the plain symplectic one.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void IntegratePositions(int* list, int count, BodyState* states, BodyMotion* motions, float h)
    {
        Wide step = Wide.Splat(h);
        Wide half = Wide.Splat(0.5f);
        for (int i = 0; i < count; i += Wide.Count)
        {
            int* index = list + i;
            float* motion = (float*)motions;
            GatherMotion(states, motion, index, out WideVelocity v, out WideDelta d, out FourColumns start, out FourColumns change);
            Wide startX = start.A;
            Wide startY = start.B;
            Wide startW = start.C;
            Wide turned = start.D;
            Wide changeX = change.A;
            Wide changeY = change.B;
            Wide changeW = change.C;
            d.X = d.X + (step * (v.X - (half * SmallerChange(v.X - startX, changeX))));
            d.Y = d.Y + (step * (v.Y - (half * SmallerChange(v.Y - startY, changeY))));
            turned = turned + (step * (v.W - (half * SmallerChange(v.W - startW, changeW))));
            Show(turned, ref d);
            BodyLanes.ScatterDelta(states, index, d);
            BodyLanes.Scatter(motion, index, startX, startY, startW, turned);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void GatherMotion(
        BodyState* states, float* motion, int* index, out WideVelocity v, out WideDelta d, out FourColumns start, out FourColumns change)
    {
        if (Wide.Count <= MatrixTurn.MostLanes)
        {
            // All are turned before one is read: memory is waited for once.
            FourColumns speed;
            FourColumns moved;
            FourColumns turnedStart;
            FourColumns turnedChange;
            BodyLanes.Turn((float*)states, index, &speed);
            BodyLanes.Turn((float*)states + 4, index, &moved);
            BodyLanes.Turn(motion, index, &turnedStart);
            BodyLanes.Turn(motion + 4, index, &turnedChange);
            v = BodyLanes.AsVelocity(speed);
            d = BodyLanes.AsDelta(moved);
            start = turnedStart;
            change = turnedChange;
            return;
        }

        BodyLanes.GatherVelocity(states, index, out v);
        BodyLanes.GatherDelta(states, index, out d);
        BodyLanes.Gather(motion, index, out start.A, out start.B, out start.C, out start.D);
        BodyLanes.Gather(motion + 4, index, out change.A, out change.B, out change.C, out change.D);
    }

    /// <summary>The turn as contacts see it, of a body whose displacement is kept elsewhere.</summary>
    /// <param name="state">The body.</param>
    /// <param name="turned">Its turn since the foreseen middle of the step.</param>
    /// <param name="sin">The turn's sine.</param>
    /// <param name="cos">The turn's cosine.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Show(BodyState* state, double turned, double sin, double cos)
    {
        bool far = Math.Abs(turned) > LargestTurn;
        state->DeltaSin = (float)(far ? (turned > 0 ? SineOfLargest : -SineOfLargest) : sin);
        state->DeltaCos = (float)(far ? CosineOfLargest : cos);
    }

    /// <summary>The turn as contacts see it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Show(Wide turned, ref WideDelta d) =>
        WideTrigonometry.SinCos(Wide.Max(Wide.Splat(-LargestTurn), Wide.Min(Wide.Splat(LargestTurn), turned)), out d.Sin, out d.Cos);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide SmallerChange(Wide a, Wide b) =>
        Wide.Max(Wide.Min(a, b), Wide.Zero) + Wide.Min(Wide.Max(a, b), Wide.Zero);
}
