using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Orleans;
using Orleans.Configuration;
using Orleans.Hosting;
using Orleans.Runtime;
using Orleans.TestingHost;
using Xunit;

namespace Farseer.Rooms.Tests;

/// <summary>Two servers in this process, and a folder for their rooms.</summary>
public sealed class TwoSilos : IAsyncLifetime
{
    private static readonly TimeSpan _patience = TimeSpan.FromMinutes(1);
    private readonly bool _ownsFolder;

    public TwoSilos()
        : this(null)
    {
    }

    /// <param name="folder">Where rooms are kept; null: in a folder that is deleted at the end.</param>
    internal TwoSilos(string? folder)
    {
        _ownsFolder = folder is null;
        Folder = folder ?? Directory.CreateTempSubdirectory("farseer-rooms").FullName;
        InProcessTestClusterBuilder builder = new(2);
        builder.ConfigureSilo((_, silo) => silo.AddRooms(Folder).Configure<ClusterMembershipOptions>(FindTheDeadSoon));
        Cluster = builder.Build();
    }

    public string Folder { get; }

    public InProcessTestCluster Cluster { get; }

    public SiloAddress First => Cluster.Silos[0].SiloAddress;

    public SiloAddress Second => Cluster.Silos[1].SiloAddress;

    public Task InitializeAsync() => Cluster.DeployAsync();

    public async Task DisposeAsync()
    {
        await Cluster.DisposeAsync();
        if (_ownsFolder)
        {
            Directory.Delete(Folder, recursive: true);
        }
    }

    public IRoom Room(long number) => Cluster.Client.GetGrain<IRoom>(number);

    public SiloAddress OtherThan(SiloAddress silo) => new[] { First, Second }.Single(s => !s.Equals(silo));

    /// <summary>Moves a room. Where it is to go is a hint, which is not heard while a server has only just joined the others.</summary>
    public async Task Move(long number, SiloAddress silo)
    {
        const int MostTries = 100;
        IRoom room = Room(number);
        for (int tries = 0; tries < MostTries && !(await room.Look()).Silo.Equals(silo); tries++)
        {
            await room.MoveTo(silo);
            await Task.Delay(50);
        }

        Assert.Equal(silo, (await room.Look()).Silo);
    }

    /// <summary>Looks at a room whose server was killed: calls fail until the other one has found out.</summary>
    public async Task<RoomView> LookPatiently(long number)
    {
        Stopwatch waited = Stopwatch.StartNew();
        while (true)
        {
            try
            {
                return await Room(number).Look();
            }
            catch (Exception e) when (e is OrleansException or TimeoutException && waited.Elapsed < _patience)
            {
                await Task.Delay(100);
            }
        }
    }

    /// <summary>Plays turns of the script.</summary>
    public async Task<RoomView> Play(long number, int first, int count)
    {
        IRoom room = Room(number);
        await RoomScript.Play(room, number, first, count);
        return await room.Look();
    }

    /// <summary>Servers ask each other every second. By default ten seconds lie between, and two must agree that one is dead.</summary>
    private static void FindTheDeadSoon(ClusterMembershipOptions options)
    {
        options.ProbeTimeout = TimeSpan.FromSeconds(1);
        options.TableRefreshTimeout = TimeSpan.FromSeconds(2);
        options.NumVotesForDeathDeclaration = 1;
    }
}
