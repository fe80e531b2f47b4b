using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Flash;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>
/// Judges the events: the same kinds and pairs in the same order of first appearance, at the same
/// updates but for the shift of the discretisation. That is two updates (the original notices an
/// overlap one update after it came about, and runs up to one step ahead of the exact path), and the
/// time in which the bodies cross what is a matter of shape and depth: AllowedPenetration and the
/// height by which the original's polygon stays inside a circle. A contact ENDS later where a circle of
/// radius r that rests d deep leaves along the tangent: it is clear after a way of sqrt(2 r d). The number of contacts, their places
/// and depths are the detail of the original's vertices and grid, and are not compared. Where one listener hears of all pairs (the
/// other format), the order of pairs within one step is that of the original's lists and is not compared either.
/// </summary>
public static class EventJudge
{
    /// <summary>Updates by which the discretisation alone may shift a change.</summary>
    internal const int StepShift = 2;

    private const int LargestCrossing = 8;

    public static IEnumerable<Check> Judge(SceneFile file, int iterations, Recording ours)
    {
        if (file.Recordings[iterations].Events is not { } expected)
        {
            return [];
        }

        FlashExemptions? exempt = file.Format == SceneFormat.Box2DFlash ? new(file) : null;
        IReadOnlyList<SceneEvent> got = [.. (ours.Events ?? []).Where(e => exempt?.Holds(e, iterations) is not true)];
        expected = [.. expected.Where(e => exempt?.Holds(e, iterations) is not true)];
        List<Check> checks = [];
        string[] missing = expected.Where(e => !IsBrief(e)).Select(e => e.Key).Except(got.Select(e => e.Key)).ToArray();
        string[] extra = got.Where(g => !IsBrief(g) && expected.All(e => e.Key != g.Key)).Select(g => g.Key + " at " + Runs(g)).ToArray();
        checks.Add(Check.Of("events", missing.Length == 0 ? null : "missing " + string.Join("; ", missing)));
        checks.Add(Check.Of("events", extra.Length == 0 ? null : "not in the original: " + string.Join("; ", extra)));
        Dictionary<string, int> place = got.Select((e, i) => (e.Key, i)).ToDictionary(p => p.Key, p => p.i);
        for (int i = 0; i < expected.Count; i++)
        {
            if (!place.TryGetValue(expected[i].Key, out int index))
            {
                continue;
            }

            (int shift, _) = Shifts(file, iterations, expected[i]);
            checks.Add(Check.Of("event " + expected[i].Key, Steps(file, iterations, expected[i], got[index])));
            for (int j = i + 1; j < expected.Count; j++)
            {
                if (place.TryGetValue(expected[j].Key, out int other) && other < index)
                {
                    int gap = expected[j].Runs[0].First - expected[i].Runs[0].First;
                    bool sameUpdate = gap == 0
                        && (file.Format == SceneFormat.Farseer || IsSamePair(expected[i], expected[j]))
                        && got[index].Runs[0].First == got[other].Runs[0].First;
                    checks.Add(Check.Of(
                        "order of events", gap > shift || sameUpdate ? expected[i].Key + " comes after " + expected[j].Key : null));
                }
            }
        }

        return checks;
    }

    /// <summary>A contact that lasts no longer than the shift may have begun and ended within one step.</summary>
    private static bool IsBrief(SceneEvent e) => e.Type == "Persist" && e.Runs.All(r => r.Last - r.First < StepShift);

    private static bool IsSamePair(SceneEvent a, SceneEvent b) => a.First == b.First && a.Second == b.Second;

    /// <summary>
    /// Null if the updates are those of the recording, or in the other format of one with another count of iterations: what differs
    /// between the original's own two is a matter of its method.
    /// </summary>
    private static string? Steps(SceneFile file, int iterations, SceneEvent expected, SceneEvent got)
    {
        string? difference = Compare(file, iterations, expected, got);
        if (difference is null || file.Format == SceneFormat.Farseer)
        {
            return difference;
        }

        foreach ((int other, Recording recording) in file.Recordings.Where(r => r.Key != iterations))
        {
            if (recording.Events?.FirstOrDefault(e => e.Key == expected.Key) is { } same && Compare(file, other, same, got) is null)
            {
                return null;
            }
        }

        return difference;
    }

    /// <summary>Compares the runs of updates; a separation begins when a contact ends, so both its bounds may shift as an ending.</summary>
    private static string? Compare(SceneFile file, int iterations, SceneEvent expected, SceneEvent got)
    {
        (int shift, int ending) = Shifts(file, iterations, expected);
        int early = expected.Type == "OnSeparation" ? ending : shift;
        (int First, int Last, int Early, int Ending)[] runs = [.. expected.Runs.Select(r => (
            r.First, r.Last, early + FlashShifts.OfBeginning(
                file, iterations, expected, r.First), ending + FlashShifts.OfEnding(file, iterations, expected, r.Last)))];
        bool Fires(int update) => got.Runs.Any(r => r.First <= update && update <= r.Last);
        string difference = $"at {Runs(got)}, in the original at {Runs(expected)}, allowed shift "
            + string.Join(", ", runs.Take(6).Select(r => $"{r.Early} and {r.Ending}").Distinct());
        foreach ((int first, int last, int begins, int ends) in runs)
        {
            bool kept = last - first >= begins + ends
                ? Enumerable.Range(first + begins, last - first - begins - ends + 1).All(Fires)
                : Enumerable.Range(first - begins, last - first + begins + ends + 1).Any(Fires);
            if (!kept)
            {
                return difference;
            }
        }

        bool inside = got.Runs.All(g => Enumerable.Range(g.First, g.Last - g.First + 1)
            .All(u => runs.Any(e => u >= e.First - e.Early && u <= e.Last + e.Ending)));
        return inside ? null : difference;
    }

    private static (int Shift, int Ending) Shifts(SceneFile file, int iterations, SceneEvent e)
    {
        (List<MadeObject> geoms, double slack) = Slack(file, e.First, e.Second);
        double depth = SceneSizes.AllowedPenetration(file);
        double radius = geoms.Select(SceneSizes.Radius).DefaultIfEmpty(0).Max();
        double arriving = geoms.Select(g => SpeedAt(file, iterations, g.Body!, e.Runs[0].First)).DefaultIfEmpty(0).Max();
        double leaving = e.Runs.Select(r => geoms.Select(g => SpeedAt(file, iterations, g.Body!, r.Last)).DefaultIfEmpty(0).Max()).Min();
        int shift = StepShift + Updates(slack, arriving * file.Dt);
        return (shift, shift + (radius > 0 ? Updates(Math.Sqrt(2 * radius * depth), leaving * file.Dt) : 0));
    }

    /// <summary>
    /// The updates that a pair of geoms may need more or less to cross what is a matter of shape and depth, or an edge of a circle that
    /// rolls.
    /// </summary>
    internal static int Crossing(SceneFile file, int iterations, string first, string second, int update)
    {
        (List<MadeObject> geoms, double slack) = Slack(file, first, second);
        slack += geoms.Sum(SceneSizes.Edge);
        return StepShift + Updates(slack, geoms.Select(g => SpeedAt(file, iterations, g.Body!, update)).DefaultIfEmpty(0).Max() * file.Dt);
    }

    private static (List<MadeObject> Geoms, double Slack) Slack(SceneFile file, string first, string second)
    {
        List<MadeObject> geoms = file.Geoms.Where(g => g.Id == first || g.Id == second).ToList();
        return (geoms, geoms.Sum(SceneSizes.Sagitta) + SceneSizes.AllowedPenetration(file));
    }

    private static int Updates(double way, double perUpdate)
        => (int)Math.Min(LargestCrossing, perUpdate > 0 ? Math.Ceiling(way / perUpdate) : LargestCrossing);

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

    private static string Runs(SceneEvent e) =>
        string.Join(" ", e.Runs.Take(6).Select(r => r.First == r.Last ? $"{r.First}" : $"{r.First}-{r.Last}"));
}
