using System.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Settings;

/// <summary>How the friction coefficients of two colliders combine.</summary>
internal enum FrictionMix
{
    Average,
    Minimum,

    /// <summary>The square root of the product.</summary>
    GeometricMean,
    Maximum,
    Product,
}

/// <summary>How the restitution coefficients of two colliders combine.</summary>
internal enum RestitutionMix
{
    Average,
    Maximum,
    Minimum,
    Product,
}

/// <summary>The dials of one world. No dial carries a hidden unit of length: a scene scaled by a power of two gives scaled bits.</summary>
internal sealed class WorldSettings
{
    public const int DefaultSubsteps = 5;
    public const float DefaultAllowedPenetration = 0.05f;

    /// <summary>Acceleration of every body that does not ignore gravity, length/s². Default (0, 0).</summary>
    public Vector2 Gravity { get; set; }

    /// <summary>Substeps a step: the accuracy dial. At least 1; default 5. The error falls fourfold for each doubling.</summary>
    public int Substeps { get; set; } = DefaultSubsteps;

    /// <summary>Islands that need more substeps than the step has take them. Default true.</summary>
    public bool AdaptSubsteps { get; set; } = true;

    /// <summary>
    /// Depth at which a contact rests, a length of the scene, if <see cref="AllowedPenetrationShare"/> is not less. 0 or more; default 0.05
    /// (the original's).
    /// </summary>
    public float AllowedPenetration { get; set; } = DefaultAllowedPenetration;

    /// <summary>
    /// Share of the smaller piece's shorter side at which a contact rests at most. 0 or more; default 0: surfaces rest at each other in
    /// whatever unit the lengths of a scene are, and all that they sink in by is the sag of the solver, which falls fourfold with each
    /// doubling of the substeps. An original whose bodies rest in each other has its own.
    /// </summary>
    public float AllowedPenetrationShare { get; set; }

    /// <summary>Default average.</summary>
    public FrictionMix FrictionMix { get; set; } = FrictionMix.Average;

    /// <summary>Default average.</summary>
    public RestitutionMix RestitutionMix { get; set; } = RestitutionMix.Average;

    /// <summary>Approach slower than this does not bounce, a speed of the scene. 0 or more; default 0.</summary>
    public float BounceThreshold { get; set; }

    /// <summary>
    /// Speed up to which restitutions above 1 drive bodies on, a speed of the scene; above 0. Default infinite: as far as the body's size
    /// and the step allow.
    /// </summary>
    public float MostDrivenSpeed { get; set; } = float.PositiveInfinity;

    /// <summary>The same for spins, rad/s.</summary>
    public float MostDrivenSpin { get; set; } = float.PositiveInfinity;

    /// <summary>The friction of a pair stays what it was when the pair was made (a quirk of the original). Default false.</summary>
    public bool FreezePairFriction { get; set; }

    /// <summary>Share of a deep overlap that is removed in one step, without becoming speed. 0 to 1; default 0.8.</summary>
    public float Recovery { get; set; } = 0.8f;

    /// <summary>
    /// Contacts and joints start a step from the impulses of the one before. False: from nothing, so that each step stands for itself, and
    /// stacks sink and ropes stretch. Default true.
    /// </summary>
    public bool KeepImpulses { get; set; } = true;

    /// <summary>
    /// Overlaps are pushed out and joints that drifted apart pulled together. False: surfaces and joints only stop what would make it
    /// worse. Default true.
    /// </summary>
    public bool CorrectPositions { get; set; } = true;

    /// <summary>Bodies that move by more than their size in a step are looked after (continuous collision). Default true.</summary>
    public bool Continuous { get; set; } = true;

    /// <summary>A pair collides if only one side wants the other (a quirk of the original). Default false: both must.</summary>
    public bool OneSidedFilter { get; set; }

    /// <summary>Bodies that rest fall asleep. Default false.</summary>
    public bool AllowSleep { get; set; }

    /// <summary>A change of gravity wakes all bodies; false is a quirk of an original. Default true.</summary>
    public bool GravityWakes { get; set; } = true;

    /// <summary>Seconds that a body, and all that it is in touch with, must rest before they fall asleep. Above 0; default 0.5.</summary>
    public float TimeToSleep { get; set; } = 0.5f;

    /// <summary>
    /// A body rests as long as it stays within this share of its size. Above 0; default 2⁻¹⁴. Larger: bodies that still creep are
    /// stopped; smaller: what trembles stays awake.
    /// </summary>
    public float RestShare { get; set; } = 1f / (1 << 14);

    /// <summary>Raise separation for pairs that only overlapped with their boxes (a quirk of the original). Default false.</summary>
    public bool SeparateUntouchedPairs { get; set; }

    /// <summary>A joint still acts in the step in which it breaks (a quirk of the original). Default false.</summary>
    public bool JointsBreakLate { get; set; }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        Gravity = s.Value(Gravity);
        Substeps = s.Value(Substeps);
        AdaptSubsteps = s.Value(AdaptSubsteps);
        AllowedPenetration = s.Value(AllowedPenetration);
        AllowedPenetrationShare = s.Value(AllowedPenetrationShare);
        FrictionMix = s.Value(FrictionMix);
        RestitutionMix = s.Value(RestitutionMix);
        BounceThreshold = s.Value(BounceThreshold);
        MostDrivenSpeed = s.Value(MostDrivenSpeed);
        MostDrivenSpin = s.Value(MostDrivenSpin);
        FreezePairFriction = s.Value(FreezePairFriction);
        Recovery = s.Value(Recovery);
        KeepImpulses = s.Value(KeepImpulses);
        CorrectPositions = s.Value(CorrectPositions);
        Continuous = s.Value(Continuous);
        OneSidedFilter = s.Value(OneSidedFilter);
        AllowSleep = s.Value(AllowSleep);
        GravityWakes = s.Value(GravityWakes);
        TimeToSleep = s.Value(TimeToSleep);
        RestShare = s.Value(RestShare);
        SeparateUntouchedPairs = s.Value(SeparateUntouchedPairs);
        JointsBreakLate = s.Value(JointsBreakLate);
    }
}
