using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Runtime;
using Farseer.Benchmarks.Memory;
using Farseer.Benchmarks.Scenes;
using Farseer.CommandLines;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Worlds;

/// <summary>
/// The verb <c>worlds-in-numbers</c>: what worlds take, small and large, few and many, in one table beside what is aimed at. Each figure is
/// measured in a process of its own.
/// </summary>
internal static class WorldFigures
{
    private const string Name = "worlds-in-numbers";
    private const int Rooms = 10_000;
    private const int Circles = 1_000_000;
    private const int FewCircles = 1000;
    private const int ManyCircles = 100_000;

    /// <summary>990 and 99,681 boxes.</summary>
    private const int FewBase = 44;
    private const int ManyBase = 446;
    private const int Steps = 60;
    private const int FewRuns = 100;
    private const int ManyRuns = 2;
    private const int Worlds = 256;
    private const int Boxes = 10;

    /// <summary>Processes of which the middle one counts, where the compiler is what takes time.</summary>
    private const int Processes = 5;
    private const float Dt = 1f / 60;
    private const double Kibi = 1024;
    private const double Giga = 1e9;

    private static readonly Figure[] _all =
    [
        new("empty", "an empty world, KiB", 40, 1, () => WorldMemory.Bytes(new PhysicsSimulator()) / Kibi),
        new("room", "floor and ten boxes, KiB", 70, 1, () => WorldMemory.Bytes(WorldMemory.Room()) / Kibi),
        new("rooms", "10,000 such worlds, GB of resident memory", 0.8, 1, () => WorldMemory.Resident(Rooms) / Giga),
        new("pyramid", "large_pyramid, bytes a body", 1400, 1, () => BytesABody(new LargePyramid(), new LargePyramid().DefaultSize)),
        new("million", "a million circles, GB", 1.5, 1, () => BytesABody(new CirclePile(), Circles) * Circles / Giga),
        new("boxes", "99,681 boxes of a pyramid, time a body to that of 990", 1.8, 1, () => Ratio(new LargePyramid(), FewBase, ManyBase)),
        new("circles", "100,000 circles, time a body to that of 1,000", 1.8, 1, () => Ratio(new CirclePile(), FewCircles, ManyCircles)),
        new("turns", "256 worlds in turn to one after the other, quiet", 1.2, 1, () => InTurn(t => t.LeastRun)),
        new("busy", "the same, median", double.NaN, 1, () => InTurn(t => t.MedianRun)),
        new("first", "first step of ten boxes, ms of processor time", 40, Processes, FirstStep),
        new("methods", "methods compiled in it", double.NaN, 1, MethodsOfFirstStep),
    ];

    private static readonly Argument<string?> _one = Verb.Maybe("figure", "the name of one of them, measured here; without, all");

    public static Command Create() => Verb.Of(Name, "What worlds take, small and large, few and many, beside what is aimed at.", Run, _one);

    private static int Run(ParseResult result)
    {
        TextWriter output = result.Output();
        if (result.GetValue(_one) is string name)
        {
            Figure one = Array.Find(_all, f => f.Name == name)
                ?? throw new UsageException(
                    $"no figure is called '{name}'; there are {string.Join(", ", Array.ConvertAll(_all, f => f.Name))}.");
            output.WriteLine(one.Measure().ToString("R", CultureInfo.InvariantCulture));
            return 0;
        }

        output.WriteLine("| | aim | measured |");
        output.WriteLine("|---|---|---|");
        foreach (Figure figure in _all)
        {
            string aim = double.IsNaN(figure.Aim) ? "" : figure.Aim.ToString("G5", CultureInfo.InvariantCulture);
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"| {figure.Meaning} | {aim} | {Apart(figure):G4} |"));
        }

        return 0;
    }

    /// <summary>The median of processes of their own.</summary>
    private static double Apart(Figure figure)
    {
        var values = new List<double>();
        for (int i = 0; i < figure.Runs; i++)
        {
            var start = new ProcessStartInfo(Environment.ProcessPath!) { RedirectStandardOutput = true };
            if (Path.GetFileNameWithoutExtension(Environment.ProcessPath!) == "dotnet")
            {
                start.ArgumentList.Add(typeof(WorldFigures).Assembly.Location);
            }

            start.ArgumentList.Add(Name);
            start.ArgumentList.Add(figure.Name);
            using Process process = Process.Start(start)!;
            string printed = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            values.Add(double.Parse(printed, CultureInfo.InvariantCulture));
        }

        values.Sort();
        return values[values.Count / 2];
    }

    private static double BytesABody(PerformanceScene scene, int size)
    {
        long before = GC.GetTotalMemory(forceFullCollection: true);
        using var simulator = new PhysicsSimulator();
        scene.Build(simulator, size);
        for (int i = 0; i < Steps; i++)
        {
            scene.Drive(i);
            simulator.Update(scene.Dt);
        }

        return (GC.GetTotalMemory(forceFullCollection: true) - before) / (double)simulator.BodyList.Count;
    }

    private static double Ratio(PerformanceScene scene, int few, int many)
    {
        double Cost(int size, int runs)
        {
            var timing = new SceneTiming(scene, size, Steps, workers: 1);
            timing.Run(runs);
            return timing.BestOfSteps / timing.DynamicBodies;
        }

        return Cost(many, ManyRuns) / Cost(few, FewRuns);
    }

    private static double InTurn(Func<StepTimes, double> of)
    {
        (StepTimes consecutive, StepTimes inTurn) = TurnTiming.Measure(Worlds);
        return of(inTurn) / of(consecutive);
    }

    /// <summary>Boxes that lie on the ground: their first step has contacts.</summary>
    private static PhysicsSimulator TenBoxes()
    {
        var simulator = new PhysicsSimulator();
        Verb.Scene("resting_boxes").Build(simulator, Boxes);
        return simulator;
    }

    private static double FirstStep()
    {
        using PhysicsSimulator simulator = TenBoxes();
        TimeSpan before = Environment.CpuUsage.TotalTime;
        simulator.Update(Dt);
        return (Environment.CpuUsage.TotalTime - before).TotalMilliseconds;
    }

    private static double MethodsOfFirstStep()
    {
        using PhysicsSimulator simulator = TenBoxes();
        long before = JitInfo.GetCompiledMethodCount();
        simulator.Update(Dt);
        return JitInfo.GetCompiledMethodCount() - before;
    }

    private sealed record Figure(string Name, string Meaning, double Aim, int Runs, Func<double> Measure);
}
