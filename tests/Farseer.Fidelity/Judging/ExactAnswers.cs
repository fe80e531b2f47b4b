using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>Answers that geometry gives, where the original's are those of its approximations.</summary>
public static class ExactAnswers
{
    /// <summary>The answer, or null where the original's stays the reference.</summary>
    public static object? Of(SceneFile file, SceneQuery query) => query.Call switch
    {
        "GetMomentOfInertia" when Outline(file, query.Vertices) is { } outline => CentralInertia(outline),
        "Collide" when query.AfterStep == 0 || file.Geoms.All(g => Stands(file, g)) => Touches(file, query),
        _ => null,
    };

    private static double[][]? Outline(SceneFile file, JsonElement vertices)
    {
        JsonElement points = vertices.ValueKind == JsonValueKind.String ? Json.Optional(Json.Optional(file.Root, "vertices"), vertices.GetString()!) : vertices;
        return points.ValueKind == JsonValueKind.Array ? [.. points.EnumerateArray().Select(p => new[] { p[0].GetDouble(), p[1].GetDouble() })] : null;
    }

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

    /// <summary>
    /// A circle touches a point or another circle within its radius, and a box if the box's nearest point, |p| clamped to the half-widths in its own
    /// frame, is. Two geoms without a circle are polygons in the original, too.
    /// </summary>
    private static bool? Touches(SceneFile file, SceneQuery query)
    {
        if (query.Args is not [{ } argument] || file.Geoms.FirstOrDefault(g => g.Id == query.Target) is not { } asked)
        {
            return null;
        }

        if (argument.ValueKind == JsonValueKind.Array)
        {
            return IsCircle(asked) ? Distance(Centre(file, asked), (argument[0].GetDouble(), argument[1].GetDouble())) <= SceneSizes.Radius(asked) : null;
        }

        MadeObject? other = argument.ValueKind == JsonValueKind.String ? file.Geoms.FirstOrDefault(g => g.Id == argument.GetString()) : null;
        MadeObject[] circles = [.. new[] { asked, other }.Where(g => g is not null && IsCircle(g)).Select(g => g!)];
        MadeObject? box = new[] { asked, other }.FirstOrDefault(g => g?.Factory == "CreateRectangleGeom");
        if (circles.Length == 2)
        {
            return Distance(Centre(file, circles[0]), Centre(file, circles[1])) <= circles.Sum(SceneSizes.Radius);
        }

        if (circles.Length == 0 || box is null)
        {
            return null;
        }

        double rotation = Angle(file, box) + Json.Number(box.Args, "rotationOffset", 0);
        (double cx, double cy) = Centre(file, circles[0]);
        (double ox, double oy) = Centre(file, box);
        double along = Math.Abs(((cx - ox) * Math.Cos(rotation)) + ((cy - oy) * Math.Sin(rotation)));
        double across = Math.Abs(((cy - oy) * Math.Cos(rotation)) - ((cx - ox) * Math.Sin(rotation)));
        double outX = Math.Max(0, along - (Json.Required(box.Args, "width").GetDouble() / 2));
        double outY = Math.Max(0, across - (Json.Required(box.Args, "height").GetDouble() / 2));
        return Math.Sqrt((outX * outX) + (outY * outY)) <= SceneSizes.Radius(circles[0]);
    }

    private static bool IsCircle(MadeObject geom) => geom.Factory == "CreateCircleGeom";

    private static double Distance((double X, double Y) a, (double X, double Y) b)
        => Math.Sqrt(((a.X - b.X) * (a.X - b.X)) + ((a.Y - b.Y) * (a.Y - b.Y)));

    /// <summary>Whether the body of a geom is where it was made whenever it is asked.</summary>
    private static bool Stands(SceneFile file, MadeObject geom)
    {
        bool isStatic = file.Bodies.Any(b => b.Id == geom.Body && Value(b, "isStatic").ValueKind == JsonValueKind.True);
        return isStatic || file.Recordings.Values.All(r => r.Rows.TryGetValue(geom.Body!, out Row[]? rows)
            && rows.All(row => row.X == rows[0].X && row.Y == rows[0].Y && row.Rotation == rows[0].Rotation));
    }

    private static double Angle(SceneFile file, MadeObject geom)
        => Value(file.Bodies.Single(b => b.Id == geom.Body), "rotation") is { ValueKind: JsonValueKind.Number } turned ? turned.GetDouble() : 0;

    /// <summary>The centre of a circle or a box: that of its body, and its offset turned with the body.</summary>
    private static (double X, double Y) Centre(SceneFile file, MadeObject geom)
    {
        JsonElement at = Value(file.Bodies.Single(b => b.Id == geom.Body), "position");
        (double x, double y) = at.ValueKind == JsonValueKind.Array ? (at[0].GetDouble(), at[1].GetDouble()) : (0, 0);
        JsonElement offset = Json.Optional(geom.Args, "offset");
        if (offset.ValueKind != JsonValueKind.Array)
        {
            return (x, y);
        }

        (double sin, double cos) = Math.SinCos(Angle(file, geom));
        (double ox, double oy) = (offset[0].GetDouble(), offset[1].GetDouble());
        return (x + (ox * cos) - (oy * sin), y + (ox * sin) + (oy * cos));
    }

    private static JsonElement Value(MadeObject made, string name) => made.Properties.FirstOrDefault(p => p.Key == name).Value;
}
