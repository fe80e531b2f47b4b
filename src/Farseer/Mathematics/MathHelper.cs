using System;

namespace FarseerGames.FarseerPhysics.Mathematics;

/// <summary>Small functions and constants of mathematics.</summary>
/// <example>
/// <code>
/// float quarter = MathHelper.ToRadians(90);
/// </code>
/// </example>
public static class MathHelper
{
    /// <summary>Degrees in a radian, 180 / pi: multiply RADIANS by it to get degrees, whatever the name says.</summary>
    public const float DegreesToRadiansRatio = 57.29578f;

    /// <summary>The base of natural logarithms.</summary>
    public const float E = 2.7182817f;

    /// <summary>The logarithm of <see cref="E"/> to the base 10.</summary>
    public const float Log10E = 0.4342945f;

    /// <summary>The logarithm of <see cref="E"/> to the base 2.</summary>
    public const float Log2E = 1.442695f;

    /// <summary>Half a turn, in radians.</summary>
    public const float Pi = 3.1415927f;

    /// <summary>A quarter of a turn, in radians.</summary>
    public const float PiOver2 = 1.5707964f;

    /// <summary>An eighth of a turn, in radians.</summary>
    public const float PiOver4 = 0.7853982f;

    /// <summary>Radians in a degree, pi / 180: multiply DEGREES by it to get radians, whatever the name says.</summary>
    public const float RadiansToDegreesRatio = 0.017453292f;

    /// <summary>A whole turn, in radians.</summary>
    public const float TwoPi = 6.2831855f;

    /// <summary>One coordinate of a point of a triangle by its barycentric coordinates.</summary>
    /// <param name="value1">The coordinate of the first corner.</param>
    /// <param name="value2">The coordinate of the second corner.</param>
    /// <param name="value3">The coordinate of the third corner.</param>
    /// <param name="amount1">The weight of the second corner.</param>
    /// <param name="amount2">The weight of the third corner.</param>
    /// <returns>The coordinate of the point.</returns>
    public static float Barycentric(float value1, float value2, float value3, float amount1, float amount2) =>
        value1 + ((value2 - value1) * amount1) + ((value3 - value1) * amount2);

    /// <summary>A number of a Catmull-Rom spline between its two middle numbers.</summary>
    /// <param name="value1">The number before.</param>
    /// <param name="value2">The result for 0.</param>
    /// <param name="value3">The result for 1.</param>
    /// <param name="value4">The number after.</param>
    /// <param name="amount">The share of the way, 0 to 1.</param>
    /// <returns>The number.</returns>
    public static float CatmullRom(float value1, float value2, float value3, float value4, float amount) =>
        Hermite(value2, (value3 - value1) * 0.5f, value3, (value4 - value2) * 0.5f, amount);

    /// <summary>Keeps a number within a range.</summary>
    /// <param name="value">The number.</param>
    /// <param name="min">The smallest result.</param>
    /// <param name="max">The largest result; it wins if it is below <paramref name="min"/>.</param>
    /// <returns><paramref name="value"/>, or the nearer end of the range.</returns>
    public static double Clamp(double value, double min, double max)
    {
        value = value < min ? min : value;
        return value > max ? max : value;
    }

    /// <summary>Keeps a number within a range.</summary>
    /// <param name="value">The number.</param>
    /// <param name="min">The smallest result.</param>
    /// <param name="max">The largest result; it wins if it is below <paramref name="min"/>.</param>
    /// <returns><paramref name="value"/>, or the nearer end of the range.</returns>
    public static float Clamp(float value, float min, float max)
    {
        value = value < min ? min : value;
        return value > max ? max : value;
    }

    /// <summary>The distance between two numbers.</summary>
    /// <param name="value1">One number.</param>
    /// <param name="value2">The other number.</param>
    /// <returns>The absolute value of their difference.</returns>
    public static float Distance(float value1, float value2) => Math.Abs(value1 - value2);

    /// <summary>A number of a cubic Hermite spline.</summary>
    /// <param name="value1">The result for 0.</param>
    /// <param name="tangent1">The slope there.</param>
    /// <param name="value2">The result for 1.</param>
    /// <param name="tangent2">The slope there.</param>
    /// <param name="amount">The share of the way, 0 to 1.</param>
    /// <returns>The number.</returns>
    public static float Hermite(float value1, float tangent1, float value2, float tangent2, float amount)
    {
        float square = amount * amount;
        float cube = square * amount;
        return (value1 * ((2 * cube) - (3 * square) + 1)) + (value2 * ((3 * square) - (2 * cube)))
            + (tangent1 * (cube - (2 * square) + amount)) + (tangent2 * (cube - square));
    }

    /// <summary>A number on the way from one to another.</summary>
    /// <param name="value1">The result for 0.</param>
    /// <param name="value2">The result for 1.</param>
    /// <param name="amount">How far along; outside 0 to 1 the line is extended.</param>
    /// <returns>value1 + (value2 - value1) * amount.</returns>
    public static float Lerp(float value1, float value2, float amount) => value1 + ((value2 - value1) * amount);

    /// <summary>The greater of two numbers.</summary>
    /// <param name="value1">One number.</param>
    /// <param name="value2">The other number.</param>
    /// <returns>The greater one; not a number if either is not.</returns>
    public static float Max(float value1, float value2) => Math.Max(value1, value2);

    /// <summary>The smaller of two numbers.</summary>
    /// <param name="value1">One number.</param>
    /// <param name="value2">The other number.</param>
    /// <returns>The smaller one; not a number if either is not.</returns>
    public static float Min(float value1, float value2) => Math.Min(value1, value2);

    /// <summary>A number between two others that starts and ends at rest.</summary>
    /// <param name="value1">The result for 0.</param>
    /// <param name="value2">The result for 1.</param>
    /// <param name="amount">How far along; limited to 0 to 1.</param>
    /// <returns>The number.</returns>
    public static float SmoothStep(float value1, float value2, float amount) => Hermite(value1, 0, value2, 0, Clamp(amount, 0f, 1f));

    /// <summary>Turns radians into degrees.</summary>
    /// <param name="radians">An angle in radians.</param>
    /// <returns>The angle in degrees.</returns>
    public static float ToDegrees(float radians) => radians * DegreesToRadiansRatio;

    /// <summary>Turns degrees into radians.</summary>
    /// <param name="degrees">An angle in degrees.</param>
    /// <returns>The angle in radians.</returns>
    public static float ToRadians(float degrees) => degrees * RadiansToDegreesRatio;

    /// <summary>The same direction as an angle of less than a turn.</summary>
    /// <param name="angle">An angle in radians.</param>
    /// <returns>The angle above -pi and up to pi.</returns>
    public static float WrapAngle(float angle)
    {
        float wrapped = (float)Math.IEEERemainder(angle, TwoPi);
        return wrapped <= -Pi ? wrapped + TwoPi : wrapped;
    }
}
