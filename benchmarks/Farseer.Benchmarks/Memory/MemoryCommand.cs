using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Memory;

/// <summary>The verb <c>memory</c>: what a scene keeps, in bytes a body, and which stores keep it.</summary>
internal static class MemoryCommand
{
    public const string Usage = "memory [SCENE [STEPS] | worlds [ROOMS] [--stores]]";
    private const int Misused = 2;
    private const int DefaultSteps = 100;

    /// <summary>Stores of less, bytes a body, are summed up.</summary>
    private const double LeastShown = 10;

    public static int Run(ReadOnlySpan<string> args, TextWriter output, TextWriter errors)
    {
        string name = args.Length > 0 ? args[0] : "large_pyramid";
        if (name == WorldMemory.Verb)
        {
            return WorldMemory.Run(args[1..], output, errors);
        }

        int steps = DefaultSteps;
        if (PerformanceScenes.Find(name) is not { } scene
            || (args.Length > 1 && !int.TryParse(args[1], NumberStyles.None, CultureInfo.InvariantCulture, out steps)))
        {
            errors.WriteLine($"usage: {Usage}");
            return Misused;
        }

        Print(output, scene, steps);
        return 0;
    }

    private static void Print(TextWriter output, PerformanceScene scene, int steps)
    {
        long before = GC.GetTotalMemory(forceFullCollection: true);
        using var simulator = new PhysicsSimulator();
        scene.Build(simulator, scene.DefaultSize);
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
            CultureInfo.InvariantCulture, $"{scene.Name} after {steps} steps: {bodies} bodies, {kept / bodies:F0} bytes a body by the collector"));
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
