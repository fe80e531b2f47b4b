using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>
/// Judges the values observed with every row. What counts (numbers of things, flags, names) must be
/// that of the same sample or of a neighbour, for a change may fall on the other side of a sample;
/// what measures (an error of a joint may be smaller) may be off by the spread between iteration counts, by the integrator's error (see
/// <see cref="Discretisation"/>) and by rounding. Of the contact pairs, the pairs are compared and not
/// the numbers of their contacts: those are the original's vertices.
/// </summary>
public static class ObservationJudge
{
    public static IEnumerable<Check> Judge(
        SceneFile file, int iterations, Recording ours, IReadOnlyDictionary<string, Row[]>? motion = null)
    {
        foreach ((string expression, JsonElement[] expected) in file.Recordings[iterations].Observed)
        {
            JsonElement[] got = ours.Observed[expression];
            if (expression == "simulator.ContactPairs")
            {
                yield return Touching(file, iterations, expected.Select(Pairs).ToArray(), got.Select(Pairs).ToArray(), motion is not null);
            }
            else if (expression.EndsWith("Time", StringComparison.Ordinal) && expected.All(e => e.ValueKind == JsonValueKind.Number))
            {
                yield return Timed(expression, expected, got, file);
            }
            else if (expected.All(IsCount))
            {
                yield return Counted(
                    expression,
                    expected.Select(e => new[] { e.ToString() }).ToArray(),
                    got.Select(e => new[] { e.ToString() }).ToArray(),
                    file);
            }
            else
            {
                yield return Measured(file, iterations, expression, expected, got);
            }
        }
    }

    internal static bool IsCount(JsonElement value) => value.ValueKind switch
    {
        JsonValueKind.Number => value.TryGetInt32(out _),
        JsonValueKind.Array => value.GetArrayLength() == 0,
        _ => true,
    };

    /// <summary>A joint that errs less than the original's is no less faithful: only what it errs more counts.</summary>
    private static double Excess(JsonElement expected, JsonElement got)
        => Math.Max(0, Math.Abs(got.GetDouble()) - Math.Abs(expected.GetDouble()));

    private static string[] Pairs(JsonElement value) => value.EnumerateArray().Select(p => p.GetString()!.Split(':')[0]).ToArray();

    /// <summary>
    /// Each pair must be had or not as in a sample near by: the next, or one within the updates in which it crosses what its circles'
    /// edges and
    /// the depth of rest leave open. A circle that rolls leaves the floor from edge to edge in the original; where it moves so unlike
    /// a circle that the equations of motion are followed, its pairs are not compared.
    /// </summary>
    private static Check Touching(SceneFile file, int iterations, string[][] expected, string[][] got, bool byMotion)
    {
        const string Name = "simulator.ContactPairs";
        foreach (string pair in expected.Concat(got).SelectMany(p => p).Distinct())
        {
            string[] geoms = pair.Split('|');
            if (byMotion && file.Geoms.Any(g => geoms.Contains(g.Id) && SceneSizes.Sagitta(g) > 0))
            {
                continue;
            }

            for (int k = 0; k < got.Length; k++)
            {
                int step = file.SampleSteps[k];
                int shift = EventJudge.Crossing(file, iterations, geoms[0], geoms[1], step);
                bool near = Enumerable.Range(0, expected.Length).Where(j => Math.Abs(j - k) <= 1
                    || Math.Abs(file.SampleSteps[j] - step) <= shift)
                    .Any(j => expected[j].Contains(pair) == got[k].Contains(pair));
                if (!near)
                {
                    string pairs = string.Join(", ", expected[k]);
                    return Check.Of(Name, $"after {step} [{string.Join(", ", got[k])}], in the original [{pairs}]");
                }
            }
        }

        return Check.Of(Name, null);
    }

    /// <summary>
    /// Milliseconds since something: what it was may be two updates earlier or later, and the sample beside it may be nearer.
    /// </summary>
    private static Check Timed(string what, JsonElement[] expected, JsonElement[] got, SceneFile file)
    {
        const double Milliseconds = 1000;
        double limit = EventJudge.StepShift * file.Dt * Milliseconds * 1.001;
        Worst worst = new();
        for (int k = 0; k < got.Length; k++)
        {
            double error = expected[Math.Max(0, k - 1)..Math.Min(expected.Length, k + 2)].Min(e => ValueComparer.Difference(e, got[k]));
            worst.Take(error, limit, "after " + file.SampleSteps[k].ToString(CultureInfo.InvariantCulture));
        }

        return worst.ToCheck(what);
    }

    private static Check Counted(string what, string[][] expected, string[][] got, SceneFile file)
    {
        for (int k = 0; k < expected.Length; k++)
        {
            string[][] near = expected[Math.Max(0, k - 1)..Math.Min(expected.Length, k + 2)];
            string[] unknown = got[k].Except(near.SelectMany(n => n)).ToArray();
            string[] lost = near.Aggregate((a, b) => a.Intersect(b).ToArray()).Except(got[k]).ToArray();
            if (unknown.Length + lost.Length > 0)
            {
                string update = file.SampleSteps[k].ToString(CultureInfo.InvariantCulture);
                return Check.Of(what, $"after {update} [{string.Join(", ", got[k])}], in the original [{string.Join(", ", expected[k])}]");
            }
        }

        return Check.Of(what, null);
    }

    private static Check Measured(SceneFile file, int iterations, string what, JsonElement[] expected, JsonElement[] got)
    {
        double magnitude = expected.Select(ValueComparer.Magnitude).Max();
        double limit = FloatTolerance.Ulp(magnitude) * (2 + Math.Sqrt(file.Steps));
        foreach (Recording other in file.Recordings.Values)
        {
            limit = Math.Max(limit, other.Observed[what].Zip(expected, ValueComparer.Difference).Max());
        }

        if (what.EndsWith("Rotation", StringComparison.Ordinal))
        {
            limit += file.Refined?.FromRecorded.Rotation ?? 0;
        }

        if (expected.All(e => e.ValueKind == JsonValueKind.Number))
        {
            double[] values = expected.Select(e => e.GetDouble()).ToArray();
            for (int k = 2; k < values.Length; k++)
            {
                double updates = file.SampleSteps[k] - file.SampleSteps[k - 1];
                limit += Math.Abs(values[k] - (2 * values[k - 1]) + values[k - 2]) / updates / 2;
            }
        }

        Worst worst = new();
        for (int k = 0; k < expected.Length; k++)
        {
            double error = what.EndsWith(".JointError", StringComparison.Ordinal)
                ? Excess(expected[k], got[k])
                : ValueComparer.Difference(expected[k], got[k]);
            worst.Take(error, limit, "after " + file.SampleSteps[k].ToString(CultureInfo.InvariantCulture));
        }

        return worst.ToCheck(what);
    }
}
