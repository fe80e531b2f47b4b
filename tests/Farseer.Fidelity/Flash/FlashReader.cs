using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Running;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// Reads a scene recorded with Box2DFlash into the form that the judges know: shapes stand for geoms, the linear slop for the depth of
/// rest, and the calls of the contact listener for events. What has no counterpart stays in <see cref="SceneFile.Root"/>.
/// </summary>
internal static class FlashReader
{
    private const double LinearSlop = 0.005;

    public static bool IsFlash(JsonElement root) => root.ValueKind == JsonValueKind.Object && root.TryGetProperty("world", out _);

    public static SceneFile Parse(string path, JsonElement root)
    {
        int steps = Json.Required(root, "steps").GetInt32();
        float dt = Json.Required(root, "dt").GetSingle();
        if (steps < 0 || !float.IsFinite(dt) || dt <= 0)
        {
            throw new BadSceneException($"steps {steps} and dt {dt} must be at least 0 and above 0.");
        }

        int[] samples = Json.Items(root, "sampleSteps").Select(e => e.GetInt32()).ToArray();
        int[] iterations = Json.Items(root, "iterations").Select(e => e.GetInt32()).ToArray();
        if (iterations.Length == 0)
        {
            throw new BadSceneException("'iterations' is missing or empty.");
        }

        JsonElement spread = Json.Optional(root, "spread");
        JsonElement between = Json.Optional(spread, "between10And100Iterations");
        JsonElement perturbed = Json.Optional(spread, "underTinyPerturbation");
        return new SceneFile(path, root)
        {
            Name = Json.Text(root, "name"),
            Category = Json.Text(root, "category"),
            Quirk = Json.OptionalText(root, "quirk"),
            Format = SceneFormat.Box2DFlash,
            RestDepth = LinearSlop,
            Gravity = Json.Required(Json.Required(root, "world"), "gravity"),
            Dt = dt,
            LongestDt = Json.Items(root, "actions").Select(a => Json.Optional(a, "dt")).Where(e => e.ValueKind == JsonValueKind.Number)
                .Select(e => e.GetSingle()).Append(dt).Max(),
            Steps = steps,
            Iterations = iterations,
            SampleSteps = samples,
            Bodies = Json.Items(root, "bodies")
                .Select(b => new MadeObject(Json.Text(b, "id"), "b2BodyDef", Json.Required(b, "def"), [], null)).ToList(),
            Geoms = Json.Items(root, "bodies").SelectMany(Shapes).ToList(),
            Joints = Json.Items(root, "joints").Select(j => new MadeObject(Json.Text(j, "id"), Json.Text(j, "type"), j, [], null)).ToList(),
            Queries = Json.Items(root, "queries").Select(ReadQuery).ToList(),
            Observe = Json.Items(root, "observe").Select(e => e.GetString()!).ToList(),
            Spread = between.ValueKind == JsonValueKind.Object ? ReadDifference(between) : null,
            Growth = perturbed.ValueKind == JsonValueKind.Object ? ReadGrowth(perturbed) : 1,
            Refined = ReadRefined(Json.Optional(root, "refined"), samples.Length),
            Recordings = iterations.ToDictionary(n => n, n => ReadRecording(root, n, samples.Length)),
        };
    }

    /// <summary>The id of a shape: its own, or that of the body and its number.</summary>
    public static string ShapeId(string body, JsonElement shape, int index)
        => Json.OptionalText(shape, "id") ?? body + ".s" + index.ToString(CultureInfo.InvariantCulture);

    /// <summary>The calls of the contact listener as events, one for each kind and pair; see <see cref="PairEvents"/>.</summary>
    public static IReadOnlyList<SceneEvent>? ReadEvents(JsonElement root, string key)
    {
        JsonElement sequence = Json.Optional(Json.Optional(root, "contactSequence"), key);
        if (sequence.ValueKind != JsonValueKind.Array)
        {
            return null;
        }

        PairEvents events = new();
        foreach (JsonElement run in sequence.EnumerateArray())
        {
            int last = run.GetProperty("steps")[1].GetInt32();
            for (int step = run.GetProperty("steps")[0].GetInt32(); step <= last; step++)
            {
                foreach (JsonElement call in run.GetProperty("calls").EnumerateArray())
                {
                    events.Add(step, call[0].GetString()!, call[1].GetString()!, call[2].GetString()!);
                }
            }
        }

        Dictionary<string, string> bodies = Json.Items(root, "bodies").SelectMany(Shapes).ToDictionary(g => g.Id, g => g.Body!);
        int steps = root.GetProperty("steps").GetInt32();
        return events.ToEvents(shape => bodies.TryGetValue(shape, out string? body)
            ? SleepIntervals.Of(SleepIntervals.Read(root, key, body), steps)
            : []);
    }

    private static IEnumerable<MadeObject> Shapes(JsonElement body)
    {
        string id = Json.Text(body, "id");
        return Json.Items(body, "shapes").Select((s, i) => new MadeObject(ShapeId(id, s, i), Json.Text(s, "type"), Sizes(s), [], id));
    }

    /// <summary>Half sides become sides; the rest has the names that the judges look for.</summary>
    private static JsonElement Sizes(JsonElement shape)
    {
        JsonElement box = Json.Optional(shape, "SetAsBox");
        box = box.ValueKind == JsonValueKind.Array ? box : Json.Optional(shape, "SetAsOrientedBox");
        return box.ValueKind == JsonValueKind.Array
            ? JsonSerializer.SerializeToElement(
                new Dictionary<string, double> { ["width"] = 2 * box[0].GetDouble(), ["height"] = 2 * box[1].GetDouble() })
            : shape;
    }

    private static SceneQuery ReadQuery(JsonElement element) => new(
        Json.Optional(element, "afterStep") is { ValueKind: JsonValueKind.Number } after ? after.GetInt32() : 0,
        Json.OptionalText(element, "target"),
        null,
        default,
        Json.OptionalText(element, "call"),
        Json.OptionalText(element, "list") ?? (Json.Optional(element, "debugDraw").ValueKind == JsonValueKind.Array ? "debugDraw" : null),
        Json.Items(element, "args").Concat(Json.Items(element, "debugDraw")).ToList());

    private static Difference ReadDifference(JsonElement element) => new(
        Json.Required(element, "position").GetDouble(),
        Json.Required(element, "angle").GetDouble(),
        Json.Required(element, "linearVelocity").GetDouble(),
        Json.Required(element, "angularVelocity").GetDouble());

    private static double ReadGrowth(JsonElement perturbed)
    {
        double by = Json.Required(perturbed, "perturbedBy").GetDouble();
        return by > 0 ? Math.Max(1, ReadDifference(perturbed).Position / by) : 1;
    }

    private static Refined? ReadRefined(JsonElement element, int samples) => element.ValueKind == JsonValueKind.Undefined
        ? null
        : new Refined(
            Json.Required(element, "dtDivisor").GetInt32(),
            ReadDifference(Json.Required(element, "differenceFromRecorded")),
            Json.Members(element, "rows").ToDictionary(p => p.Name, p => ReadRows(p.Value, samples)));

    private static Recording ReadRecording(JsonElement root, int iterations, int samples)
    {
        string key = iterations.ToString(CultureInfo.InvariantCulture);
        return new Recording(
            Json.Members(Json.Optional(root, "recorded"), key).ToDictionary(p => p.Name, p => ReadRows(p.Value, samples)),
            Json.Members(Json.Optional(root, "observed"), key).ToDictionary(p => p.Name, p => p.Value.EnumerateArray().ToArray()),
            ReadEvents(root, key),
            Json.Items(Json.Optional(root, "queryResults"), key).ToList());
    }

    private static Row[] ReadRows(JsonElement rows, int samples)
    {
        Row[] result = rows.EnumerateArray().Select(ReadRow).ToArray();
        return result.Length == samples
            ? result
            : throw new BadSceneException($"a body has {result.Length} rows, but there are {samples} 'sampleSteps'.");
    }

    private static Row ReadRow(JsonElement r) => r.ValueKind == JsonValueKind.Null
        ? Row.Absent
        : new Row(r[0].GetDouble(), r[1].GetDouble(), r[2].GetDouble(), r[3].GetDouble(), r[4].GetDouble(), r[5].GetDouble());
}
