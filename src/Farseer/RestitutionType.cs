namespace FarseerGames.FarseerPhysics;

/// <summary>
/// How the restitution coefficients of two touching geoms are combined into the one of the pair. (An addition to the original, which takes
/// the mean.)
/// </summary>
/// <example>
/// <code>
/// simulator.RestitutionType = RestitutionType.Maximum;
/// </code>
/// </example>
public enum RestitutionType
{
    /// <summary>The mean of the two coefficients. The default.</summary>
    Average = 0,

    /// <summary>The smaller of the two coefficients.</summary>
    Minimum = 1,

    /// <summary>The larger of the two coefficients: a ball bounces off everything.</summary>
    Maximum = 2,

    /// <summary>Their product.</summary>
    Product = 3,
}
