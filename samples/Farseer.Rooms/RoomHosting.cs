using Microsoft.Extensions.DependencyInjection;
using Orleans.Hosting;
using Orleans.Runtime.Hosting;
using Orleans.Serialization;

namespace Farseer.Rooms;

/// <summary>What a server needs to have rooms.</summary>
internal static class RoomHosting
{
    /// <summary>The name of the storage of rooms.</summary>
    public const string Storage = "rooms";

    /// <param name="silo">The server.</param>
    /// <param name="folder">Where snapshots are kept; all servers of a fleet need the same.</param>
    public static ISiloBuilder AddRooms(this ISiloBuilder silo, string folder)
    {
        silo.Services.AddGrainStorage(
            Storage, (services, _) => new FolderStorage(folder, services.GetRequiredService<Serializer>()));
        return silo;
    }
}
