namespace FarseerGames.FarseerPhysics;

/// <summary>How a curve continues before its first and after its last key.</summary>
/// <example>
/// <code>
/// var wave = new Curve { PreLoop = CurveLoopType.Oscillate, PostLoop = CurveLoopType.Oscillate };
/// </code>
/// </example>
public enum CurveLoopType
{
    /// <summary>With the value of that key.</summary>
    Constant = 0,

    /// <summary>From the other end again.</summary>
    Cycle = 1,

    /// <summary>From the other end again, shifted so that it goes on without a jump.</summary>
    CycleOffset = 2,

    /// <summary>Back and forth.</summary>
    Oscillate = 3,

    /// <summary>Straight on, by the tangent of that key.</summary>
    Linear = 4,
}
