using System;
using System.Collections.Generic;
using Farseer.Accuracy.General;
using Farseer.Accuracy.Sweeping;

namespace Farseer.Accuracy.Dials;

/// <summary>What a dial gave and took: the default first, then one doubling after the other.</summary>
/// <param name="Points">Errors in the unit of the kind, costs in ns a body and 1/60 s.</param>
/// <param name="Rounding">Errors below are not asked to fall.</param>
internal sealed record DialCurve(IReadOnlyList<(double Error, double Cost)> Points, double Rounding)
{
    public double Default => Points[0].Error;

    public double Doubled => Points[1].Error;

    /// <summary>Time of one doubling over that of the default.</summary>
    public double CostFactor => Points[1].Cost / Points[0].Cost;

    /// <summary>
    /// Log2 of what a doubling divides the error by, over all doublings up to the first that is within rounding; NaN if the default is.
    /// </summary>
    public double Order => Slope(point => 1);

    /// <summary>The same for what doubles the time, by which dials of different prices compare.</summary>
    public double OrderOfTime => Slope(last => Math.Log2(Points[last].Cost / Points[0].Cost) / last);

    private double Slope(Func<int, double> priceOfADoubling)
    {
        int last = 0;
        while (last + 1 < Points.Count && Points[last].Error > Rounding)
        {
            last++;
        }

        return last == 0 ? double.NaN : Math.Log2(Default / Math.Max(Points[last].Error, Rounding)) / (last * priceOfADoubling(last));
    }
}

/// <summary>Both dials of a kind.</summary>
internal sealed record DialResult(DialKind Kind, DialCurve Iterations, DialCurve Steps)
{
    /// <summary>A dial of less gains too little to be turned.</summary>
    private const double LeastOrder = 0.5;

    /// <summary>Orders nearer than this are the noise of the clock.</summary>
    private const double Alike = 1.3;

    /// <summary>Which dial buys more for the same time.</summary>
    public string Turn
    {
        get
        {
            if (Iterations.Default <= Kind.Rounding)
            {
                return "neither: exact";
            }

            if (Iterations.Order < LeastOrder && Steps.Order < LeastOrder)
            {
                return "neither helps";
            }

            double ratio = Math.Max(Iterations.OrderOfTime, 0.01) / Math.Max(Steps.OrderOfTime, 0.01);
            return ratio > Alike ? "`Iterations`" : ratio < 1 / Alike ? "1/dt" : "either";
        }
    }
}

/// <summary>Runs the kinds at the default and at doublings of each dial.</summary>
internal static class DialRuns
{
    private const int Doublings = 3;

    /// <summary>For the clock: the first run warms up, and of the others each step counts with its quickest.</summary>
    private const int Runs = 3;

    /// <summary>32 times as many substeps a second as the finest run that is held against it.</summary>
    private static readonly Dial _reference = new(160, Options.DefaultDt / 8, 0);

    public static DialResult Measure(DialKind kind, int runs = Runs)
    {
        List<double[]> right = kind.IsAgainstReference ? Ends(kind, _reference, 1, out _) : [];
        var first = Point(kind, right, 1, 1, runs);
        var iterations = new List<(double Error, double Cost)> { first };
        var steps = new List<(double Error, double Cost)> { first };
        for (int times = 2; times <= 1 << Doublings; times *= 2)
        {
            iterations.Add(Point(kind, right, times, 1, runs));
            steps.Add(Point(kind, right, 1, times, runs));
        }

        return new DialResult(kind, new DialCurve(iterations, kind.Rounding), new DialCurve(steps, kind.Rounding));
    }

    /// <summary>The median error of a kind's samples at a setting, and the mean cost.</summary>
    public static (double Error, double Cost) Point(DialKind kind, Dial dial, int runs) => Point(kind, [], dial, runs);

    private static (double Error, double Cost) Point(DialKind kind, List<double[]> right, int iterations, int steps, int runs) =>
        Point(kind, right, new Dial(Options.DefaultIterations * iterations, Options.DefaultDt / steps, 0), runs);

    private static (double Error, double Cost) Point(DialKind kind, List<double[]> right, Dial dial, int runs)
    {
        List<double[]> ends = Ends(kind, dial, runs, out double cost);
        var errors = new List<double>();
        for (int i = 0; i < ends.Count; i++)
        {
            double sum = 0;
            for (int k = 0; k < ends[i].Length; k++)
            {
                double off = ends[i][k] - (kind.IsAgainstReference ? right[i][k] : 0);
                sum += off * off;
            }

            errors.Add(Math.Sqrt(sum));
        }

        return (Bookkeeping.Median(errors), cost);
    }

    private static List<double[]> Ends(DialKind kind, Dial dial, int runs, out double cost)
    {
        var ends = new List<double[]>();
        cost = 0;
        foreach (SceneChoice choice in kind.Choices)
        {
            List<Row> rows = Runner.Run(choice, dial, runs);
            ends.Add(Array.ConvertAll(kind.Metrics, metric => rows.Find(row => row.Metric == metric)!.Value));
            cost += rows[0].NanosecondsPerBodyStep * SweepPoint.Frame / dial.Dt / kind.Parameters.Length;
        }

        return ends;
    }
}
