using BenchmarkDotNet.Attributes;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Suites;

/// <summary>Updates of a grid of discs on revolute joints, ns an update of all joints.</summary>
public class JointSuite
{
    private PhysicsSimulator _simulator = null!;
    private float _dt;

    [Params(10, 20)]
    public int Side { get; set; }

    [GlobalSetup]
    public void Setup() => _simulator = SceneSuite.Start($"joint_grid={Side}", out _dt);

    [GlobalCleanup]
    public void Cleanup() => _simulator.Dispose();

    [Benchmark]
    public void Update() => _simulator.Update(_dt);
}
