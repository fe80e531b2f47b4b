using System;
using System.Numerics;
using Farseer.Engine.Numerics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>The checks of the public members. Every message names the argument and its value.</summary>
internal static class Check
{
    public static T NotNull<T>(T? value, string name)
        where T : class =>
        value ?? throw new ArgumentNullException(name);

    public static float Finite(float value, string name) =>
        FloatBits.IsFinite(value) ? value : throw Range(name, value, "must be finite");

    public static double Finite(double value, string name) =>
        FloatBits.IsFinite(value) ? value : throw Range(name, value, "must be finite");

    public static Vector2 Finite(Vector2 value, string name) =>
        FloatBits.IsFinite(value.X) && FloatBits.IsFinite(value.Y) ? value : throw Range(name, value, "must be finite");

    /// <summary>Finite and above zero.</summary>
    public static float Positive(float value, string name) =>
        value > 0 && FloatBits.IsFinite(value) ? value : throw Range(name, value, "must be finite and above 0");

    /// <summary>Finite and not below zero.</summary>
    public static float NotNegative(float value, string name) =>
        value >= 0 && FloatBits.IsFinite(value) ? value : throw Range(name, value, "must be finite and at least 0");

    public static int AtLeast(int value, int least, string name) =>
        value >= least ? value : throw Range(name, value, "must be at least " + least.ToString(System.Globalization.CultureInfo.InvariantCulture));

    private static ArgumentOutOfRangeException Range(string name, object value, string rule) =>
        new ArgumentOutOfRangeException(name, value, name + " " + rule + ".");
}
