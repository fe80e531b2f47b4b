using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading.Tasks;
using Orleans.Runtime;

namespace Farseer.Rooms;

/// <summary>A room's move from one server to the other.</summary>
internal sealed record Move(long Room, RoomView Before, RoomView After, TimeSpan Time)
{
    public bool IsSame => Before.Hash == After.Hash && Before.Steps == After.Steps;
}

/// <summary>How one room ended.</summary>
internal sealed record RoomEnd(long Room, RoomView View, ulong Straight)
{
    public bool IsSame => View.Hash == Straight;
}

/// <summary>Rooms that are played on two servers, all at once, and moved to and fro.</summary>
internal sealed class RoomRun
{
    private readonly Fleet _fleet;
    private readonly RoomOptions _options;

    public RoomRun(Fleet fleet, RoomOptions options)
    {
        _fleet = fleet;
        _options = options;
    }

    private IEnumerable<long> Rooms => Enumerable.Range(1, _options.Rooms).Select(i => (long)i);

    /// <summary>Plays turns before the first move, between moves and after the last one.</summary>
    public async Task<IReadOnlyList<Move>> Play()
    {
        List<Move> moves = [];
        for (int round = 0; round < _options.Moves; round++)
        {
            await PlayTurns();
            moves.AddRange(await Task.WhenAll(Rooms.Select(MoveOver)));
        }

        await PlayTurns();
        return moves;
    }

    /// <summary>One server stops; the rooms of it go on on the other one.</summary>
    public async Task<IReadOnlyList<RoomEnd>> StopOne()
    {
        await _fleet.StopLastAsync();
        await PlayTurns();
        return await Task.WhenAll(Rooms.Select(async room =>
        {
            RoomView view = await _fleet.Room(room).Look();
            return new RoomEnd(room, view, RoomScript.Straight(room, (int)(view.Steps / RoomScript.StepsOfTurn)));
        }));
    }

    private Task PlayTurns() => Task.WhenAll(Rooms.Select(PlayTurns));

    private async Task PlayTurns(long number)
    {
        IRoom room = _fleet.Room(number);

        // A room that was kept from a run before goes on where it was.
        int first = (int)((await room.Look()).Steps / RoomScript.StepsOfTurn);
        await RoomScript.Play(room, number, first, _options.Turns);
    }

    private async Task<Move> MoveOver(long number)
    {
        IRoom room = _fleet.Room(number);
        RoomView before = await room.Look();
        SiloAddress target = _fleet.Silos.First(s => !s.Equals(before.Silo));
        long start = Stopwatch.GetTimestamp();
        await room.MoveTo(target);
        RoomView after = await room.Look();
        return new Move(number, before, after, Stopwatch.GetElapsedTime(start));
    }
}

/// <summary>What is played.</summary>
/// <param name="Rooms">How many rooms.</param>
/// <param name="Turns">Turns between two moves; 30 steps each.</param>
/// <param name="Moves">How often each room moves.</param>
internal sealed record RoomOptions(int Rooms, int Turns, int Moves);
