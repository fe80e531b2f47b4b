using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Sweeping;

/// <summary>What a set of settings is worth: the front of those that none beats in both error and cost, and figures of it.</summary>
internal static class Pareto
{
    private const double LeastCost = 1;
    private const double MostCost = 5;
    private const double LeastError = -4;

    /// <summary>Points that no other beats, by rising cost and falling error.</summary>
    public static List<SweepPoint> Front(IEnumerable<SweepPoint> points)
    {
        var sorted = new List<SweepPoint>(points);
        sorted.Sort((a, b) => a.Cost != b.Cost ? a.Cost.CompareTo(b.Cost) : a.Error.CompareTo(b.Error));
        var front = new List<SweepPoint>();
        double least = double.MaxValue;
        foreach (SweepPoint point in sorted)
        {
            if (point.Error < least)
            {
                front.Add(point);
                least = point.Error;
            }
        }

        return front;
    }

    /// <summary>
    /// Area that the front dominates in the plane of log cost (10 to 100,000 ns) and log error (1e-4 to 1 of the failure scale), as a
    /// share: 0 useless, 1 exact for nothing.
    /// </summary>
    public static double Hypervolume(IEnumerable<SweepPoint> points)
    {
        double area = 0;
        double depth = 0;
        double from = MostCost;
        bool first = true;
        foreach (SweepPoint point in Front(points))
        {
            double cost = Math.Clamp(Math.Log10(Math.Max(point.Cost, 1e-9)), LeastCost, MostCost);
            double error = point.Failed ? 0 : Math.Clamp(Math.Log10(Math.Max(point.Error, 1e-30)), LeastError, 0);
            area += first ? 0 : (cost - from) * depth;
            depth = Math.Max(depth, -error);
            from = cost;
            first = false;
        }

        area += (MostCost - from) * depth;
        return area / ((MostCost - LeastCost) * -LeastError);
    }

    /// <summary>The cheapest setting within the tolerance, or null if none is.</summary>
    public static SweepPoint? Cheapest(IEnumerable<SweepPoint> points, double tolerance)
    {
        SweepPoint? best = null;
        foreach (SweepPoint point in points)
        {
            if (!point.Failed && point.Error <= tolerance && (best is null || point.Cost < best.Cost))
            {
                best = point;
            }
        }

        return best;
    }
}
