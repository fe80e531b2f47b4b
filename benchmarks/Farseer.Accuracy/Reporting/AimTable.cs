using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Farseer.Accuracy.Sweeping;

namespace Farseer.Accuracy.Reporting;

/// <summary>An aim and what was reached.</summary>
internal sealed record AimResult(Aim Aim, double Limit, double Value, double? BestPeer, string PeerName)
{
    public bool IsMet => Value < Runner.Exploded && (Aim.AtLeast ? Value >= Limit : Value <= Limit);
}

/// <summary>Runs the scenes of the aims.</summary>
internal static class AimTable
{
    private static readonly string[] _peers = ["Box2D.NET", "Aether", "Farseer2.0.1"];

    public static List<AimResult> Measure()
    {
        var done = new Dictionary<string, List<Row>>();
        var results = new List<AimResult>();
        foreach (Aim aim in Aims.All)
        {
            double limit = aim.Times is null ? aim.Limit : aim.Limit * Value(done, aim.Times, aim.Metric);
            double value = Value(done, aim.Scene, aim.Metric);
            (double? best, string name) = BestPeer(done, aim);
            results.Add(new AimResult(aim, limit, value, best, name));
        }

        return results;
    }

    /// <summary>The table as lines of Markdown.</summary>
    public static List<string> Lines(IReadOnlyList<AimResult> results)
    {
        var lines = new List<string> { "| subject | figure | aim | reached | | best peer |", "|---|---|---|---|---|---|" };
        foreach (AimResult r in results)
        {
            string peer = r.BestPeer is null ? "–" : r.BestPeer >= Runner.Exploded ? "fails" : $"{Show(r.BestPeer.Value)} ({r.PeerName})";
            string reached = r.Value >= Runner.Exploded ? "fails" : Show(r.Value);
            lines.Add($"| {r.Aim.Subject} | `{r.Aim.Scene}` {r.Aim.Metric} | {(r.Aim.AtLeast ? "≥ " : "≤ ")}{Show(r.Limit)} | {reached} | "
                + $"{(r.IsMet ? "met" : "**missed**")} | {peer} |");
        }

        return lines;
    }

    public static bool Print(TextWriter output)
    {
        output.WriteLine(Cli.Settings);
        output.WriteLine($"{"scene",-30} {"metric",-28} {"reached",13} {"aim",13}  result   best peer");
        List<AimResult> results = Measure();
        int met = 0;
        foreach (AimResult r in results)
        {
            met += r.IsMet ? 1 : 0;
            string peer = r.BestPeer is null ? "-" : string.Create(CultureInfo.InvariantCulture, $"{r.BestPeer:G4} {r.PeerName}");
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{r.Aim.Scene,-30} {r.Aim.Metric,-28} {r.Value,13:G6} {r.Limit,13:G6}  {(r.IsMet ? "met   " : "MISSED")}   {peer}"));
        }

        output.WriteLine($"{met} met, {results.Count - met} missed");
        return met == results.Count;
    }

    private static string Show(double value) => value == 0 ? "0" : value.ToString("G3", CultureInfo.InvariantCulture);

    private static double Value(Dictionary<string, List<Row>> done, string scene, string metric)
    {
        if (!done.TryGetValue(scene, out List<Row>? rows))
        {
            rows = Runner.Run(Options.ParseScene(scene), new Dial(Options.DefaultIterations, Options.DefaultDt), 1);
            done.Add(scene, rows);
        }

        double value = rows.Find(row => row.Metric == metric)!.Value;

        // Signed figures count by their size; the sign is the direction of the miss.
        return Math.Abs(value);
    }

    private static (double? Best, string Name) BestPeer(Dictionary<string, List<Row>> done, Aim aim)
    {
        double right = aim.Peers is null ? 0 : Value(done, aim.Scene, aim.Peers.Right);
        double? best = null;
        string name = string.Empty;
        foreach (string peer in _peers)
        {
            if (SweepData.PeerDefault(peer, aim.Peers?.Scene ?? aim.Scene, aim.Peers?.Metric ?? aim.Metric) is double value
                && double.IsFinite(value))
            {
                double size = Math.Abs(value - right);
                if (best is null || (aim.AtLeast ? size > best && size < Runner.Exploded : size < best))
                {
                    best = size;
                    name = peer;
                }
            }
        }

        return (best, name);
    }
}
