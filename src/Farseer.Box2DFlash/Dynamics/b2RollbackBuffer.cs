using System;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics;

/// <summary>
/// The last frames of a <see cref="b2World"/>, for rollback: <see cref="Push"/> keeps the state of now as a frame,
/// <see cref="Rewind"/> goes back to one that is held. A frame takes what changed since the one before; the oldest fall out.
/// </summary>
/// <remarks>
/// What a state holds, what it asks of items of your own and what is guaranteed after going back is said at
/// <see cref="b2World.Capture(b2WorldState)"/>. Its memory is kept: once it has grown, nothing is allocated. Beside the frames
/// it has room for two whole states to work with. Like the world it is to be used by one thread at a time.
/// </remarks>
/// <example>
/// <code>
/// var buffer = new b2RollbackBuffer(world, 120);
/// buffer.Push();
/// for (int i = 0; i &lt; 100; i++)
/// {
///     world.Step(1f / 60, 10);
///     buffer.Push();
/// }
///
/// buffer.Rewind(95); // as it was after 95 of them
/// for (int i = 95; i &lt; 100; i++)
/// {
///     world.Step(1f / 60, 10);
///     buffer.Push();
/// }
/// </code>
/// </example>
public sealed class b2RollbackBuffer
{
    private readonly StateRing _ring;

    /// <summary>Makes a buffer for a number of frames, empty at first.</summary>
    /// <param name="world">The world whose states are kept.</param>
    /// <param name="frames">Most frames held, 1 or more; a second at 60 Hz is 60.</param>
    /// <exception cref="ArgumentNullException"><paramref name="world"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="frames"/> is less than 1.</exception>
    public b2RollbackBuffer(b2World world, int frames)
    {
        World = Bridge.Require.NotNull(world, nameof(world));
        _ring = StateRing.OfFrames(frames);
    }

    private b2RollbackBuffer(b2World world, long bytes)
    {
        World = Bridge.Require.NotNull(world, nameof(world));
        _ring = StateRing.OfBytes(bytes);
    }

    /// <summary>Makes a buffer that holds as many frames as fit into a number of bytes, empty at first.</summary>
    /// <param name="world">The world whose states are kept.</param>
    /// <param name="bytes">
    /// Most bytes of all frames together, as <see cref="ByteCount"/> counts them, 1 or more. The newest frame is held in any case.
    /// </param>
    /// <returns>The buffer.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="world"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="bytes"/> is less than 1.</exception>
    public static b2RollbackBuffer WithBudget(b2World world, long bytes) => new b2RollbackBuffer(world, bytes);

    /// <summary>The world whose states are kept.</summary>
    public b2World World { get; }

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
    /// <exception cref="InvalidOperationException">A step runs. The buffer stays as it was.</exception>
    public long Push()
    {
        StateStream state = _ring.BeginPush();
        try
        {
            World.Write(state, World.Roster);
        }
        catch
        {
            _ring.CancelPush();
            throw;
        }

        return _ring.Push();
    }

    /// <summary>
    /// Goes back to a frame, as <see cref="b2World.Restore"/> does. It is the newest one then: those after it are dropped, and the
    /// next <see cref="Push"/> gives the number after it again.
    /// </summary>
    /// <param name="frame">Its number, from <see cref="OldestFrame"/> to <see cref="NewestFrame"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="frame"/> is not held.</exception>
    /// <exception cref="InvalidOperationException">A step runs. Nothing is changed then.</exception>
    public void Rewind(long frame)
    {
        StateStream state = _ring.BeginRewind(frame);
        try
        {
            World.Read(state, World.Roster);
        }
        catch
        {
            _ring.CancelRewind();
            throw;
        }

        _ring.EndRewind(frame);
    }

    /// <summary>Drops all frames, and every reference to what was in them. The next one goes on with the numbers.</summary>
    public void Clear() => _ring.Clear();
}
