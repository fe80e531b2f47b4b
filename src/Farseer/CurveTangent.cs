namespace FarseerGames.FarseerPhysics;

/// <summary>How the tangent of a key is worked out.</summary>
public enum CurveTangent
{
    /// <summary>0.</summary>
    Flat = 0,

    /// <summary>The difference to the value of the neighbour.</summary>
    Linear = 1,

    /// <summary>The slope between both neighbours.</summary>
    Smooth = 2,
}
