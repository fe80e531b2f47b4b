namespace Farseer.Hunt.Running;

/// <summary>An invariant that did not hold.</summary>
/// <param name="Kind">What failures are grouped by, and what a shorter world must show to be the same failure.</param>
/// <param name="Text">The values.</param>
/// <param name="Call">The number of the call.</param>
/// <param name="Step">Steps made before.</param>
internal sealed record Failure(string Kind, string Text, int Call, int Step);
