using System;
using System.Collections.Generic;

namespace Farseer.Rollback;

/// <summary>
/// Makes a good line poor: what is sent is lost, or arrives later, and not in order. The same seed loses the same packets.
/// </summary>
internal sealed class PoorLine
{
    private readonly PriorityQueue<byte[], (double Due, int Number)> _underWay = new();
    private readonly Action<byte[]> _deliver;
    private readonly LineQuality _quality;
    private readonly Random _random;
    private int _number;

    /// <param name="quality">How poor.</param>
    /// <param name="seed">Decides what is lost and how long the rest takes.</param>
    /// <param name="deliver">Takes what has got through.</param>
    public PoorLine(LineQuality quality, int seed, Action<byte[]> deliver)
    {
        _quality = quality;
        _random = new Random(seed);
        _deliver = deliver;
    }

    public int Sent { get; private set; }

    public int Lost { get; private set; }

    public void Send(byte[] packet, double now)
    {
        double delay = _quality.Latency + (_quality.Jitter * _random.NextDouble());
        bool isLost = _random.NextDouble() * 100 < _quality.Loss;
        Sent++;
        if (isLost)
        {
            Lost++;
            return;
        }

        _underWay.Enqueue(packet, (now + delay, _number++));
    }

    public void Deliver(double now)
    {
        while (_underWay.TryPeek(out byte[]? packet, out (double Due, int Number) place) && place.Due <= now)
        {
            _underWay.Dequeue();
            _deliver(packet);
        }
    }
}

/// <summary>One way of a line.</summary>
/// <param name="Latency">Least time under way, ms.</param>
/// <param name="Jitter">Most time on top of it, ms.</param>
/// <param name="Loss">Packets lost, percent.</param>
internal readonly record struct LineQuality(double Latency, double Jitter, double Loss);
