using System;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Mathematics;

/// <summary>Values at four points of the unit circle, and between them.</summary>
/// <remarks>
/// On the circle the value runs evenly with the angle from one of the four points to the next. Within it, the value runs
/// evenly along the diameter through the point; at the centre, where every diameter has its own, it is the mean of the four.
/// (Version 2.0.1 took |x - y| for the distance from the centre, so that its values jumped at the axes.)
/// </remarks>
/// <example>
/// <code>
/// var wind = new CircularInterpolator(4, 2, 0, 2, minValue: 0, maxValue: 4);
/// float fromNorthEast = wind.GetValue(new Vector2(0.7f, 0.7f));
/// </code>
/// </example>
public class CircularInterpolator
{
    private readonly float[] _values;
    private readonly float _minValue;
    private readonly float _maxValue;

    /// <summary>Makes an interpolator.</summary>
    /// <param name="value1">The value at (1, 0).</param>
    /// <param name="value2">The value at (0, 1).</param>
    /// <param name="value3">The value at (-1, 0).</param>
    /// <param name="value4">The value at (0, -1).</param>
    /// <param name="minValue">The smallest result.</param>
    /// <param name="maxValue">The largest result; not below <paramref name="minValue"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="maxValue"/> is below <paramref name="minValue"/>.</exception>
    public CircularInterpolator(float value1, float value2, float value3, float value4, float minValue, float maxValue)
    {
        _values = new[] { value1, value2, value3, value4 };
        _minValue = minValue;
        _maxValue = Require.NotBelow(maxValue, minValue, nameof(maxValue));
    }

    /// <summary>The value at a point.</summary>
    /// <param name="position">The point; outside the unit circle the line along the diameter is extended.</param>
    /// <returns>The interpolated value, within the range given to the constructor.</returns>
    public float GetValue(Vector2 position) => GetValue(position.X, position.Y);

    /// <summary>The value at a point.</summary>
    /// <param name="x">Its x coordinate.</param>
    /// <param name="y">Its y coordinate.</param>
    /// <returns>The interpolated value, within the range given to the constructor.</returns>
    public float GetValue(float x, float y)
    {
        float value;
        if (x == 0f && y == 0f)
        {
            value = (_values[0] + _values[1] + _values[2] + _values[3]) * 0.25f;
        }
        else
        {
            var quarters = Calculator.ATan2(y, x) / MathHelper.PiOver2;
            quarters = quarters < 0f ? quarters + 4f : quarters;
            var quadrant = (int)quarters;
            var part = quarters - quadrant;
            var near = MathHelper.Lerp(_values[quadrant & 3], _values[(quadrant + 1) & 3], part);
            var opposite = MathHelper.Lerp(_values[(quadrant + 2) & 3], _values[(quadrant + 3) & 3], part);
            value = MathHelper.Lerp(near, opposite, (1f - new Vector2(x, y).Length()) * 0.5f);
        }

        return MathHelper.Clamp(value, _minValue, _maxValue);
    }
}
