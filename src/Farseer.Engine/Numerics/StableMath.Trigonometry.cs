namespace Farseer.Engine.Numerics;

internal static unsafe partial class StableMath
{
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
}
