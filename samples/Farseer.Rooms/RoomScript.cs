using System;
using System.Numerics;
using System.Threading.Tasks;

namespace Farseer.Rooms;

/// <summary>What players do: the same in each run, so that a room that moved can be compared with one that did not.</summary>
internal static class RoomScript
{
    /// <summary>Steps between two inputs of a player.</summary>
    public const int StepsOfTurn = 30;

    public static Vector2 Push(long room, int turn, int player)
    {
        Random random = new(unchecked((int)((room * 7919) + (turn * 31) + player)));
        return new Vector2((16 * random.NextSingle()) - 8, 12 * random.NextSingle());
    }

    /// <summary>Plays turns in a room, wherever it is.</summary>
    public static async Task Play(IRoom room, long number, int first, int count)
    {
        for (int turn = first; turn < first + count; turn++)
        {
            for (int player = 0; player < RoomWorld.Players; player++)
            {
                Vector2 push = Push(number, turn, player);
                await room.Push(player, push.X, push.Y);
            }

            await room.Step(StepsOfTurn);
        }
    }

    /// <summary>Plays the turns in a world that never leaves this place, and returns its hash.</summary>
    public static ulong Straight(long room, int turns)
    {
        RoomWorld world = RoomWorld.Build(room);
        for (int turn = 0; turn < turns; turn++)
        {
            for (int player = 0; player < RoomWorld.Players; player++)
            {
                world.Push(player, Push(room, turn, player));
            }

            world.Step(StepsOfTurn);
        }

        return world.Hash;
    }
}
