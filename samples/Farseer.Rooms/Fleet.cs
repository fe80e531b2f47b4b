using System;
using System.Collections.Generic;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Threading.Tasks;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using Orleans;
using Orleans.Configuration;
using Orleans.Hosting;
using Orleans.Runtime;

namespace Farseer.Rooms;

/// <summary>Servers that form a cluster, here all in this process. Between machines only the clustering provider differs.</summary>
internal sealed class Fleet : IAsyncDisposable
{
    private readonly List<IHost> _hosts = [];

    private Fleet()
    {
    }

    /// <summary>The servers, the first one first.</summary>
    public IReadOnlyList<SiloAddress> Silos => [.. _hosts.Select(h => h.Services.GetRequiredService<ILocalSiloDetails>().SiloAddress)];

    /// <summary>Starts servers.</summary>
    /// <param name="count">How many, at least 1.</param>
    /// <param name="folder">Where rooms are kept.</param>
    public static async Task<Fleet> StartAsync(int count, string folder)
    {
        int[] ports = FreePorts(2 * count);
        IPEndPoint first = new(IPAddress.Loopback, ports[0]);
        Fleet fleet = new();
        try
        {
            for (int i = 0; i < count; i++)
            {
                HostApplicationBuilder builder = Host.CreateEmptyApplicationBuilder(null);
                int siloPort = ports[2 * i];
                int gatewayPort = ports[(2 * i) + 1];
                builder.UseOrleans(silo => silo
                    .UseDevelopmentClustering(first)
                    .ConfigureEndpoints(IPAddress.Loopback, siloPort, gatewayPort)
                    .Configure<ClusterOptions>(names => (names.ClusterId, names.ServiceId) = ("rooms", "rooms"))
                    .AddRooms(folder));
                IHost host = builder.Build();
                fleet._hosts.Add(host);
                await host.StartAsync();
            }
        }
        catch
        {
            await fleet.DisposeAsync();
            throw;
        }

        return fleet;
    }

    public IRoom Room(long number) => _hosts[0].Services.GetRequiredService<IGrainFactory>().GetGrain<IRoom>(number);

    /// <summary>Takes the last server out; its rooms go on on the others.</summary>
    public async Task StopLastAsync()
    {
        IHost host = _hosts[^1];
        _hosts.RemoveAt(_hosts.Count - 1);
        await host.StopAsync();
        host.Dispose();
    }

    // The last one first: the cluster knows its servers by the first one.
    public async ValueTask DisposeAsync()
    {
        while (_hosts.Count > 0)
        {
            await StopLastAsync();
        }
    }

    private static int[] FreePorts(int count)
    {
        TcpListener[] listeners = [.. Enumerable.Range(0, count).Select(_ => new TcpListener(IPAddress.Loopback, 0))];
        foreach (TcpListener listener in listeners)
        {
            listener.Start();
        }

        int[] ports = [.. listeners.Select(l => ((IPEndPoint)l.LocalEndpoint).Port)];
        foreach (TcpListener listener in listeners)
        {
            listener.Stop();
        }

        return ports;
    }
}
