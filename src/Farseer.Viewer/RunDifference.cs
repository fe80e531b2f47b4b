using System;
using System.Globalization;

namespace FarseerGames.FarseerPhysics.Viewer;

/// <summary>The first thing in which two recordings differ: see <see cref="RunRecorder.Compare"/>.</summary>
/// <example>
/// <code>
/// if (RunRecorder.Compare(first, second) is { } difference)
/// {
///     Console.WriteLine(difference); // update 31, body 4 (ball), vy: -2.5 and -2.50000024
/// }
/// </code>
/// </example>
public sealed class RunDifference
{
    internal RunDifference(int frame, string subject, int index, string? name, string field, double first, double second)
    {
        Frame = frame;
        Subject = subject;
        Index = index;
        Name = name;
        Field = field;
        First = first;
        Second = second;
    }

    /// <summary>The frame that differs first; 0 is the first one recorded.</summary>
    public int Frame { get; }

    /// <summary>"body", "joint", "spring" or "run".</summary>
    public string Subject { get; }

    /// <summary>Which body, joint or spring, in the order in which they were recorded first; -1 for the whole run.</summary>
    public int Index { get; }

    /// <summary>Its name; null if it has none.</summary>
    public string? Name { get; }

    /// <summary>The field, for example "x", "angle", "vy", "error", "flags"; of the whole run "frames", "bodies" or "hash".</summary>
    public string Field { get; }

    /// <summary>Its value in the first recording.</summary>
    public double First { get; }

    /// <summary>Its value in the second one.</summary>
    public double Second { get; }

    /// <summary>The update, the thing, its field, and both values.</summary>
    /// <returns>A line of text.</returns>
    public override string ToString()
    {
        string thing = Index < 0 ? Subject : Subject + " " + Index.ToString(CultureInfo.InvariantCulture);
        string named = Name is null ? thing : thing + " (" + Name + ")";
        return FormattableString.Invariant($"update {Frame + 1}, {named}, {Field}: {First:R} and {Second:R}");
    }
}
