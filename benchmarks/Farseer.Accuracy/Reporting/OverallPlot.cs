using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Accuracy.Sweeping;

namespace Farseer.Accuracy.Reporting;

/// <summary>The ten scenes of the sweep as one scene: of each setting the geometric means of error and cost.</summary>
internal static class OverallPlot
{
    /// <summary>
    /// Smaller errors count as this share of failure: what is exact in a scene, a hanging rope for instance, must not make up for what
    /// is wrong in others.
    /// </summary>
    public const double LeastError = 1e-4;

    private static readonly SweepScene _all = new("all", "error", 1, "Ten scenes, geometric means; ringed: the default settings", 0);

    /// <summary>A picture of the engines in the points.</summary>
    public static string Draw(IReadOnlyList<SweepPoint> points) => SvgPlot.Draw(_all, Means(points));

    /// <summary>One point for each setting that an engine was run with in all scenes; a failure has the error 1.</summary>
    public static List<SweepPoint> Means(IEnumerable<SweepPoint> points)
    {
        var means = new List<SweepPoint>();
        foreach (var setting in points.Where(p => p.Kind == SweepKind.Dial).GroupBy(p => (p.Engine, p.Dial, Steps: Math.Round(1 / p.Dt))))
        {
            if (setting.Select(p => p.Scene).Distinct().Count() == SweepScene.All.Count)
            {
                double error = Math.Exp(setting.Average(p => Math.Log(Math.Clamp(p.Error, LeastError, 1))));
                double cost = Math.Exp(setting.Average(p => Math.Log(p.Cost)));
                means.Add(new SweepPoint(
                    setting.Key.Engine, _all.Scene, SweepKind.Dial, setting.Key.Dial, 1 / setting.Key.Steps, error, cost, Failed: false));
            }
        }

        return means;
    }
}
