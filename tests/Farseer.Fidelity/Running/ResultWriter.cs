using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using System.Text.Json.Nodes;
using Farseer.Fidelity.Building;

namespace Farseer.Fidelity.Running;

/// <summary>Writes what the library answered in the notation of the scene files.</summary>
public static class ResultWriter
{
    public static JsonNode? Write(BuiltScene scene, object? value)
    {
        switch (value)
        {
            case null:
                return null;
            case bool or string or int or byte or uint or long or double:
                return JsonSerializer.SerializeToNode(value);
            case float number:
                return float.IsFinite(number)
                    ? JsonValue.Create(number)
                    : JsonValue.Create(number.ToString(System.Globalization.CultureInfo.InvariantCulture));
            case Enum member:
                return member.ToString();
            case Vector2 point:
                return new JsonArray(Write(scene, point.X), Write(scene, point.Y));
        }

        if (scene.IdOf(value) is { } id)
        {
            return id;
        }

        return value.GetType().Name switch
        {
            "AABB" => Members(scene, value, "Min", "Max"),
            "LineIntersectInfo" => Write(scene, Facade.Get(value, "Points")),
            _ when value is IEnumerable items => Items(scene, items),
            _ => value.ToString(),
        };
    }

    /// <summary>The answer to a call: its value, the values it handed out, or the changed vertices when it gives nothing.</summary>
    public static JsonNode? Write(BuiltScene scene, CallResult result, object? target)
    {
        if (result.HandedOut is [{ } feature] && feature.GetType().Name == "Feature" && result.Returned is bool hit)
        {
            return hit
                ? new JsonObject
                {
                    ["hit"] = true,
                    ["distance"] = Write(scene, Facade.Get(feature, "Distance")),
                    ["normal"] = Write(scene, Facade.Get(feature, "Normal")),
                }
                : new JsonObject { ["hit"] = false };
        }

        if (!result.IsVoid)
        {
            return result.Returned?.GetType().Name == "Feature" ? FeatureOf(scene, result.Returned) : Write(scene, result.Returned);
        }

        return result.HandedOut.Count switch
        {
            0 => Write(scene, target),
            1 => Flattened(Write(scene, result.HandedOut[0])),
            _ => new JsonArray(result.HandedOut.Select(v => Write(scene, v)).ToArray()),
        };
    }

    private static JsonObject FeatureOf(BuiltScene scene, object feature) => new()
    {
        ["distance"] = Write(scene, Facade.Get(feature, "Distance")),
        ["normal"] = Write(scene, Facade.Get(feature, "Normal")),
        ["position"] = Write(scene, Facade.Get(feature, "Position")),
    };

    private static JsonArray Members(BuiltScene scene, object value, params string[] names)
        => new(names.Select(n => Write(scene, Facade.Get(value, n))).ToArray());

    private static JsonArray Items(BuiltScene scene, IEnumerable items)
        => new(items.Cast<object?>().Select(i => Write(scene, i)).ToArray());

    /// <summary>A list with one list of points in it (one geom cut by one line) is written as those points.</summary>
    private static JsonNode? Flattened(JsonNode? node)
        => node is JsonArray { Count: 1 } outer && outer[0] is JsonArray { Count: > 0 } inner && inner[0] is JsonArray
            ? inner.DeepClone()
            : node;
}
