using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>
/// How far arms are turned along to find speeds with, while impulses act at those of the step's middle. For an impulse of 1 at an arm a a
/// speed found with a', turned by φ, changes by k' = m + i·a·a' and not by K = m + i·a², so a sweep leaves 1 - k'/K of an error. For boxes
/// and rods (i·r² up to 3 m) k' is negative from φ = 71° on: the answer has the wrong sign, and what is jammed multiplied its impulses
/// tenfold a substep. Up to 26° k'/K lies between 0.63 and 1.29.
/// </summary>
internal static unsafe class TurnedArms
{
    /// <summary>
    /// Cosine of the largest turn from the step's middle, 0.45 rad: what spins at 54 rad/s at 60 steps a second gets as far.
    /// </summary>
    private const float LeastCosine = 0.9f;

    public const float LargestSine = 0.43588989f;

    /// <summary>
    /// The displacement with a turn no larger than that. (A turn as contacts see it is at most a radian, where sines grow with it.) A
    /// smaller one is left as it is to the last bit, since stages ask for many lanes at once whether some are larger.
    /// </summary>
    /// <param name="moved">The displacement.</param>
    /// <param name="most">The sine of the largest turn: of <see cref="FarSurfaces"/> less than of others.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDelta Limited(in WideDelta moved, Wide most)
    {
        WideMask far = most < Wide.Splat(LargestSine);
        WideMask beyond = Wide.Select(far, Wide.Max(moved.Sin, Wide.Zero - moved.Sin), Wide.Splat(LeastCosine))
            > Wide.Select(far, most, moved.Cos);
        Wide sine = Wide.Max(Wide.Zero - most, Wide.Min(most, moved.Sin));
        Wide cosine = Wide.Select(far, Wide.Sqrt(Wide.One - (sine * sine)), Wide.Splat(LeastCosine));
        WideDelta limited = moved;
        limited.Sin = Wide.Select(beyond, sine, moved.Sin);
        limited.Cos = Wide.Select(beyond, cosine, moved.Cos);
        return limited;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask IsBeyond(Wide cos) => cos < Wide.Splat(LeastCosine);

    /// <summary>Lanes where neither body has turned further than that.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask AreWithin(in WideDelta a, in WideDelta b) => Wide.Min(a.Cos, b.Cos) >= Wide.Splat(LeastCosine);

    /// <summary>Normal arms of a point, turned along: of gaps and of friction.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Normal(ContactPointLanes* p, int lane, in WideDelta a, in WideDelta b, out Wide turnedA, out Wide turnedB)
    {
        turnedB = (b.Cos * Wide.Load(p->NormalArmB + lane)) + (b.Sin * Wide.Load(p->TangentArmB + lane));
        turnedA = (a.Cos * Wide.Load(p->NormalArmA + lane)) + (a.Sin * Wide.Load(p->TangentArmA + lane));
    }
}
