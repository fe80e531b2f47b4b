using System;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Orleans.Runtime;
using Xunit;

namespace Farseer.Rooms.Tests;

/// <summary>Servers that stop, and fleets that start again.</summary>
public sealed class SiloTests
{
    private static readonly long[] _rooms = [1, 2, 3, 4, 5, 6];

    [Fact]
    public async Task Rooms_OfAServerThatStops_GoOnOnTheOther()
    {
        TwoSilos silos = new();
        await silos.InitializeAsync();
        try
        {
            await Task.WhenAll(_rooms.Select(n => silos.Play(n, 0, 2)));
            foreach (long number in _rooms)
            {
                await silos.Move(number, silos.Second);
            }

            SiloAddress first = silos.First;
            await silos.Cluster.StopSiloAsync(silos.Cluster.Silos[1]);

            RoomView[] ends = await Task.WhenAll(_rooms.Select(n => silos.Play(n, 2, 2)));
            Assert.All(ends, e => Assert.Equal(first, e.Silo));
            Assert.Equal(_rooms.Select(n => RoomScript.Straight(n, 4)), ends.Select(e => e.Hash));
        }
        finally
        {
            await silos.DisposeAsync();
        }
    }

    /// <summary>A killed server says goodbye to nobody: the others find out by themselves, and what was not saved is lost.</summary>
    [Fact]
    public async Task Rooms_OfAServerThatIsKilled_GoOnOnTheOtherFromWhereTheyWereSaved()
    {
        TwoSilos silos = new();
        await silos.InitializeAsync();
        try
        {
            await Task.WhenAll(_rooms.Select(n => silos.Play(n, 0, 2)));
            foreach (long number in _rooms)
            {
                await silos.Move(number, silos.Second);
                await silos.Play(number, 2, 1);
                await silos.Room(number).Save();
                await silos.Play(number, 3, 1);
            }

            SiloAddress first = silos.First;
            await silos.Cluster.KillSiloAsync(silos.Cluster.Silos[1]);

            RoomView[] back = await Task.WhenAll(_rooms.Select(silos.LookPatiently));
            Assert.All(back, v => Assert.Equal((first, 3 * RoomScript.StepsOfTurn), (v.Silo, v.Steps)));
            Assert.Equal(_rooms.Select(n => RoomScript.Straight(n, 3)), back.Select(v => v.Hash));
            RoomView[] ends = await Task.WhenAll(_rooms.Select(n => silos.Play(n, 3, 2)));
            Assert.Equal(_rooms.Select(n => RoomScript.Straight(n, 5)), ends.Select(e => e.Hash));
        }
        finally
        {
            await silos.DisposeAsync();
        }
    }

    [Fact]
    public async Task Rooms_OfAFleetThatStops_GoOnInTheNextOne()
    {
        string folder = Directory.CreateTempSubdirectory("farseer-rooms").FullName;
        try
        {
            for (int life = 0; life < 2; life++)
            {
                TwoSilos silos = new(folder);
                await silos.InitializeAsync();
                try
                {
                    RoomView[] ends = await Task.WhenAll(_rooms.Select(n => silos.Play(n, 3 * life, 3)));

                    Assert.Equal(_rooms.Select(n => RoomScript.Straight(n, 3 * (life + 1))), ends.Select(e => e.Hash));
                    await silos.Cluster.StopAllSilosAsync();
                }
                finally
                {
                    await silos.DisposeAsync();
                }

                Assert.Equal(_rooms.Length, Directory.GetFiles(folder).Length);
            }
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
