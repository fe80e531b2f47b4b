using System;

namespace Farseer.Engine.Storage;

/// <summary>A place in a <see cref="StateStream"/>.</summary>
internal struct StatePlace : IEquatable<StatePlace>
{
    /// <summary>Bytes before it.</summary>
    public int At;

    /// <summary>References before it.</summary>
    public int ObjectAt;

    public readonly bool Equals(StatePlace other) => At == other.At && ObjectAt == other.ObjectAt;
}
