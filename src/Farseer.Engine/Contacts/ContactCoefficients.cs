namespace Farseer.Engine.Contacts;

/// <summary>Constants of one substep, the same for every contact.</summary>
internal readonly struct ContactCoefficients
{
    /// <summary>Share of the velocity taken over from the substep before when impulses are extrapolated.</summary>
    public const float Extrapolation = 0.3f;

    /// <summary>
    /// How many times the impulse of the substep before, and the weight, a warm start may apply at most. After an impact it
    /// would repeat the blow: bodies in a row are thrown apart again although nothing bounces.
    /// </summary>
    public const float LargestGrowth = 4f;

    /// <summary>
    /// The same where nothing weighs anything, and no weight tells a load from a blow: there what grew is not taken further, so that no
    /// blow is repeated, and what fell is by all of its fall, so that one dies out. A load that lasts is started from whole.
    /// </summary>
    private const float WeightlessRise = 0f;
    private const float WeightlessFall = 1f;

    /// <summary>
    /// Times the feed-forward that a load grows with a longer substep at most. The heavier point of a box that is about to slide with a
    /// friction of 0.6 bears four times what the other does.
    /// </summary>
    public const float LoadInFeeds = 4f;

    /// <summary>
    /// Share of its lesser point's load that a contact gives up to sink to the depth of rest. If it gave up all, nothing would hold
    /// against friction meanwhile, and a sliding box would tilt. What is given up in a substep moves it by that share of g·h²: in a shorter
    /// one a larger share tilts it no further, and with the same share it would sink the slower, the finer the substeps are.
    /// </summary>
    private const float UsualSettleShare = 0.25f;
    private const float MostSettleShare = 0.75f;

    /// <summary>Rest 1 - η of the static load that the feed-forward leaves: 10 times less sag. 0 lets pyramids creep.</summary>
    public const float FeedRest = 0.1f;
    public const float SmallestFeedRest = 1e-4f;

    /// <summary>
    /// Size in units of the fall g·h² in the usual substep from which on a piece is large: the sag is in proportion to g·h² whatever the
    /// size, so for smaller pieces the rest shrinks with the size, and a box of 1 cm rests as truly, for its size, as one of 1 m.
    /// </summary>
    private const float LargeSize = 8000f;

    // ζ = 10 and ω = 2π·(1/4)/h, so ωh = π/2 at every step length: stiffness is tied to the substep rate and the error falls
    // fourfold with each doubling of the substeps. 1/2 is unstable, 1/8 costs fourfold in error.
    private const float DampingRatio = 10f;
    private const float AngularStep = 1.57079633f;

    /// <summary>Share of a depth that a substep takes back.</summary>
    public const float RecoveryShare = AngularStep / ((2f * DampingRatio) + AngularStep);

    /// <param name="substep">h, seconds.</param>
    /// <param name="gravity">Length of the gravity vector.</param>
    /// <param name="bounceThreshold">Approach slower than this does not bounce.</param>
    /// <param name="coarseness">
    /// How many times as long as usual the substep is against the step. For small pieces the sag is in proportion to their size, whatever
    /// the step; by the usual substep their rest is the same at every finer dial, and the sag falls fourfold with each doubling of the
    /// substeps. In longer substeps the rest is less, so that the sag only grows with their length.
    /// </param>
    /// <param name="recovery">The substep at whose rate depths go, if it is longer than h.</param>
    /// <param name="driven">How far restitutions above 1 drive.</param>
    public ContactCoefficients(
        float substep,
        float gravity,
        float bounceThreshold,
        float coarseness = 1f,
        float recovery = 0f,
        DrivenBound driven = default)
    {
        Driven = driven;
        SettleShare = System.Math.Min(UsualSettleShare / coarseness, MostSettleShare);
        Gravity = gravity;
        RiseTaken = gravity > 0 ? Extrapolation : WeightlessRise;
        FallTaken = gravity > 0 ? Extrapolation : WeightlessFall;
        LeastKept = gravity > 0 ? 0f : float.MaxValue;
        BounceThreshold = bounceThreshold;
        Substep = substep;
        InverseSubstep = 1f / substep;

        // A contact is as stiff as in the longest substep of late, and in a shorter one moves less: it rests at the same depth in each.
        float longest = System.Math.Max(substep, recovery);

        // Without gravity nothing sinks; a finite number keeps lanes without a piece, of size 0, at 0.
        float usual = longest / coarseness;
        Smallness = System.Math.Min(1f / (LargeSize * gravity * usual * System.Math.Max(usual, longest)), float.MaxValue);
        ErrorScale = substep / longest;
        float angular = AngularStep * ErrorScale;
        float denominator = (2f * DampingRatio) + angular;
        float product = angular * denominator;
        BiasRate = AngularStep / denominator * (1f / longest);
        MassScale = product / (1f + product);
        ImpulseScale = 1f / (1f + product);
        SagShare = 1f / (angular * angular);
    }

    /// <summary>Some row has a surface far from its body: see <see cref="FarSurfaces"/>.</summary>
    public bool AnyFar { get; init; }

    /// <summary>1/length: the share of the rest that a piece of some size has is the size times that, at most 1.</summary>
    public float Smallness { get; }

    /// <summary>Share of its load that a contact gives up to sink: see <see cref="UsualSettleShare"/>.</summary>
    public float SettleShare { get; }

    /// <summary>h, seconds.</summary>
    public float Substep { get; }

    public float Gravity { get; }

    /// <summary>Approach slower than this does not bounce.</summary>
    public float BounceThreshold { get; }

    /// <summary>Up to which speed a restitution above 1 makes a rebound faster than its approach.</summary>
    public DrivenBound Driven { get; }

    /// <summary>Share of a rise of its impulse that a contact starts a substep with.</summary>
    public float RiseTaken { get; }

    /// <summary>The same of a fall.</summary>
    public float FallTaken { get; }

    /// <summary>
    /// What is kept of an impulse, at least, as the one before, whatever it grew from. A blow is taken for a load when it has lasted for as
    /// many substeps as it takes the weight to grow to it; where there is no weight nothing would ever be one, and every substep began from
    /// nothing: after two.
    /// </summary>
    public float LeastKept { get; }

    public float InverseSubstep { get; }

    /// <summary>The substep in terms of the longest of late, at whose pace errors go; at most 1.</summary>
    public float ErrorScale { get; }

    /// <summary>Speed of recovery per unit of depth, 1/s.</summary>
    public float BiasRate { get; }

    public float MassScale { get; }

    public float ImpulseScale { get; }

    /// <summary>1 - η for a contact whose smaller piece has the size <paramref name="size"/>.</summary>
    public float FeedRestOf(float size) => System.Math.Max(FeedRest * System.Math.Min(size * Smallness, 1f), SmallestFeedRest);

    /// <summary>1/(ωh)².</summary>
    public float SagShare { get; }

    /// <summary>Static sag per unit of speed held up, λ·k: s = λ·k·h/(ωh)².</summary>
    public float Sag(float load) => load * Substep * SagShare;
}
