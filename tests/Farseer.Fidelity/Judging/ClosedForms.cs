using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>A closed form that stands in for the original's numbers where a decision here is truer than the original.</summary>
/// <param name="Reason">Which decision, in one line.</param>
/// <param name="Row">The state of a body at a time, or null where the original's rows stay the reference.</param>
/// <param name="Query">The answer to a query, or null where the original's stays the reference.</param>
public sealed record ClosedForm(
    string Reason,
    Func<SceneFile, string, double, Row>? Row = null,
    Func<SceneFile, SceneQuery, object?>? Query = null);

/// <summary>The scenes judged by a closed form: at most eight.</summary>
public static class ClosedForms
{
    private const double LinearDrag = 0.001;

    public static IReadOnlyDictionary<string, ClosedForm> ByScene { get; } = new Dictionary<string, ClosedForm>(StringComparer.Ordinal)
    {
        ["collide_point"] = new("circles are true circles, so they touch what their polygon of edges just misses", Query: (file, query) => CircleTouchesBox(file, query)),
        ["geom_compound"] = new("circles are true circles, so a dumbbell rolls on its end without the bumps of a polygon", FallingBody.At),
        ["geom_offset"] = new("the original's spin lags behind that of a pendulum on the box's corner, by more than its limit", FallingBody.At),
        ["head_on_equal"] = new("circles are true circles, so an elastic impact without friction follows the line of centres", HeadOn),
        ["head_on_unequal"] = new("circles are true circles, so an elastic impact without friction follows the line of centres", HeadOn),
        ["incline_circle_rolls"] = new("a circle is a true circle, so it rolls without the losses of a polygon", Rolling),
        ["spring_break"] = new("a spring alone swings with its own frequency, where the original runs ahead by its step's error", HungAndBreaking),
        ["vertices"] = new("the inertia of a concave polygon is the integral over its area", Query: OutlineInertia),
    };

    /// <summary>
    /// Two circles meet when |p + v t| = 2 r (p, v relative). With n the line of centres then, each body's
    /// velocity changes by j n / m with j = (1 + e) (v . n) / (1/mA + 1/mB), e = 1; nothing turns them.
    /// </summary>
    private static Row HeadOn(SceneFile file, string body, double time)
    {
        Circle a = new(file.Bodies[0]);
        Circle b = new(file.Bodies[1]);
        (double px, double py) = (b.X - a.X, b.Y - a.Y);
        (double vx, double vy) = (b.VelocityX - a.VelocityX, b.VelocityY - a.VelocityY);
        double speedSquared = (vx * vx) + (vy * vy);
        double closing = (px * vx) + (py * vy);
        double reach = a.Radius + b.Radius;
        double gapSquared = (px * px) + (py * py) - (reach * reach);
        double meeting = (-closing - Math.Sqrt((closing * closing) - (speedSquared * gapSquared))) / speedSquared;
        (double nx, double ny) = ((px + (vx * meeting)) / reach, (py + (vy * meeting)) / reach);
        double impulse = 2 * ((vx * nx) + (vy * ny)) / ((1 / a.Mass) + (1 / b.Mass));
        Circle own = body == file.Bodies[0].Id ? a : b;
        double change = time < meeting ? 0 : (body == file.Bodies[0].Id ? impulse : -impulse) / own.Mass;
        (double jumpX, double jumpY) = (change * nx, change * ny);
        double after = time - meeting;
        return new Row(
            own.X + (own.VelocityX * time) + (jumpX * after),
            own.Y + (own.VelocityY * time) + (jumpY * after),
            0,
            own.VelocityX + jumpX,
            own.VelocityY + jumpY,
            0);
    }

    /// <summary>
    /// A cylinder rolling from rest down a slope s: (m + I / r^2) v' = m g sin s - c v with I = m r^2 / 2
    /// and the default drag c, hence v = (m g sin s / c)(1 - e^(-c t / (1.5 m))); the angle is the way / r.
    /// It rests at AllowedPenetration in the slope.
    /// </summary>
    private static Row Rolling(SceneFile file, string body, double time)
    {
        Circle wheel = new(file.Bodies[0]);
        double slope = Property(file.Bodies[1], "rotation").GetDouble();
        double thickness = Json.Required(file.Bodies[1].Args, "height").GetDouble();
        double final = wheel.Mass * Impacts.Gravity(file) * Math.Sin(slope) / LinearDrag;
        double rate = LinearDrag / (1.5 * wheel.Mass);
        double speed = final * (1 - Math.Exp(-rate * time));
        double way = final * (time - ((1 - Math.Exp(-rate * time)) / rate));
        (double alongX, double alongY) = (Math.Cos(slope), Math.Sin(slope));
        (double upX, double upY) = (alongY, -alongX);
        double height = (wheel.X * upX) + (wheel.Y * upY);
        double settled = time > 0 ? (thickness / 2) + wheel.Radius - SceneSizes.AllowedPenetration(file) : height;
        return new Row(
            wheel.X + (way * alongX) + ((settled - height) * upX),
            wheel.Y + (way * alongY) + ((settled - height) * upY),
            way / wheel.Radius,
            speed * alongX,
            speed * alongY,
            speed / wheel.Radius);
    }

    /// <summary>
    /// A body hung on a spring: with w^2 = k/m, z = c/(2m) and u = x - x_rest (x_rest: g/w^2 below the start, where the spring has its rest length), u is e^(-z t) times
    /// u0 cos d t + ((v0 + z u0) / d) sin d t, d = sqrt(w^2 - z^2). The update after the first one that starts with an
    /// error above Breakpoint breaks it and still pulls; then the body falls freely.
    /// </summary>
    private static Row HungAndBreaking(SceneFile file, string body, double time)
    {
        Circle hung = new(file.Bodies.Single(b => b.Id == body));
        MadeObject spring = file.Springs.Single(s => Json.Text(s.Args, "body") == body);
        double gravity = Impacts.Gravity(file);
        double square = Json.Required(spring.Args, "springConstant").GetDouble() / hung.Mass;
        double decay = Json.Required(spring.Args, "dampingConstant").GetDouble() / (2 * hung.Mass);
        double turn = Math.Sqrt(square - (decay * decay));
        double most = Property(spring, "breakpoint").GetDouble();
        double sag = gravity / square;
        double Stretch(double t) => sag - (sag * Math.Exp(-decay * t) * (Math.Cos(turn * t) + (decay / turn * Math.Sin(turn * t))));
        double Speed(double t) => sag * Math.Exp(-decay * t) * square / turn * Math.Sin(turn * t);
        double end = double.PositiveInfinity;
        for (int update = 1; update < file.Steps && double.IsPositiveInfinity(end); update++)
        {
            end = Stretch((update - 1) * (double)file.Dt) > most ? (update + 1) * (double)file.Dt : end;
        }

        double pulled = Math.Min(time, end);
        double free = time - pulled;
        double y = hung.Y + Stretch(pulled) + (Speed(pulled) * free) + (gravity * free * free / 2);
        return new Row(hung.X, y, 0, 0, Speed(pulled) + (gravity * free), 0);
    }

    private static object? OutlineInertia(SceneFile file, SceneQuery query) => query.Call != "GetMomentOfInertia"
        ? null
        : CentralInertia(Json.Required(Json.Required(file.Root, "vertices"), query.Vertices.GetString()!).EnumerateArray()
            .Select(p => new[] { p[0].GetDouble(), p[1].GetDouble() }).ToArray());

    /// <summary>
    /// Over the triangles (0, p, q) of the outline, with d = p x q: the area is the sum of d / 2, the centroid c
    /// that of (p + q) d / 6 over it, and the integral of r^2 that of d (p.p + p.q + q.q) / 12, less area c.c.
    /// </summary>
    private static double CentralInertia(double[][] points)
    {
        double area = 0;
        double momentX = 0;
        double momentY = 0;
        double second = 0;
        for (int i = 0; i < points.Length; i++)
        {
            double[] p = points[i];
            double[] q = points[(i + 1) % points.Length];
            double cross = (p[0] * q[1]) - (p[1] * q[0]);
            area += cross / 2;
            momentX += (p[0] + q[0]) * cross / 6;
            momentY += (p[1] + q[1]) * cross / 6;
            second += cross * ((p[0] * p[0]) + (p[1] * p[1]) + (p[0] * q[0]) + (p[1] * q[1]) + (q[0] * q[0]) + (q[1] * q[1])) / 12;
        }

        return (second / area) - (((momentX * momentX) + (momentY * momentY)) / (area * area));
    }

    /// <summary>A circle touches a box if the box's nearest point, |p| clamped to the half-widths in its own frame, is within r.</summary>
    private static bool? CircleTouchesBox(SceneFile file, SceneQuery query)
    {
        MadeObject? first = file.Geoms.FirstOrDefault(g => g.Id == query.Target);
        MadeObject? second = query.Call == "Collide" && query.Args is [{ ValueKind: JsonValueKind.String } id]
            ? file.Geoms.FirstOrDefault(g => g.Id == id.GetString())
            : null;
        MadeObject? circle = new[] { first, second }.FirstOrDefault(g => g?.Factory == "CreateCircleGeom");
        MadeObject? box = new[] { first, second }.FirstOrDefault(g => g?.Factory == "CreateRectangleGeom");
        if (circle is null || box is null || second is null)
        {
            return null;
        }

        MadeObject boxBody = file.Bodies.Single(b => b.Id == box.Body);
        JsonElement centre = Property(file.Bodies.Single(b => b.Id == circle.Body), "position");
        JsonElement origin = Property(boxBody, "position");
        JsonElement angle = Property(boxBody, "rotation");
        double rotation = angle.ValueKind == JsonValueKind.Number ? angle.GetDouble() : 0;
        double x = centre[0].GetDouble() - origin[0].GetDouble();
        double y = centre[1].GetDouble() - origin[1].GetDouble();
        double along = Math.Abs((x * Math.Cos(rotation)) + (y * Math.Sin(rotation)));
        double across = Math.Abs((y * Math.Cos(rotation)) - (x * Math.Sin(rotation)));
        double outX = Math.Max(0, along - (Json.Required(box.Args, "width").GetDouble() / 2));
        double outY = Math.Max(0, across - (Json.Required(box.Args, "height").GetDouble() / 2));
        return Math.Sqrt((outX * outX) + (outY * outY)) <= SceneSizes.Radius(circle);
    }

    private static JsonElement Property(MadeObject made, string name) => made.Properties.FirstOrDefault(p => p.Key == name).Value;

    private readonly struct Circle
    {
        public Circle(MadeObject body)
        {
            Radius = Json.Required(body.Args, "radius").GetDouble();
            Mass = Json.Required(body.Args, "mass").GetDouble();
            JsonElement position = Property(body, "position");
            JsonElement velocity = Property(body, "linearVelocity");
            (X, Y) = (position[0].GetDouble(), position[1].GetDouble());
            (VelocityX, VelocityY) = velocity.ValueKind == JsonValueKind.Array ? (velocity[0].GetDouble(), velocity[1].GetDouble()) : (0, 0);
        }

        public double Radius { get; }

        public double Mass { get; }

        public double X { get; }

        public double Y { get; }

        public double VelocityX { get; }

        public double VelocityY { get; }
    }
}
