using System;
using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using Farseer.CommandLines;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Scenes;

/// <summary>
/// The verb <c>resting</c>: worlds of 1 to 20 boxes at rest, as most games are most of the time. Such a step takes as long as some fifty
/// readings of the clock, so it is read once for a block of them; of many blocks the fastest counts, by turns among the sizes.
/// </summary>
internal static class RestingTiming
{
    private const int Steps = 100_000;
    private const int BlockSteps = 2000;
    private const int WarmBlocks = 50;
    private const int Blocks = 200;

    private static readonly int[] Sizes = [1, 5, 10, 20];

    private static readonly ValueOption<string?> _csv = Values.File("--csv", "writes the times to a file too");

    public static Command Create() => Verb.Of("resting", "Time of a step of 1, 5, 10 and 20 boxes at rest.", Run, _csv);

    private static int Run(ParseResult result)
    {
        using StreamWriter? csv = Values.Open(_csv.Name, result.GetValue(_csv));
        Measure(result.Output(), csv);
        return 0;
    }

    private static void Measure(TextWriter output, StreamWriter? csv)
    {
        var scene = new RestingBoxes();
        var simulators = new PhysicsSimulator[Sizes.Length];
        var times = new double[Sizes.Length][];
        for (int i = 0; i < Sizes.Length; i++)
        {
            simulators[i] = new PhysicsSimulator { WorkerCount = 1 };
            scene.Build(simulators[i], Sizes[i]);
            times[i] = new double[Blocks];
        }

        for (int block = 0; block < WarmBlocks + Blocks; block++)
        {
            for (int i = 0; i < Sizes.Length; i++)
            {
                double seconds = RunBlock(simulators[i], scene.Dt);
                if (block >= WarmBlocks)
                {
                    times[i][block - WarmBlocks] = seconds;
                }
            }
        }

        csv?.WriteLine(StepTimes.CsvHeader);
        output.WriteLine($"boxes at rest, fastest of {Blocks} blocks of {BlockSteps} steps");
        for (int i = 0; i < Sizes.Length; i++)
        {
            Array.Sort(times[i]);
            double microseconds = 1e6 * times[i][0] / BlockSteps;
            double median = 1e6 * times[i][Blocks / 2] / BlockSteps;
            ulong hash = simulators[i].MotionHash();
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{Sizes[i],4} boxes: {microseconds,7:F3} us a step, {1e-3 * microseconds * Steps,7:F1} ms for {Steps} steps, hash "
                    + $"{hash:x16}"));
            csv?.WriteLine(StepTimes.ToCsv(scene.Name, Sizes[i], 1e-3 * microseconds, 1e-3 * median, 1e-3 * microseconds, hash));
            simulators[i].Dispose();
        }
    }

    private static double RunBlock(PhysicsSimulator simulator, float dt)
    {
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < BlockSteps; i++)
        {
            simulator.Update(dt);
        }

        return Stopwatch.GetElapsedTime(start).TotalSeconds;
    }
}
