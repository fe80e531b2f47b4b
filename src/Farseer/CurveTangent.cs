namespace FarseerGames.FarseerPhysics;

/// <summary>How the tangent of a key is worked out.</summary>
/// <example>
/// <code>
/// var track = new Curve();
/// track.Keys.Add(new CurveKey(0, 0));
/// track.Keys.Add(new CurveKey(1, 2));
/// track.ComputeTangents(CurveTangent.Smooth);
/// </code>
/// </example>
public enum CurveTangent
{
    /// <summary>0.</summary>
    Flat = 0,

    /// <summary>The difference to the value of the neighbour.</summary>
    Linear = 1,

    /// <summary>The slope between both neighbours.</summary>
    Smooth = 2,
}
