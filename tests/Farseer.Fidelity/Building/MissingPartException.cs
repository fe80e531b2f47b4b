using System;

namespace Farseer.Fidelity.Building;

/// <summary>A type, factory method or member that the scene needs and the library does not have yet.</summary>
public sealed class MissingPartException : Exception
{
    public MissingPartException(string part)
        : base(part)
    {
    }
}
