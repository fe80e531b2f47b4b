namespace FarseerGames.FarseerPhysics;

/// <summary>How a curve goes from a key to the next.</summary>
/// <example>
/// <code>
/// var steps = new Curve();
/// steps.Keys.Add(new CurveKey(0, 1) { Continuity = CurveContinuity.Step });
/// </code>
/// </example>
public enum CurveContinuity
{
    /// <summary>Smoothly, by the tangents of both keys.</summary>
    Smooth = 0,

    /// <summary>It keeps the value of the key until the next one.</summary>
    Step = 1,
}
