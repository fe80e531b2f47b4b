namespace FarseerGames.FarseerPhysics;

/// <summary>How the friction coefficients of two touching geoms are combined into the one of the pair.</summary>
public enum FrictionType
{
    /// <summary>The mean of the two coefficients. The default.</summary>
    Average = 0,

    /// <summary>The smaller of the two coefficients.</summary>
    Minimum = 1,
}
