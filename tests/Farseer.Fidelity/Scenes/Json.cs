using System.Collections.Generic;
using System.Text.Json;

namespace Farseer.Fidelity.Scenes;

/// <summary>Access to members of a JSON object with one clear line when one is missing.</summary>
internal static class Json
{
    public static JsonElement Required(JsonElement parent, string name)
        => Optional(parent, name) is { ValueKind: not JsonValueKind.Undefined } value
            ? value
            : throw new BadSceneException($"'{name}' is missing.");

    public static JsonElement Optional(JsonElement parent, string name)
        => parent.ValueKind == JsonValueKind.Object && parent.TryGetProperty(name, out JsonElement value) ? value : default;

    public static string Text(JsonElement parent, string name)
        => OptionalText(parent, name) ?? throw new BadSceneException($"'{name}' is missing.");

    public static string? OptionalText(JsonElement parent, string name)
    {
        JsonElement value = Optional(parent, name);
        return value.ValueKind switch
        {
            JsonValueKind.Undefined => null,
            JsonValueKind.String => value.GetString(),
            _ => throw new BadSceneException($"'{name}' must be text, not {value.ValueKind}."),
        };
    }

    public static double Number(JsonElement parent, string name, double other)
        => Optional(parent, name) is { ValueKind: JsonValueKind.Number } value ? value.GetDouble() : other;

    public static IEnumerable<JsonElement> Items(JsonElement parent, string name)
    {
        JsonElement value = Optional(parent, name);
        return value.ValueKind switch
        {
            JsonValueKind.Undefined => [],
            JsonValueKind.Array => value.EnumerateArray(),
            _ => throw new BadSceneException($"'{name}' must be a list, not {value.ValueKind}."),
        };
    }

    public static IEnumerable<JsonProperty> Members(JsonElement parent, string name)
    {
        JsonElement value = Optional(parent, name);
        return value.ValueKind switch
        {
            JsonValueKind.Undefined => [],
            JsonValueKind.Object => value.EnumerateObject(),
            _ => throw new BadSceneException($"'{name}' must be an object, not {value.ValueKind}."),
        };
    }
}
