using System;

namespace FarseerGames.FarseerPhysics.Mathematics;

/// <summary>Small functions and constants of mathematics.</summary>
public static class MathHelper
{
    /// <summary>Degrees in a radian, 180 / pi: multiply RADIANS by it to get degrees, whatever the name says.</summary>
    public const float DegreesToRadiansRatio = 57.29578f;

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

    /// <summary>Keeps a number within a range.</summary>
    /// <param name="value">The number.</param>
    /// <param name="min">The least result.</param>
    /// <param name="max">The greatest result; it wins if it is below <paramref name="min"/>.</param>
    /// <returns><paramref name="value"/>, or the nearer end of the range.</returns>
    public static double Clamp(double value, double min, double max)
    {
        value = value < min ? min : value;
        return value > max ? max : value;
    }

    /// <summary>Keeps a number within a range.</summary>
    /// <param name="value">The number.</param>
    /// <param name="min">The least result.</param>
    /// <param name="max">The greatest result; it wins if it is below <paramref name="min"/>.</param>
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

    /// <summary>Turns degrees into radians.</summary>
    /// <param name="degrees">An angle in degrees.</param>
    /// <returns>The angle in radians.</returns>
    public static float ToRadians(float degrees) => degrees * RadiansToDegreesRatio;
}
