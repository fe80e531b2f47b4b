using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>
/// Judges the events: the same kinds and pairs in the same order of first appearance, at the same
/// updates but for the shift of the discretisation. That is two updates (the original notices an
/// overlap one update after it came about, and runs up to one step ahead of the exact path), and the
/// time in which the bodies cross what is a matter of shape and depth: AllowedPenetration and the
/// height by which the original's polygon stays inside a circle. The number of contacts, their places
/// and depths are the detail of the original's vertices and grid, and are not compared.
/// </summary>
public static class EventJudge
{
    private const int StepShift = 2;
    private const int LargestCrossing = 8;

    public static IEnumerable<Check> Judge(SceneFile file, int iterations, Recording ours)
    {
        if (file.Recordings[iterations].Events is not { } expected)
        {
            return [];
        }

        IReadOnlyList<SceneEvent> got = ours.Events ?? [];
        List<Check> checks = [];
        string[] missing = expected.Select(e => e.Key).Except(got.Select(e => e.Key)).ToArray();
        string[] extra = got.Where(g => expected.All(e => e.Key != g.Key)).Select(g => g.Key + " at " + Runs(g)).ToArray();
        checks.Add(Check.Of("events", missing.Length == 0 ? null : "missing " + string.Join("; ", missing)));
        checks.Add(Check.Of("events", extra.Length == 0 ? null : "not in the original: " + string.Join("; ", extra)));
        Dictionary<string, int> place = got.Select((e, i) => (e.Key, i)).ToDictionary(p => p.Key, p => p.i);
        for (int i = 0; i < expected.Count; i++)
        {
            if (!place.TryGetValue(expected[i].Key, out int index))
            {
                continue;
            }

            int shift = Shift(file, iterations, expected[i]);
            checks.Add(Check.Of("event " + expected[i].Key, Steps(expected[i], got[index], shift)));
            for (int j = i + 1; j < expected.Count; j++)
            {
                if (place.TryGetValue(expected[j].Key, out int other) && other < index)
                {
                    int gap = expected[j].Runs[0].First - expected[i].Runs[0].First;
                    bool sameUpdate = gap == 0 && got[index].Runs[0].First == got[other].Runs[0].First;
                    checks.Add(Check.Of("order of events", gap > shift || sameUpdate ? expected[i].Key + " comes after " + expected[j].Key : null));
                }
            }
        }

        return checks;
    }

    private static string? Steps(SceneEvent expected, SceneEvent got, int shift)
    {
        bool Fires(int update) => got.Runs.Any(r => r.First <= update && update <= r.Last);
        string difference = $"at {Runs(got)}, in the original at {Runs(expected)}, allowed shift {shift}";
        foreach ((int first, int last) in expected.Runs)
        {
            bool long_ = last - first >= 2 * shift;
            bool kept = long_
                ? Enumerable.Range(first + shift, last - first - (2 * shift) + 1).All(Fires)
                : Enumerable.Range(first - shift, last - first + (2 * shift) + 1).Any(Fires);
            if (!kept)
            {
                return difference;
            }
        }

        bool inside = got.Runs.All(g => Enumerable.Range(g.First, g.Last - g.First + 1)
            .All(u => expected.Runs.Any(e => u >= e.First - shift && u <= e.Last + shift)));
        return inside ? null : difference;
    }

    private static int Shift(SceneFile file, int iterations, SceneEvent e)
    {
        IEnumerable<MadeObject> geoms = file.Geoms.Where(g => g.Id == e.First || g.Id == e.Second);
        double slack = geoms.Sum(SceneSizes.Sagitta) + SceneSizes.AllowedPenetration(file);
        double speed = geoms.Select(g => SpeedAt(file, iterations, g.Body!, e.Runs[0].First)).DefaultIfEmpty(0).Max();
        double updates = speed > 0 ? Math.Ceiling(slack / (speed * file.Dt)) : LargestCrossing;
        return StepShift + (int)Math.Min(LargestCrossing, updates);
    }

    /// <summary>The speed of a body in the last sample before an update: that of its approach.</summary>
    private static double SpeedAt(SceneFile file, int iterations, string body, int update)
    {
        if (!file.Recordings[iterations].Rows.TryGetValue(body, out Row[]? rows))
        {
            return 0;
        }

        int row = Array.FindLastIndex(file.SampleSteps, s => s < update);
        return Discretisation.Speed(rows[Math.Max(0, row)], default);
    }

    private static string Runs(SceneEvent e) => string.Join(" ", e.Runs.Take(6).Select(r => r.First == r.Last ? $"{r.First}" : $"{r.First}-{r.Last}"));
}
