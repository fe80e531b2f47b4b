using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Fine;

/// <summary>A circle or a convex polygon (corners counter-clockwise) in the frame of its body.</summary>
internal sealed class FineShape
{
    private FineShape(FineBody body, JsonElement shape)
    {
        const double DefaultFriction = 0.2;
        Body = body;
        Density = Number(shape, "density", 0);
        Friction = Number(shape, "friction", DefaultFriction);
        Restitution = Number(shape, "restitution", 0);
        if (Json.Text(shape, "type") == "b2CircleDef")
        {
            JsonElement at = Json.Optional(shape, "localPosition");
            Radius = Json.Required(shape, "radius").GetDouble();
            Corners = [at.ValueKind == JsonValueKind.Array ? (at[0].GetDouble(), at[1].GetDouble()) : (0, 0)];
            return;
        }

        JsonElement box = Json.Required(shape, "SetAsBox");
        (double w, double h) = (box[0].GetDouble(), box[1].GetDouble());
        Corners = [(-w, -h), (w, -h), (w, h), (-w, h)];
    }

    public FineBody Body { get; }

    public double Density { get; }

    public double Friction { get; }

    public double Restitution { get; }

    /// <summary>0 for a polygon.</summary>
    public double Radius { get; }

    /// <summary>The centre of a circle.</summary>
    public (double X, double Y)[] Corners { get; }

    public static FineShape Read(FineBody body, JsonElement shape) => new(body, shape);

    /// <summary>Area, centroid, and second moment about the body's origin of a unit density.</summary>
    public (double Area, double X, double Y, double Moment) Integrals()
    {
        if (Radius > 0)
        {
            (double cx, double cy) = Corners[0];
            double disc = Math.PI * Radius * Radius;
            return (disc, cx, cy, disc * ((Radius * Radius / 2) + (cx * cx) + (cy * cy)));
        }

        (double area, double x, double y, double moment) = (0, 0, 0, 0);
        for (int i = 0; i < Corners.Length; i++)
        {
            ((double px, double py), (double qx, double qy)) = (Corners[i], Corners[(i + 1) % Corners.Length]);
            double cross = (px * qy) - (py * qx);
            area += cross / 2;
            x += (px + qx) * cross / 6;
            y += (py + qy) * cross / 6;
            moment += cross * ((px * px) + (py * py) + (px * qx) + (py * qy) + (qx * qx) + (qy * qy)) / 12;
        }

        return (area, x / area, y / area, moment);
    }

    public (double X, double Y) World(int corner) => Body.ToWorld(Corners[corner]);

    /// <summary>Largest distance of a point of the shape from the body's centre of mass.</summary>
    public double Reach() => Corners.Max(c => Math.Sqrt(Square(c.X - Body.LocalX) + Square(c.Y - Body.LocalY))) + Radius;

    private static double Square(double value) => value * value;

    private static double Number(JsonElement shape, string name, double other)
        => Json.Optional(shape, name) is { ValueKind: JsonValueKind.Number } e ? e.GetDouble() : other;
}

/// <summary>A body: its place is that of its centre of mass.</summary>
internal sealed class FineBody
{
    private FineBody(JsonElement body)
    {
        Id = Json.Text(body, "id");
        JsonElement def = Json.Required(body, "def");
        Angle = Json.Optional(def, "angle") is { ValueKind: JsonValueKind.Number } angle ? angle.GetDouble() : 0;
        Shapes = [.. Json.Items(body, "shapes").Select(s => FineShape.Read(this, s))];
        JsonElement at = Json.Required(def, "position");
        (X, Y) = (at[0].GetDouble(), at[1].GetDouble());
        if (Json.Optional(body, "SetMassFromShapes").ValueKind == JsonValueKind.True)
        {
            SetMassFromShapes();
        }

        foreach (JsonElement call in Json.Items(body, "calls"))
        {
            Call(Json.Text(call, "call"), [.. Json.Items(call, "args")]);
        }
    }

    public string Id { get; }

    public List<FineShape> Shapes { get; }

    public double X { get; set; }

    public double Y { get; set; }

    public double Angle { get; set; }

    public double VelocityX { get; set; }

    public double VelocityY { get; set; }

    public double Spin { get; set; }

    public double InverseMass { get; private set; }

    public double InverseInertia { get; private set; }

    public double LocalX { get; private set; }

    public double LocalY { get; private set; }

    public static FineBody Read(JsonElement body) => new(body);

    public (double X, double Y) ToWorld((double X, double Y) local)
    {
        (double sin, double cos) = Math.SinCos(Angle);
        (double x, double y) = (local.X - LocalX, local.Y - LocalY);
        return (X + (cos * x) - (sin * y), Y + (sin * x) + (cos * y));
    }

    public (double X, double Y) ToLocal((double X, double Y) world)
    {
        (double sin, double cos) = Math.SinCos(Angle);
        (double x, double y) = (world.X - X, world.Y - Y);
        return ((cos * x) + (sin * y) + LocalX, (cos * y) - (sin * x) + LocalY);
    }

    public Row ToRow()
    {
        (double x, double y) = ToWorld((0, 0));
        return new Row(x, y, Angle, VelocityX, VelocityY, Spin);
    }

    /// <summary>The calls of b2Body that the scenes make.</summary>
    public void Call(string name, IReadOnlyList<JsonElement> args)
    {
        switch (name)
        {
            case "SetLinearVelocity":
                (VelocityX, VelocityY) = (args[0][0].GetDouble(), args[0][1].GetDouble());
                break;
            case "SetAngularVelocity":
                Spin = args[0].GetDouble();
                break;
            case "SetXForm":
                MoveTo(args[0][0].GetDouble(), args[0][1].GetDouble(), args[1].GetDouble());
                break;
            case "SetMassFromShapes":
                SetMassFromShapes();
                break;
            case "SetBullet":
                break;
            default:
                throw new BadSceneException(name + " has no part in the equations of motion.");
        }
    }

    /// <summary>The change of velocity by an impulse at a point.</summary>
    public void Push(double x, double y, double impulseX, double impulseY)
    {
        VelocityX += InverseMass * impulseX;
        VelocityY += InverseMass * impulseY;
        Spin += InverseInertia * (((x - X) * impulseY) - ((y - Y) * impulseX));
    }

    private void MoveTo(double x, double y, double angle)
    {
        Angle = angle;
        (double sin, double cos) = Math.SinCos(angle);
        X = x + (cos * LocalX) - (sin * LocalY);
        Y = y + (sin * LocalX) + (cos * LocalY);
    }

    private void SetMassFromShapes()
    {
        (double originX, double originY) = ToWorld((0, 0));
        (double mass, double x, double y, double moment) = (0, 0, 0, 0);
        foreach (FineShape shape in Shapes)
        {
            (double area, double cx, double cy, double second) = shape.Integrals();
            mass += shape.Density * area;
            x += shape.Density * area * cx;
            y += shape.Density * area * cy;
            moment += shape.Density * second;
        }

        if (mass > 0)
        {
            (LocalX, LocalY) = (x / mass, y / mass);
            InverseMass = 1 / mass;
            InverseInertia = 1 / (moment - (mass * ((LocalX * LocalX) + (LocalY * LocalY))));
            MoveTo(originX, originY, Angle);
        }
    }
}
