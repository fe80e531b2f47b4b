using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Fine;

/// <summary>
/// A scene of Farseer Physics 2.0: bodies start as their first recorded row says and have the mass and inertia that the file gives them.
/// </summary>
internal sealed class FarseerFineScene : FineScene
{
    private const double DefaultDrag = 0.001;

    /// <summary>What of a body and of a geom matters here, or does not change how it moves.</summary>
    private static readonly string[] _ofBodies =
    [
        "position", "rotation", "linearVelocity", "angularVelocity", "isStatic", "ignoreGravity", "linearDragCoefficient",
        "quadraticDragCoefficient", "isQuadraticDragEnabled", "rotationalDragCoefficient",
    ];

    private static readonly string[] _ofGeoms =
    [
        "frictionCoefficient", "restitutionCoefficient", "collisionGroup", "collisionEnabled", "collisionResponseEnabled", "onCollision",
        "onSeparation",
    ];

    private static readonly string[] _held = ["ApplyForce", "ApplyTorque", "ApplyForceAtLocalPoint", "ApplyForceAtWorldPoint"];

    private readonly SceneFile _file;
    private readonly bool _leastFriction;
    private readonly Dictionary<FineShape, MadeObject> _geoms = [];
    private readonly Dictionary<FineBody, FineForce> _forces = [];

    public FarseerFineScene(SceneFile file)
    {
        _file = file;
        Refuse(file.Joints.Any(j => j.Factory != "CreateFixedRevoluteJoint" || j.Properties.Count > 0), "a joint");
        Refuse(Json.Items(file.Root, "paths").Any() || Json.Items(file.Root, "controllers").Any(), "a path or a controller");
        Refuse(Json.Members(file.Root, "settings")
            .Any(s => s.Name is "inactivityController" or "maxContactsToResolve" or "maxContactsToDetect"), "a setting");
        Refuse(file.Actions.Any(a => a.Call is null || !_held.Contains(a.Call)), "an action");
        _leastFriction = Json.OptionalText(Json.Optional(file.Root, "settings"), "frictionType") == "Minimum";
        Gravity = (file.Gravity[0].GetDouble(), file.Gravity[1].GetDouble());
        Bodies.AddRange(file.Bodies.Select(ReadBody));
        foreach (MadeObject geom in file.Geoms)
        {
            AddShape(geom);
        }

        foreach (MadeObject joint in file.Joints)
        {
            (double x, double y) = Point(Json.Required(joint.Args, "anchor"));
            Hinges.Add(new FineHinge(Body(Json.Text(joint.Args, "body")), x, y));
        }

        foreach (MadeObject spring in file.Springs)
        {
            Pulls.Add(FineSpring.Read(spring, Body));
        }

        foreach (FineBody body in Bodies.Where(b => file.Actions.Any(a => a.Target == b.Id)))
        {
            _forces.Add(body, new FineForce(body));
            Pulls.Add(_forces[body]);
        }
    }

    /// <summary>Everything bounces.</summary>
    public override double BounceThreshold => 0;

    public override FineContact? Meet(FineShape a, FineShape b)
    {
        (MadeObject first, MadeObject second) = (_geoms[a], _geoms[b]);
        double group = Number(first, "collisionGroup", 0);
        if ((group != 0 && group == Number(second, "collisionGroup", 0)) || Passes(first) || Passes(second))
        {
            return null;
        }

        double friction = _leastFriction ? Math.Min(a.Friction, b.Friction) : (a.Friction + b.Friction) / 2;
        return new FineContact(a, b, friction, (a.Restitution + b.Restitution) / 2);
    }

    public override void Act(int step)
    {
        foreach (FineForce force in _forces.Values)
        {
            force.Clear();
        }

        foreach (SceneAction action in _file.Actions.Where(a => a.Step <= step && step <= a.Until))
        {
            FineBody body = Body(action.Target!);
            if (action.Call == "ApplyTorque")
            {
                _forces[body].Add(0, 0, action.Args[0].GetDouble());
                continue;
            }

            (double x, double y) = Point(action.Args[0]);
            (double ax, double ay) = action.Call switch
            {
                "ApplyForce" => (body.X, body.Y),
                "ApplyForceAtLocalPoint" => body.ToWorld(Point(action.Args[1])),
                _ => Point(action.Args[1]),
            };
            _forces[body].Add(x, y, ((ax - body.X) * y) - ((ay - body.Y) * x));
        }
    }

    private static void Refuse(bool unknown, string what)
    {
        if (unknown)
        {
            throw new NotExpressedException(what);
        }
    }

    private static (double X, double Y) Point(JsonElement value) => (value[0].GetDouble(), value[1].GetDouble());

    private static JsonElement Value(MadeObject made, string name) => made.Properties.FirstOrDefault(p => p.Key == name).Value;

    private static double HalfSide(MadeObject box, string name) => Json.Required(box.Args, name).GetDouble() / 2;

    private static double Number(MadeObject made, string name, double other)
        => Value(made, name) is { ValueKind: JsonValueKind.Number } e ? e.GetDouble() : other;

    /// <summary>Has no contacts, or none that push.</summary>
    private static bool Passes(MadeObject geom) => new[] { "collisionEnabled", "collisionResponseEnabled", "onCollision" }
        .Any(n => Value(geom, n).ValueKind == JsonValueKind.False);

    private FineBody ReadBody(MadeObject made)
    {
        Refuse(made.Properties.Any(p => !_ofBodies.Contains(p.Key)), "a property of a body");
        bool isStatic = Value(made, "isStatic").ValueKind == JsonValueKind.True;
        FineBody body = new(made.Id)
        {
            HasNoWeight = Value(made, "ignoreGravity").ValueKind == JsonValueKind.True,
            Drag = isStatic ? default : (
                Number(made, "linearDragCoefficient", DefaultDrag),
                Value(made, "isQuadraticDragEnabled").ValueKind == JsonValueKind.True
                    ? Number(made, "quadraticDragCoefficient", DefaultDrag)
                    : 0,
                Number(made, "rotationalDragCoefficient", DefaultDrag),
                0,
                0),
        };
        if (isStatic)
        {
            JsonElement position = Value(made, "position");
            Refuse(position.ValueKind != JsonValueKind.Array, "a static body where its factory puts it");
            (body.X, body.Y) = Point(position);
            body.Angle = Number(made, "rotation", 0);
            return body;
        }

        Refuse(!_file.Recordings.Values.First().Rows.TryGetValue(made.Id, out Row[]? rows), "a body that was not recorded");
        JsonElement masses = Json.Optional(Json.Optional(_file.Root, "massProperties"), made.Id);
        Refuse(masses.ValueKind != JsonValueKind.Object, "a body of unknown mass");
        body.InverseMass = 1 / Json.Required(masses, "mass").GetDouble();
        body.InverseInertia = 1 / Json.Required(masses, "momentOfInertia").GetDouble();
        (body.X, body.Y, body.Angle, body.VelocityX, body.VelocityY, body.Spin) = rows![0];
        return body;
    }

    private void AddShape(MadeObject geom)
    {
        Refuse(geom.Properties.Any(p => !_ofGeoms.Contains(p.Key)), "a property of a geom");
        FineBody body = Body(geom.Body!);
        (double, double, double) of = (0, Number(geom, "frictionCoefficient", 0), Number(geom, "restitutionCoefficient", 0));
        (double X, double Y) offset = Json.Optional(geom.Args, "offset") is { ValueKind: JsonValueKind.Array } at ? Point(at) : (0, 0);
        double turned = Json.Number(geom.Args, "rotationOffset", 0);
        Refuse(turned != 0 && offset != (0, 0), "an offset that is turned");
        FineShape shape = geom.Factory switch
        {
            "CreateCircleGeom" => FineShape.Circle(body, offset, SceneSizes.Radius(geom), of),
            "CreateRectangleGeom" =>
                FineShape.Polygon(body, FineShape.Box(HalfSide(geom, "width"), HalfSide(geom, "height"), offset, turned), of),
            "CreatePolygonGeom" when turned == 0 => FineShape.Polygon(body, Centred(geom, offset), of),
            _ => throw new NotExpressedException(geom.Factory),
        };
        body.Shapes.Add(shape);
        _geoms.Add(shape, geom);
    }

    /// <summary>A polygon lies with its centroid at the body's centre, or at its offset.</summary>
    private (double X, double Y)[] Centred(MadeObject geom, (double X, double Y) offset)
    {
        JsonElement points = Json.Required(geom.Args, "vertices");
        points = points.ValueKind == JsonValueKind.String
            ? Json.Required(Json.Required(_file.Root, "vertices"), points.GetString()!)
            : points;
        FineShape outline = FineShape.Polygon(new FineBody(string.Empty), [.. points.EnumerateArray().Select(Point)], default);
        (_, double x, double y, _) = outline.Integrals();
        return [.. outline.Corners.Select(c => (c.X - x + offset.X, c.Y - y + offset.Y))];
    }

    private FineBody Body(string id) => Bodies.Find(b => b.Id == id) ?? throw new NotExpressedException(id);
}
