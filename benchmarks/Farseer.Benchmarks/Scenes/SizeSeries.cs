using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.Scenes.Performance;

namespace Farseer.Benchmarks.Scenes;

/// <summary>
/// The verb <c>series</c>: what a body costs in a step, from a handful of bodies to a million, beside what it costs among a thousand.
/// </summary>
internal static class SizeSeries
{
    /// <summary>The same steps for all sizes, so that they are compared in the same state.</summary>
    private const int Steps = 60;

    /// <summary>Bodies of all runs of a size: a small world is run until it is compiled in full, a large one can be waited for.</summary>
    private const int BodiesOfRuns = 100_000;
    private const int LeastRuns = 2;
    private const int MostRuns = 400;

    /// <summary>Where a body costs 1.</summary>
    private const int Reference = 1000;

    // 15, 105, 990, 9,870 and 99,681 boxes.
    private static readonly int[] _bases = [5, 14, 44, 140, 446];
    private static readonly int[] _circles = [100, 1000, 10_000, 100_000, 1_000_000];

    private static readonly Argument<int> _largest = Verb.Maybe("largest", "bodies at most", int.MaxValue);

    public static Command Create() =>
        Verb.Of("series", "ns a body-step from 15 bodies to 1,000,000, or to the largest, beside those of 1,000.", Run, _largest);

    private static int Run(ParseResult result)
    {
        TextWriter output = result.Output();
        int largest = result.GetValue(_largest);
        output.WriteLine($"{Asset.Name}, {Asset.Lanes} lanes, {Steps} steps, best of each step; ratio to {Reference} bodies");
        Print(new LargePyramid(), _bases, size => size * (size + 1) / 2, largest, output);
        Print(new CirclePile(), _circles, size => size, largest, output);
        return 0;
    }

    private static void Print(PerformanceScene scene, int[] sizes, Func<int, int> bodies, int largest, TextWriter output)
    {
        output.WriteLine($"{scene.Name}: bodies, contacts, ms a step, ns a body-step, bytes a body, ratio");
        var rows = new List<(SceneTiming Timing, double Cost)>();
        double reference = double.NaN;
        foreach (int size in sizes)
        {
            int count = bodies(size);
            if (count > largest)
            {
                break;
            }

            var timing = new SceneTiming(scene, size, Steps, workers: 1);
            timing.Run(Math.Clamp(BodiesOfRuns / count, LeastRuns, MostRuns));
            double cost = 1e6 * timing.BestOfSteps / timing.DynamicBodies;
            rows.Add((timing, cost));
            reference = Math.Abs(count - Reference) * 50 <= Reference ? cost : reference;
        }

        foreach ((SceneTiming timing, double cost) in rows)
        {
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"  {timing.DynamicBodies,9:N0} {timing.Contacts,9:N0} {timing.BestOfSteps,10:F4} {cost,8:F0} {timing.BytesPerBody,7:F0} "
                    + $"{cost / reference,6:F2}"));
        }
    }
}
