using System;
using System.Collections.Generic;
using System.IO;

namespace Farseer.Accuracy.Dials;

internal static class DialsCommand
{
    public static void Run(string[] args, TextWriter output)
    {
        foreach (DialKind kind in DialKinds.All)
        {
            var w = System.Diagnostics.Stopwatch.StartNew();
            DialResult r = DialRuns.Measure(kind);
            output.WriteLine($"{kind.Title,-36} I {string.Join(' ', System.Linq.Enumerable.Select(r.Iterations.Points, p => $"{p.Error:G3}@{p.Cost:F0}")),-60} order {r.Iterations.Order:F2} {r.Iterations.OrderOfTime:F2}");
            output.WriteLine($"{w.Elapsed.TotalSeconds,-36:F1} T {string.Join(' ', System.Linq.Enumerable.Select(r.Steps.Points, p => $"{p.Error:G3}@{p.Cost:F0}")),-60} order {r.Steps.Order:F2} {r.Steps.OrderOfTime:F2} {r.Turn}");
        }
    }
}
