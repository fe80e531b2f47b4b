using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Farseer.Accuracy.Sweeping;

/// <summary>What a sweep is worth: hypervolume, time to tolerance, floors; engine by engine.</summary>
internal static class SweepTables
{
    /// <summary>What a scene that never comes within the tolerance counts in the mean.</summary>
    private const double Never = 1e6;

    private const double FloorFactor = 1.5;

    public static List<string> Engines(IEnumerable<SweepPoint> points)
    {
        var engines = new List<string>();
        foreach (SweepPoint point in points)
        {
            if (!engines.Contains(point.Engine))
            {
                engines.Add(point.Engine);
            }
        }

        return engines;
    }

    public static List<SweepPoint> Of(IEnumerable<SweepPoint> points, string engine, string scene, SweepKind kind)
    {
        var found = new List<SweepPoint>();
        foreach (SweepPoint point in points)
        {
            if (point.Engine == engine && point.Scene == scene && point.Kind == kind)
            {
                found.Add(point);
            }
        }

        return found;
    }

    /// <summary>Mean hypervolume over the scenes, and the worst of them.</summary>
    public static (double Mean, double Worst, string WorstScene) Hypervolume(IReadOnlyList<SweepPoint> points, string engine)
    {
        double sum = 0;
        double worst = double.MaxValue;
        string name = string.Empty;
        foreach (SweepScene scene in SweepScene.All)
        {
            double volume = Pareto.Hypervolume(Of(points, engine, scene.Scene, SweepKind.Dial));
            sum += volume;
            if (volume < worst)
            {
                worst = volume;
                name = scene.Scene;
            }
        }

        return (sum / SweepScene.All.Count, worst, name);
    }

    /// <summary>Geometric mean of the times to 1 % and how many scenes come there.</summary>
    public static (double Mean, int Reached) TimeToTolerance(IReadOnlyList<SweepPoint> points, string engine)
    {
        double logs = 0;
        int reached = 0;
        foreach (SweepScene scene in SweepScene.All)
        {
            SweepPoint? best = Pareto.Cheapest(Of(points, engine, scene.Scene, SweepKind.Dial), SweepScene.Tolerance);
            logs += Math.Log10(best?.Cost ?? Never);
            reached += best is null ? 0 : 1;
        }

        return (Math.Pow(10, logs / SweepScene.All.Count), reached);
    }

    /// <summary>
    /// Scenes of which another engine's default is no failure: its error there and what it takes, and this library's least time with an
    /// error no larger, longer steps included.
    /// </summary>
    public static List<PeerMatch> ToDefaultOf(IReadOnlyList<SweepPoint> points, string peer)
    {
        var matches = new List<PeerMatch>();
        foreach (SweepScene scene in SweepScene.All)
        {
            double? value = SweepData.PeerDefault(peer, scene.Scene, scene.Metric);
            double? cost = SweepData.PeerDefaultCost(peer, scene.Scene);
            double error = Math.Abs(value ?? double.NaN) / scene.Scale;
            if (cost is null || !(error < 1))
            {
                continue;
            }

            List<SweepPoint> tried = Of(points, SweepPoint.Own, scene.Scene, SweepKind.Dial);
            tried.AddRange(Of(points, SweepPoint.Own, scene.Scene, SweepKind.LongStep));
            SweepPoint? own = Pareto.Cheapest(tried, error);
            matches.Add(new PeerMatch(scene, error, cost.Value, own));
        }

        return matches;
    }

    /// <summary>Scenes on which a doubling of the own dial does not divide the error by 1.5 although it is no rounding yet.</summary>
    public static List<string> Floors(IReadOnlyList<SweepPoint> points, string engine)
    {
        var floors = new List<string>();
        foreach (SweepScene scene in SweepScene.All)
        {
            List<SweepPoint> dial = Of(points, engine, scene.Scene, SweepKind.Dial).FindAll(p => Math.Abs(p.Dt - Options.DefaultDt) < 1e-6);
            foreach (SweepPoint coarse in dial)
            {
                SweepPoint? fine = dial.Find(p => p.Dial == 2 * coarse.Dial);
                if (fine is not null && !coarse.Failed && fine.Error > scene.Rounding && fine.Error * FloorFactor > coarse.Error)
                {
                    floors.Add(string.Create(
                        CultureInfo.InvariantCulture,
                        $"{scene.Scene}: dial {coarse.Dial} -> {fine.Dial}: error {coarse.Error:G3} -> {fine.Error:G3}"));
                }
            }
        }

        return floors;
    }

    public static void Print(IReadOnlyList<SweepPoint> points, TextWriter output)
    {
        List<string> engines = Engines(points);
        output.WriteLine();
        output.WriteLine($"{"engine",-18} {"hypervolume",11}  {"worst scene",-32} {"time to 1 %",12}  within 1 %");
        foreach (string engine in engines)
        {
            (double mean, double worst, string name) = Hypervolume(points, engine);
            (double time, int reached) = TimeToTolerance(points, engine);
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{engine,-18} {mean,11:F3}  {$"{name} ({worst:F3})",-32} {time,9:F0} ns  {reached} of {SweepScene.All.Count}"));
        }

        output.WriteLine();
        output.WriteLine("least ns a body and 1/60 s with an error of at most 1 % of the scale:");
        foreach (SweepScene scene in SweepScene.All)
        {
            output.Write($"{scene.Scene,-26}");
            foreach (string engine in engines)
            {
                SweepPoint? best = Pareto.Cheapest(Of(points, engine, scene.Scene, SweepKind.Dial), SweepScene.Tolerance);
                string text = best is null ? "never" : best.Cost.ToString("F0", CultureInfo.InvariantCulture);
                output.Write($"{engine,18}: {text,7}");
            }

            output.WriteLine();
        }

        output.WriteLine();
        output.WriteLine($"least ns a body and 1/60 s with no larger an error than {SweepData.DefaultPeer} at its default:");
        foreach (PeerMatch match in ToDefaultOf(points, SweepData.DefaultPeer))
        {
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{match.Scene.Scene,-26} error {match.Error,9:G3}  {match.PeerCost,7:F0} -> {match.Own?.Cost,7:F0}  {match.Ratio:F2}  "
                    + $"({match.Setting})"));
        }

        output.WriteLine();
        foreach (string engine in engines)
        {
            List<string> floors = Floors(points, engine);
            output.WriteLine($"floors of {engine}: {(floors.Count == 0 ? "none" : floors.Count.ToString(CultureInfo.InvariantCulture))}");
            foreach (string floor in floors)
            {
                output.WriteLine($"    {floor}");
            }
        }
    }
}

/// <summary>What it takes to be as exact as another engine is at its default.</summary>
/// <param name="Scene">The scene.</param>
/// <param name="Error">The other engine's error as a share of the scale.</param>
/// <param name="PeerCost">What that takes there, ns a body-step.</param>
/// <param name="Own">The cheapest setting with an error no larger; null: the sweep has none.</param>
internal sealed record PeerMatch(SweepScene Scene, double Error, double PeerCost, SweepPoint? Own)
{
    public double? Ratio => Own?.Cost / PeerCost;

    /// <summary>The setting, for people.</summary>
    public string Setting => Own is null
        ? "none"
        : string.Create(CultureInfo.InvariantCulture, $"{Own.Dial} iterations at 1/{1 / Own.Dt:F0} s");
}
