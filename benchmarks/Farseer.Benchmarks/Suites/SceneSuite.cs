using BenchmarkDotNet.Attributes;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Suites;

/// <summary>Whole updates of scenes that have come to rest, ns an update.</summary>
public class SceneSuite
{
    private const int SettlingUpdates = 300;
    private PhysicsSimulator _simulator = null!;
    private float _dt;

    [Params("resting_boxes=10", "large_pyramid=20", "large_pyramid=60", "circle_pile=1000")]
    public string Scene { get; set; } = string.Empty;

    [GlobalSetup]
    public void Setup() => _simulator = Start(Scene, out _dt);

    [GlobalCleanup]
    public void Cleanup() => _simulator.Dispose();

    [Benchmark]
    public void Update() => _simulator.Update(_dt);

    internal static PhysicsSimulator Start(string name, out float dt)
    {
        string[] parts = name.Split('=');
        PerformanceScene scene = PerformanceScenes.Find(parts[0])!;
        var simulator = new PhysicsSimulator();
        scene.Build(simulator, int.Parse(parts[1], System.Globalization.CultureInfo.InvariantCulture));
        dt = scene.Dt;
        for (int i = 0; i < SettlingUpdates; i++)
        {
            simulator.Update(dt);
        }

        return simulator;
    }
}
