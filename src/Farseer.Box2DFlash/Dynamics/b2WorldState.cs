using System.Collections.Generic;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics;

/// <summary>
/// A state of a <see cref="b2World"/> at one moment: made by <see cref="b2World.Capture()"/>, gone back to by
/// <see cref="b2World.Restore"/> as often as wanted. It belongs to the world that it was captured from, and lasts until it is
/// captured anew.
/// </summary>
/// <remarks>Its memory is kept: once it has grown, capturing into it again allocates nothing.</remarks>
/// <example>
/// <code>
/// var state = new b2WorldState();
/// world.Capture(state);
/// world.Step(1f / 60, 10);
/// world.Restore(state); // as if there had been no step
/// </code>
/// </example>
public sealed class b2WorldState
{
    /// <summary>Makes a state that holds nothing yet.</summary>
    public b2WorldState()
    {
    }

    /// <summary>Bytes that the state takes, without references to objects and unused room; 0 if it holds nothing.</summary>
    public int ByteCount => Owner is null ? 0 : Stream.Length;

    internal b2World? Owner { get; set; }

    internal StateStream Stream { get; } = new StateStream();

    /// <summary>Whether two captures are of the same state, bit for bit and with the same objects.</summary>
    /// <param name="other">Another one.</param>
    /// <returns>False also if <paramref name="other"/> is null.</returns>
    public bool IsSameAs(b2WorldState? other) =>
        other is not null && ReferenceEquals(Owner, other.Owner) && (Owner is null || Stream.IsSameAs(other.Stream));

    /// <summary>From now on captures note the names of the fields, for those who look for a difference.</summary>
    internal void BeginTrace() => Stream.Trace = new List<(int At, int ObjectAt, string Name)>();

    internal IEnumerable<string> Differences(b2WorldState other) => Stream.Differences(other.Stream);

    internal string FirstDifference(b2WorldState other) => Stream.FirstDifference(other.Stream);
}
