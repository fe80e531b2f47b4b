using System;

namespace Farseer.Engine.Storage;

/// <summary>Why a world goes on the same without something.</summary>
internal enum Why
{
    /// <summary>It is filled before it is read, in each step or call.</summary>
    OfOneStep,

    /// <summary>It is given before each use, or once and for all, and visited where it belongs.</summary>
    Elsewhere,

    /// <summary>It says how much memory there is, or keeps some for later.</summary>
    Room,

    /// <summary>It says how steps are run: workers, measured times, tuning. Nothing that is computed depends on it.</summary>
    Running,

    /// <summary>It is the user's own.</summary>
    Users,

    /// <summary>It is worked out from what is visited, and anew after reading.</summary>
    Derived,

    /// <summary>It is always the same between steps, and only there are states taken and gone back to.</summary>
    Calm,

    /// <summary>It never changes once it is made.</summary>
    Fixed,
}

/// <summary>
/// On a field, property or type that lives from step to step and that no method with a <see cref="StateStream"/> visits. A test
/// asks for one of the two.
/// </summary>
[AttributeUsage(AttributeTargets.Field | AttributeTargets.Property | AttributeTargets.Class | AttributeTargets.Struct)]
internal sealed class NotStateAttribute : Attribute
{
    public NotStateAttribute(Why why) => Why = why;

    public Why Why { get; }
}
