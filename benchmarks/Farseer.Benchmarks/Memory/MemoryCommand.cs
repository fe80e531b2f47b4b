using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Memory;

/// <summary>The verb <c>memory</c>: what a scene keeps, in bytes a body, and which stores keep it.</summary>
internal static class MemoryCommand
{
    private const int DefaultSteps = 100;

    /// <summary>Stores of less, bytes a body, are summed up.</summary>
    private const double LeastShown = 5;

    private static readonly Argument<string?> _scene = Verb.Maybe("scene", "the name of a scene; without, large_pyramid");
    private static readonly Argument<int> _steps = Verb.Maybe("steps", "updates before it is measured", DefaultSteps);

    private static readonly Argument<int> _size = Verb.Maybe("size", "of the scene; 0: its own", 0);

    public static Command Create() =>
        Verb.Of("memory", "What a scene keeps in memory, bytes a body by store.", Run, _scene, _steps, _size);

    private static int Run(ParseResult result)
    {
        PerformanceScene scene = Verb.Scene(result.GetValue(_scene) ?? "large_pyramid");
        int size = result.GetValue(_size);
        Print(result.Output(), scene, result.GetValue(_steps), size > 0 ? size : scene.DefaultSize);
        return 0;
    }

    private static void Print(TextWriter output, PerformanceScene scene, int steps, int size)
    {
        long before = GC.GetTotalMemory(forceFullCollection: true);
        using var simulator = new PhysicsSimulator();
        scene.Build(simulator, size);
        for (int i = 0; i < steps; i++)
        {
            scene.Drive(i);
            simulator.Update(scene.Dt);
        }

        long kept = GC.GetTotalMemory(forceFullCollection: true) - before;
        double bodies = simulator.BodyList.Count;
        var walk = new HeapWalk();
        walk.Walk(simulator);
        var stores = new List<KeyValuePair<string, long>>(walk.Bytes);
        stores.Sort((a, b) => a.Value != b.Value ? b.Value.CompareTo(a.Value) : string.CompareOrdinal(a.Key, b.Key));
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{scene.Name} after {steps} steps: {bodies} bodies, {kept / bodies:F0} bytes a body by the collector"));
        double rest = 0;
        foreach ((string store, long bytes) in stores)
        {
            if (bytes < LeastShown * bodies)
            {
                rest += bytes;
                continue;
            }

            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{bytes / bodies,8:F0}  {store}"));
        }

        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{rest / bodies,8:F0}  stores of less than {LeastShown} each"));
    }
}
