using Farseer.Engine.Bodies;

namespace Farseer.Engine.Contacts;

/// <summary>The passes of a substep over contact rows.</summary>
internal enum ContactPassKind
{
    WarmStart,
    Biased,
    PushOut,
    Relax,
}

/// <summary>A pass, and what it needs besides rows.</summary>
internal unsafe struct ContactPass
{
    public ContactPassKind Kind;
    public BodyState* States;
    public ContactCoefficients Coefficients;

    /// <summary>Biased: there are contacts of deep islands. Relax: with friction.</summary>
    public bool Flag;

    /// <summary>Relax: the only sweep, or the first, of the substep.</summary>
    public bool First;

    /// <summary>PushOut: how fast overlaps go.</summary>
    public float Rate;
}
