using System;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Mathematics;

/// <summary>Values at the four corners of a rectangle, and between them.</summary>
/// <remarks>
/// Value 1 belongs to the corner (min X, min Y), 2 to (min X, max Y), 3 to (max X, max Y) and 4 to (max X, min Y).
/// </remarks>
/// <example>
/// <code>
/// var height = new BilinearInterpolator(Vector2.Zero, Vector2.One, 0, 1, 1, 2, 0, 2);
/// float middle = height.GetValue(0.5f, 0.5f);
/// </code>
/// </example>
public class BilinearInterpolator
{
    private readonly float _value1;
    private readonly float _value2;
    private readonly float _value3;
    private readonly float _value4;
    private readonly float _minValue = float.MinValue;
    private readonly float _maxValue = float.MaxValue;

    /// <summary>Makes an interpolator of a rectangle without extent at the origin; its values are 0.</summary>
    public BilinearInterpolator()
    {
    }

    /// <summary>Makes an interpolator whose values are 0.</summary>
    /// <param name="min">See <see cref="Min"/>.</param>
    /// <param name="max">See <see cref="Max"/>.</param>
    public BilinearInterpolator(Vector2 min, Vector2 max)
    {
        Min = min;
        Max = max;
    }

    /// <summary>Makes an interpolator.</summary>
    /// <param name="min">See <see cref="Min"/>.</param>
    /// <param name="max">See <see cref="Max"/>.</param>
    /// <param name="value1">The value at (min X, min Y).</param>
    /// <param name="value2">The value at (min X, max Y).</param>
    /// <param name="value3">The value at (max X, max Y).</param>
    /// <param name="value4">The value at (max X, min Y).</param>
    /// <param name="minValue">The smallest result.</param>
    /// <param name="maxValue">The largest result; not below <paramref name="minValue"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="maxValue"/> is below <paramref name="minValue"/>.</exception>
    public BilinearInterpolator(
        Vector2 min,
        Vector2 max,
        float value1,
        float value2,
        float value3,
        float value4,
        float minValue,
        float maxValue)
        : this(min, max)
    {
        _minValue = minValue;
        _maxValue = Require.NotBelow(maxValue, minValue, nameof(maxValue));
        _value1 = value1;
        _value2 = value2;
        _value3 = value3;
        _value4 = value4;
    }

    /// <summary>The corner with the larger coordinates. Default (0, 0).</summary>
    public Vector2 Max { get; set; }

    /// <summary>The corner with the smaller coordinates. Default (0, 0).</summary>
    public Vector2 Min { get; set; }

    /// <summary>The value at a point.</summary>
    /// <param name="position">The point; outside the rectangle the nearest point of it counts.</param>
    /// <returns>The interpolated value, within the range given to the constructor.</returns>
    public float GetValue(Vector2 position) => GetValue(position.X, position.Y);

    /// <summary>The value at a point.</summary>
    /// <param name="x">Its x coordinate; outside the rectangle the nearest point of it counts.</param>
    /// <param name="y">Its y coordinate; outside the rectangle the nearest point of it counts.</param>
    /// <returns>The interpolated value, within the range given to the constructor.</returns>
    public float GetValue(float x, float y) =>
        Calculator.BiLerp(new Vector2(x, y), Min, Max, _value1, _value2, _value3, _value4, _minValue, _maxValue);
}
