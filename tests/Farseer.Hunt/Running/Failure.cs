namespace Farseer.Hunt.Running;

/// <summary>An invariant that did not hold.</summary>
/// <param name="Kind">What failures are grouped by, and what a shorter world must show to be the same failure.</param>
/// <param name="Text">The values.</param>
/// <param name="Call">The number of the call.</param>
/// <param name="Step">Steps made before.</param>
/// <param name="Excess">How often a bound was exceeded, 1 where there is none.</param>
internal sealed record Failure(string Kind, string Text, int Call, int Step, double Excess = 1)
{
    /// <summary>
    /// A smaller world must not fall just beyond a bound, by a drag or an overlap that what was left out had prevented.
    /// </summary>
    public bool IsShownBy(Failure? other) => other is not null && other.Kind == Kind && other.Excess >= Excess / 2;
}
