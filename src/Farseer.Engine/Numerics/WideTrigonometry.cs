using System.Runtime.CompilerServices;

namespace Farseer.Engine.Numerics;

/// <summary>Sine and cosine on lanes, from plain operations only, so that all machines agree.</summary>
internal static class WideTrigonometry
{
    // Adding and subtracting 1.5·2^23 rounds a float of magnitude below 2^22 to the nearest integer, on every machine.
    private const float RoundingShift = 12582912f;
    private const float TwoOverPi = 0.636619772f;

    // π/2 in three parts whose leading ones have few bits: k·part is exact for |k| < 2^11, about 3,200 radians a step.
    private const float HalfPiHigh = 1.5703125f;
    private const float HalfPiMiddle = 4.83751296997e-4f;
    private const float HalfPiLow = 7.54978995489e-8f;

    /// <summary>Below π/4 by more than rounding: nearest to no quarter turn.</summary>
    private const float NoQuarter = 0.78f;

    /// <summary>
    /// Sine and cosine of <paramref name="angle"/> (radians). The angle is brought into [-π/4, π/4], where the odd and even
    /// polynomials are within 6e-8 of the truth; the pair is then of unit length to rounding.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void SinCos(Wide angle, out Wide sin, out Wide cos)
    {
#if NET8_0_OR_GREATER
        // Turns of one step are small as a rule: the same bits without the way there and back, which is most of the chain.
        if (WideLanes.Bits(Wide.Abs(angle) <= Wide.Splat(NoQuarter)) == (1 << Wide.Count) - 1)
        {
            Series(angle, out sin, out cos);
            return;
        }
#endif

        Wide shift = Wide.Splat(RoundingShift);
        Wide quarter = ((angle * Wide.Splat(TwoOverPi)) + shift) - shift;
        Wide x = angle - (quarter * Wide.Splat(HalfPiHigh));
        x = x - (quarter * Wide.Splat(HalfPiMiddle));
        x = x - (quarter * Wide.Splat(HalfPiLow));
        Series(x, out Wide s, out Wide c);

        // quarter modulo 4 by the same rounding trick, in {-2, -1, 0, 1, 2}: odd quarters swap, halves change signs.
        Wide turns = ((quarter * Wide.Splat(0.25f)) + shift) - shift;
        Wide q = quarter - (turns * Wide.Splat(4f));
        Wide size = Wide.Abs(q);
        WideMask odd = (size > Wide.Splat(0.5f)) & (size < Wide.Splat(1.5f));
        WideMask half = size > Wide.Splat(1.5f);
        Wide sinPart = Wide.Select(odd, c, s);
        Wide cosPart = Wide.Select(odd, s, c);
        WideMask negativeQuarter = q < Wide.Zero;
        sin = Wide.Select(half | (odd & negativeQuarter), Wide.Zero - sinPart, sinPart);
        cos = Wide.Select(half | (odd & (q > Wide.Zero)), Wide.Zero - cosPart, cosPart);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Series(Wide x, out Wide sin, out Wide cos)
    {
        Wide z = x * x;
        sin = x + (x * z * (Wide.Splat(-0.16666654611f) + (z * (Wide.Splat(8.3321608736e-3f) + (z * Wide.Splat(-1.9515295891e-4f))))));
        cos = (Wide.One - (Wide.Splat(0.5f) * z))
            + (z * z * (Wide.Splat(4.166664568298827e-2f)
                + (z * (Wide.Splat(-1.388731625493765e-3f) + (z * Wide.Splat(2.443315711809948e-5f))))));
    }
}
