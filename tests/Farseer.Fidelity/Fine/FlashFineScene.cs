using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Fine;

/// <summary>A scene of Box2DFlash.</summary>
internal sealed class FlashFineScene : FineScene
{
    private static readonly string[] _known =
        ["position", "angle", "isBullet", "allowSleep", "userData", "linearDamping", "angularDamping"];

    private static readonly string[] _knownOfShapes =
    [
        "id", "type", "density", "friction", "restitution", "radius", "localPosition", "SetAsBox", "SetAsOrientedBox", "vertices",
        "userData",
    ];

    private readonly List<JsonElement> _actions;

    public FlashFineScene(SceneFile file)
    {
        JsonElement world = Json.Required(file.Root, "world");
        Refuse(Json.Optional(world, "continuousPhysics").ValueKind == JsonValueKind.False, "what passes through on purpose");
        Refuse(Json.Items(file.Root, "inAddCallback").Any()
            || Json.Optional(file.Root, "contactFilter").ValueKind != JsonValueKind.Undefined, "what listeners do");
        Gravity = (file.Gravity[0].GetDouble(), file.Gravity[1].GetDouble());
        _actions = [.. Json.Items(file.Root, "actions")];
        Refuse(_actions.Any(a => Json.Optional(a, "dt").ValueKind != JsonValueKind.Undefined), "another time step");
        Bodies.AddRange(Json.Items(file.Root, "bodies").Select(ReadBody));
        foreach (JsonElement joint in Json.Items(file.Root, "joints"))
        {
            MakeJoint(joint);
        }
    }

    /// <summary>The original's.</summary>
    public override double BounceThreshold => 1;

    public override FineContact Meet(FineShape a, FineShape b)
        => new(a, b, Math.Sqrt(a.Friction * b.Friction), Math.Max(a.Restitution, b.Restitution));

    public override void Act(int step)
    {
        foreach (JsonElement action in _actions.Where(a => a.GetProperty("step").GetInt32() == step))
        {
            Refuse(Json.Optional(action, "until").ValueKind != JsonValueKind.Undefined, "an action of many steps");
            if (Json.OptionalText(action, "create") is { } kind)
            {
                Create(kind, action);
                continue;
            }

            string call = Json.Text(action, "call");
            List<JsonElement> args = [.. Json.Items(action, "args")];
            string target = Json.Text(action, "target");
            if (call == "SetTarget")
            {
                Pulls.OfType<FineDrag>().Single(d => d.Id == target).SetTarget(args[0]);
            }
            else if (call == "DestroyBody")
            {
                Bodies.RemoveAll(b => b.Id == args[0].GetString());
            }
            else
            {
                Call(Body(target), call, args);
            }
        }
    }

    /// <summary>A shape of a body that stands where its definition says.</summary>
    public static FineShape ReadShape(FineBody body, JsonElement shape)
    {
        const double DefaultFriction = 0.2;
        string? unknown = shape.EnumerateObject().Select(p => p.Name).FirstOrDefault(n => !_knownOfShapes.Contains(n));
        Refuse(unknown is not null, unknown!);
        (double Density, double Friction, double Restitution) of =
            (Json.Number(shape, "density", 0), Json.Number(shape, "friction", DefaultFriction), Json.Number(shape, "restitution", 0));
        if (Json.Text(shape, "type") == "b2CircleDef")
        {
            JsonElement at = Json.Optional(shape, "localPosition");
            (double, double) centre = at.ValueKind == JsonValueKind.Array ? Point(at) : (0, 0);
            return FineShape.Circle(body, centre, Json.Required(shape, "radius").GetDouble(), of);
        }

        if (Json.Optional(shape, "SetAsBox") is { ValueKind: JsonValueKind.Array } box)
        {
            return FineShape.Polygon(body, FineShape.Box(box[0].GetDouble(), box[1].GetDouble()), of);
        }

        (double X, double Y)[] corners = Json.Optional(shape, "SetAsOrientedBox") is { ValueKind: JsonValueKind.Array } turned
            ? FineShape.Box(turned[0].GetDouble(), turned[1].GetDouble(), Point(turned[2]), turned[3].GetDouble())
            : [.. Json.Items(shape, "vertices").Select(Point)];
        return FineShape.Polygon(body, corners, of);
    }

    private static void Refuse(bool unknown, string what)
    {
        if (unknown)
        {
            throw new NotExpressedException(what);
        }
    }

    private static (double X, double Y) Point(JsonElement value) => (value[0].GetDouble(), value[1].GetDouble());

    private static FineBody ReadBody(JsonElement body)
    {
        JsonElement def = Json.Required(body, "def");
        string? unknown = def.EnumerateObject().Select(p => p.Name).FirstOrDefault(n => !_known.Contains(n));
        Refuse(unknown is not null, unknown!);
        (double x, double y) = Point(Json.Required(def, "position"));
        FineBody made = new(Json.Text(body, "id"))
        {
            X = x,
            Y = y,
            Angle = Json.Number(def, "angle", 0),
            Drag = (0, 0, 0, Json.Number(def, "linearDamping", 0), Json.Number(def, "angularDamping", 0)),
        };
        made.Shapes.AddRange(Json.Items(body, "shapes").Select(s => ReadShape(made, s)));
        if (Json.Optional(body, "SetMassFromShapes").ValueKind == JsonValueKind.True)
        {
            made.SetMassFromShapes();
        }

        foreach (JsonElement call in Json.Items(body, "calls"))
        {
            Call(made, Json.Text(call, "call"), [.. Json.Items(call, "args")]);
        }

        return made;
    }

    /// <summary>The calls of b2Body that have a part in the equations.</summary>
    private static void Call(FineBody body, string name, IReadOnlyList<JsonElement> args)
    {
        switch (name)
        {
            case "SetLinearVelocity":
                (body.VelocityX, body.VelocityY) = Point(args[0]);
                break;
            case "SetAngularVelocity":
                body.Spin = args[0].GetDouble();
                break;
            case "SetXForm":
                body.MoveTo(args[0][0].GetDouble(), args[0][1].GetDouble(), args[1].GetDouble());
                break;
            case "SetMassFromShapes":
                body.SetMassFromShapes();
                break;
            case "SetBullet":
                break;
            default:
                throw new NotExpressedException(name);
        }
    }

    private void Create(string kind, JsonElement action)
    {
        JsonElement value = action.GetProperty("value");
        switch (kind)
        {
            case "body":
                Bodies.Add(ReadBody(value));
                break;
            case "shape":
                FineBody body = Body(Json.Text(action, "target"));
                body.Shapes.Add(ReadShape(body, value));
                break;
            default:
                MakeJoint(value);
                break;
        }
    }

    private void MakeJoint(JsonElement joint)
    {
        switch (Json.Text(joint, "type"))
        {
            case "b2RevoluteJointDef" when joint.EnumerateObject().All(p => p.Name is "id" or "type" or "Initialize"):
                JsonElement[] made = [.. Json.Items(joint, "Initialize")];
                Refuse(made[0].GetString() != "groundBody" || made[2].ValueKind != JsonValueKind.Array, "a hinge of two bodies");
                Hinges.Add(new FineHinge(Body(made[1].GetString()!), made[2][0].GetDouble(), made[2][1].GetDouble()));
                break;
            case "b2MouseJointDef":
                Pulls.Add(new FineDrag(Body(Json.Text(joint, "body2")), joint));
                break;
            case string other:
                throw new NotExpressedException(other);
        }
    }

    private FineBody Body(string id) => Bodies.Find(b => b.Id == id) ?? throw new NotExpressedException(id);
}
