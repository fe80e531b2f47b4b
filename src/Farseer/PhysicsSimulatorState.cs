using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// A state of a <see cref="PhysicsSimulator"/> at one moment: made by <see cref="PhysicsSimulator.Capture()"/>, gone back to by
/// <see cref="PhysicsSimulator.Restore"/> as often as wanted. It belongs to the simulator that it was captured from, and lasts
/// until it is captured anew.
/// </summary>
/// <remarks>Its memory is kept: once it has grown, capturing into it again allocates nothing.</remarks>
/// <example>
/// <code>
/// var state = new PhysicsSimulatorState();
/// simulator.Capture(state);
/// simulator.Update(1f / 60);
/// simulator.Restore(state); // as if there had been no update
/// </code>
/// </example>
public sealed class PhysicsSimulatorState
{
    /// <summary>Makes a state that holds nothing yet.</summary>
    public PhysicsSimulatorState()
    {
    }

    /// <summary>Bytes that the state takes, without references to objects and unused room; 0 if it holds nothing.</summary>
    public int ByteCount => Owner is null ? 0 : Stream.Length;

    /// <summary>Whether two captures are of the same state, bit for bit and with the same objects.</summary>
    /// <param name="other">Another one.</param>
    /// <returns>False also if <paramref name="other"/> is null.</returns>
    public bool IsSameAs(PhysicsSimulatorState? other) =>
        other is not null && ReferenceEquals(Owner, other.Owner) && (Owner is null || Stream.IsSameAs(other.Stream));

    /// <summary>From now on captures note the names of the fields, for those who look for a difference.</summary>
    internal void BeginTrace() => Stream.Trace = new System.Collections.Generic.List<(int At, int ObjectAt, string Name)>();

    internal System.Collections.Generic.IEnumerable<string> Differences(PhysicsSimulatorState other) => Stream.Differences(other.Stream);

    internal string FirstDifference(PhysicsSimulatorState other) => Stream.FirstDifference(other.Stream);

    /// <summary>Whose state it is; null while it holds nothing.</summary>
    internal PhysicsSimulator? Owner { get; set; }

    internal StateStream Stream { get; } = new StateStream();
}
