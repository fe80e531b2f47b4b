using System;

namespace Farseer.Engine.Storage;

/// <summary>A stable name of a record: slot index and generation. The default value names nothing.</summary>
internal readonly struct Handle : IEquatable<Handle>
{
    public Handle(int index, uint generation)
    {
        Index = index;
        Generation = generation;
    }

    public int Index { get; }

    /// <summary>At least 1 for a live record, so <c>default</c> is never valid.</summary>
    public uint Generation { get; }

    public bool IsNull => Generation == 0;

    public bool Equals(Handle other) => Index == other.Index && Generation == other.Generation;

    public override bool Equals(object? obj) => obj is Handle other && Equals(other);

    public override int GetHashCode() => (Index * 397) ^ (int)Generation;
}
