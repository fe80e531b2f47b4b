using System;
using System.Globalization;
using System.Text;

namespace Farseer.Samples.Terminal;

/// <summary>What the mouse does.</summary>
internal enum MouseAction
{
    Press,
    Drag,
    Release,
}

/// <summary>An act of the left button over a character cell, counted from 0.</summary>
internal readonly record struct MouseEvent(MouseAction Action, int Column, int Row)
{
    private const int LongestReport = 24;
    private const int Moved = 32;

    /// <summary>Reads what follows the escape of a report, as terminals write it ("[&lt;button;column;row" and M or m).</summary>
    /// <param name="next">Gives the next character, or null if there is none.</param>
    /// <returns>Null if it is the report of something else.</returns>
    public static MouseEvent? Read(Func<char?> next)
    {
        StringBuilder report = new();
        while (report.Length < LongestReport && next() is char character)
        {
            report.Append(character);
            if (char.IsAsciiLetter(character))
            {
                return Parse(report.ToString());
            }
        }

        return null;
    }

    private static MouseEvent? Parse(string report)
    {
        const string Beginning = "[<";
        string[] parts = report[..^1].TrimStart('[', '<').Split(';');
        Span<int> numbers = stackalloc int[3];
        if (!report.StartsWith(Beginning, StringComparison.Ordinal) || report[^1] is not ('M' or 'm') || parts.Length != numbers.Length)
        {
            return null;
        }

        for (int i = 0; i < numbers.Length; i++)
        {
            if (!int.TryParse(parts[i], NumberStyles.None, CultureInfo.InvariantCulture, out numbers[i]))
            {
                return null;
            }
        }

        return (numbers[0] & ~Moved) != 0
            ? null
            : new MouseEvent(
                report[^1] == 'm' ? MouseAction.Release : (numbers[0] & Moved) != 0 ? MouseAction.Drag : MouseAction.Press,
                numbers[1] - 1,
                numbers[2] - 1);
    }
}
