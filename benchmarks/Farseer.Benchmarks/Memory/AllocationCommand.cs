using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Memory;

/// <summary>The verb <c>allocation</c>: what scenes still allocate after their first second, in which step last, and which stores hold it.</summary>
internal static class AllocationCommand
{
    public const string Usage = "allocation [SCENE [STEPS]]";
    private const int Misused = 2;
    private const int WarmSteps = 60;

    public static int Run(ReadOnlySpan<string> args, TextWriter output, TextWriter errors)
    {
        int steps = 0;
        PerformanceScene? chosen = args.Length > 0 ? PerformanceScenes.Find(args[0]) : null;
        if ((args.Length > 0 && chosen == null)
            || (args.Length > 1 && !int.TryParse(args[1], NumberStyles.None, CultureInfo.InvariantCulture, out steps)))
        {
            errors.WriteLine($"usage: {Usage}");
            return Misused;
        }

        foreach (PerformanceScene scene in PerformanceScenes.All)
        {
            if (chosen == null || scene == chosen)
            {
                Print(output, scene, steps > 0 ? steps : scene.Steps);
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
