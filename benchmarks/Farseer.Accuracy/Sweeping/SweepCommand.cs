using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using Farseer.CommandLines;

namespace Farseer.Accuracy.Sweeping;

/// <summary>Runs the dials of the ten scenes of the sweep and prints what they are worth beside other engines.</summary>
internal static class SweepCommand
{
    /// <summary>The published dials, and the doublings by which floors are found.</summary>
    private static readonly int[] _iterations = [1, 2, 4, 5, 8, 10, 16, 20, 32, 40, 64];

    /// <summary>Shorter outer steps with fewer iterations each.</summary>
    private static readonly (int Divisor, int Iterations)[] _outer = [(2, 1), (2, 3), (4, 1), (4, 2), (8, 1)];

    /// <summary>Longer outer steps, 1/30, 1/15, 1/10 and 1/8 s, as multiples, with the iterations tried in each.</summary>
    private static readonly double[] _longSteps = [2, 4, 6, 7.5];
    private static readonly int[] _longIterations = [1, 2, 3, 4, 5, 8];

    private static readonly (string Scene, string Metric)[] _stepLengthScenes =
    [
        ("S03_bounce=0.8", "apex_max_rel_error"), ("S05_friction_slide=0.3", "dist_rel_error"), ("S08_pendulum=90", "energy_rel_drift_60s"),
        ("S11_rope=100", "stretch_pct"), ("S14_spring=2005", "damping_ratio_error"), ("S15_stack=10", "height_error_pct_of_box"),
        ("S17_mass_ratio=100", "height_error_mm"),
    ];

    private static readonly double[] _steps = [1.0 / 15, 1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 1000];

    private static readonly ValueOption<string?> _out = Values.File("--out", "writes the points to a file too");
    private static readonly Option<int> _runs = Values.Whole("--runs", "runs for the clock", 1, 1000, 3);

    public static Command Create() => Cli.Plain(
        "sweep", "The dials of ten scenes: error against cost, hypervolume, time to 1 %, floors.", Run, _out, _runs);

    private static void Run(ParseResult result)
    {
        TextWriter output = result.Output();
        string? path = result.GetValue(_out);
        WarmUp();
        List<SweepPoint> own = Measure(result.GetValue(_runs), output);
        if (path is not null)
        {
            SweepData.Write(path, own);
        }

        var all = new List<SweepPoint>(own);
        all.AddRange(SweepData.Peers());
        SweepTables.Print(all, output);
    }

    /// <summary>Cost in nanoseconds for a body and 1/60 s, and the error as a share of the scale.</summary>
    public static SweepPoint Measure(SweepScene scene, SweepKind kind, int iterations, double dt, int runs)
    {
        List<Row> rows = Runner.Run(Options.ParseScene(scene.Scene), new Dial(iterations, dt), runs);
        Row main = rows.Find(row => row.Metric == scene.Metric)!;
        bool fell = rows.Exists(row => (row.Metric == "stood" && row.Value == 0) || (row.Metric == "load_lost" && row.Value != 0));
        double error = Math.Abs(main.Value) / scene.Scale;
        bool failed = fell || !(error < 1);
        double cost = main.NanosecondsPerBodyStep * SweepPoint.Frame / dt;
        return new SweepPoint(SweepPoint.Own, scene.Scene, kind, iterations, dt, failed ? 1 : error, cost, failed);
    }

    /// <summary>
    /// Scenes of one body end before the code that they run is compiled to its last stage, and the first of them paid four times what
    /// it costs: all scenes run once before any is timed, and again when the compiler has had time.
    /// </summary>
    public static void WarmUp() => WarmUp(SweepScene.All.Select(scene => scene.Scene));

    /// <inheritdoc cref="WarmUp()"/>
    public static void WarmUp(IEnumerable<string> scenes)
    {
        for (int i = 0; i < 3; i++)
        {
            foreach (string scene in scenes)
            {
                Runner.Run(Options.ParseScene(scene), new Dial(Options.DefaultIterations, Options.DefaultDt), 1);
            }

            Thread.Sleep(500);
        }
    }

    private static List<SweepPoint> Measure(int runs, TextWriter output)
    {
        var points = new List<SweepPoint>();
        foreach (SweepScene scene in SweepScene.All)
        {
            output.WriteLine($"{scene.Scene}: {scene.Metric}");
            foreach (int iterations in _iterations)
            {
                points.Add(Show(Measure(scene, SweepKind.Dial, iterations, Options.DefaultDt, runs), output));
            }

            foreach ((int divisor, int iterations) in _outer)
            {
                points.Add(Show(Measure(scene, SweepKind.Dial, iterations, Options.DefaultDt / divisor, runs), output));
            }

            foreach (double factor in _longSteps)
            {
                foreach (int iterations in _longIterations)
                {
                    points.Add(Show(Measure(scene, SweepKind.LongStep, iterations, Options.DefaultDt * factor, runs), output));
                }
            }
        }

        foreach ((string name, string metric) in _stepLengthScenes)
        {
            SweepScene scene = SweepScene.Find(name)
                ?? new SweepScene(name, metric, metric.Contains("pct", StringComparison.Ordinal) ? 100 : 1, name, 1e-6);
            output.WriteLine($"{scene.Scene}: {scene.Metric}, step lengths");
            foreach (double dt in _steps)
            {
                points.Add(Show(Measure(scene, SweepKind.StepLength, Options.DefaultIterations, dt, 1), output));
            }
        }

        return points;
    }

    private static SweepPoint Show(SweepPoint p, TextWriter output)
    {
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"    iterations {p.Dial,3}  dt {p.Dt,10:G6}  error {p.Error,12:G5} of the scale  {p.Cost,9:F0} ns a body and 1/60 "
                + $"s{(p.Failed ? "  failed" : string.Empty)}"));
        output.Flush();
        return p;
    }
}
