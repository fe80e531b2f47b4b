using System.Globalization;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// What <see cref="PhysicsSimulator.Inspect"/> found: a number that names the kind, the object, and what to turn. (An addition to the
/// original.)
/// </summary>
/// <example>
/// <code>
/// foreach (InspectionFinding finding in simulator.Inspect())
/// {
///     System.Console.WriteLine(finding);
/// }
/// </code>
/// </example>
public sealed class InspectionFinding
{
    internal InspectionFinding(int number, object subject, string message, string dial)
    {
        Number = number;
        Subject = subject;
        Message = message;
        Dial = dial;
    }

    /// <summary>Names the kind of finding, from 1 on: see docs/Games.md.</summary>
    public int Number { get; }

    /// <summary>The body, geom or joint that it is about.</summary>
    public object Subject { get; }

    /// <summary>What is the matter, with its numbers.</summary>
    public string Message { get; }

    /// <summary>What to change.</summary>
    public string Dial { get; }

    /// <summary>All in a line.</summary>
    /// <returns>The number, the object, the message and the dial.</returns>
    public override string ToString() =>
        string.Format(CultureInfo.InvariantCulture, "FI{0:00} {1}: {2} {3}", Number, Subject, Message, Dial);
}
