using System;
using System.Net;
using LiteNetLib;

namespace Farseer.Rollback;

/// <summary>One end of a line over UDP on this machine: packets that may be lost, as games send them.</summary>
internal sealed class UdpLink : IDisposable
{
    private const string Key = "farseer";

    private readonly EventBasedNetListener _listener = new();
    private readonly NetManager _manager;
    private NetPeer? _peer;

    private UdpLink()
    {
        _manager = new NetManager(_listener) { AutoRecycle = true, IPv6Enabled = false };
        _listener.ConnectionRequestEvent += static request => request.AcceptIfKey(Key);
        _listener.PeerConnectedEvent += peer => _peer = peer;
        _listener.NetworkReceiveEvent += (_, reader, _, _) => Received?.Invoke(reader.GetRemainingBytes());
    }

    /// <summary>Called in <see cref="Poll"/> for each packet.</summary>
    public event Action<byte[]>? Received;

    public bool IsConnected => _peer is not null;

    /// <summary>Waits for the other end on a free port.</summary>
    public static UdpLink Host()
    {
        UdpLink link = new();
        link.Start();
        return link;
    }

    public UdpLink Join()
    {
        UdpLink link = new();
        link.Start();
        link._manager.Connect(new IPEndPoint(IPAddress.Loopback, _manager.LocalPort), Key);
        return link;
    }

    public void Send(byte[] packet) => _peer?.Send(packet, DeliveryMethod.Unreliable);

    public void Poll() => _manager.PollEvents();

    public void Dispose() => _manager.Stop();

    private void Start()
    {
        if (!_manager.Start(IPAddress.Loopback, IPAddress.IPv6Loopback, 0))
        {
            throw new InvalidOperationException("No UDP port could be opened on this machine.");
        }
    }
}
