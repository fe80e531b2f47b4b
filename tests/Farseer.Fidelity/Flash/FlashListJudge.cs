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

    /// <summary>
    /// The time that a body must rest before it sleeps, and the shift of steps. The original judges rest by speed and the library by
    /// place: what still sinks to its depth of rest begins to rest later.
    /// </summary>
    public const double SleepShift = 0.5 + (2.0 / 60);

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

        bool sleep = name == "sleepChanges";
        int shift = sleep ? (int)Math.Ceiling(SleepShift / file.Dt) : StepShift;
        HashSet<string> moving = [.. file.Recordings.Values.SelectMany(r => r.Rows.Keys)];
        foreach (string body in expected.EnumerateObject().Select(p => p.Name).Concat(got.Keys).Distinct().Where(moving.Contains))
        {
            if (sleep && FlashExemptions.IsStoppedByDamping(file, body))
            {
                continue;
            }

            // The original's own two recordings may fall asleep at times far apart, or one of them not at all: any of it will do.
            List<(int Step, bool State)>[] recordings = [.. Json.Members(file.Root, name).Select(p => Lasting(Changes(p.Value, body)))];
            List<(int Step, bool State)> found = Lasting(got.GetValueOrDefault(body, []));
            bool same = recordings.Any(r => IsSame(r, found, recordings, file.Steps, shift));
            yield return Check.Of(
                name + " " + body,
                same ? null : $"{Text(got.GetValueOrDefault(body, []))}, in the original {Text(Changes(expected, body))}");
        }
    }

    private static bool IsSame(
        IEnumerable<(int Step, bool State)> recording,
        IEnumerable<(int Step, bool State)> got,
        List<(int Step, bool State)>[] recordings,
        int steps,
        int shift)
    {
        List<(int Step, bool State)> wanted = [.. recording];
        List<(int Step, bool State)> found = [.. got];
        DropLast(found, wanted.Count, steps - shift);
        DropLast(wanted, found.Count, steps - shift);
        return wanted.Count == found.Count && Enumerable.Range(0, found.Count).All(i =>
            found[i].State == wanted[i].State
                && Near(found[i].Step, [.. recordings.Where(r => r.Count > i).Select(r => r[i].Step)], shift));
    }

    private static List<(int Step, bool State)> Changes(JsonElement byBody, string body)
        => [.. Json.Items(byBody, body).Select(c => (c[0].GetInt32(), c[1].GetBoolean()))];

    private static bool Near(int step, int[] steps, int shift) => step >= steps.Min() - shift && step <= steps.Max() + shift;

    /// <summary>Without naps of a few steps.</summary>
    private static List<(int Step, bool State)> Lasting(List<(int Step, bool State)> changes)
    {
        List<(int Step, bool State)> lasting = [];
        foreach ((int step, bool state) in changes)
        {
            if (lasting.Count > 0 && !state && step - lasting[^1].Step <= StepShift)
            {
                lasting.RemoveAt(lasting.Count - 1);
            }
            else
            {
                lasting.Add((step, state));
            }
        }

        return lasting;
    }

    /// <summary>What comes so late in the one that it may just as well come after the end in the other does not count.</summary>
    private static void DropLast(List<(int Step, bool State)> changes, int others, int latest)
    {
        if (changes.Count == others + 1 && changes[^1].Step > latest)
        {
            changes.RemoveAt(changes.Count - 1);
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
