using System;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.Scenes.Performance;
using Farseer.Tests.Shared.Growth;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Jointed;

/// <summary>
/// The verb <c>jointed</c>: processor time of small jointed worlds at the default dials, beside what samples of their kind took in the
/// original engine, and beside an update of the large pyramid, which tells how fast the machine is.
/// </summary>
internal static class JointedTiming
{
    private const int Steps = 600;
    private const int Runs = 5;
    private const float Dt = 0.01f;

    private static readonly (string Name, Func<PhysicsSimulator> Make, double Original)[] _scenes =
    [
        ("spider", JointedScenes.Spider, 0.24),
        ("track", JointedScenes.Track, 0.10),
        ("soft body", JointedScenes.SoftBody, 0.13),
    ];

    public static Command Create() =>
        Verb.Plain("jointed", $"Processor time of {Steps} steps of small jointed worlds, beside the original's.", Run);

    private static int Run(TextWriter output)
    {
        double pyramid = Pyramid();
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"{Steps} steps, least of {Runs} runs; an update of large_pyramid takes {1e3 * pyramid:F2} ms"));
        output.WriteLine("| world | bodies | joints | springs | s | updates of large_pyramid | the original's s | ratio |");
        output.WriteLine("|---|---|---|---|---|---|---|---|");
        int misses = 0;
        foreach ((string name, Func<PhysicsSimulator> make, double original) in _scenes)
        {
            double least = double.PositiveInfinity;
            int bodies = 0;
            int joints = 0;
            int springs = 0;
            for (int run = 0; run < Runs; run++)
            {
                using PhysicsSimulator simulator = make();
                double start = GrowthClock.Seconds();
                for (int i = 0; i < Steps; i++)
                {
                    simulator.Update(Dt);
                }

                least = Math.Min(least, GrowthClock.Seconds() - start);
                (bodies, joints, springs) = (simulator.BodyList.Count, simulator.JointList.Count, simulator.SpringList.Count);
            }

            misses += least > original ? 1 : 0;
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"| {name} | {bodies} | {joints} | {springs} | {least:F3} | {least / pyramid:F0} | {original:F2} | "
                    + $"{least / original:F2} |"));
        }

        return misses == 0 ? 0 : 1;
    }

    private static double Pyramid()
    {
        var scene = new LargePyramid();
        using var simulator = new PhysicsSimulator();
        scene.Build(simulator, scene.DefaultSize);
        double least = double.PositiveInfinity;
        for (int i = 0; i < 60; i++)
        {
            double start = GrowthClock.Seconds();
            simulator.Update(scene.Dt);
            least = Math.Min(least, GrowthClock.Seconds() - start);
        }

        return least;
    }
}
