using System;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Numerics;

/// <summary>
/// Elementary functions that give the same bits on every platform, framework and build: only + − · / and bit operations,
/// in a fixed order, never fused. Library sines differ between C runtimes, so one of them in the engine would let two machines drift apart.
/// Results are within 2 units in the last place of the exact value (sine and cosine: up to |x| = 10⁵, then within 10⁻¹⁵ up to 10⁹).
/// </summary>
/// <remarks>
/// The polynomials are plain Taylor series, cut where the next term lies below the last place: reducing the argument a
/// little further costs less than minimax coefficients that nobody could check by eye.
/// </remarks>
internal static unsafe partial class StableMath
{
    public const double Pi = 3.141592653589793;
    public const double HalfPi = 1.5707963267948966;

    // Adding and subtracting 1.5·2⁵² rounds |v| < 2⁵¹ to the nearest whole number, and leaves it in the low bits.
    private const double RoundToWhole = 6755399441055744.0;

    /// <summary>The square root, correctly rounded by IEEE 754: the double root of a float rounds to the same float.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Sqrt(float value) => (float)Math.Sqrt(value);

    public static float Sin(float angle) => (float)Sin((double)angle);

    public static float Cos(float angle) => (float)Cos((double)angle);

    public static float Atan2(float y, float x) => (float)Atan2((double)y, (double)x);

    public static float Exp(float value) => (float)Exp((double)value);

    public static float Log(float value) => (float)Log((double)value);

    /// <summary>The rotation by <paramref name="angle"/> radians, each part rounded once from double.</summary>
    public static Rotation FromAngle(double angle)
    {
        SinCos(angle, out double sin, out double cos);
        return new Rotation((float)cos, (float)sin);
    }

    private static long ToBits(double value) => *(long*)&value;

    private static double FromBits(long bits) => *(double*)&bits;

    /// <summary>2 to a whole power within the normal range, −1022 … 1023.</summary>
    private static double PowerOfTwo(int exponent) => FromBits((long)(exponent + 1023) << 52);

    // π/2 in parts of 22 bits: a quadrant count of 31 bits times a part is exact in a double (Cody and Waite).
    private const double HalfPi1 = 1.570796012878418;
    private const double HalfPi2 = 3.139164164167596e-07;
    private const double HalfPi3 = 6.223371969669989e-14;
    private const double HalfPi4 = 2.0222662487959506e-21;
    private const double InverseHalfPi = 0.6366197723675814;

    // The largest argument that is reduced in one go: 2³⁰ quadrants.
    private const double DirectLimit = 1.6e9;

    // 1/n! with alternating sign.
    private const double S3 = -1.0 / 6;
    private const double S5 = 1.0 / 120;
    private const double S7 = -1.0 / 5040;
    private const double S9 = 1.0 / 362880;
    private const double S11 = -1.0 / 39916800;
    private const double S13 = 1.0 / 6227020800;
    private const double S15 = -1.0 / 1307674368000;
    private const double S17 = 1.0 / 355687428096000;
    private const double C4 = 1.0 / 24;
    private const double C6 = -1.0 / 720;
    private const double C8 = 1.0 / 40320;
    private const double C10 = -1.0 / 3628800;
    private const double C12 = 1.0 / 479001600;
    private const double C14 = -1.0 / 87178291200;
    private const double C16 = 1.0 / 20922789888000;

    public static double Sin(double angle)
    {
        SinCos(angle, out double sin, out _);
        return sin;
    }

    public static double Cos(double angle)
    {
        SinCos(angle, out _, out double cos);
        return cos;
    }

    /// <summary>
    /// Sine and cosine of an angle in radians. Beyond 1.6·10⁹ the angle is first reduced by multiples of 2π; what is left of its
    /// accuracy is about the spacing of doubles there. An angle that is not finite gives NaN.
    /// </summary>
    public static void SinCos(double angle, out double sin, out double cos)
    {
        if (!FloatBits.IsFinite(angle))
        {
            sin = double.NaN;
            cos = double.NaN;
            return;
        }

        while (angle > DirectLimit || angle < -DirectLimit)
        {
            angle = DropTurns(angle);
        }

        double shifted = (angle * InverseHalfPi) + RoundToWhole;
        double quadrants = shifted - RoundToWhole;
        int quadrant = (int)ToBits(shifted) & 3;

        // The first differences cancel exactly; what the last one rounds off is kept in tail.
        double r = (angle - (quadrants * HalfPi1)) - (quadrants * HalfPi2);
        double small = quadrants * HalfPi3;
        double r3 = r - small;
        double lost = (r - r3) - small;
        double last = (quadrants * HalfPi4) - lost;
        double reduced = r3 - last;
        double tail = (r3 - reduced) - last;

        double s = SinNearZero(reduced, tail);
        double c = CosNearZero(reduced, tail);
        switch (quadrant)
        {
            case 0:
                sin = s;
                cos = c;
                break;
            case 1:
                sin = c;
                cos = -s;
                break;
            case 2:
                sin = -s;
                cos = -c;
                break;
            default:
                sin = -c;
                cos = s;
                break;
        }
    }

    // sin(x + t) = sin x + t·cos x for |x| ≤ π/4 and t below the last place of x.
    private static double SinNearZero(double x, double t)
    {
        double z = x * x;
        double p = S5 + (z * (S7 + (z * (S9 + (z * (S11 + (z * (S13 + (z * (S15 + (z * S17)))))))))));
        double cubic = z * x;
        return x + ((cubic * (S3 + (z * p))) + (t * (1 - (0.5 * z))));
    }

    // cos(x + t) = cos x − t·sin x; 1 − x²/2 is rounded once and its error added back.
    private static double CosNearZero(double x, double t)
    {
        double z = x * x;
        double p = C4 + (z * (C6 + (z * (C8 + (z * (C10 + (z * (C12 + (z * (C14 + (z * C16)))))))))));
        double half = 0.5 * z;
        double w = 1 - half;
        return w + (((1 - w) - half) + ((z * z * p) - (t * x)));
    }

    // Subtracts k·2ⁿ·2π, which brings the angle about 29 binary places down.
    private static double DropTurns(double angle)
    {
        int exponent = (int)((ToBits(angle) >> 52) & 0x7FF) - 1023;
        double scale = PowerOfTwo(exponent - 29);
        double shifted = (angle / scale * (InverseHalfPi * 0.25)) + RoundToWhole;
        double turns = 4 * scale * (shifted - RoundToWhole);
        return (((angle - (turns * HalfPi1)) - (turns * HalfPi2)) - (turns * HalfPi3)) - (turns * HalfPi4);
    }

    private const double Ln2High = 0.6931471803691238;
    private const double Ln2Low = 1.9082149292705877e-10;
    private const double InverseLn2 = 1.4426950408889634;

    /// <summary>e to the power of <paramref name="value"/>; 0 below −745.2, infinite above 709.8.</summary>
    public static double Exp(double value)
    {
        if (double.IsNaN(value))
        {
            return value;
        }

        if (value > 709.79)
        {
            return double.PositiveInfinity;
        }

        if (value < -745.2)
        {
            return 0;
        }

        // value = k·ln 2 + r; k·Ln2High is exact.
        double shifted = (value * InverseLn2) + RoundToWhole;
        double whole = shifted - RoundToWhole;
        int k = (int)ToBits(shifted);
        double high = value - (whole * Ln2High);
        double low = whole * Ln2Low;
        double r = high - low;
        double lost = (high - r) - low;
        double p = (1.0 / 720) + (r * ((1.0 / 5040) + (r * ((1.0 / 40320) + (r * ((1.0 / 362880) + (r * ((1.0 / 3628800)
            + (r * ((1.0 / 39916800) + (r * ((1.0 / 479001600) + (r * (1.0 / 6227020800))))))))))))));
        double q = 0.5 + (r * ((1.0 / 6) + (r * ((1.0 / 24) + (r * ((1.0 / 120) + (r * p)))))));
        double result = 1 + (r + ((r * r * q) + lost));

        // In two factors, so that a denormal result is rounded once and 2¹⁰²⁴ is never formed.
        int half = k / 2;
        return result * PowerOfTwo(half) * PowerOfTwo(k - half);
    }

    /// <summary>The natural logarithm; −∞ at 0, NaN below.</summary>
    public static double Log(double value)
    {
        if (double.IsNaN(value) || value < 0)
        {
            return double.NaN;
        }

        if (value == 0)
        {
            return double.NegativeInfinity;
        }

        if (value > double.MaxValue)
        {
            return value;
        }

        int exponent = 0;
        if (value < 2.2250738585072014e-308)
        {
            value *= PowerOfTwo(54);
            exponent = -54;
        }

        long bits = ToBits(value);
        exponent += (int)(bits >> 52) - 1023;
        double m = FromBits((bits & 0xFFFFFFFFFFFFFL) | (1023L << 52));
        if (m > 1.4142135623730951)
        {
            m *= 0.5;
            exponent++;
        }

        // With s = f/(2+f): log(1+f) = 2·(s + s³/3 + s⁵/5 + …) = f − f²/2 + s·(f²/2 + R), where R = 2·(s²/3 + s⁴/5 + …).
        double f = m - 1;
        double s = f / (2 + f);
        double z = s * s;
        double tail = (2.0 / 15) + (z * ((2.0 / 17) + (z * ((2.0 / 19) + (z * ((2.0 / 21) + (z * (2.0 / 23))))))));
        double series = z * ((2.0 / 3) + (z * ((2.0 / 5) + (z * ((2.0 / 7) + (z * ((2.0 / 9) + (z * ((2.0 / 11)
            + (z * ((2.0 / 13) + (z * tail))))))))))));
        double half = 0.5 * f * f;
        return (exponent * Ln2High) - ((half - ((s * (half + series)) + (exponent * Ln2Low))) - f);
    }
}
