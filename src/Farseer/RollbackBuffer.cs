using System;
using System.Runtime.ExceptionServices;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// The last frames of a <see cref="PhysicsSimulator"/>, for rollback: <see cref="Push"/> keeps the state of now as a frame,
/// <see cref="Rewind"/> goes back to one that is held. A frame takes what changed since the one before; the oldest fall out.
/// </summary>
/// <remarks>
/// What a state holds, what it asks of items of your own and what is guaranteed after going back is said at
/// <see cref="PhysicsSimulator.Capture(PhysicsSimulatorState)"/>. Its memory is kept: once it has grown, nothing is allocated.
/// Beside the frames it has room for two whole states to work with. Like the simulator it is to be used by one thread at a time.
/// </remarks>
/// <example>
/// <code>
/// var buffer = new RollbackBuffer(simulator, 120);
/// buffer.Push();
/// for (int i = 0; i &lt; 100; i++)
/// {
///     simulator.Update(1f / 60);
///     buffer.Push();
/// }
///
/// buffer.Rewind(95); // as it was after 95 of them
/// for (int i = 95; i &lt; 100; i++)
/// {
///     simulator.Update(1f / 60);
///     buffer.Push();
/// }
/// </code>
/// </example>
public sealed class RollbackBuffer
{
    private readonly StateRing _ring;

    /// <summary>Makes a buffer for a number of frames, empty at first.</summary>
    /// <param name="simulator">The simulator whose states are kept.</param>
    /// <param name="frames">Most frames held, 1 or more; a second at 60 Hz is 60.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="frames"/> is less than 1.</exception>
    public RollbackBuffer(PhysicsSimulator simulator, int frames)
    {
        Simulator = Require.NotNull(simulator, nameof(simulator));
        _ring = StateRing.OfFrames(frames);
    }

    private RollbackBuffer(PhysicsSimulator simulator, long bytes)
    {
        Simulator = Require.NotNull(simulator, nameof(simulator));
        _ring = StateRing.OfBytes(bytes);
    }

    /// <summary>Makes a buffer that holds as many frames as fit into a number of bytes, empty at first.</summary>
    /// <param name="simulator">The simulator whose states are kept.</param>
    /// <param name="bytes">
    /// Most bytes of all frames together, as <see cref="ByteCount"/> counts them, 1 or more. The newest frame is held in any case.
    /// </param>
    /// <returns>The buffer.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="bytes"/> is less than 1.</exception>
    public static RollbackBuffer WithBudget(PhysicsSimulator simulator, long bytes) => new RollbackBuffer(simulator, bytes);

    /// <summary>The simulator whose states are kept.</summary>
    public PhysicsSimulator Simulator { get; }

    /// <summary>Most frames held; <see cref="int.MaxValue"/> of a buffer with a budget.</summary>
    public int FrameLimit => _ring.MostFrames;

    /// <summary>Most bytes held; <see cref="long.MaxValue"/> of a buffer with a number of frames.</summary>
    public long ByteBudget => _ring.MostBytes;

    /// <summary>Frames held, 0 or more.</summary>
    public int Count => _ring.Count;

    /// <summary>Number of the oldest frame held; −1 if there is none.</summary>
    public long OldestFrame => _ring.Oldest;

    /// <summary>Number of the newest frame, that pushed or rewound to last; −1 if there is none.</summary>
    public long NewestFrame => _ring.Newest;

    /// <summary>Bytes that the frames take, references to objects included and unused room left out.</summary>
    public long ByteCount => _ring.ByteCount;

    /// <summary>
    /// Keeps the present state as the newest frame. If there are too many frames then, or they take too much, the oldest are dropped.
    /// </summary>
    /// <returns>The frame's number: 0 the first time, then one more than <see cref="NewestFrame"/> was.</returns>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">
    /// An update runs; or the call comes from an item of your own that is being saved or restored; or a joint, spring, controller or
    /// broad phase of your own does not implement <see cref="Interfaces.ISavedState"/>: its type is named. The buffer stays as it was,
    /// also if an item of your own throws.
    /// </exception>
    public long Push()
    {
        StateStream state = _ring.BeginPush();
        try
        {
            Simulator.Write(state, Simulator.Present);
        }
        catch
        {
            _ring.CancelPush();
            throw;
        }

        return _ring.Push();
    }

    /// <summary>
    /// Goes back to a frame, as <see cref="PhysicsSimulator.Restore"/> does. It is the newest one then: those after it are dropped, and the
    /// next <see cref="Push"/> gives the number after it again.
    /// </summary>
    /// <param name="frame">Its number, from <see cref="OldestFrame"/> to <see cref="NewestFrame"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="frame"/> is not held.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">
    /// An update runs, or something that is to come back belongs to another simulator by now. Nothing is changed then, neither in
    /// the simulator nor here.
    /// </exception>
    public void Rewind(long frame)
    {
        StateStream state = _ring.BeginRewind(frame);
        ExceptionDispatchInfo? failure;
        try
        {
            failure = Simulator.Read(state, Simulator.Present, Simulator.Former);
        }
        catch
        {
            _ring.CancelRewind();
            throw;
        }

        _ring.EndRewind(frame);
        failure?.Throw();
    }

    /// <summary>Drops all frames, and every reference to what was in them. The next one goes on with the numbers.</summary>
    public void Clear() => _ring.Clear();
}
