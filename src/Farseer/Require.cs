using System;
using System.Globalization;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// The checks of arguments at the door. Each exception names the argument, or the property that was set, and the value; nothing is
/// changed before all arguments of a call have passed.
/// </summary>
internal static class Require
{
    public static bool IsFinite(Vector2 value) => FloatBits.IsFinite(value.X) && FloatBits.IsFinite(value.Y);

    public static float Finite(float value, string name) =>
        FloatBits.IsFinite(value) ? value : throw Range(name, value, "must be a finite number");

    /// <summary>Finite also as a float: that is how it will be read back.</summary>
    public static double Finite(double value, string name) =>
        FloatBits.IsFinite((float)value) ? value : throw Range(name, value, "must be a finite number within the range of a float");

    public static Vector2 Finite(Vector2 value, string name) =>
        IsFinite(value) ? value : throw Range(name, value, "must have finite coordinates");

    /// <summary>A coordinate or angle of a body: within what the engine can compute with.</summary>
    public static double Place(double value, string name) => Place(value, value, name);

    /// <summary>As above, for a coordinate of <paramref name="shown"/>.</summary>
    public static double Place<T>(double value, T shown, string name)
        where T : struct =>
        StateRange.Holds(value, 0, 0) ? value : throw Range(name, shown, "must be finite and within ±9.2E18");

    public static Matrix4x4 Finite(Matrix4x4 value, string name)
    {
        float sum = (value.M11 * 0) + (value.M12 * 0) + (value.M13 * 0) + (value.M14 * 0)
            + (value.M21 * 0) + (value.M22 * 0) + (value.M23 * 0) + (value.M24 * 0)
            + (value.M31 * 0) + (value.M32 * 0) + (value.M33 * 0) + (value.M34 * 0)
            + (value.M41 * 0) + (value.M42 * 0) + (value.M43 * 0) + (value.M44 * 0);
        return sum == 0 ? value : throw Range(name, value, "must have finite elements");
    }

    public static float Positive(float value, string name) =>
        value > 0 && FloatBits.IsFinite(value) ? value : throw Range(name, value, "must be a finite number above 0");

    /// <summary>A mass or moment of inertia: also its inverse, which is what the solver works with, must be finite.</summary>
    public static float Invertible(float value, string name) =>
        value > 0 && FloatBits.IsFinite(value) && FloatBits.IsFinite(1 / value)
            ? value
            : throw Range(name, value, "must be a finite number above 0 with a finite inverse");

    /// <summary>A size of a shape: the engine must be able to square it.</summary>
    public static float Length(float value, string name) =>
        value >= StateRange.Least && value <= StateRange.Limit
            ? value
            : throw Range(name, value, "must be a finite number above 0, from 1.1E-19 to 9.2E18");

    /// <summary>A point of a shape, or an offset: the engine must be able to square its coordinates.</summary>
    public static Vector2 Place(Vector2 value, string name)
    {
        Place(value.X, value, name);
        Place(value.Y, value, name);
        return value;
    }

    public static float NotNegative(float value, string name) =>
        value >= 0 && FloatBits.IsFinite(value) ? value : throw Range(name, value, "must be a finite number, 0 or more");

    public static double NotNegative(double value, string name) =>
        value >= 0 && value <= float.MaxValue
            ? value
            : throw Range(name, value, "must be a finite number, 0 or more, within the range of a float");

    /// <summary>An upper bound that must not be below the lower one.</summary>
    public static float NotBelow(float value, float least, string name, string nameOfLeast) =>
        value >= least
            ? value
            : throw Range(name, value, "must not be below " + nameOfLeast + ", which is " + least.ToString(CultureInfo.InvariantCulture));

    /// <summary>A length that may be 0.</summary>
    public static float Depth(float value, string name) =>
        value >= 0 && value <= StateRange.Limit ? value : throw Range(name, value, "must be a finite number, from 0 to 9.2E18");

    public static float NotBelow(float value, float least, string name) =>
        value >= least ? value : throw Range(name, value, "must not be below " + least.ToString(CultureInfo.InvariantCulture));

    public static int AtLeast(int value, int least, string name) =>
        value >= least ? value : throw Range(name, value, "must be at least " + least.ToString(CultureInfo.InvariantCulture));

    public static int Within(int value, int least, int most, string name) =>
        value >= least && value <= most
            ? value
            : throw Range(
                name,
                value,
                "must be from " + least.ToString(CultureInfo.InvariantCulture) + " to " + most.ToString(CultureInfo.InvariantCulture));

    /// <summary>The unit vector of a direction that must have a length.</summary>
    public static Vector2 Direction(Vector2 value, string name)
    {
        double length = Math.Sqrt(((double)value.X * value.X) + ((double)value.Y * value.Y));
        return length > 0 && FloatBits.IsFinite(length)
            ? new Vector2((float)(value.X / length), (float)(value.Y / length))
            : throw Range(name, value, "must be finite and not (0, 0)");
    }

    public static T NotNull<T>(T? value, string name)
        where T : class =>
        value ?? throw new ArgumentNullException(name);

    public static ArgumentOutOfRangeException Range(string name, object value, string rule) =>
        new ArgumentOutOfRangeException(name, value, name + " " + rule + ".");
}
