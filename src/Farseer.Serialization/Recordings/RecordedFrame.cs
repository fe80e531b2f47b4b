namespace FarseerGames.FarseerPhysics.Serialization.Recordings;

/// <summary>An update of a recording.</summary>
internal sealed class RecordedFrame
{
    public float Dt { get; set; }

    /// <summary>
    /// The simulator just before the update, as a file; null: it is what the update before has left, but for <see cref="Before"/>.
    /// </summary>
    public byte[]? Keyframe { get; set; }

    /// <summary>What the program changed since the update before; null: nothing.</summary>
    public StateChange? Before { get; set; }

    /// <summary>What handlers changed in the update; null: nothing.</summary>
    public StateChange? After { get; set; }

    /// <summary>The simulator after an update in which handlers brought something new, as a file; mostly null.</summary>
    public byte[]? End { get; set; }

    /// <summary>The state after the update, and before <see cref="After"/>.</summary>
    public ulong Hash { get; set; }
}
