using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Memory;

/// <summary>
/// The verb <c>allocation</c>: what scenes still allocate after their first second, in which step last, and which stores hold it.
/// </summary>
internal static class AllocationCommand
{
    private const int WarmSteps = 60;

    private static readonly Argument<string?> _scene = Verb.Maybe("scene", "the name of a scene; without, all of them");
    private static readonly Argument<int> _steps = Verb.Maybe("steps", "updates; 0: the scene's own number", 0);

    public static Command Create() =>
        Verb.Of("allocation", "What scenes allocate after their first second, by store.", Run, _scene, _steps);

    private static int Run(ParseResult result)
    {
        PerformanceScene? chosen = result.GetValue(_scene) is string name ? Verb.Scene(name) : null;
        int steps = result.GetValue(_steps);
        foreach (PerformanceScene scene in PerformanceScenes.All)
        {
            if (chosen == null || scene.Name == chosen.Name)
            {
                Print(result.Output(), scene, steps > 0 ? steps : scene.Steps);
            }
        }

        return 0;
    }

    private static void Print(TextWriter output, PerformanceScene scene, int steps)
    {
        using var simulator = new PhysicsSimulator();
        scene.Build(simulator, scene.DefaultSize);
        var bytes = new SortedDictionary<string, (long Bytes, int Times, int Last)>(StringComparer.Ordinal);
        long warm = 0;
        long late = 0;
        int last = 0;
        HeapWalk? known = null;
        for (int i = 0; i < steps; i++)
        {
            scene.Drive(i);
            long before = GC.GetAllocatedBytesForCurrentThread();
            simulator.Update(scene.Dt);
            long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
            if (i < WarmSteps)
            {
                warm += allocated;
            }
            else if (allocated > 0)
            {
                late += allocated;
                last = i + 1;
                known = Book(simulator, known, bytes, i + 1);
            }

            if (i == WarmSteps - 1)
            {
                known = new HeapWalk();
                known.Walk(simulator);
            }
        }

        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{scene.Name}, {steps} steps: {warm} bytes in the first {WarmSteps}, {late} after them, the last in step {last}"));
        foreach ((string store, (long Bytes, int Times, int Last) sum) in bytes)
        {
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture, $"{sum.Bytes,12}  {store}, {sum.Times} steps, the last {sum.Last}"));
        }
    }

    private static HeapWalk Book(
        PhysicsSimulator simulator, HeapWalk? known, SortedDictionary<string, (long Bytes, int Times, int Last)> bytes, int step)
    {
        var walk = new HeapWalk();
        walk.Walk(simulator, known);
        foreach ((string store, long fresh) in walk.Bytes)
        {
            (long sum, int times, _) = bytes.GetValueOrDefault(store);
            bytes[store] = (sum + fresh, times + 1, step);
        }

        return walk;
    }
}
