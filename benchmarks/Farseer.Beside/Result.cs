using System.Collections.Generic;

namespace Farseer.Beside;

/// <summary>What a build told in one part.</summary>
/// <param name="Items">What it measured.</param>
/// <param name="Fault">Why there is nothing; empty if there is.</param>
internal sealed record Reading<T>(IReadOnlyList<T> Items, string Fault);

/// <summary>A part of both builds.</summary>
/// <param name="Name">Of the part.</param>
/// <param name="FaultBefore">Why the earlier build told nothing; empty if it did.</param>
/// <param name="FaultAfter">The same of the later build.</param>
/// <param name="Figures">Null if it is a part of times, or a build told nothing.</param>
/// <param name="Times">Null if it is a part of figures, or a build told nothing.</param>
internal sealed record Result(string Name, string FaultBefore, string FaultAfter, FigureComparison? Figures, TimeComparison? Times)
{
    /// <summary>It was there before and is no longer.</summary>
    public bool HasEnded => FaultBefore.Length == 0 && FaultAfter.Length > 0;

    public static Result Of(Part part, Reading<Figure> before, Reading<Figure> after) => new(
        part.Name,
        before.Fault,
        after.Fault,
        AreThere(before, after) ? new FigureComparison(before.Items, after.Items, part.Kind == PartKind.Draws) : null,
        null);

    public static Result Of(Part part, Reading<Timing> before, Reading<Timing> after) => new(
        part.Name,
        before.Fault,
        after.Fault,
        null,
        AreThere(before, after) ? new TimeComparison(before.Items, after.Items) : null);

    private static bool AreThere<T>(Reading<T> before, Reading<T> after) => before.Fault.Length + after.Fault.Length == 0;
}
