using System;
using System.Globalization;
using Box2D.Common.Math;
using Farseer.Engine.Bodies;

namespace Box2D.Bridge;

/// <summary>Checks at the door: each throws with the name and the value, before anything has changed.</summary>
internal static class Require
{
    public static T NotNull<T>(T? value, string name)
        where T : class => value ?? throw new ArgumentNullException(name);

    public static float Finite(float value, string name) =>
        b2Math.b2IsValid(value) ? value : throw Outside(value, name, "must be finite");

    public static float NotNegative(float value, string name) =>
        b2Math.b2IsValid(value) && value >= 0 ? value : throw Outside(value, name, "must be finite and at least 0");

    public static float Positive(float value, string name) =>
        b2Math.b2IsValid(value) && value > 0 ? value : throw Outside(value, name, "must be finite and above 0");

    /// <summary>A size of a shape: the engine must be able to square it.</summary>
    public static float Length(float value, string name) =>
        value >= StateRange.Least && value <= StateRange.Limit
            ? value
            : throw Outside(value, name, "must be above 0, from 1.1E-19 to 9.2E18");

    /// <summary>An angle or an angular velocity that the engine can hold.</summary>
    public static float Turn(float value, string name) =>
        StateRange.Holds(value, 0, 0) ? value : throw Outside(value, name, "must be finite and within ±9.2E18");

    /// <summary>A mass or an inertia: the solver works with its inverse. 0 stands for none.</summary>
    public static float Mass(float value, string name) =>
        IsMass(value) ? value : throw Outside(value, name, "must be 0, or finite and above 0 with a finite inverse");

    public static bool IsMass(float value) => value == 0 || (value > 0 && b2Math.b2IsValid(value) && b2Math.b2IsValid(1 / value));

    public static int Positive(int value, string name) =>
        value > 0 ? value : throw new ArgumentOutOfRangeException(name, value, "The value must be above 0.");

    public static int NotNegative(int value, string name) =>
        value >= 0 ? value : throw new ArgumentOutOfRangeException(name, value, "The value must be at least 0.");

    /// <summary>Not null, and a place or velocity that the engine can hold.</summary>
    public static b2Vec2 Vector(b2Vec2? value, string name)
    {
        NotNull(value, name);
        return value!.IsValid() && StateRange.Holds(value.x, value.y, 0)
            ? value
            : throw new ArgumentOutOfRangeException(name, value, "Both components must be finite and in the range of the engine.");
    }

    public static float[] Room(float[]? value, string name) =>
        NotNull(value, name).Length > 0 ? value! : throw new ArgumentException("The array must have room for a number.", name);

    private static ArgumentOutOfRangeException Outside(float value, string name, string rule) =>
        new ArgumentOutOfRangeException(name, value, "The value " + value.ToString(CultureInfo.InvariantCulture) + " " + rule + ".");
}
