using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// Judges the values observed with every row. Flags and numbers of things must be those of a sample near by. What measures must lie
/// between the values of neighbouring samples (or on a branch beside a jump), give or take the spread between iteration counts, rounding,
/// and the share of its range by which the original's own motion is off: its error in position over the way the bodies go, and likewise for
/// angles and speeds.
/// </summary>
internal static class FlashObservationJudge
{
    private const int StepShift = 2;

    /// <summary>Rounding counts against this if all values are smaller, 0 for example.</summary>
    private const double SmallestUnit = 1;

    public static IEnumerable<Check> Judge(SceneFile file, int iterations, Recording ours)
    {
        double share = Share(file, iterations);
        foreach ((string expression, JsonElement[] expected) in file.Recordings[iterations].Observed)
        {
            JsonElement[] got = ours.Observed[expression];
            bool counts = expected.All(ObservationJudge.IsCount) && expected.Any(e => e.ValueKind != JsonValueKind.Number);
            counts |= expression.EndsWith("Count", StringComparison.Ordinal);
            yield return counts
                ? Counted(file, expression, expected, got)
                : Measured(file, iterations, expression, expected, got, share);
        }
    }

    private static Check Counted(SceneFile file, string what, JsonElement[] expected, JsonElement[] got)
    {
        int shift =
            what.EndsWith("IsSleeping", StringComparison.Ordinal) ? (int)Math.Ceiling(FlashListJudge.SleepShift / file.Dt) : StepShift;
        for (int k = 0; k < got.Length; k++)
        {
            int step = file.SampleSteps[k];
            bool near = Enumerable.Range(0, expected.Length)
                .Where(j => Math.Abs(j - k) <= 1 || Math.Abs(file.SampleSteps[j] - step) <= shift)
                .Any(j => expected[j].ToString() == got[k].ToString());
            if (!near)
            {
                return Check.Of(what, $"after {step} {got[k]}, in the original {expected[k]}");
            }
        }

        return Check.Of(what, null);
    }

    private static Check Measured(SceneFile file, int iterations, string what, JsonElement[] expected, JsonElement[] got, double share)
    {
        double[][] wanted = expected.Select(Numbers).ToArray();
        double[][] found = got.Select(Numbers).ToArray();
        double limit = wanted.SelectMany(w => w).Select(Math.Abs).Append(SmallestUnit).Max() * 1e-6;
        foreach (Recording other in file.Recordings.Values)
        {
            limit = Math.Max(limit, other.Observed[what].Select(Numbers).Zip(wanted, Apart).Max());
        }

        double range = Enumerable.Range(0, wanted[0].Length)
            .Select(i => wanted.Where(w => w.Length > i).Max(w => w[i]) - wanted.Where(w => w.Length > i).Min(w => w[i]))
            .DefaultIfEmpty(0).Max();
        // Both the recording and the library may be that far from the truth, on either side.
        limit += (2 * share * range) + FlashSlops.OfObserved(file, what);
        bool[] struck = StruckNear(file, iterations);
        Worst worst = new();
        for (int k = 0; k < found.Length; k++)
        {
            // What a joint gives while something strikes depends on the moment within the step.
            if (struck[k] && (what.Contains("Reaction", StringComparison.Ordinal) || what.Contains("GetMotor", StringComparison.Ordinal)))
            {
                continue;
            }

            double[][] near = wanted[Math.Max(0, k - 1)..Math.Min(wanted.Length, k + 2)];
            bool like = near.All(n => n.Length == found[k].Length);
            near = like ? [.. near, .. Branches(wanted, k)] : near;
            double error = like ? Outside(found[k], near) : double.PositiveInfinity;
            worst.Take(
                error,
                limit,
                $"after {file.SampleSteps[k].ToString(CultureInfo.InvariantCulture)}: {got[k]}, in the original {expected[k]}");
        }

        return worst.ToCheck(what);
    }

    /// <summary>
    /// Where the value jumps beside a sample (a motor reaches its speed and holds it), the jump may as well come on the sample's other
    /// side: the value is then that of the branch over there, carried on in a straight line. A branch is what changes by less than half
    /// the jump.
    /// </summary>
    private static IEnumerable<double[]> Branches(double[][] wanted, int k)
    {
        foreach (int side in new[] { -1, 1 })
        {
            int far = k + (2 * side);
            if (far >= 0 && far < wanted.Length)
            {
                double[] next = wanted[k + side];
                double[] beyond = wanted[far];
                double jump = Apart(next, wanted[k]);
                if (Apart(beyond, next) < jump / 2)
                {
                    yield return [.. next.Zip(beyond, (n, b) => (2 * n) - b)];
                }
            }
        }
    }

    private static bool[] StruckNear(SceneFile file, int iterations)
    {
        bool[] struck = new bool[file.SampleSteps.Length];
        IReadOnlyDictionary<string, Row[]> rows = file.Recordings[iterations].Rows;
        FloatTolerance rounding = FloatTolerance.Of(file, rows.Values);
        foreach (Impacts impacts in rows.Values.Select(r => new Impacts(file, r, rounding)))
        {
            for (int k = 0; k < struck.Length; k++)
            {
                struck[k] |= impacts.Between(k - 2) || impacts.Between(k - 1) || impacts.Between(k);
            }
        }

        return struck;
    }

    private static double Outside(double[] found, double[][] near) => Enumerable.Range(0, found.Length)
        .Select(i => Math.Max(near.Min(n => n[i]) - found[i], found[i] - near.Max(n => n[i])))
        .Append(0).Max();

    private static double Apart(double[] a, double[] b) => a.Zip(b, (x, y) => Math.Abs(x - y)).DefaultIfEmpty(0).Max();

    private static double[] Numbers(JsonElement value) => value.ValueKind switch
    {
        JsonValueKind.Number => [value.GetDouble()],
        JsonValueKind.Array => value.EnumerateArray().SelectMany(Numbers).ToArray(),
        JsonValueKind.String when value.GetString() == "NaN" => [0],
        _ => [],
    };

    /// <summary>The largest share of their ranges by which the recording's positions, angles and velocities are off.</summary>
    private static double Share(SceneFile file, int iterations)
    {
        IReadOnlyDictionary<string, Row[]> rows = file.Recordings[iterations].Rows;
        Difference off = file.Refined?.FromRecorded ?? RowJudge.LargestLimits(file, iterations);
        double share = 0;
        share = Math.Max(share, Over(off.Position, r => r.X, r => r.Y));
        share = Math.Max(share, Over(off.Rotation, r => r.Rotation));
        share = Math.Max(share, Over(off.LinearVelocity, r => r.VelocityX, r => r.VelocityY));
        return Math.Min(1, Math.Max(share, Over(off.AngularVelocity, r => r.AngularVelocity)));

        double Over(double error, params Func<Row, double>[] parts)
        {
            double range = rows.Values.Select(b => b.Where(r => !r.IsAbsent).ToArray()).Where(b => b.Length > 0)
                .SelectMany(b => parts.Select(p => b.Max(p) - b.Min(p))).DefaultIfEmpty(0).Max();
            return range > error ? error / range : 0;
        }
    }
}
