using System;

namespace FarseerGames.FarseerPhysics.Interfaces;

/// <summary>
/// What a joint, spring, controller or broad phase of your own implements to take part in
/// <see cref="PhysicsSimulator.Capture(PhysicsSimulatorState)"/> and <see cref="PhysicsSimulator.Restore"/>: it writes its fields
/// to a span of bytes and reads them from one.
/// </summary>
/// <remarks>
/// Fields of the base classes (enabled, limits, bodies and the like) are saved by the library; only what you add is yours to
/// save.
/// </remarks>
/// <example>
/// <code>
/// public int StateSize => sizeof(float);
///
/// public void SaveState(Span&lt;byte&gt; destination) => MemoryMarshal.Write(destination, in _phase);
///
/// public void RestoreState(ReadOnlySpan&lt;byte&gt; source) => _phase = MemoryMarshal.Read&lt;float&gt;(source);
/// </code>
/// </example>
public interface ISavedState
{
    /// <summary>
    /// Bytes that <see cref="SaveState"/> is going to write, at least 0. Asked at each capture; it may change from one to the
    /// next.
    /// </summary>
    int StateSize { get; }

    /// <summary>Writes all that influences a later update.</summary>
    /// <param name="destination">Room for <see cref="StateSize"/> bytes, all of which are kept.</param>
    void SaveState(Span<byte> destination);

    /// <summary>Sets the fields to what was written. Must not change the simulator.</summary>
    /// <param name="source">What <see cref="SaveState"/> wrote.</param>
    void RestoreState(ReadOnlySpan<byte> source);
}
