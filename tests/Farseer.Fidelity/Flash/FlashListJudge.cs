using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// Judges what was told by step: the same things in the same order, at the same step but for the shift of the discretisation. Results
/// of actions must be equal. A body must fall asleep and wake in the same order of states; when it falls asleep depends on when its
/// last quiver ends.
/// </summary>
internal static class FlashListJudge
{
    private const int StepShift = 2;

    /// <summary>A quarter of a second: half the time that a body must rest before it sleeps.</summary>
    private const double SleepShift = 0.25;

    public static IEnumerable<Check> Lists(SceneFile file, string key, FlashRun run)
    {
        foreach ((string name, JsonElement got) in run.Lists)
        {
            JsonElement expected = Json.Optional(Json.Optional(file.Root, name), key);
            if (expected.ValueKind == JsonValueKind.Array)
            {
                bool exact = name is "actionResults" or "callbackResults";
                yield return Check.Of(name, exact ? Exact(expected, got) : InOrder(expected, got, name == "filterCalls"));
            }
        }
    }

    public static IEnumerable<Check> States(string name, SceneFile file, string key, Dictionary<string, List<(int Step, bool State)>> got)
    {
        JsonElement expected = Json.Optional(Json.Optional(file.Root, name), key);
        if (expected.ValueKind != JsonValueKind.Object)
        {
            yield break;
        }

        int shift = name == "sleepChanges" ? (int)Math.Ceiling(SleepShift / file.Dt) : StepShift;
        HashSet<string> moving = [.. file.Recordings.Values.SelectMany(r => r.Rows.Keys)];
        foreach (string body in expected.EnumerateObject().Select(p => p.Name).Concat(got.Keys).Distinct().Where(moving.Contains))
        {
            List<(int Step, bool State)> wanted = Json.Items(expected, body).Select(c => (c[0].GetInt32(), c[1].GetBoolean())).ToList();
            List<(int Step, bool State)> found = got.GetValueOrDefault(body, []);
            bool same = wanted.Count == found.Count && wanted.Zip(found, (w, f) => w.State == f.State && Math.Abs(w.Step - f.Step) <= shift).All(s => s);
            yield return Check.Of(name + " " + body, same ? null : $"{Text(found)}, in the original {Text(wanted)}");
        }
    }

    private static string? Exact(JsonElement expected, JsonElement got)
        => ValueComparer.Difference(expected, got) == 0 ? null : $"{got}, in the original {expected}";

    private static string? InOrder(JsonElement expected, JsonElement got, bool byPair)
    {
        List<(int Step, string What)> wanted = expected.EnumerateArray().Select(e => Item(e, byPair)).ToList();
        List<(int Step, string What)> found = got.EnumerateArray().Select(e => Item(e, byPair)).ToList();
        if (byPair)
        {
            // Boxes with a margin do not part as often as the original's: only the first answer of a pair counts, and the pairs of one
            // step have the order of the original's lists.
            wanted = [.. wanted.DistinctBy(w => w.What).OrderBy(w => w.What, StringComparer.Ordinal)];
            found = [.. found.DistinctBy(w => w.What).OrderBy(w => w.What, StringComparer.Ordinal)];
        }

        bool same = wanted.Count == found.Count
            && wanted.Zip(found, (w, f) => w.What == f.What && Math.Abs(w.Step - f.Step) <= StepShift).All(s => s);
        return same ? null : $"{got}, in the original {expected}";
    }

    private static (int Step, string What) Item(JsonElement entry, bool byPair)
    {
        string[] parts = entry.EnumerateArray().Skip(1).Select(p => p.ToString()).ToArray();
        if (byPair)
        {
            Array.Sort(parts, 0, 2, StringComparer.Ordinal);
        }

        return (entry[0].GetInt32(), string.Join(" ", parts));
    }

    private static string Text(List<(int Step, bool State)> changes) => changes.Count == 0
        ? "never"
        : string.Join(" ", changes.Select(c => c.Step.ToString(CultureInfo.InvariantCulture) + (c.State ? " on" : " off")));
}
