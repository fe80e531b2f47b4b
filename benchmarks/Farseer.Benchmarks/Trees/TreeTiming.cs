using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using Farseer.Engine.Simulation;

namespace Farseer.Benchmarks.Trees;

/// <summary>
/// The verb <c>trees</c>: what a body of a tree costs in a substep, whole steps taken together, and the hash of the state at the end, by
/// which a change shows that it kept the bits.
/// </summary>
internal static class TreeTiming
{
    public const string Usage = "trees [NAME] [--runs N]";

    private const float Dt = 1f / 60;
    private const int WarmSteps = 60;
    private const int Steps = 240;
    private const int DefaultRuns = 5;

    private static readonly Scene[] Scenes =
    [
        new("rope", "a hanging rope of 100 links", () => TreeScenes.Ropes(1, 100, false)),
        new("ropes", "64 hanging ropes of 20 links", () => TreeScenes.Ropes(64, 20, false)),
        new("swing", "a rope of 30 links let go from the side", () => TreeScenes.Ropes(1, 30, true)),
        new("swings", "64 ropes of 20 links let go from the side", () => TreeScenes.Ropes(64, 20, true)),
        new("bridge", "ten bridges of 20 planks under ten planks' load", () => TreeScenes.Bridges(10)),
        new("flight", "64 ragdolls in flight, limits in their hinges", () => TreeScenes.Ragdolls(64, false, false)),
        new("ragdolls", "64 ragdolls on a floor, limits in their hinges", () => TreeScenes.Ragdolls(64, false, true)),
        new("puppets", "the same with friction in their hinges", () => TreeScenes.Ragdolls(64, true, true)),
    ];

    public static int Run(ReadOnlySpan<string> arguments, TextWriter output)
    {
        string name = "";
        int runs = DefaultRuns;
        for (int i = 0; i < arguments.Length; i++)
        {
            if (arguments[i] == "--runs" && i + 1 < arguments.Length)
            {
                runs = int.Parse(arguments[++i], CultureInfo.InvariantCulture);
            }
            else
            {
                name = arguments[i];
            }
        }

        output.WriteLine($"ns a body and substep, least and median of {runs} runs of {Steps} steps; user time of the process, median");
        foreach (Scene scene in Scenes)
        {
            if (name.Length == 0 || name == scene.Name)
            {
                Time(scene, runs, output);
            }
        }

        return 0;
    }

    private static void Time(Scene scene, int runs, TextWriter output)
    {
        var wall = new double[runs];
        var user = new double[runs];
        ulong hash = 0;
        for (int run = -1; run < runs; run++)
        {
            using World world = scene.Build();
            for (int step = 0; step < WarmSteps; step++)
            {
                world.Step(Dt);
            }

            TimeSpan before = Process.GetCurrentProcess().UserProcessorTime;
            long start = Stopwatch.GetTimestamp();
            for (int step = 0; step < Steps; step++)
            {
                world.Step(Dt);
            }

            TimeSpan time = Stopwatch.GetElapsedTime(start);
            double units = (double)Steps * world.Settings.Substeps * MovingBodies(world);
            if (run >= 0)
            {
                wall[run] = time.TotalNanoseconds / units;
                user[run] = (Process.GetCurrentProcess().UserProcessorTime - before).TotalNanoseconds / units;
            }

            hash = world.StateHash();
        }

        Array.Sort(wall);
        Array.Sort(user);
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"  {scene.Name,-9} {wall[0],6:F0} {wall[runs / 2],6:F0} {user[runs / 2],6:F0}  {hash:x16}  {scene.Title}"));
    }

    private static int MovingBodies(World world)
    {
        int count = 0;
        for (int body = 1; body < world.Bodies.Ids.End; body++)
        {
            count += world.Bodies.Mass[body].InverseMass > 0 ? 1 : 0;
        }

        return count;
    }

    private sealed record Scene(string Name, string Title, Func<World> Build);
}
