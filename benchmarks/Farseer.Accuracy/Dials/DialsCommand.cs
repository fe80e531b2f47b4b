using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using Farseer.Accuracy.Reporting;
using Farseer.Accuracy.Sweeping;
using Farseer.CommandLines;

namespace Farseer.Accuracy.Dials;

/// <summary>Renews the tables and plots of docs/Dials.md, and the plot that README.md shows.</summary>
internal static class DialsCommand
{
    public const string Document = "Dials.md";
    public const string Part = "dials";
    public const string Overall = "error-against-time.svg";

    /// <summary>Of timing, for a scene and for another setting.</summary>
    private const double Seconds = 5;
    private const double OtherSeconds = 1.5;
    private const string PlotFolder = "plots";

    private static readonly ValueOption<string?> _docs = GeneratedPart.FolderOption();

    public static Command Create() => Cli.Plain(
        "dials", "Writes docs/Dials.md: what Iterations, 1/dt and other settings give and take in a dozen kinds of scene.", Run, _docs);

    private static void Run(ParseResult result)
    {
        TextWriter output = result.Output();
        (string folder, string path, string text) = GeneratedPart.Open("dials", Document, result.GetValue(_docs));
        GeneratedPart.Read(text, Part);
        string plots = Path.Combine(folder, PlotFolder);
        Directory.CreateDirectory(plots);
        File.WriteAllText(Path.Combine(plots, Overall), OverallPlot.Draw([.. SweepData.Stored(), .. SweepData.Peers()]));
        var results = new List<DialResult>();
        foreach (DialKind kind in DialKinds.All)
        {
            DialResult measured = DialRuns.Measure(kind, Seconds);
            results.Add(measured);
            output.WriteLine(Row(measured));
            output.Flush();
            File.WriteAllText(Path.Combine(plots, PlotName(kind)), Plot(measured));
        }

        var lines = new List<string>(Table(results)) { string.Empty };
        lines.AddRange(OtherTable(output));
        lines.Add(string.Empty);
        lines.AddRange(Sections(results));
        File.WriteAllText(path, GeneratedPart.Replaced(text, Part, lines));
        output.WriteLine($"written: {path} and {results.Count + 1} plots");
    }

    /// <summary>The row of a kind in the table.</summary>
    public static string Row(DialResult result)
    {
        string chance = result.Chance > result.Kind.Rounding ? Figure(result.Chance) : "–";
        DialCurve i = result.Iterations;
        DialCurve s = result.Steps;
        return FormattableString.Invariant(
            $"| {result.Kind.Title} | {result.Kind.Error} | {Figure(i.Default)} | {Figure(i.Doubled)} | {Figure(s.Doubled)} ")
            + FormattableString.Invariant($"| {Order(i)} | {Order(s)} | {i.CostFactor:F1} | {s.CostFactor:F1} ")
            + $"| {chance} | {result.Turn} |";
    }

    private static List<string> Table(List<DialResult> results)
    {
        var lines = new List<string>
        {
            "| scene | error | at the default | `Iterations` × 2 | 1/dt × 2 | order, `Iterations` | order, 1/dt "
            + "| time, `Iterations` × 2 | time, 1/dt × 2 | chance | turn |",
            "|---|---|---|---|---|---|---|---|---|---|---|",
        };
        lines.AddRange(results.ConvertAll(Row));
        return lines;
    }

    private static List<string> OtherTable(TextWriter output)
    {
        var lines = new List<string> { "| setting | scene | error | before | after | time |", "|---|---|---|---|---|---|" };
        foreach (OtherDial dial in OtherDials.All)
        {
            List<(double Error, double Cost)> points = DialRuns.Points(dial.Kind, [], [dial.From, dial.To], OtherSeconds);
            lines.Add(FormattableString.Invariant(
                $"| {dial.What} | {dial.Kind.Title} | {dial.Kind.Error} | {Figure(points[0].Error)} | {Figure(points[1].Error)} ")
                + FormattableString.Invariant($"| × {points[1].Cost / points[0].Cost:F2} |"));
            output.WriteLine(lines[^1]);
        }

        return lines;
    }

    private static List<string> Sections(List<DialResult> results)
    {
        var lines = new List<string>();
        foreach (DialResult result in results)
        {
            lines.Add($"### {char.ToUpperInvariant(result.Kind.Title[0])}{result.Kind.Title[1..]}");
            lines.Add(string.Empty);
            lines.Add(result.Kind.Advice);
            lines.Add(string.Empty);
            lines.Add($"![{result.Kind.Title}: error against cost of both dials]({PlotFolder}/{PlotName(result.Kind)})");
            lines.Add(string.Empty);
        }

        lines.RemoveAt(lines.Count - 1);
        return lines;
    }

    private static string PlotName(DialKind kind) => $"dial-{kind.Name}.svg";

    private static string Plot(DialResult result) => SvgPlot.Draw(
        $"{result.Kind.Title}: {result.Kind.Error[..result.Kind.Error.IndexOf(',', StringComparison.Ordinal)]}",
        [
            new PlotSeries("Iterations 5, 10, 20, 40", "#e8590c", Shares(result.Kind, result.Iterations), 0),
            new PlotSeries("1/dt 60, 120, 240, 480", "#4c7fd6", Shares(result.Kind, result.Steps), 0),
        ]);

    private static List<SweepPoint> Shares(DialKind kind, DialCurve curve)
    {
        var points = new List<SweepPoint>();
        foreach ((double error, double cost) in curve.Points)
        {
            double share = error / kind.Failure;
            bool failed = !(share < 1);
            points.Add(new SweepPoint(
                SweepPoint.Own, kind.Name, SweepKind.Dial, points.Count, Options.DefaultDt, failed ? 1 : share, cost, failed));
        }

        return points;
    }

    private static string Order(DialCurve curve) => double.IsNaN(curve.Order) ? "–" : FormattableString.Invariant($"{curve.Order:F1}");

    /// <summary>Two digits; small ones as powers of ten.</summary>
    private static string Figure(double value) => value is 0 or (>= 1e-3 and < 1e4)
        ? double.Parse(FormattableString.Invariant($"{value:G2}"), System.Globalization.CultureInfo.InvariantCulture)
            .ToString("0.#####", System.Globalization.CultureInfo.InvariantCulture)
        : FormattableString.Invariant($"{value:0.0E+0}");
}
