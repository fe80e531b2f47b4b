using System;
using BenchmarkDotNet.Attributes;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;

namespace Farseer.Benchmarks.Suites;

/// <summary>All pairs of boxes that all look for pairs, ns a search; <c>-- pairs</c> has more scenes.</summary>
public class PairSuite
{
    private readonly ProxyStore _proxies = new ProxyStore();
    private readonly PairBuffer _pairs = new PairBuffer();
    private readonly LevelGrid _grid = new LevelGrid();
    private readonly SelectiveSweep _sweep = new SelectiveSweep();

    [Params(1_000, 10_000)]
    public int Bodies { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        var random = new Random(1);
        float side = MathF.Sqrt(Bodies) * 1.1f;
        _proxies.Set.EnsureCapacity(Bodies);
        _proxies.End = Bodies;
        for (int i = 0; i < Bodies; i++)
        {
            float x = (float)random.NextDouble() * side;
            float y = (float)random.NextDouble() * side;
            float size = 1 + ((float)random.NextDouble() * 0.2f);
            _proxies.Fat[i] = new Box(x, y, x + size, y + size);
            _proxies.Info[i] = new ProxyInfo { Body = i, Flags = ProxyFlags.Alive | ProxyFlags.Moved };
            _grid.Added(_proxies, i);
            _sweep.Added(_proxies, i);
        }
    }

    [Benchmark]
    public void Grid() => Collect(_grid);

    [Benchmark]
    public void SelectiveSweep() => Collect(_sweep);

    private void Collect(IBroadPhase finder)
    {
        _pairs.Clear();
        finder.Collect(_proxies, _pairs);
    }
}
