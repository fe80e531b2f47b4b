using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Text.Json;
using System.Text.Json.Nodes;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Farseer.Fidelity.Building;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>Turns the notation of the scene files into arguments, and answers into that notation.</summary>
internal static class FlashValues
{
    public static b2Vec2 Vector(JsonElement value) => new(value[0].GetSingle(), value[1].GetSingle());

    /// <summary>An argument for a parameter of the type.</summary>
    public static object? Read(FlashScene scene, JsonElement value, Type type)
    {
        switch (value.ValueKind)
        {
            case JsonValueKind.Null:
                return null;
            case JsonValueKind.True or JsonValueKind.False:
                return value.GetBoolean();
            case JsonValueKind.Number:
                return type == typeof(int) ? value.GetInt32() : type == typeof(uint) ? value.GetUInt32() : (object)value.GetSingle();
            case JsonValueKind.String:
                return type == typeof(object) ? value.GetString() : scene[value.GetString()!];
            case JsonValueKind.Array when type == typeof(b2Vec2[]):
                return value.EnumerateArray().Select(Vector).ToArray();
            case JsonValueKind.Array:
                return Vector(value);
        }

        JsonProperty part = value.EnumerateObject().First();
        return part.Name switch
        {
            "worldCenter" => scene.Body(part.Value.GetString()!).GetWorldCenter().Copy(),
            "worldPoint" => scene.Body(part.Value[0].GetString()!).GetWorldPoint(Vector(part.Value[1])),
            "massData" => Fill(scene, new b2MassData(), part.Value),
            "filter" => Fill(scene, new b2FilterData(), part.Value),
            "aabb" => Box(part.Value),
            _ when type == typeof(b2MassData) => Fill(scene, new b2MassData(), value),
            _ when type == typeof(b2FilterData) => Fill(scene, new b2FilterData(), value),
            _ => throw new BadSceneException($"'{part.Name}' is no argument."),
        };
    }

    /// <summary>Sets the members that the text names.</summary>
    public static T Fill<T>(FlashScene scene, T target, JsonElement values, params string[] except)
        where T : class
    {
        foreach (JsonProperty value in values.EnumerateObject().Where(v => !except.Contains(v.Name)))
        {
            PropertyInfo property = target.GetType().GetProperty(value.Name)
                ?? throw new MissingPartException(target.GetType().Name + "." + value.Name);
            property.SetValue(target, Read(scene, value.Value, property.PropertyType));
        }

        return target;
    }

    /// <summary>Calls a method by name; the members of the base class that it hides are no candidates.</summary>
    public static object? Call(FlashScene scene, object target, string name, IReadOnlyList<JsonElement> args)
    {
        MethodInfo method = target.GetType().GetMethods()
            .Where(m => m.Name == name && m.DeclaringType != typeof(object) && m.GetParameters().Length == args.Count)
            .FirstOrDefault() ?? throw new MissingPartException(target.GetType().Name + "." + name);
        object?[] values = method.GetParameters().Select((p, i) => Read(scene, args[i], p.ParameterType)).ToArray();
        try
        {
            return method.Invoke(target, values);
        }
        catch (TargetInvocationException e) when (e.InnerException is not null)
        {
            throw e.InnerException;
        }
    }

    public static JsonNode? Write(FlashScene scene, object? value) => value switch
    {
        null => null,
        float number when !float.IsFinite(number) => JsonValue.Create(number.ToString(CultureInfo.InvariantCulture)),
        bool or string or int or uint or float => JsonSerializer.SerializeToNode(value),
        b2Vec2 v => new JsonArray(Write(scene, v.x), Write(scene, v.y)),
        b2Vec2[] list => new JsonArray(list.Select(v => Write(scene, v)).ToArray()),
        b2AABB box => new JsonArray(Write(scene, box.lowerBound), Write(scene, box.upperBound)),
        b2XForm xf => new JsonObject
        {
            ["position"] = Write(scene, xf.position),
            ["R"] = new JsonObject { ["col1"] = Write(scene, xf.R.col1), ["col2"] = Write(scene, xf.R.col2) },
        },
        b2MassData mass => new JsonObject { ["mass"] = mass.mass, ["center"] = Write(scene, mass.center), ["I"] = mass.I },
        b2FilterData filter => new JsonObject
        {
            ["categoryBits"] = filter.categoryBits,
            ["maskBits"] = filter.maskBits,
            ["groupIndex"] = filter.groupIndex,
        },
        b2JointEdge edge => new JsonArray(scene.IdOf(edge.joint), scene.IdOf(edge.other)),
        _ => scene.IdOf(value) ?? throw new BadSceneException($"{value.GetType().Name} has no notation."),
    };

    private static b2AABB Box(JsonElement corners)
    {
        b2AABB box = new();
        box.lowerBound.SetV(Vector(corners[0]));
        box.upperBound.SetV(Vector(corners[1]));
        return box;
    }
}
