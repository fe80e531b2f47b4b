using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Running;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>Judges the answers to queries and the masses and inertias: equal up to rounding.</summary>
public static class QueryJudge
{
    /// <summary>A query is a short chain of single-precision operations; each may round by an ulp of the largest number in it.</summary>
    private const double Operations = 16;

    private static readonly double Ulp = Math.Pow(2, -23);

    /// <param name="file">The scene.</param>
    /// <param name="iterations">Which of its runs.</param>
    /// <param name="ours">What the library did.</param>
    /// <param name="exactly">True: where geometry knows the answer better than the original, it is the reference.</param>
    public static IEnumerable<Check> Queries(SceneFile file, int iterations, Recording ours, bool exactly = true)
    {
        IReadOnlyList<JsonElement> expected = file.Recordings[iterations].QueryResults;
        if (expected.Count == 0)
        {
            return [];
        }

        Difference moved = RowJudge.LargestLimits(file, iterations);
        Worst worst = new();
        for (int i = 0; i < expected.Count; i++)
        {
            SceneQuery query = file.Queries[i];
            JsonElement answer = (exactly ? ExactAnswers.Of(file, query) : null) is { } truth
                ? JsonSerializer.SerializeToElement(truth)
                : expected[i];
            double magnitude =
                query.Args.Append(Points(file, query)).Select(ValueComparer.Magnitude).Append(ValueComparer.Magnitude(answer)).Max();

            // What is asked after some steps is asked of bodies that may be off by the limits of the trajectory.
            bool inMotion = query.AfterStep > 0 && (moved.Position > 0 || moved.Rotation > 0);
            double travelled = inMotion
                ? Math.Max(moved.Position, moved.LinearVelocity) + ((moved.Rotation + moved.AngularVelocity) * magnitude)
                    + (moved.Position * SpinOf(file, iterations))
                : 0;
            double error = ValueComparer.Difference(answer, ours.QueryResults[i]);
            worst.Take(error, (Operations * Ulp * magnitude) + travelled, query + ": expected " + answer + ", got " + ours.QueryResults[i]);
        }

        Check check = worst.ToCheck("queries");
        return [check.Passed ? check with { Where = string.Empty } : check];
    }

    public static IEnumerable<Check> MassProperties(SceneFile file, RunResult run)
    {
        Worst worst = new();
        bool any = false;
        foreach (JsonProperty body in Json.Members(file.Root, "massProperties"))
        {
            double[] got = run.MassProperties[body.Name];
            int i = 0;
            foreach (JsonProperty property in body.Value.EnumerateObject())
            {
                double expected = property.Value.GetDouble();
                worst.Take(
                    Math.Abs(got[i] - expected),
                    Operations * Ulp * Math.Abs(expected),
                    $"{body.Name}.{property.Name}: expected {expected:g9}, got {got[i]:g9}");
                i++;
                any = true;
            }
        }

        Check check = worst.ToCheck("massProperties");
        return any ? [check.Passed ? check with { Where = string.Empty } : check] : [];
    }

    /// <summary>Paths as their factory made them: equal counts, places to the rounding of the curve they follow.</summary>
    public static IEnumerable<Check> Paths(SceneFile file, RunResult run)
    {
        foreach (JsonProperty path in Json.Members(file.Root, "pathResults"))
        {
            JsonElement got = run.PathResults[path.Name];
            foreach (JsonProperty property in path.Value.EnumerateObject())
            {
                double limit = property.Name.EndsWith("Count", StringComparison.Ordinal)
                    ? 0
                    : Operations * Ulp * ValueComparer.Magnitude(property.Value);
                yield return new Check(
                    path.Name + "." + property.Name,
                    ValueComparer.Difference(property.Value, Json.Optional(got, property.Name)),
                    limit,
                    string.Empty);
            }
        }
    }

    /// <summary>
    /// The polygon that is asked, whose coordinates are rounded as well: the centre of a hexagon about the origin is 0 to their rounding.
    /// </summary>
    private static JsonElement Points(SceneFile file, SceneQuery query) => query.Vertices.ValueKind == JsonValueKind.String
        ? Json.Optional(Json.Optional(file.Root, "vertices"), query.Vertices.GetString()!)
        : query.Vertices;

    private static double SpinOf(SceneFile file, int iterations)
        => file.Recordings[iterations].Rows.Values.SelectMany(r => r).Select(r => Math.Abs(r.AngularVelocity)).DefaultIfEmpty(0).Max();
}
