using System;

namespace FarseerGames.FarseerPhysics.Mathematics;

/// <summary>
/// Sine, cosine, arc tangent and arc cosine in double precision from additions, multiplications, divisions and square roots
/// alone, which round alike everywhere; <see cref="Math"/> calls the platform's own library, whose last bits differ between
/// operating systems. The error is a few units of the last place of a double, so that a result rounded to float is the
/// nearest float but for the rarest ties.
/// </summary>
internal static class StableTrigonometry
{
    // pi/2 in three parts: the first two have 33 bits each, so that their products with a quadrant number below 2^20 are exact.
    private const double HalfPi1 = 1.57079632673412561417e+00;
    private const double HalfPi2 = 6.07710050630396597660e-11;
    private const double HalfPi3 = 2.02226624879595063154e-21;
    private const double TwoOverPi = 0.63661977236758134308;
    private const double HalfPi = 1.57079632679489661923;

    /// <summary>Beyond this the quadrant number could outgrow 20 bits; whole turns are taken off first.</summary>
    private const double DirectRange = 1e6;

    public static double Sin(double angle)
    {
        var quadrant = Reduce(angle, out var rest);
        return quadrant switch
        {
            0 => SinSeries(rest),
            1 => CosSeries(rest),
            2 => -SinSeries(rest),
            _ => -CosSeries(rest),
        };
    }

    public static double Cos(double angle)
    {
        var quadrant = Reduce(angle, out var rest);
        return quadrant switch
        {
            0 => CosSeries(rest),
            1 => -SinSeries(rest),
            2 => -CosSeries(rest),
            _ => SinSeries(rest),
        };
    }

    public static double Atan2(double y, double x)
    {
        var ay = Math.Abs(y);
        var ax = Math.Abs(x);
        double angle;
        if (ax == 0d && ay == 0d)
        {
            angle = 0d;
        }
        else if (ay <= ax)
        {
            angle = AtanOfRatio(ay / ax);
        }
        else
        {
            angle = HalfPi - AtanOfRatio(ax / ay);
        }

        if (x < 0d)
        {
            angle = (2d * HalfPi) - angle;
        }

        return y < 0d ? -angle : angle;
    }

    public static double Acos(double value) => Atan2(Math.Sqrt((1d - value) * (1d + value)), value);

    /// <summary>The quadrant (0 to 3) and the rest of the angle, within a quarter of pi of 0.</summary>
    private static int Reduce(double angle, out double rest)
    {
        if (Math.Abs(angle) > DirectRange)
        {
            // The remainder of a double division is exact; what is lost is only the distance of the double from 2 pi.
            angle %= 4d * HalfPi;
        }

        var turns = Math.Floor((angle * TwoOverPi) + 0.5);
        rest = ((angle - (turns * HalfPi1)) - (turns * HalfPi2)) - (turns * HalfPi3);
        return (int)((long)turns & 3);
    }

    /// <summary>Taylor's series; at pi/4 the first term left out is below 1e-19.</summary>
    private static double SinSeries(double x)
    {
        var s = x * x;
        var sum = 1d / 355687428096000d;
        sum = (-1d / 1307674368000d) + (s * sum);
        sum = (1d / 6227020800d) + (s * sum);
        sum = (-1d / 39916800d) + (s * sum);
        sum = (1d / 362880d) + (s * sum);
        sum = (-1d / 5040d) + (s * sum);
        sum = (1d / 120d) + (s * sum);
        sum = (-1d / 6d) + (s * sum);
        return x + (x * s * sum);
    }

    private static double CosSeries(double x)
    {
        var s = x * x;
        var sum = 1d / 20922789888000d;
        sum = (-1d / 87178291200d) + (s * sum);
        sum = (1d / 479001600d) + (s * sum);
        sum = (-1d / 3628800d) + (s * sum);
        sum = (1d / 40320d) + (s * sum);
        sum = (-1d / 720d) + (s * sum);
        sum = (1d / 24d) + (s * sum);
        sum = (-1d / 2d) + (s * sum);
        return 1d + (s * sum);
    }

    /// <summary>
    /// The arc tangent of 0 to 1: the angle is halved twice, tan(a/2) = t / (1 + sqrt(1 + t^2)), which leaves t below 0.2, where
    /// the first term left out of the series is below 1e-18.
    /// </summary>
    private static double AtanOfRatio(double ratio)
    {
        var t = ratio / (1d + Math.Sqrt(1d + (ratio * ratio)));
        t /= 1d + Math.Sqrt(1d + (t * t));
        var s = t * t;
        var sum = 0d;
        for (var n = 23; n >= 3; n -= 2)
        {
            var term = (n & 2) == 0 ? 1d / n : -1d / n;
            sum = s * (term + sum);
        }

        return 4d * (t + (t * sum));
    }
}
