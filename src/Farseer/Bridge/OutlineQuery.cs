using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Exact answers about outlines, rounded shapes and lines, independent of the engine and of the grid. A circle answers with its
/// documented edges, so that all queries agree with each other and with what is drawn.
/// </summary>
internal static class OutlineQuery
{
    /// <summary>If a local point is in the geom or on its edge.</summary>
    public static bool Contains(Geom geom, Vector2 local)
    {
        GeomForm form = geom.Form!;
        switch (form.Kind)
        {
            case FormKind.Capsule:
                return Distance(local, form.Points[0], form.Points[1], out _) <= form.Radius;
            case FormKind.Segment:
            case FormKind.Chain:
                return false;
            default:
                return Inside(geom.LocalVertices, local) || OnEdge(geom.LocalVertices, local);
        }
    }

    /// <summary>If two geoms share a point, from their world outlines and radii.</summary>
    public static bool Overlap(Geom a, Geom b)
    {
        float radius = Core(a, out Vector2[] pointsA, out bool closedA) + Core(b, out Vector2[] pointsB, out bool closedB);
        if ((closedA && InsideArray(pointsA, pointsB[0])) || (closedB && InsideArray(pointsB, pointsA[0])))
        {
            return true;
        }

        int edgesA = Edges(pointsA, closedA);
        int edgesB = Edges(pointsB, closedB);
        for (int i = 0; i < edgesA; i++)
        {
            Vector2 a0 = pointsA[i];
            Vector2 a1 = pointsA[(i + 1) % pointsA.Length];
            for (int j = 0; j < edgesB; j++)
            {
                if (SegmentDistance(a0, a1, pointsB[j], pointsB[(j + 1) % pointsB.Length]) <= radius)
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>If a point is strictly inside an outline, by the number of edges to its right.</summary>
    public static bool Inside(Vertices outline, Vector2 point)
    {
        bool inside = false;
        for (int i = 0, j = outline.Count - 1; i < outline.Count; j = i++)
        {
            inside ^= Crosses(outline[i], outline[j], point);
        }

        return inside;
    }

    /// <summary>Distance from a point to a segment, and the segment's nearest point.</summary>
    public static float Distance(Vector2 point, Vector2 a, Vector2 b, out Vector2 nearest)
    {
        Vector2 along = b - a;
        float length2 = along.LengthSquared();
        float t = length2 > 0 ? Vector2.Dot(point - a, along) / length2 : 0;
        nearest = t <= 0 ? a : t >= 1 ? b : a + (t * along);
        return (point - nearest).Length();
    }

    private static bool OnEdge(Vertices outline, Vector2 point)
    {
        for (int i = 0, j = outline.Count - 1; i < outline.Count; j = i++)
        {
            if (Distance(point, outline[j], outline[i], out _) == 0)
            {
                return true;
            }
        }

        return false;
    }

    private static bool Crosses(Vector2 a, Vector2 b, Vector2 point) =>
        (a.Y > point.Y) != (b.Y > point.Y)
        && point.X < ((((double)b.X - a.X) * ((double)point.Y - a.Y)) / ((double)b.Y - a.Y)) + a.X;

    private static bool InsideArray(Vector2[] outline, Vector2 point)
    {
        bool inside = false;
        for (int i = 0, j = outline.Length - 1; i < outline.Length; j = i++)
        {
            inside ^= Crosses(outline[i], outline[j], point);
        }

        return inside;
    }

    private static int Edges(Vector2[] points, bool closed) => closed || points.Length == 1 ? points.Length : points.Length - 1;

    /// <summary>What a geom is made of in the world: points, and the radius around them.</summary>
    private static float Core(Geom geom, out Vector2[] points, out bool closed)
    {
        GeomForm form = geom.Form!;
        closed = form.Kind == FormKind.Box || form.Kind == FormKind.Outline || form.Kind == FormKind.Circle;
        if (closed)
        {
            points = geom.WorldVertices.ToArray();
            return 0;
        }

        points = (Vector2[])form.Points.Clone();
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = geom.GetWorldPosition(points[i]);
        }

        if (form.Kind == FormKind.Chain && form.IsLoop)
        {
            Array.Resize(ref points, points.Length + 1);
            points[points.Length - 1] = points[0];
        }

        return form.Radius;
    }

    private static float SegmentDistance(Vector2 a0, Vector2 a1, Vector2 b0, Vector2 b1)
    {
        if (Side(a0, a1, b0) * Side(a0, a1, b1) < 0 && Side(b0, b1, a0) * Side(b0, b1, a1) < 0)
        {
            return 0;
        }

        float first = Math.Min(Distance(b0, a0, a1, out _), Distance(b1, a0, a1, out _));
        return Math.Min(first, Math.Min(Distance(a0, b0, b1, out _), Distance(a1, b0, b1, out _)));
    }

    private static int Side(Vector2 a, Vector2 b, Vector2 p) =>
        Math.Sign((((double)b.X - a.X) * ((double)p.Y - a.Y)) - (((double)b.Y - a.Y) * ((double)p.X - a.X)));
}
