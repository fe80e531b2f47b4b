namespace Farseer.Engine.Contacts;

/// <summary>Constants of one substep, the same for every contact.</summary>
internal readonly struct ContactCoefficients
{
    /// <summary>Share of the velocity taken over from the substep before when impulses are extrapolated.</summary>
    public const float Extrapolation = 0.3f;

    /// <summary>Share η of the static load that the feed-forward carries: 10 times less sag. 1 lets pyramids creep.</summary>
    public const float FeedShare = 0.9f;

    // ζ = 10 and ω = 2π·(1/4)/h, so ωh = π/2 at every step length: stiffness is tied to the substep rate and the error falls
    // fourfold with each doubling of the substeps. 1/2 is unstable, 1/8 costs fourfold in error.
    private const float DampingRatio = 10f;
    private const float AngularStep = 1.57079633f;
    private const float Denominator = (2f * DampingRatio) + AngularStep;
    private const float Product = AngularStep * Denominator;

    public ContactCoefficients(float substep)
    {
        Substep = substep;
        InverseSubstep = 1f / substep;
        BiasRate = AngularStep / Denominator * InverseSubstep;
    }

    /// <summary>h, seconds.</summary>
    public float Substep { get; }

    public float InverseSubstep { get; }

    /// <summary>Speed of recovery per unit of depth, 1/s.</summary>
    public float BiasRate { get; }

    public static float MassScale => Product / (1f + Product);

    public static float ImpulseScale => 1f / (1f + Product);

    /// <summary>Static sag per unit of impulse and response: s = λ·k·h/(ωh)².</summary>
    public float Sag(float impulse, float response) => impulse * response * Substep * (1f / (AngularStep * AngularStep));
}
