using System;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

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

    /// <summary>Compares it with another state, of the same simulator or of one that was made by the same program.</summary>
    /// <remarks>
    /// To find the names of the fields the simulator goes back to both states and then to what it is now: of that nothing is left but that
    /// <see cref="PhysicsSimulator.Events"/> is empty. It is for those who look for a fault, and takes some hundred times as long as a
    /// capture.
    /// </remarks>
    /// <param name="other">The other one.</param>
    /// <param name="most">The search ends when it has found so many differences; at least 1. Default 100.</param>
    /// <returns>The differences, by body, geom, joint or pair and by field, with both values and their bits.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="other"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="other"/> holds nothing.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="most"/> is less than 1.</exception>
    /// <exception cref="InvalidOperationException">This state holds nothing, or an update runs.</exception>
    /// <exception cref="ObjectDisposedException">A simulator is disposed.</exception>
    public StateComparison Compare(PhysicsSimulatorState other, int most = 100)
    {
        Require.NotNull(other, nameof(other));
        Require.AtLeast(most, 1, nameof(most));
        if (Owner is null)
        {
            throw new InvalidOperationException("The state holds nothing.");
        }

        if (other.Owner is null)
        {
            throw new ArgumentException("The state holds nothing.", nameof(other));
        }

        return IsSameAs(other)
            ? new StateComparison([])
            : StateNames.Compare(Owner, StateNames.Named(this), StateNames.Named(other), ReferenceEquals(Owner, other.Owner), most);
    }

    /// <summary>From now on captures note the names of the fields, for those who look for a difference.</summary>
    internal void BeginTrace() => Stream.Trace = new StateTrace();

    /// <summary>Whose state it is; null while it holds nothing.</summary>
    internal PhysicsSimulator? Owner { get; set; }

    internal StateStream Stream { get; } = new StateStream();
}
