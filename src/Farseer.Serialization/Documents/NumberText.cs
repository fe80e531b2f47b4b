using System;
using System.Globalization;

namespace FarseerGames.FarseerPhysics.Serialization.Documents;

/// <summary>Numbers as JSON: the shortest digits that give the same bits. What is no number has no digits, and is a text.</summary>
internal static class NumberText
{
    public static string Of(float value)
    {
        if (float.IsNaN(value) || float.IsInfinity(value))
        {
            return Named(value);
        }

        string text = value.ToString("R", CultureInfo.InvariantCulture);
        return float.Parse(text, CultureInfo.InvariantCulture).Equals(value)
            ? Signed(text, value)
            : value.ToString("G9", CultureInfo.InvariantCulture);
    }

    public static string Of(double value)
    {
        if (double.IsNaN(value) || double.IsInfinity(value))
        {
            return Named(value);
        }

        string text = value.ToString("R", CultureInfo.InvariantCulture);
        return double.Parse(text, CultureInfo.InvariantCulture).Equals(value)
            ? Signed(text, value)
            : value.ToString("G17", CultureInfo.InvariantCulture);
    }

    public static bool TryName(string text, out double value)
    {
        value = text == "NaN" ? double.NaN : text == "Infinity" ? double.PositiveInfinity : double.NegativeInfinity;
        return text is "NaN" or "Infinity" or "-Infinity";
    }

    private static string Named(double value) => double.IsNaN(value) ? "\"NaN\"" : value > 0 ? "\"Infinity\"" : "\"-Infinity\"";

    // Old frameworks leave out the sign of -0.
    private static string Signed(string text, double value) => value == 0 && 1 / value < 0 ? "-0" : text;
}
