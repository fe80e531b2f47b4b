using System;
using System.Collections.Generic;
using System.Globalization;

namespace Farseer.Benchmarks.Scenes;

/// <summary>Milliseconds of the steps of several runs of the same scene: whole runs, and for each step the fastest of the runs.</summary>
internal sealed class StepTimes
{
    /// <summary>What every file of times has, for <see cref="ResultComparison"/>.</summary>
    public const string CsvHeader = "scene,size,ms_step_min,ms_step_median,ms_step_quiet,state_hash";

    private readonly List<double> _runs = [];
    private readonly double[] _best;
    private double _total;

    public StepTimes(int steps)
    {
        _best = new double[steps];
        Array.Fill(_best, double.PositiveInfinity);
    }

    public double LeastRun => _runs.Count > 0 ? Sorted()[0] : 0;

    public double MedianRun => _runs.Count > 0 ? Sorted()[_runs.Count / 2] : 0;

    /// <summary>A run made of the fastest of each step: what is left when other work on the machine is not in the way.</summary>
    public double Quiet
    {
        get
        {
            double sum = 0;
            foreach (double step in _best)
            {
                sum += step;
            }

            return sum;
        }
    }

    public static string ToCsv(string scene, int size, double least, double median, double quiet, ulong hash) =>
        string.Create(CultureInfo.InvariantCulture, $"{scene},{size},{least:G6},{median:G6},{quiet:G6},{hash:x16}");

    public void Add(int step, double milliseconds)
    {
        _best[step] = Math.Min(_best[step], milliseconds);
        _total += milliseconds;
    }

    public void EndRun()
    {
        _runs.Add(_total);
        _total = 0;
    }

    private List<double> Sorted()
    {
        List<double> sorted = [.. _runs];
        sorted.Sort();
        return sorted;
    }
}
