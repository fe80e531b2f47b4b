using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;

namespace Farseer.Fidelity.Scenes;

/// <summary>Reads the parts of a scene file.</summary>
internal static class SceneParts
{
    private static readonly string[] NotProperties = ["id", "factory", "args", "body"];

    public static MadeObject ReadObject(JsonElement element)
    {
        string? body = Json.OptionalText(element, "body");
        string id = Json.OptionalText(element, "id") ?? (body is null ? throw new BadSceneException("'id' is missing.") : "g" + body);
        List<KeyValuePair<string, JsonElement>> properties = element.EnumerateObject()
            .Where(p => !NotProperties.Contains(p.Name))
            .Select(p => new KeyValuePair<string, JsonElement>(p.Name, p.Value))
            .ToList();
        return new MadeObject(id, Json.Text(element, "factory"), Json.Optional(element, "args"), properties, body);
    }

    public static SceneAction ReadAction(JsonElement element)
    {
        int step = Json.Required(element, "step").GetInt32();
        JsonElement until = Json.Optional(element, "until");
        return new SceneAction(
            step,
            until.ValueKind == JsonValueKind.Number ? until.GetInt32() : step,
            Json.OptionalText(element, "target"),
            Json.OptionalText(element, "call"),
            Json.Optional(element, "args"),
            Json.Optional(element, "set"),
            Json.OptionalText(element, "remove"),
            Json.OptionalText(element, "dispose"));
    }

    public static SceneQuery ReadQuery(JsonElement element)
    {
        JsonElement after = Json.Optional(element, "afterStep");
        return new SceneQuery(
            after.ValueKind == JsonValueKind.Number ? after.GetInt32() : 0,
            Json.OptionalText(element, "target"),
            Json.OptionalText(element, "static"),
            Json.Optional(element, "vertices"),
            Json.OptionalText(element, "call"),
            Json.OptionalText(element, "get"),
            Json.Items(element, "args").ToList());
    }

    public static Difference ReadDifference(JsonElement element) => new(
        Json.Required(element, "position").GetDouble(),
        Json.Required(element, "rotation").GetDouble(),
        Json.Required(element, "linearVelocity").GetDouble(),
        Json.Required(element, "angularVelocity").GetDouble());

    public static double ReadGrowth(JsonElement perturbed)
    {
        double by = Json.Required(perturbed, "perturbedBy").GetDouble();
        return by > 0 ? Math.Max(1, ReadDifference(perturbed).Position / by) : 1;
    }

    public static Refined? ReadRefined(JsonElement element, int samples)
    {
        if (element.ValueKind == JsonValueKind.Undefined)
        {
            return null;
        }

        return new Refined(
            Json.Required(element, "dtDivisor").GetInt32(),
            ReadDifference(Json.Required(element, "differenceFromRecorded")),
            Json.Members(element, "rows").ToDictionary(p => p.Name, p => ReadRows(p.Value, samples)));
    }

    public static Recording ReadRecording(JsonElement root, int iterations, int samples)
    {
        string key = iterations.ToString(CultureInfo.InvariantCulture);
        Dictionary<string, JsonElement[]> observed = Json.Members(Json.Optional(root, "observed"), key)
            .ToDictionary(p => p.Name, p => p.Value.EnumerateArray().ToArray());
        JsonElement events = Json.Optional(Json.Optional(root, "events"), key);
        return new Recording(
            Json.Members(Json.Optional(root, "recorded"), key).ToDictionary(p => p.Name, p => ReadRows(p.Value, samples)),
            observed,
            events.ValueKind == JsonValueKind.Array ? events.EnumerateArray().Select(ReadEvent).ToList() : null,
            Json.Items(Json.Optional(root, "queryResults"), key).ToList());
    }

    private static SceneEvent ReadEvent(JsonElement element)
    {
        List<(int, int)> runs = Json.Items(element, "steps").Select(r => (r[0].GetInt32(), r[1].GetInt32())).ToList();
        if (runs.Count == 0)
        {
            throw new BadSceneException("an event has no 'steps'.");
        }

        return new SceneEvent(
            Json.Text(element, "type"),
            Json.OptionalText(element, "geom1") ?? Json.Text(element, "object"),
            Json.OptionalText(element, "geom2") ?? string.Empty,
            Json.Required(element, "count").GetInt32(),
            runs);
    }

    private static Row[] ReadRows(JsonElement rows, int samples)
    {
        Row[] result = rows.EnumerateArray().Select(r => r.GetArrayLength() == 6
            ? new Row(r[0].GetDouble(), r[1].GetDouble(), r[2].GetDouble(), r[3].GetDouble(), r[4].GetDouble(), r[5].GetDouble())
            : throw new BadSceneException($"a row has {r.GetArrayLength()} numbers instead of 6.")).ToArray();
        return result.Length == samples
            ? result
            : throw new BadSceneException($"a body has {result.Length} rows, but there are {samples} 'sampleSteps'.");
    }
}
