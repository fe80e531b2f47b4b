using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Text.Json;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Farseer.Fidelity.Building;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>A scene made with the library: the world and everything in it, by id.</summary>
internal sealed class FlashScene
{
    private readonly Dictionary<string, object> _objects = [];
    private readonly ConditionalWeakTable<object, string> _ids = [];

    public FlashScene(SceneFile file, Box2DFlash202Quirks quirks)
    {
        File = file;
        JsonElement world = file.Root.GetProperty("world");
        b2AABB box = new();
        box.lowerBound.SetV(FlashValues.Vector(world.GetProperty("worldAABB")[0]));
        box.upperBound.SetV(FlashValues.Vector(world.GetProperty("worldAABB")[1]));
        World = new b2World(
            box, FlashValues.Vector(world.GetProperty("gravity")), world.GetProperty("doSleep").GetBoolean()) { Quirks = quirks };
        Switch("warmStarting", World.SetWarmStarting);
        Switch("positionCorrection", World.SetPositionCorrection);
        Switch("continuousPhysics", World.SetContinuousPhysics);
        Name("world", World);
        Name("groundBody", World.GetGroundBody());
        Log = new FlashLog(this);

        void Switch(string name, Action<bool> set)
        {
            if (Json.Optional(world, name) is { ValueKind: JsonValueKind.True or JsonValueKind.False } value)
            {
                set(value.GetBoolean());
            }
        }
    }

    public SceneFile File { get; }

    public b2World World { get; }

    public FlashLog Log { get; }

    public object this[string id] => Find(id) ?? throw new BadSceneException($"there is no '{id}' in the scene.");

    public IEnumerable<KeyValuePair<string, b2Body>> Bodies =>
        _objects.Where(o => o.Value is b2Body && o.Key != "groundBody").Select(o => KeyValuePair.Create(o.Key, (b2Body)o.Value));

    public object? Find(string id) => _objects.GetValueOrDefault(id);

    public b2Body Body(string id) => (b2Body)this[id];

    public string? IdOf(object? value) => value is not null && _ids.TryGetValue(value, out string? id) ? id : null;

    /// <summary>Makes all that the file names.</summary>
    public void Build()
    {
        foreach (JsonElement body in Json.Items(File.Root, "bodies"))
        {
            MakeBody(body);
        }

        foreach (JsonElement joint in Json.Items(File.Root, "joints"))
        {
            MakeJoint(joint);
        }
    }

    /// <summary>Something made in mid-run or by a callback.</summary>
    /// <returns>Its id, or null where the library made nothing.</returns>
    public string? Create(string kind, string? target, JsonElement value) => kind switch
    {
        "body" => IdOf(MakeBody(value)),
        "shape" => IdOf(MakeShape(Body(target!), target!, value, 0)),
        "joint" => IdOf(MakeJoint(value)),
        _ => throw new BadSceneException($"'{kind}' cannot be created."),
    };

    private b2Body? MakeBody(JsonElement value)
    {
        string id = Json.Text(value, "id");
        b2Body? body = World.CreateBody(FlashValues.Fill(this, new b2BodyDef(), value.GetProperty("def")));
        if (body is null)
        {
            return null;
        }

        Name(id, body);
        int index = 0;
        foreach (JsonElement shape in Json.Items(value, "shapes"))
        {
            MakeShape(body, id, shape, index++);
        }

        if (Json.Optional(value, "SetMassFromShapes").ValueKind == JsonValueKind.True)
        {
            body.SetMassFromShapes();
        }

        foreach (JsonElement call in Json.Items(value, "calls"))
        {
            FlashValues.Call(this, body, Json.Text(call, "call"), Json.Items(call, "args").ToList());
        }

        return body;
    }

    private b2Shape? MakeShape(b2Body body, string bodyId, JsonElement value, int index)
    {
        b2ShapeDef def = Json.Text(value, "type") == "b2CircleDef" ? new b2CircleDef() : new b2PolygonDef();
        if (def is b2PolygonDef polygon)
        {
            if (Json.Optional(value, "SetAsBox") is { ValueKind: JsonValueKind.Array } box)
            {
                polygon.SetAsBox(box[0].GetSingle(), box[1].GetSingle());
            }
            else if (Json.Optional(value, "SetAsOrientedBox") is { ValueKind: JsonValueKind.Array } turned)
            {
                polygon.SetAsOrientedBox(
                    turned[0].GetSingle(), turned[1].GetSingle(), FlashValues.Vector(turned[2]), turned[3].GetSingle());
            }
            else
            {
                polygon.vertexCount = value.GetProperty("vertices").GetArrayLength();
            }
        }

        FlashValues.Fill(this, def, value, "id", "type", "SetAsBox", "SetAsOrientedBox");
        b2Shape? shape = body.CreateShape(def);
        if (shape is not null)
        {
            Name(FlashReader.ShapeId(bodyId, value, index), shape);
        }

        return shape;
    }

    private b2Joint? MakeJoint(JsonElement value)
    {
        b2JointDef def = Json.Text(value, "type") switch
        {
            "b2DistanceJointDef" => new b2DistanceJointDef(),
            "b2RevoluteJointDef" => new b2RevoluteJointDef(),
            "b2PrismaticJointDef" => new b2PrismaticJointDef(),
            "b2PulleyJointDef" => new b2PulleyJointDef(),
            "b2GearJointDef" => new b2GearJointDef(),
            "b2MouseJointDef" => new b2MouseJointDef(),
            string other => throw new MissingPartException(other),
        };
        if (Json.Optional(value, "Initialize").ValueKind == JsonValueKind.Array)
        {
            FlashValues.Call(this, def, "Initialize", Json.Items(value, "Initialize").ToList());
        }

        FlashValues.Fill(this, def, value, "id", "type", "Initialize");
        b2Joint? joint = World.CreateJoint(def);
        if (joint is not null)
        {
            Name(Json.Text(value, "id"), joint);
        }

        return joint;
    }

    private void Name(string id, object value)
    {
        _objects.Add(id, value);
        _ids.Add(value, id);
    }
}
