using System;
using System.Diagnostics;
using System.Linq;
using System.Numerics;
using System.Threading.Tasks;
using Orleans.Runtime;
using Xunit;

namespace Farseer.Rooms.Tests;

/// <summary>Rooms on two servers: wherever they go, no bit is lost. Each test has rooms of its own numbers.</summary>
public sealed class RoomTests : IClassFixture<TwoSilos>
{
    private static readonly TimeSpan _patience = TimeSpan.FromSeconds(30);
    private readonly TwoSilos _silos;

    public RoomTests(TwoSilos silos) => _silos = silos;

    [Fact]
    public async Task Room_MovedBetweenTurns_EndsAsOneThatNeverMoved()
    {
        const int Turns = 5;
        const int Moves = 4;
        RoomView view = await _silos.Play(1, 0, Turns);
        for (int move = 1; move <= Moves; move++)
        {
            SiloAddress target = _silos.OtherThan(view.Silo);

            await _silos.Move(1, target);

            RoomView moved = await _silos.Room(1).Look();
            Assert.Equal(target, moved.Silo);
            Assert.Equal((view.Hash, view.Steps), (moved.Hash, moved.Steps));
            Assert.True(moved.SavedBytes > 0, "the room was built anew");
            view = await _silos.Play(1, move * Turns, Turns);
        }

        Assert.Equal(RoomScript.Straight(1, (Moves + 1) * Turns), view.Hash);
    }

    [Fact]
    public async Task Room_MovedWithAnInputThatNoStepHasSeen_TakesItAlong()
    {
        Vector2 push = new(3, 8);
        RoomWorld straight = RoomWorld.Build(2);
        straight.Step(10);
        ulong without = Hash(straight, 1);
        straight = RoomWorld.Build(2);
        straight.Step(10);
        straight.Push(1, push);
        IRoom room = _silos.Room(2);
        RoomView before = await room.Step(10);
        await room.Push(1, push.X, push.Y);

        await room.MoveTo(_silos.OtherThan(before.Silo));

        ulong hash = (await room.Step(1)).Hash;
        Assert.NotEqual(without, hash);
        Assert.Equal(Hash(straight, 1), hash);
    }

    [Fact]
    public async Task Room_MovedBeforeItsFirstStep_IsTheSameRoom()
    {
        IRoom room = _silos.Room(3);
        RoomView before = await room.Look();

        await room.MoveTo(_silos.OtherThan(before.Silo));

        Assert.Equal(RoomWorld.Build(3).Hash, (await room.Look()).Hash);
        Assert.Equal(RoomScript.Straight(3, 4), (await _silos.Play(3, 0, 4)).Hash);
    }

    [Fact]
    public async Task Room_ThatNobodyCallsForAWhile_IsSavedAndGoesOnWhenCalled()
    {
        RoomView before = await _silos.Play(4, 0, 3);

        await _silos.Cluster.DeactivateAsync(_silos.Room(4));

        RoomView after = await _silos.Room(4).Look();
        Assert.Equal((before.Hash, before.Steps), (after.Hash, after.Steps));
        Assert.True(after.SavedBytes > 0, "the room was built anew");
        Assert.Equal(RoomScript.Straight(4, 8), (await _silos.Play(4, 3, 5)).Hash);
    }

    [Fact]
    public async Task Rooms_MovedWhileTheyArePlayed_EndAsThoseThatNeverMoved()
    {
        const int Turns = 20;
        long[] numbers = [.. Enumerable.Range(100, 6).Select(i => (long)i)];
        int moves = 0;
        Task<RoomView[]> played = Task.WhenAll(numbers.Select(n => _silos.Play(n, 0, Turns)));
        while (!played.IsCompleted)
        {
            foreach (long number in numbers)
            {
                await _silos.Room(number).MoveTo(moves++ % 3 == 0 ? _silos.First : _silos.Second);
            }
        }

        RoomView[] ends = await played;

        Assert.True(moves >= 2 * numbers.Length, $"{moves} moves");
        Assert.Contains(ends, e => e.SavedBytes > 0);
        Assert.Equal(numbers.Select(n => RoomScript.Straight(n, Turns)), ends.Select(e => e.Hash));
        Assert.All(ends, e => Assert.Equal(Turns * RoomScript.StepsOfTurn, e.Steps));
    }

    [Fact]
    public async Task Room_ThatRuns_StepsWithTheClockAlsoWhereItMoves()
    {
        IRoom room = _silos.Room(5);
        await room.Run(true);
        RoomView before = await Until(room, 5);

        await _silos.Move(5, _silos.OtherThan(before.Silo));

        RoomView after = await room.Look();
        Assert.NotEqual(before.Silo, after.Silo);
        RoomView later = await Until(room, after.Steps + 5);
        Assert.True(later.Steps > before.Steps);
        await room.Run(false);
        RoomView stopped = await room.Look();
        RoomWorld straight = RoomWorld.Build(5);
        Assert.Equal(Hash(straight, (int)stopped.Steps), stopped.Hash);
        await Task.Delay(200);
        Assert.Equal(stopped.Steps, (await room.Look()).Steps);
    }

    [Fact]
    public async Task Call_WithABadArgument_IsRefusedByNameAndChangesNothing()
    {
        IRoom room = _silos.Room(6);
        RoomView before = await room.Step(3);

        ArgumentOutOfRangeException player = await Assert.ThrowsAsync<ArgumentOutOfRangeException>(() => room.Push(2, 1, 1));
        ArgumentOutOfRangeException count = await Assert.ThrowsAsync<ArgumentOutOfRangeException>(() => room.Step(-1));
        await Assert.ThrowsAsync<ArgumentOutOfRangeException>(() => room.Push(0, float.NaN, 1));

        // Of an exception only type and message cross between servers.
        Assert.Contains("'player'", player.Message);
        Assert.Contains("'count'", count.Message);
        Assert.Equal(before, await room.Look());
    }

    private static ulong Hash(RoomWorld world, int steps)
    {
        world.Step(steps);
        return world.Hash;
    }

    private static async Task<RoomView> Until(IRoom room, long steps)
    {
        Stopwatch clock = Stopwatch.StartNew();
        while (true)
        {
            RoomView view = await room.Look();
            if (view.Steps >= steps)
            {
                return view;
            }

            Assert.True(clock.Elapsed < _patience, $"{view.Steps} steps of {steps} in {_patience}");
            await Task.Delay(20);
        }
    }
}
