namespace FarseerGames.FarseerPhysics;

/// <summary>How a curve goes from a key to the next.</summary>
public enum CurveContinuity
{
    /// <summary>Smoothly, by the tangents of both keys.</summary>
    Smooth = 0,

    /// <summary>It keeps the value of the key until the next one.</summary>
    Step = 1,
}
