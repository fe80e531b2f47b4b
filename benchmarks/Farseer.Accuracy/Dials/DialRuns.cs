using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using Farseer.Accuracy.General;
using Farseer.Accuracy.Sweeping;

namespace Farseer.Accuracy.Dials;

/// <summary>Runs a kind at the default and at doublings of each dial.</summary>
internal static class DialRuns
{
    private const int Doublings = 3;
    private const int LeastRounds = 5;
    private const int MostRounds = 25;
    private const int WarmUpPause = 150;

    /// <summary>
    /// What motions without a closed form are held against: 16 times as many substeps a second as in the finest run that is judged. How far
    /// two such runs of other shares of steps and iterations are apart is what rounding and chance leave open.
    /// </summary>
    private static readonly Dial _reference = new(8 * Options.DefaultIterations, Options.DefaultDt / 16);
    private static readonly Dial _otherReference = new(4 * Options.DefaultIterations, Options.DefaultDt / 32);

    /// <summary>Both curves of a kind.</summary>
    /// <param name="kind">What is run.</param>
    /// <param name="seconds">How long settings are timed, in turns: what slows the machine for a while slows all of them alike.</param>
    public static DialResult Measure(DialKind kind, double seconds)
    {
        List<double[]> right = kind.IsAgainstReference ? Ends(kind, _reference, out _) : [];
        var settings = new List<Dial> { new(Options.DefaultIterations, Options.DefaultDt) };
        for (int times = 2; times <= 1 << Doublings; times *= 2)
        {
            settings.Add(settings[0] with { Iterations = Options.DefaultIterations * times });
        }

        for (int times = 2; times <= 1 << Doublings; times *= 2)
        {
            settings.Add(settings[0] with { Dt = Options.DefaultDt / times });
        }

        List<(double Error, double Cost)> points = Points(kind, right, settings, seconds);
        var steps = new List<(double Error, double Cost)> { points[0] };
        steps.AddRange(points[(Doublings + 1)..]);
        double chance = kind.IsAgainstReference ? Error(kind, Ends(kind, _otherReference, out _), right) : 0;
        double floor = Math.Max(chance, kind.Rounding);
        return new DialResult(kind, chance, new DialCurve(points[..(Doublings + 1)], floor), new DialCurve(steps, floor));
    }

    /// <summary>
    /// The median error of the samples at each setting, and the cost: the median time of the first setting, and for the others that
    /// times the median of their ratios to it.
    /// </summary>
    public static List<(double Error, double Cost)> Points(DialKind kind, List<double[]> right, List<Dial> settings, double seconds)
    {
        List<double> errors = WarmUp(kind, right, settings);
        var first = new List<double>();
        List<double>[] ratios = [.. settings.ConvertAll(_ => new List<double>())];
        var clock = Stopwatch.StartNew();
        for (int round = 0; round < MostRounds && (round < LeastRounds || clock.Elapsed.TotalSeconds < seconds); round++)
        {
            for (int i = 0; i < settings.Count; i++)
            {
                Ends(kind, settings[i], out double cost);
                if (i == 0)
                {
                    first.Add(cost);
                }

                ratios[i].Add(cost / first[round]);
            }
        }

        double usual = Bookkeeping.Median(first);
        var points = new List<(double Error, double Cost)>();
        for (int i = 0; i < settings.Count; i++)
        {
            points.Add((errors[i], usual * Bookkeeping.Median(ratios[i])));
        }

        return points;
    }

    /// <summary>
    /// All settings once, for their errors, which repeat bit for bit, and for the compiler, which does its last stage beside the running
    /// code and after a pause.
    /// </summary>
    private static List<double> WarmUp(DialKind kind, List<double[]> right, List<Dial> settings)
    {
        Ends(kind, settings[0], out _);
        Thread.Sleep(WarmUpPause);
        List<double> errors = settings.ConvertAll(setting => Error(kind, Ends(kind, setting, out _), right));
        Thread.Sleep(WarmUpPause);
        return errors;
    }

    private static double Error(DialKind kind, List<double[]> ends, List<double[]> right)
    {
        var errors = new List<double>();
        for (int i = 0; i < ends.Count; i++)
        {
            double sum = 0;
            for (int k = 0; k < ends[i].Length; k++)
            {
                double off = ends[i][k] - (kind.IsAgainstReference ? right[i][k] : 0);
                sum += off * off;
            }

            errors.Add(Math.Sqrt(sum) * kind.Unit);
        }

        return Bookkeeping.Median(errors);
    }

    /// <summary>The metrics of each sample, and the mean cost of a body and 1/60 s.</summary>
    private static List<double[]> Ends(DialKind kind, Dial dial, out double cost)
    {
        var ends = new List<double[]>();
        cost = 0;
        foreach (SceneChoice choice in kind.Choices)
        {
            List<Row> rows = Runner.Run(choice, dial, 1);
            ends.Add(Array.ConvertAll(kind.Metrics, metric => rows.Find(row => row.Metric == metric)!.Value));
            cost += rows[0].NanosecondsPerBodyStep * SweepPoint.Frame / dial.Dt / kind.Parameters.Length;
        }

        return ends;
    }
}
