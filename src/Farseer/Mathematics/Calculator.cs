using System;
using System.Numerics;
using Farseer.Engine.Numerics;

namespace FarseerGames.FarseerPhysics.Mathematics;

/// <summary>Functions of angles, vectors and curves.</summary>
/// <remarks>
/// Angles are in radians; a positive angle turns the x axis towards the y axis. The functions of angles give the same bits on
/// every machine.
/// </remarks>
/// <example>
/// <code>
/// float turned = Calculator.VectorToRadians(new Vector2(0, 1));
/// float held = Calculator.Clamp(5, 0, 1);
/// </code>
/// </example>
public static partial class Calculator
{
    /// <summary>Degrees in a radian, 180 / pi: multiply RADIANS by it to get degrees, whatever the name says.</summary>
    public const float DegreesToRadiansRatio = 57.29578f;

    /// <summary>Radians in a degree, pi / 180: multiply DEGREES by it to get radians, whatever the name says.</summary>
    public const float RadiansToDegreesRatio = 0.017453292f;

    private static readonly Random _random = new Random();

    /// <summary>The sine.</summary>
    /// <param name="angle">The angle, in radians.</param>
    /// <returns>-1 to 1; not a number unless the angle is finite.</returns>
    public static float Sin(float angle) => StableMath.Sin(angle);

    /// <summary>The cosine.</summary>
    /// <param name="angle">The angle, in radians.</param>
    /// <returns>-1 to 1; not a number unless the angle is finite.</returns>
    public static float Cos(float angle) => StableMath.Cos(angle);

    /// <summary>The arc cosine.</summary>
    /// <param name="value">-1 to 1.</param>
    /// <returns>0 to pi; not a number for a value outside -1 to 1.</returns>
    public static float ACos(float value) =>
        (float)StableMath.Atan2(Math.Sqrt((1d - value) * (1d + value)), value);

    /// <summary>The angle of the vector (x, y) from the x axis.</summary>
    /// <param name="y">The y coordinate.</param>
    /// <param name="x">The x coordinate.</param>
    /// <returns>-pi to pi; 0 for (0, 0); not a number if a coordinate is not. The sign of a zero counts, as usual.</returns>
    public static float ATan2(float y, float x) =>
        StableMath.Atan2(y, x);

    /// <summary>Turns degrees into radians.</summary>
    /// <param name="degrees">An angle in degrees.</param>
    /// <returns>The angle in radians.</returns>
    public static float DegreesToRadians(float degrees) => degrees * RadiansToDegreesRatio;

    /// <summary>Keeps a number within a range.</summary>
    /// <param name="value">The number.</param>
    /// <param name="low">The least result; it wins if it is above <paramref name="high"/>.</param>
    /// <param name="high">The largest result.</param>
    /// <returns><paramref name="value"/>, or the nearer end of the range.</returns>
    public static float Clamp(float value, float low, float high) => Math.Max(low, Math.Min(value, high));

    /// <summary>Tells whether a number is within a range, its ends excluded.</summary>
    /// <param name="number">The number.</param>
    /// <param name="min">The lower end.</param>
    /// <param name="max">The upper end.</param>
    /// <returns>True if min &lt; number &lt; max.</returns>
    public static bool IsBetweenNonInclusive(float number, float min, float max) => number > min && number < max;

    /// <summary>A random number.</summary>
    /// <param name="min">The smallest result.</param>
    /// <param name="max">The upper end.</param>
    /// <returns>A number from <paramref name="min"/> to <paramref name="max"/>, evenly spread.</returns>
    /// <remarks>Another sequence on every run; the simulation never uses it. Safe for use by several threads.</remarks>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite, or <paramref name="max"/> is below
    /// <paramref name="min"/>.</exception>
    public static float RandomNumber(float min, float max)
    {
        Require.Finite(min, nameof(min));
        Require.Finite(max, nameof(max));
        Require.NotBelow(max, min, nameof(max));
        lock (_random)
        {
            return (float)(min + (((double)max - min) * _random.NextDouble()));
        }
    }

    /// <summary>The value at a point of a rectangle, from the values at its corners.</summary>
    /// <param name="point">The point; outside the rectangle the nearest point of it counts.</param>
    /// <param name="min">The corner with the smaller coordinates.</param>
    /// <param name="max">The corner with the larger coordinates.</param>
    /// <param name="value1">The value at (min X, min Y).</param>
    /// <param name="value2">The value at (min X, max Y).</param>
    /// <param name="value3">The value at (max X, max Y).</param>
    /// <param name="value4">The value at (max X, min Y).</param>
    /// <param name="minValue">The smallest result.</param>
    /// <param name="maxValue">The largest result.</param>
    /// <returns>The interpolated value. Along a side without length it is the value at its lower end.</returns>
    public static float BiLerp(
        Vector2 point,
        Vector2 min,
        Vector2 max,
        float value1,
        float value2,
        float value3,
        float value4,
        float minValue,
        float maxValue)
    {
        var xRatio = max.X > min.X ? (MathHelper.Clamp(point.X, min.X, max.X) - min.X) / (max.X - min.X) : 0f;
        var yRatio = max.Y > min.Y ? (MathHelper.Clamp(point.Y, min.Y, max.Y) - min.Y) / (max.Y - min.Y) : 0f;
        var low = MathHelper.Lerp(value1, value4, xRatio);
        var high = MathHelper.Lerp(value2, value3, xRatio);
        return MathHelper.Clamp(MathHelper.Lerp(low, high, yRatio), minValue, maxValue);
    }
}
