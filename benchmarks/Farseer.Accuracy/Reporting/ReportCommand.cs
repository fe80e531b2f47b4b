using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Text;
using Farseer.Accuracy.Sweeping;
using Farseer.CommandLines;

namespace Farseer.Accuracy.Reporting;

/// <summary>Renews the generated parts of docs/Accuracy.md and its plots; the prose between them is kept.</summary>
internal static class ReportCommand
{
    private const string Document = "Accuracy.md";
    private const string PlotFolder = "plots";

    private static readonly Option<bool> _plotsOnly = Values.Flag("--plots", "the plots alone");
    private static readonly ValueOption<string?> _docs = GeneratedPart.FolderOption();

    public static Command Create() => Cli.Plain(
        "report", "Writes the tables and plots of docs/Accuracy.md from the stored sweep and fresh runs.", Run, _plotsOnly, _docs);

    private static void Run(ParseResult result)
    {
        (string folder, string path, string text) = GeneratedPart.Open("report", Document, result.GetValue(_docs));
        var points = new List<SweepPoint>(SweepData.Stored());
        points.AddRange(SweepData.Peers());
        text = GeneratedPart.Replaced(text, "plots", Plots(folder, points));
        if (!result.GetValue(_plotsOnly))
        {
            text = GeneratedPart.Replaced(text, "aims", AimLines());
            text = GeneratedPart.Replaced(text, "costs", Costs.Lines());
            text = GeneratedPart.Replaced(text, "sweep", SweepLines(points));
            text = GeneratedPart.Replaced(text, "floors", FloorLines(points));
            text = GeneratedPart.Replaced(text, "extremes", Extremes.ExtremesCommand.Lines());
        }

        File.WriteAllText(path, text);
        result.Output().WriteLine($"written: {path} and {SweepScene.All.Count} plots");
    }

    private static List<string> AimLines()
    {
        List<AimResult> results = AimTable.Measure();
        List<string> lines = AimTable.Lines(results);
        int met = results.FindAll(r => r.IsMet).Count;
        lines.Add(string.Empty);
        lines.Add(Invariant($"{met} of {results.Count} aims are met."));
        return lines;
    }

    private static List<string> SweepLines(IReadOnlyList<SweepPoint> points)
    {
        var lines = new List<string>
        {
            "| engine | hypervolume | worst scene | time to 1 %, geometric mean | scenes within 1 % |", "|---|---|---|---|---|",
        };
        List<string> engines = SweepTables.Engines(points);
        foreach (string engine in engines)
        {
            (double mean, double worst, string name) = SweepTables.Hypervolume(points, engine);
            (double time, int reached) = SweepTables.TimeToTolerance(points, engine);
            lines.Add(Invariant($"| {engine} | {mean:F3} | `{name}` ({worst:F3}) | {time:F0} ns | {reached} of {SweepScene.All.Count} |"));
        }

        lines.Add(string.Empty);
        lines.Add("Least time, in ns a body and 1/60 s, with an error of at most 1 % of the failure scale:");
        lines.Add(string.Empty);
        lines.Add($"| scene | {string.Join(" | ", engines)} |");
        lines.Add("|---|" + string.Concat(System.Linq.Enumerable.Repeat("---|", engines.Count)));
        foreach (SweepScene scene in SweepScene.All)
        {
            var line = new StringBuilder($"| {scene.Title} |");
            foreach (string engine in engines)
            {
                SweepPoint? best = Pareto.Cheapest(SweepTables.Of(points, engine, scene.Scene, SweepKind.Dial), SweepScene.Tolerance);
                line.Append(best is null ? " never |" : Invariant($" {best.Cost:F0} |"));
            }

            lines.Add(line.ToString());
        }

        lines.Add(string.Empty);
        lines.Add($"Least time with no larger an error than {SweepData.DefaultPeer} has at its default, also at longer steps:");
        lines.Add(string.Empty);
        lines.Add("| scene | its error, share of the scale | its time, ns | Farseer | ratio | setting |");
        lines.Add("|---|---|---|---|---|---|");
        foreach (PeerMatch match in SweepTables.ToDefaultOf(points, SweepData.DefaultPeer))
        {
            string own = match.Own is null ? "never | –" : Invariant($"{match.Own.Cost:F0} | {match.Ratio:F2}");
            lines.Add(Invariant($"| {match.Scene.Title} | {match.Error:G2} | {match.PeerCost:F0} | {own} | {match.Setting} |"));
        }

        return lines;
    }

    private static List<string> Plots(string folder, IReadOnlyList<SweepPoint> points)
    {
        string plots = Path.Combine(folder, PlotFolder);
        Directory.CreateDirectory(plots);
        var lines = new List<string>();
        foreach (SweepScene scene in SweepScene.All)
        {
            var own = new List<SweepPoint>();
            foreach (SweepPoint point in points)
            {
                if (point.Scene == scene.Scene && point.Kind == SweepKind.Dial)
                {
                    own.Add(point);
                }
            }

            string name = scene.Scene[..scene.Scene.IndexOf('_', StringComparison.Ordinal)] + ".svg";
            File.WriteAllText(Path.Combine(plots, name), SvgPlot.Draw(scene, own));
            lines.Add($"![{scene.Title}: error against cost, all engines]({PlotFolder}/{name})");
        }

        return lines;
    }

    private static List<string> FloorLines(IReadOnlyList<SweepPoint> points)
    {
        var lines = new List<string> { "| engine | floors | scenes |", "|---|---|---|" };
        foreach (string engine in SweepTables.Engines(points))
        {
            List<string> floors = SweepTables.Floors(points, engine);
            var scenes = new List<string>();
            foreach (string floor in floors)
            {
                string scene = floor[..floor.IndexOf('_', StringComparison.Ordinal)];
                if (!scenes.Contains(scene))
                {
                    scenes.Add(scene);
                }
            }

            lines.Add(Invariant($"| {engine} | {floors.Count} | {string.Join(", ", scenes)} |"));
        }

        List<string> ours = SweepTables.Floors(points, SweepPoint.Own);
        lines.Add(string.Empty);
        lines.Add(ours.Count == 0 ? "None is this library's." : "Those of this library:");
        lines.Add(string.Empty);
        foreach (string floor in ours)
        {
            lines.Add($"- {floor}");
        }

        return lines;
    }

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);
}
