using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Running;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// Judges queries and masses. A box query is judged as a set: the order of its shapes is that of the original's sorted axes. If it
/// was cut short by its largest count, the shapes found must be among those that the whole query finds.
/// </summary>
internal static class FlashQueryJudge
{
    private const double Operations = 16;

    private static readonly double Ulp = Math.Pow(2, -23);

    public static IEnumerable<Check> Judge(SceneFile file, int iterations, Recording ours)
    {
        List<int> boxes = Enumerable.Range(0, file.Queries.Count).Where(i => file.Queries[i].Call == "Query").ToList();
        List<int> drawings = Enumerable.Range(0, file.Queries.Count).Where(i => file.Queries[i].Get == "debugDraw").ToList();
        IReadOnlyList<JsonElement> expected = file.Recordings[iterations].QueryResults;
        List<Check> checks = [];
        foreach (int i in boxes)
        {
            checks.Add(Check.Of("query", Box(file.Queries[i], expected[i], ours.QueryResults[i])));
        }

        foreach (int i in drawings)
        {
            checks.Add(Check.Of(
                "drawing " + string.Join(" ", file.Queries[i].Args), FlashDrawingJudge.Problem(expected[i], ours.QueryResults[i])));
        }

        // The others go by the rules that the other format has.
        List<int> rest = Enumerable.Range(0, file.Queries.Count).Except(boxes).Except(drawings).ToList();
        Difference moved = rest.Count == 0 ? default : RowJudge.LargestLimits(file, iterations);
        foreach (int i in rest)
        {
            SceneQuery query = file.Queries[i];
            double magnitude = query.Args.Select(ValueComparer.Magnitude).Append(ValueComparer.Magnitude(expected[i]))
                .Append(Largest(file, iterations)).Max();
            double travelled = query.AfterStep == 0
                ? 0
                : moved.Position + moved.LinearVelocity + ((moved.Rotation + moved.AngularVelocity) * magnitude)
                    + (moved.Position * Spin(file, iterations));
            double error = ValueComparer.Difference(expected[i], ours.QueryResults[i]);
            Check check = new(
                query + ": expected " + expected[i] + ", got " + ours.QueryResults[i],
                error,
                (Operations * Ulp * magnitude) + travelled,
                string.Empty);
            checks.Add(check.Passed ? check with { What = "query" } : check);
        }

        return checks;
    }

    public static IEnumerable<Check> MassProperties(SceneFile file, RunResult run)
    {
        Worst worst = new();
        foreach (JsonProperty body in Json.Members(file.Root, "massProperties"))
        {
            double[] got = run.MassProperties[body.Name];
            double[] expected =
            [
                body.Value.GetProperty("mass").GetDouble(),
                body.Value.GetProperty("I").GetDouble(),
                body.Value.GetProperty("localCenter")[0].GetDouble(),
                body.Value.GetProperty("localCenter")[1].GetDouble(),
                body.Value.GetProperty("isStatic").GetBoolean() ? 1 : 0,
            ];
            for (int i = 0; i < expected.Length; i++)
            {
                // A centre is a difference of places about as large as the body: an absolute rounding.
                double limit = Operations * Ulp * (i is 2 or 3 ? Math.Max(1, Math.Abs(expected[i])) : Math.Abs(expected[i]));
                worst.Take(Math.Abs(got[i] - expected[i]), limit, $"{body.Name}: expected {expected[i]:g9}, got {got[i]:g9}");
            }
        }

        Check check = worst.ToCheck("massProperties");
        yield return check.Passed ? check with { Where = string.Empty } : check;
    }

    private static string? Box(SceneQuery query, JsonElement expected, JsonElement got)
    {
        string[] wanted = Names(expected);
        string[] found = Names(got);
        bool cut = wanted.Length == query.Args[1].GetInt32();
        bool same = cut ? found.Length == wanted.Length : wanted.Order().SequenceEqual(found.Order());
        return same ? null : query + ": expected " + expected + ", got " + got;

        static string[] Names(JsonElement e) => e.GetProperty("shapes").EnumerateArray().Select(s => s.GetString()!).ToArray();
    }

    private static double Spin(SceneFile file, int iterations) => file.Recordings[iterations].Rows.Values.SelectMany(r => r)
        .Where(r => !r.IsAbsent).Select(r => Math.Abs(r.AngularVelocity)).DefaultIfEmpty(0).Max();

    private static double Largest(SceneFile file, int iterations) => file.Recordings[iterations].Rows.Values.SelectMany(r => r)
        .Where(r => !r.IsAbsent).Select(r => Math.Max(Math.Abs(r.X), Math.Abs(r.Y))).DefaultIfEmpty(1).Max();
}
