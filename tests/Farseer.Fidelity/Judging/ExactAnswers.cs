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
        JsonElement points = vertices.ValueKind == JsonValueKind.String
            ? Json.Optional(Json.Optional(file.Root, "vertices"), vertices.GetString()!)
            : vertices;
        return points.ValueKind == JsonValueKind.Array
            ? [.. points.EnumerateArray().Select(p => new[] { p[0].GetDouble(), p[1].GetDouble() })]
            : null;
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
    /// Two geoms touch if an edge of one crosses an edge of the other, or one holds the other: a circle with its outline of edges, as
    /// queries take
    /// it. The original looks whether a vertex of one lies in the other, and so misses what lies between two vertices.
    /// </summary>
    private static bool? Touches(SceneFile file, SceneQuery query)
    {
        if (query.Args is not [{ ValueKind: JsonValueKind.String } id]
            || file.Geoms.FirstOrDefault(g => g.Id == query.Target) is not { } first
            || file.Geoms.FirstOrDefault(g => g.Id == id.GetString()) is not { } second
            || World(file, first) is not { } a || World(file, second) is not { } b)
        {
            return null;
        }

        bool crosses = Edges(a).Any(e => Edges(b).Any(f =>
            Side(e.From, e.To, f.From) * Side(e.From, e.To, f.To) <= 0 && Side(f.From, f.To, e.From) * Side(f.From, f.To, e.To) <= 0));
        return crosses || Holds(a, b[0]) || Holds(b, a[0]);
    }

    private static IEnumerable<((double X, double Y) From, (double X, double Y) To)> Edges((double X, double Y)[] outline)
        => outline.Select((p, i) => (p, outline[(i + 1) % outline.Length]));

    private static double Side((double X, double Y) from, (double X, double Y) to, (double X, double Y) point)
        => ((to.X - from.X) * (point.Y - from.Y)) - ((to.Y - from.Y) * (point.X - from.X));

    /// <summary>By the number of edges to the right of the point.</summary>
    private static bool Holds((double X, double Y)[] outline, (double X, double Y) point) => Edges(outline).Count(e =>
        (e.From.Y > point.Y) != (e.To.Y > point.Y) && (Side(e.From, e.To, point) > 0) == (e.To.Y > e.From.Y)) % 2 == 1;

    /// <summary>The outline in the world, or null for a kind of geom that is not known here.</summary>
    private static (double X, double Y)[]? World(SceneFile file, MadeObject geom)
    {
        (double X, double Y)[]? local = geom.Factory switch
        {
            "CreateCircleGeom" or "CreateEllipseGeom" => Round(geom),
            "CreateRectangleGeom" => Box(geom),
            _ => null,
        };
        MadeObject body = file.Bodies.Single(b => b.Id == geom.Body);
        JsonElement at = Value(body, "position");
        JsonElement offset = Json.Optional(geom.Args, "offset");
        if (local is null || at.ValueKind != JsonValueKind.Array
            || (Json.Number(geom.Args, "rotationOffset", 0) != 0 && offset.ValueKind == JsonValueKind.Array))
        {
            return null;
        }

        double angle = Value(body, "rotation") is { ValueKind: JsonValueKind.Number } turned ? turned.GetDouble() : 0;
        (double ox, double oy) = offset.ValueKind == JsonValueKind.Array ? (offset[0].GetDouble(), offset[1].GetDouble()) : (0, 0);
        double own = Json.Number(geom.Args, "rotationOffset", 0);
        return [.. local.Select(p => Turn(p, own)).Select(p => Turn((p.X + ox, p.Y + oy), angle))
            .Select(p => (p.X + at[0].GetDouble(), p.Y + at[1].GetDouble()))];
    }

    private static (double X, double Y)[] Box(MadeObject geom)
    {
        (double x, double y) = (Json.Required(geom.Args, "width").GetDouble() / 2, Json.Required(geom.Args, "height").GetDouble() / 2);
        return [(-x, -y), (x, -y), (x, y), (-x, y)];
    }

    private static (double X, double Y)[] Round(MadeObject geom)
    {
        double radius = SceneSizes.Radius(geom);
        (double x, double y) = (Json.Number(geom.Args, "xRadius", radius), Json.Number(geom.Args, "yRadius", radius));
        int count = Json.Required(geom.Args, "numberOfEdges").GetInt32();
        return [.. Enumerable.Range(0, count).Select(i => 2 * Math.PI * i / count).Select(t => (x * Math.Cos(t), -y * Math.Sin(t)))];
    }

    private static (double X, double Y) Turn((double X, double Y) point, double angle)
    {
        (double sin, double cos) = Math.SinCos(angle);
        return ((point.X * cos) - (point.Y * sin), (point.X * sin) + (point.Y * cos));
    }

    /// <summary>Whether the body of a geom is where it was made whenever it is asked.</summary>
    private static bool Stands(SceneFile file, MadeObject geom)
    {
        bool isStatic = file.Bodies.Any(b => b.Id == geom.Body && Value(b, "isStatic").ValueKind == JsonValueKind.True);
        return isStatic || file.Recordings.Values.All(r => r.Rows.TryGetValue(geom.Body!, out Row[]? rows)
            && rows.All(row => row.X == rows[0].X && row.Y == rows[0].Y && row.Rotation == rows[0].Rotation));
    }

    private static JsonElement Value(MadeObject made, string name) => made.Properties.FirstOrDefault(p => p.Key == name).Value;
}
