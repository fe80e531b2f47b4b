namespace Farseer.Engine.Numerics;

internal static unsafe partial class StableMath
{
    private const double PiLow = 1.2246467991473532e-16;
    private const double HalfPiLow = 6.123233995736766e-17;

    /// <summary>
    /// The angle of the vector (x, y) in −π … π. As in IEEE 754: the sign of a zero y chooses the side of the cut, infinite
    /// parts give multiples of π/4, and atan2(0, 0) is 0.
    /// </summary>
    public static double Atan2(double y, double x)
    {
        if (double.IsNaN(x) || double.IsNaN(y))
        {
            return double.NaN;
        }

        bool left = ToBits(x) < 0;
        bool below = ToBits(y) < 0;
        double ax = left ? -x : x;
        double ay = below ? -y : y;
        bool steep = ay > ax;
        double large = steep ? ay : ax;
        double small = steep ? ax : ay;
        double low;
        double angle = FirstOctant(small, large, out low);
        if (steep)
        {
            angle = Subtract(HalfPi, HalfPiLow, angle, ref low);
        }

        if (left)
        {
            angle = Subtract(Pi, PiLow, angle, ref low);
        }

        angle += low;
        return below ? -angle : angle;
    }

    // (high + highLow) − (angle + low), the rounding error of the difference kept in low. Exact, because high ≥ angle.
    private static double Subtract(double high, double highLow, double angle, ref double low)
    {
        double difference = high - angle;
        low = ((high - difference) - angle) + (highLow - low);
        return difference;
    }

    // atan(small / large) for 0 ≤ small ≤ large as a sum angle + low. With c = k/8 near the quotient,
    // atan q = atan c + atan((small − c·large) / (large + c·small)), whose argument is at most 1/15.
    private static double FirstOctant(double small, double large, out double low)
    {
        low = 0;
        if (small == 0)
        {
            return 0;
        }

        if (large > double.MaxValue)
        {
            small = small > double.MaxValue ? 1 : 0;
            large = 1;
        }
        else if (large > 1e300)
        {
            small *= PowerOfTwo(-100);
            large *= PowerOfTwo(-100);
        }
        else if (large < 1e-200)
        {
            small *= PowerOfTwo(600);
            large *= PowerOfTwo(600);
        }

        int k = (int)((small / large * 8) + 0.5);
        double q;
        double error = 0;
        if (k == 0)
        {
            q = small / large;
        }
        else
        {
            // k·large/8 is split so that its rounding does not reach the quotient: the upper half of large has 26 bits.
            double upper = FromBits(ToBits(large) & ~0x7FFFFFFL);
            double c = k * 0.125;
            double numerator = (small - (c * upper)) - (c * (large - upper));
            double denominator = large + (c * small);
            q = numerator / denominator;
            error = AtanLow(k);
        }

        double z = q * q;
        double series = (-1.0 / 3) + (z * ((1.0 / 5) + (z * ((-1.0 / 7) + (z * ((1.0 / 9) + (z * ((-1.0 / 11) + (z * (1.0 / 13))))))))));
        double rest = (q * z * series) + error;
        double high = AtanHigh(k);
        if (k == 0)
        {
            low = rest;
            return q;
        }

        double sum = high + q;
        low = (q - (sum - high)) + rest;
        return sum;
    }

    // atan(k/8) as a sum of two doubles.
    private static double AtanHigh(int k) => k switch
    {
        1 => 0.12435499454676144,
        2 => 0.24497866312686414,
        3 => 0.35877067027057225,
        4 => 0.4636476090008061,
        5 => 0.5585993153435624,
        6 => 0.6435011087932844,
        7 => 0.7188299996216245,
        8 => 0.7853981633974483,
        _ => 0,
    };

    private static double AtanLow(int k) => k switch
    {
        1 => -3.1253241424539383e-18,
        2 => 1.0698755618734451e-17,
        3 => -2.4623815582638635e-17,
        4 => 2.2698777452961687e-17,
        5 => -5.4556305485916264e-18,
        6 => 1.5834785051444286e-17,
        7 => -2.1478388444456983e-17,
        8 => 3.061616997868383e-17,
        _ => 0,
    };
}
