using System;
using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using Farseer.Benchmarks.Scenes;
using Farseer.CommandLines;
using Farseer.Engine.Joints;
using Farseer.Engine.Simulation;

namespace Farseer.Benchmarks.Trees;

/// <summary>
/// The verb <c>trees</c>: what a body of a tree costs in a substep, whole steps taken together, with trees side by side and one by one; and
/// the hash of the state at the end, by which a change shows that it kept the bits.
/// </summary>
internal static class TreeTiming
{
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

    private static readonly Argument<string?> _name = Verb.Maybe("name", "the name of one scene, or 'kinds' for each kind of link");
    private static readonly Argument<string?> _part = Verb.Maybe("part", "of 'kinds', those whose name has it");
    private static readonly Option<int> _runs = Values.Whole("--runs", "runs of a scene", 1, int.MaxValue, DefaultRuns);
    private static readonly Option<bool> _lanes = Values.Flag("--lanes", "side by side alone, not one by one");
    private static readonly ValueOption<string?> _csv = Values.File("--csv", "writes the times to a file too");

    public static Command Create() =>
        Verb.Of("trees", "Time of trees of joints, ns a body and substep.", Run, _name, _part, _runs, _lanes, _csv);

    private static int Run(ParseResult result)
    {
        TextWriter output = result.Output();
        string name = result.GetValue(_name) ?? string.Empty;
        string part = result.GetValue(_part) ?? string.Empty;
        int runs = result.GetValue(_runs);
        bool lanesOnly = result.GetValue(_lanes);
        using StreamWriter? csv = Values.Open(_csv.Name, result.GetValue(_csv));
        csv?.WriteLine(StepTimes.CsvHeader);
        output.WriteLine($"ns a body and substep: mean over {Steps} steps of the least of {runs} runs; user time, median; the least with "
            + $"trees one by one");
        if (name == "kinds")
        {
            foreach (TreeKinds.Link link in TreeKinds.All)
            {
                if (!link.Name.Contains(part, StringComparison.Ordinal))
                {
                    continue;
                }

                Time(new Scene("air", link.Name, () => TreeScenes.Crowd(64, link, false), link.Name), runs, lanesOnly, output, csv);
                Time(new Scene("floor", link.Name, () => TreeScenes.Crowd(64, link, true), link.Name), runs, lanesOnly, output, csv);
            }

            return 0;
        }

        foreach (Scene scene in Scenes)
        {
            if (name.Length == 0 || name == scene.Name)
            {
                Time(scene, runs, lanesOnly, output, csv);
            }
        }

        return 0;
    }

    private static void Time(Scene scene, int runs, bool lanesOnly, TextWriter output, StreamWriter? csv)
    {
        Cost lanes = Measure(scene, runs, true);
        Cost? single = lanesOnly ? null : Measure(scene, runs, false);
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"  {scene.Name,-9} {lanes.Of(lanes.Least),6:F0} {lanes.Of(lanes.User),6:F0} {single?.Of(single.Least) ?? double.NaN,6:F0}  "
                + $"{lanes.Hash:x16} {((single ?? lanes).Hash == lanes.Hash ? "same bits" : "OTHER BITS")}  {scene.Title}"));
        string name = scene.Kind.Length == 0 ? scene.Name : $"{scene.Name} {scene.Kind.Replace(',', ';')}";
        csv?.WriteLine(StepTimes.ToCsv(name, lanes.Bodies, lanes.Run, lanes.Median, lanes.Least, lanes.Hash));
    }

    /// <summary>Of each step the least time of all runs, which leaves out what else the machine did meanwhile; their mean.</summary>
    private static Cost Measure(Scene scene, int runs, bool onLanes)
    {
        var times = new StepTimes(Steps);
        var users = new double[runs];
        int bodies = 0;
        int substeps = 0;
        ulong hash = 0;
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

            TimeSpan before = Process.GetCurrentProcess().UserProcessorTime;
            for (int step = 0; step < Steps; step++)
            {
                long start = Stopwatch.GetTimestamp();
                world.Step(Dt);
                times.Add(step, Stopwatch.GetElapsedTime(start).TotalMilliseconds);
            }

            users[run] = (Process.GetCurrentProcess().UserProcessorTime - before).TotalMilliseconds / Steps;
            times.EndRun();
            substeps = world.Settings.Substeps;
            bodies = MovingBodies(world);
            hash = world.Bodies.MotionHash();

            // As many runs more as the compiler takes to be done with the passes of a small scene.
            run -= run == 0 && Stopwatch.GetElapsedTime(begin).TotalSeconds < WarmSeconds ? 1 : 0;
        }

        Array.Sort(users);
        return new Cost(times.Quiet / Steps, times.LeastRun / Steps, times.MedianRun / Steps, users[runs / 2], bodies, substeps, hash);
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

    /// <param name="Kind">Of the joints, in a crowd of one kind.</param>
    private sealed record Scene(string Name, string Title, Func<World> Build, string Kind = "");

    /// <param name="Least">Milliseconds a step, of a run made of the fastest of each step.</param>
    /// <param name="Run">Of the fastest run.</param>
    /// <param name="Median">Of the median run.</param>
    /// <param name="User">The processor's time, of the median run.</param>
    private sealed record Cost(double Least, double Run, double Median, double User, int Bodies, int Substeps, ulong Hash)
    {
        /// <summary>Nanoseconds a body and substep.</summary>
        public double Of(double milliseconds) => 1e6 * milliseconds / (Bodies * Substeps);
    }
}
