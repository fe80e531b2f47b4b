using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Scenes;

/// <summary>
/// The verb <c>resting</c>: worlds of 1 to 20 boxes at rest, as most games are most of the time. Such a step takes as long as some fifty readings of
/// the clock, so it is read once for a block of them; of many blocks the fastest counts, by turns among the sizes.
/// </summary>
internal static class RestingTiming
{
    private const int Steps = 100_000;
    private const int BlockSteps = 2000;
    private const int WarmBlocks = 50;
    private const int Blocks = 200;

    private static readonly int[] Sizes = [1, 5, 10, 20];

    public static int Run(TextWriter output)
    {
        var scene = new RestingBoxes();
        var simulators = new PhysicsSimulator[Sizes.Length];
        var least = new double[Sizes.Length];
        for (int i = 0; i < Sizes.Length; i++)
        {
            simulators[i] = new PhysicsSimulator { WorkerCount = 1 };
            scene.Build(simulators[i], Sizes[i]);
            least[i] = double.PositiveInfinity;
        }

        for (int block = 0; block < WarmBlocks + Blocks; block++)
        {
            for (int i = 0; i < Sizes.Length; i++)
            {
                double seconds = RunBlock(simulators[i], scene.Dt);
                least[i] = block < WarmBlocks ? least[i] : Math.Min(least[i], seconds);
            }
        }

        output.WriteLine($"boxes at rest, fastest of {Blocks} blocks of {BlockSteps} steps");
        for (int i = 0; i < Sizes.Length; i++)
        {
            double microseconds = 1e6 * least[i] / BlockSteps;
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{Sizes[i],4} boxes: {microseconds,7:F3} us a step, {1e-3 * microseconds * Steps,7:F1} ms for {Steps} steps, hash {simulators[i].StateHash():x16}"));
            simulators[i].Dispose();
        }

        return 0;
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
