namespace FarseerGames.FarseerPhysics;

/// <summary>How the friction coefficients of two touching geoms are combined into the one of the pair.</summary>
/// <example>
/// <code>
/// simulator.FrictionType = FrictionType.GeometricMean;
/// </code>
/// </example>
public enum FrictionType
{
    /// <summary>The mean of the two coefficients. The default.</summary>
    Average = 0,

    /// <summary>The smaller of the two coefficients.</summary>
    Minimum = 1,

    /// <summary>The root of their product: ice is slippery for all. (An addition to the original.)</summary>
    GeometricMean = 2,

    /// <summary>The larger of the two coefficients. (An addition to the original.)</summary>
    Maximum = 3,

    /// <summary>Their product. (An addition to the original.)</summary>
    Product = 4,
}
