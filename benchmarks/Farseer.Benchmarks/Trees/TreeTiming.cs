using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using Farseer.Engine.Joints;
using Farseer.Engine.Simulation;

namespace Farseer.Benchmarks.Trees;

/// <summary>
/// The verb <c>trees</c>: what a body of a tree costs in a substep, whole steps taken together, with trees side by side and one by one; and
/// the hash of the state at the end, by which a change shows that it kept the bits.
/// </summary>
internal static class TreeTiming
{
    public const string Usage = "trees [NAME | kinds [PART]] [--runs N] [--lanes]";

    private const float Dt = 1f / 60;
    private const int WarmSteps = 60;
    private const int Steps = 240;
    private const int DefaultRuns = 5;
    private const double WarmSeconds = 2;

    private static readonly Scene[] Scenes =
    [
        new("rope", "a hanging rope of 100 links", () => TreeScenes.Ropes(1, 100, false)),
        new("ropes", "64 hanging ropes of 20 links", () => TreeScenes.Ropes(64, 20, false)),
        new("swing", "a rope of 30 links let go from the side", () => TreeScenes.Ropes(1, 30, true)),
        new("swings", "64 ropes of 20 links let go from the side", () => TreeScenes.Ropes(64, 20, true)),
        new("welds", "64 beams of 20 welded parts, held at one end", () => TreeScenes.Chains(64, JointKind.Weld, true)),
        new("slides", "64 ladders of 20 slides with limits, in flight", () => TreeScenes.Chains(64, JointKind.Prismatic, false)),
        new("rods", "64 pendulums of 10 rods let go from the side", () => TreeScenes.Pendulums(64)),
        new("weld", "one such beam", () => TreeScenes.Chains(1, JointKind.Weld, true)),
        new("crane", "one crane of five driven arms", () => TreeScenes.Cranes(1)),
        new("cranes", "64 cranes of five driven arms", () => TreeScenes.Cranes(64)),
        new("cars", "64 cars with two sprung and driven wheels, in the air", () => TreeScenes.Cars(64, false)),
        new("drive", "the same on a floor", () => TreeScenes.Cars(64, true)),
        new("bridge", "ten bridges of 20 planks under ten planks' load", () => TreeScenes.Bridges(10)),
        new("flight", "64 ragdolls in flight, limits in their hinges", () => TreeScenes.Ragdolls(64, false, false)),
        new("friction", "64 ragdolls in flight, limits and friction in their hinges", () => TreeScenes.Ragdolls(64, true, false)),
        new("ragdolls", "64 ragdolls on a floor, limits in their hinges", () => TreeScenes.Ragdolls(64, false, true)),
        new("puppets", "the same with friction in their hinges", () => TreeScenes.Ragdolls(64, true, true)),
    ];

    public static int Run(ReadOnlySpan<string> arguments, TextWriter output)
    {
        string name = "";
        string part = "";
        int runs = DefaultRuns;
        bool lanesOnly = false;
        for (int i = 0; i < arguments.Length; i++)
        {
            if (arguments[i] == "--runs" && i + 1 < arguments.Length)
            {
                runs = int.Parse(arguments[++i], CultureInfo.InvariantCulture);
            }
            else if (arguments[i] == "--lanes")
            {
                lanesOnly = true;
            }
            else if (name == "kinds")
            {
                part = arguments[i];
            }
            else
            {
                name = arguments[i];
            }
        }

        output.WriteLine($"ns a body and substep: mean over {Steps} steps of the least of {runs} runs; user time, median; the least with trees one by one");
        if (name == "kinds")
        {
            foreach (TreeKinds.Link link in TreeKinds.All)
            {
                if (!link.Name.Contains(part, StringComparison.Ordinal))
                {
                    continue;
                }

                Time(new Scene("air", link.Name, () => TreeScenes.Crowd(64, link, false)), runs, lanesOnly, output);
                Time(new Scene("floor", link.Name, () => TreeScenes.Crowd(64, link, true)), runs, lanesOnly, output);
            }

            return 0;
        }

        foreach (Scene scene in Scenes)
        {
            if (name.Length == 0 || name == scene.Name)
            {
                Time(scene, runs, lanesOnly, output);
            }
        }

        return 0;
    }

    private static void Time(Scene scene, int runs, bool lanesOnly, TextWriter output)
    {
        double lanes = Least(scene, runs, true, out double user, out ulong hash);
        ulong other = hash;
        double single = lanesOnly ? double.NaN : Least(scene, runs, false, out _, out other);
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"  {scene.Name,-9} {lanes,6:F0} {user,6:F0} {single,6:F0}  {hash:x16} {(hash == other ? "same bits" : "OTHER BITS")}  {scene.Title}"));
    }

    /// <summary>Of each step the least time of all runs, which leaves out what else the machine did meanwhile; their mean.</summary>
    private static double Least(Scene scene, int runs, bool onLanes, out double user, out ulong hash)
    {
        var least = new double[Steps];
        Array.Fill(least, double.PositiveInfinity);
        var users = new double[runs];
        double units = 1;
        hash = 0;
        long begin = Stopwatch.GetTimestamp();
        for (int run = 0; run < runs; run++)
        {
            using World world = scene.Build();
            world.TreesOnLanes = onLanes;
            world.TreesAsChains = onLanes;
            for (int step = 0; step < WarmSteps; step++)
            {
                world.Step(Dt);
            }

            units = world.Settings.Substeps * MovingBodies(world);
            TimeSpan before = Process.GetCurrentProcess().UserProcessorTime;
            for (int step = 0; step < Steps; step++)
            {
                long start = Stopwatch.GetTimestamp();
                world.Step(Dt);
                least[step] = Math.Min(least[step], Stopwatch.GetElapsedTime(start).TotalNanoseconds / units);
            }

            users[run] = (Process.GetCurrentProcess().UserProcessorTime - before).TotalNanoseconds / (Steps * units);
            hash = world.StateHash();

            // As many runs more as the compiler takes to be done with the passes of a small scene.
            run -= run == 0 && Stopwatch.GetElapsedTime(begin).TotalSeconds < WarmSeconds ? 1 : 0;
        }

        Array.Sort(users);
        user = users[runs / 2];
        double sum = 0;
        foreach (double time in least)
        {
            sum += time;
        }

        return sum / Steps;
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
