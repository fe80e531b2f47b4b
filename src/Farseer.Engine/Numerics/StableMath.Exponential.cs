namespace Farseer.Engine.Numerics;

internal static unsafe partial class StableMath
{
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
