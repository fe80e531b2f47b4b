using System;
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

    /// <summary>Compares it with another state, of the same world or of one that was made by the same program.</summary>
    /// <remarks>
    /// To find the names of the fields the world goes back to both states and then to what it is now. It is for those who look for a
    /// fault, and takes some hundred times as long as a capture.
    /// </remarks>
    /// <param name="other">The other one.</param>
    /// <param name="most">The search ends when it has found so many differences; at least 1. Default 100.</param>
    /// <returns>The differences, by body, shape, joint or pair and by field, with both values and their bits.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="other"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="other"/> holds nothing.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="most"/> is less than 1.</exception>
    /// <exception cref="InvalidOperationException">This state holds nothing, or a step runs.</exception>
    public b2StateComparison Compare(b2WorldState other, int most = 100)
    {
        Bridge.Require.NotNull(other, nameof(other));
        Bridge.Require.Positive(most, nameof(most));
        if (Owner is null)
        {
            throw new InvalidOperationException("The state holds nothing.");
        }

        if (other.Owner is null)
        {
            throw new ArgumentException("The state holds nothing.", nameof(other));
        }

        if (IsSameAs(other))
        {
            return new b2StateComparison([]);
        }

        Bridge.StateNames names = Owner.Names(other.Owner);
        return names.Compare(
            Owner, Bridge.StateNames.Named(this), Bridge.StateNames.Named(other), ReferenceEquals(Owner, other.Owner), most);
    }

    /// <summary>From now on captures note the names of the fields, for those who look for a difference.</summary>
    internal void BeginTrace() => Stream.Trace = new StateTrace();
}
