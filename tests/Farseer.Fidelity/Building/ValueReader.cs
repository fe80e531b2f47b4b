using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Building;

/// <summary>Turns the values of a scene file into the library's types.</summary>
public sealed class ValueReader
{
    private readonly JsonElement _vertices;
    private readonly Func<string, object?> _objects;

    /// <param name="vertices">The scene's named polygons.</param>
    /// <param name="objects">Finds an object of the scene by its id.</param>
    public ValueReader(JsonElement vertices, Func<string, object?> objects)
    {
        _vertices = vertices;
        _objects = objects;
    }

    public object? Read(JsonElement value, Type type)
        => TryRead(value, type, out object? result) ? result : throw new BadSceneException($"'{value}' is not a {type.Name}.");

    public bool TryRead(JsonElement value, Type type, out object? result)
    {
        if (type.IsByRef)
        {
            type = type.GetElementType()!;
        }

        result = value.ValueKind switch
        {
            JsonValueKind.True or JsonValueKind.False when type == typeof(bool) => value.GetBoolean(),
            JsonValueKind.Number => ReadNumber(value, type),
            JsonValueKind.String => ReadText(value.GetString()!, type),
            JsonValueKind.Array => ReadList(value, type),
            _ => null,
        };
        return result is not null || (value.ValueKind == JsonValueKind.Null && !type.IsValueType);
    }

    /// <summary>A new list of vertices from a name of the scene or from points.</summary>
    public object Vertices(JsonElement value)
    {
        JsonElement points = value.ValueKind == JsonValueKind.String ? Json.Optional(_vertices, value.GetString()!) : value;
        if (points.ValueKind != JsonValueKind.Array)
        {
            throw new BadSceneException($"there are no vertices '{value}'.");
        }

        object list = Activator.CreateInstance(Facade.Type("Vertices"))!;
        foreach (JsonElement point in points.EnumerateArray())
        {
            ((IList)list).Add(Point(point));
        }

        return list;
    }

    private static Vector2 Point(JsonElement value) => new(value[0].GetSingle(), value[1].GetSingle());

    private static object? ReadNumber(JsonElement value, Type type)
    {
        if (type == typeof(float))
        {
            return value.GetSingle();
        }

        if (type == typeof(double))
        {
            return value.GetDouble();
        }

        bool whole = value.TryGetInt32(out int number);
        return whole && type.IsPrimitive && type != typeof(bool) ? Convert.ChangeType(number, type, CultureInfo.InvariantCulture) : null;
    }

    private object? ReadText(string text, Type type)
    {
        if (type == typeof(string))
        {
            return text;
        }

        if (type.IsEnum)
        {
            return Enum.TryParse(type, text, out object? value) ? value : throw new MissingPartException(type.Name + "." + text);
        }

        if (type.Name == "Vertices")
        {
            return Json.Optional(_vertices, text).ValueKind == JsonValueKind.Array
                ? Vertices(JsonSerializer.SerializeToElement(text))
                : null;
        }

        object? found = _objects(text);
        return type.IsInstanceOfType(found) ? found : null;
    }

    private object? ReadList(JsonElement value, Type type)
    {
        int length = value.GetArrayLength();
        bool isPoint = length == 2 && value[0].ValueKind == JsonValueKind.Number && value[1].ValueKind == JsonValueKind.Number;
        if (type == typeof(Vector2))
        {
            return isPoint ? Point(value) : null;
        }

        if (type == typeof(uint[]))
        {
            return length > 0 && value[0].ValueKind == JsonValueKind.String ? Bitmap(value) : null;
        }

        bool arePoints = !isPoint && value.EnumerateArray().All(e => e.ValueKind == JsonValueKind.Array);
        if (type.Name == "Vertices")
        {
            return arePoints ? Vertices(value) : null;
        }

        return type.Name == "AABB" && arePoints && length == 2
            ? Activator.CreateInstance(type, Point(value[0]), Point(value[1]))
            : null;
    }

    private static uint[] Bitmap(JsonElement rows)
    {
        List<uint> pixels = [];
        foreach (JsonElement row in rows.EnumerateArray())
        {
            pixels.AddRange(row.GetString()!.Select(Pixel));
        }

        return pixels.ToArray();
    }

    private static uint Pixel(char c) => c switch
    {
        '#' => 0xFFFFFFFFu,
        '+' => 0x60FFFFFFu,
        _ => 0u,
    };
}
