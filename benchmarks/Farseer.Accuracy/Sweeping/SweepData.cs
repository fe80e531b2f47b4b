using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Farseer.Accuracy.Sweeping;

/// <summary>The tables in the folder Data: figures of other engines, and this one's last sweep.</summary>
internal static class SweepData
{
    public const string SweepHeader = "engine,scene,dial,dt,error_share,cost60_ns,kind,outcome";

    /// <summary>The engine beside which costs are set.</summary>
    public const string DefaultPeer = "Box2D.NET";

    private const string PeersResource = "peers.csv";
    private const string SweepResource = "sweep.csv";

    /// <summary>Sweep points of the other engines.</summary>
    public static List<SweepPoint> Peers()
    {
        var points = new List<SweepPoint>();
        var failed = new HashSet<string>();
        List<string[]> rows = Rows(PeersResource);
        foreach (string[] row in rows)
        {
            bool fell = row[4] is "stood" or "load_carried" && Number(row[5]) == 0;
            if (fell || row[8].Length > 0)
            {
                failed.Add(Key(row));
            }
        }

        foreach (string[] row in rows)
        {
            SweepScene? scene = SweepScene.Find(row[1]);
            if (row[7] == "default" || scene is null || scene.Metric != row[4])
            {
                continue;
            }

            double error = Math.Abs(Number(row[5])) / scene.Scale;
            bool lost = failed.Contains(Key(row)) || !(error < 1);
            double dt = Number(row[3]);
            double cost = Number(row[6]) * SweepPoint.Frame / dt;
            SweepKind kind = row[7] == "dt" ? SweepKind.StepLength : SweepKind.Dial;
            points.Add(
                new SweepPoint(row[0], row[1], kind, int.Parse(row[2], CultureInfo.InvariantCulture), dt, lost ? 1 : error, cost, lost));
        }

        return points;
    }

    /// <summary>Figure of an engine at its default dial, or null if the comparison has none.</summary>
    public static double? PeerDefault(string engine, string scene, string metric)
    {
        foreach (string[] row in Rows(PeersResource))
        {
            if (row[7] == "default" && row[0] == engine && row[1] == scene && row[4] == metric)
            {
                return Number(row[5]);
            }
        }

        return null;
    }

    /// <summary>Nanoseconds a body-step of an engine at its default dial, or null if the comparison has none.</summary>
    public static double? PeerDefaultCost(string engine, string scene)
    {
        foreach (string[] row in Rows(PeersResource))
        {
            if (row[7] == "default" && row[0] == engine && row[1] == scene)
            {
                return Number(row[6]);
            }
        }

        return null;
    }

    /// <summary>The stored sweep of this library.</summary>
    public static List<SweepPoint> Stored()
    {
        var points = new List<SweepPoint>();
        foreach (string[] row in Rows(SweepResource))
        {
            points.Add(new SweepPoint(
                row[0],
                row[1],
                Array.Find(Enum.GetValues<SweepKind>(), kind => Text(kind) == row[6]),
                int.Parse(row[2], CultureInfo.InvariantCulture),
                Number(row[3]),
                Number(row[4]),
                Number(row[5]),
                row[7].Length > 0));
        }

        return points;
    }

    public static void Write(string path, IEnumerable<SweepPoint> points)
    {
        using var file = new StreamWriter(path);
        file.NewLine = "\n";
        file.WriteLine(SweepHeader);
        foreach (SweepPoint p in points)
        {
            file.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{p.Engine},{p.Scene},{p.Dial},{p.Dt:G6},{p.Error:G6},{p.Cost:G4},{Text(p.Kind)},{(p.Failed ? "failed" : string.Empty)}"));
        }
    }

    private static string Text(SweepKind kind) => kind switch
    {
        SweepKind.StepLength => "dt",
        SweepKind.LongStep => "long",
        _ => "dial",
    };

    private static string Key(string[] row) => $"{row[0]} {row[1]} {row[2]} {row[3]} {row[7]}";

    private static double Number(string text) => double.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture);

    private static List<string[]> Rows(string resource)
    {
        using Stream stream = typeof(SweepData).Assembly.GetManifestResourceStream(resource)
            ?? throw new InvalidOperationException($"The table {resource} is missing from the program.");
        using var reader = new StreamReader(stream);
        var rows = new List<string[]>();
        reader.ReadLine();
        for (string? line = reader.ReadLine(); line is not null; line = reader.ReadLine())
        {
            rows.Add(line.Split(','));
        }

        return rows;
    }
}
