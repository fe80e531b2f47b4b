using System.Threading.Tasks;
using Orleans;
using Orleans.Runtime;

namespace Farseer.Rooms;

/// <summary>
/// A room: one world, on one of the servers at a time. Whoever knows its number can call it and need not know where it is; a room that
/// nobody has called yet is built by the first call.
/// </summary>
public interface IRoom : IGrainWithIntegerKey
{
    /// <summary>A player's input: pushes the player's disc. It acts in the next step.</summary>
    /// <param name="player">0 or 1.</param>
    /// <param name="x">To the right, kg·m/s.</param>
    /// <param name="y">Upwards, kg·m/s.</param>
    Task Push(int player, float x, float y);

    /// <summary>Makes steps by call, as turn-based games and tests want it.</summary>
    /// <param name="count">How many, at least 0.</param>
    Task<RoomView> Step(int count);

    /// <summary>Steps with the clock from now on, or no longer. The room remembers it wherever it goes.</summary>
    Task Run(bool isRunning);

    /// <summary>What clients see.</summary>
    Task<RoomView> Look();

    /// <summary>
    /// Saves the room as it is now. A server that is killed saves nothing: on the others its rooms go on from where they were saved last.
    /// </summary>
    Task Save();

    /// <summary>Moves the room to another server once it has nothing else to do; calls that come meanwhile wait for it there.</summary>
    Task MoveTo(SiloAddress silo);
}

/// <summary>A room as it is now.</summary>
/// <param name="Silo">Where it is.</param>
/// <param name="Steps">Steps since it was built.</param>
/// <param name="Hash">The hash of the motion of its world.</param>
/// <param name="BallX">Where the ball is, m.</param>
/// <param name="BallY">Where the ball is, m.</param>
/// <param name="SavedBytes">Length of the snapshot that it was loaded from; 0: it was built here.</param>
[GenerateSerializer]
[Alias("Farseer.Rooms.RoomView")]
public sealed record RoomView(SiloAddress Silo, long Steps, ulong Hash, double BallX, double BallY, int SavedBytes);

/// <summary>What is kept of a room while it is nowhere.</summary>
[GenerateSerializer]
[Alias("Farseer.Rooms.RoomState")]
public sealed class RoomState
{
    /// <summary>The world as <c>SceneFile</c> saves it, with its exact state.</summary>
    [Id(0)]
    public byte[] File { get; set; } = [];

    [Id(1)]
    public long Steps { get; set; }

    [Id(2)]
    public bool IsRunning { get; set; }
}
