using System;
using System.Collections.Generic;
using System.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>
/// Makes shapes from what a user gives. Arguments are checked at the facade's door, outlines by <see cref="Outline.Check"/>.
/// </summary>
internal static class ShapeBuilder
{
    /// <summary>Share by which a four-cornered outline may miss right angles and still be a box: the rounding of its corners.</summary>
    private const double RightAngleTolerance = 4e-6;

    public static ShapeGeometry Circle(float radius) =>
        Single(new PieceGeometry(ShapeKind.Circle, new[] { Vector2.Zero }, radius));

    public static ShapeGeometry Box(float width, float height)
    {
        float x = 0.5f * width;
        float y = 0.5f * height;
        return Single(new PieceGeometry(
            ShapeKind.Box,
            new[] { new Vector2(-x, -y), new Vector2(x, -y), new Vector2(x, y), new Vector2(-x, y) },
            0));
    }

    /// <summary>The points within <paramref name="radius"/> of the line from a to b.</summary>
    public static ShapeGeometry Capsule(Vector2 a, Vector2 b, float radius) =>
        a == b
            ? Single(new PieceGeometry(ShapeKind.Circle, new[] { a }, radius))
            : Single(new PieceGeometry(ShapeKind.Capsule, new[] { a, b }, radius));

    /// <summary>A line from a to b that collides on both sides.</summary>
    public static ShapeGeometry Segment(Vector2 a, Vector2 b) =>
        Single(new PieceGeometry(ShapeKind.Segment, new[] { a, b }, 0));

    /// <summary>
    /// Any simple outline, in either order, with repeated and collinear points allowed, rounded outwards by
    /// <paramref name="radius"/>. Convex: one piece; concave: convex pieces with seams.
    /// </summary>
    public static ShapeGeometry Polygon(ReadOnlySpan<Vector2> points, float radius = 0)
    {
        Vector2[] outline = Outline.Tidy(points);
        if (Outline.IsConvex(outline))
        {
            ShapeKind kind = radius == 0 && IsRectangle(outline) ? ShapeKind.Box : ShapeKind.Polygon;
            return Single(new PieceGeometry(kind, outline, radius));
        }

        List<List<int>> rings = Decomposition.Split(outline);
        var pieces = new PieceGeometry[rings.Count];
        for (int i = 0; i < pieces.Length; i++)
        {
            pieces[i] = PieceOf(outline, rings[i], radius);
        }

        return new ShapeGeometry(pieces);
    }

    /// <summary>
    /// One-sided links between successive points, closed if <paramref name="loop"/>. The outward normal of a link is
    /// (dy, -dx) of its direction, so a closed chain in positive order is solid to the outside world, and neighbours know
    /// each other's normals: what slides along feels no joints. The end of an open chain admits contacts from all sides but the link's own:
    /// no neighbour holds it.
    /// </summary>
    public static ShapeGeometry Chain(ReadOnlySpan<Vector2> points, bool loop)
    {
        var corner = new List<Vector2>(points.Length);
        foreach (Vector2 p in points)
        {
            if (corner.Count == 0 || corner[corner.Count - 1] != p)
            {
                corner.Add(p);
            }
        }

        if (loop && corner.Count > 1 && corner[corner.Count - 1] == corner[0])
        {
            corner.RemoveAt(corner.Count - 1);
        }

        int count = corner.Count;
        int links = loop ? count : Math.Max(0, count - 1);
        var pieces = new PieceGeometry[links];
        float thickness = loop ? ThicknessOf(corner) : float.PositiveInfinity;
        for (int i = 0; i < links; i++)
        {
            Vector2 a = corner[i];
            Vector2 b = corner[(i + 1) % count];
            Vector2 normal = PieceBaker.EdgeNormal(a, b);
            bool hasPrevious = loop || i > 0;
            bool hasNext = loop || i < links - 1;
            pieces[i] = new PieceGeometry(ShapeKind.Segment, new[] { a, b }, 0)
            {
                OneSided = true,
                Thickness = thickness,
                OutlineNormalBefore = new[] { hasPrevious ? PieceBaker.EdgeNormal(corner[(i + count - 1) % count], a) : -normal, normal },
                OutlineNormalAfter = new[] { normal, hasNext ? PieceBaker.EdgeNormal(b, corner[(i + 2) % count]) : -normal },
            };
        }

        return new ShapeGeometry(pieces);
    }

    /// <summary>
    /// That of a long strip of the loop's area and outline: it is twice the one by the other. A loop that is solid outwards has no bound.
    /// </summary>
    private static float ThicknessOf(List<Vector2> corner)
    {
        Vector2[] points = corner.ToArray();
        double area = points.Length < 3 ? 0 : MassProperties.SignedArea(points);
        double around = 0;
        for (int i = 0; i < points.Length; i++)
        {
            around += Vector2.Distance(points[i], points[(i + 1) % points.Length]);
        }

        return area > 0 ? (float)(2 * area / around) : float.PositiveInfinity;
    }

    private static PieceGeometry PieceOf(Vector2[] outline, List<int> ring, float radius)
    {
        int count = ring.Count;
        int total = outline.Length;
        var vertices = new Vector2[count];
        var seams = new bool[count];
        var before = new Vector2[count];
        var after = new Vector2[count];
        for (int i = 0; i < count; i++)
        {
            int v = ring[i];
            int next = (v + 1) % total;
            vertices[i] = outline[v];
            seams[i] = ring[(i + 1) % count] != next;
            before[i] = PieceBaker.EdgeNormal(outline[(v + total - 1) % total], outline[v]);
            after[i] = PieceBaker.EdgeNormal(outline[v], outline[next]);
        }

        return new PieceGeometry(ShapeKind.Polygon, vertices, radius)
        {
            SeamEdges = seams,
            OutlineNormalBefore = before,
            OutlineNormalAfter = after,
        };
    }

    private static bool IsRectangle(Vector2[] outline)
    {
        if (outline.Length != 4)
        {
            return false;
        }

        for (int i = 0; i < 4; i++)
        {
            Vector2 a = outline[(i + 1) % 4] - outline[i];
            Vector2 b = outline[(i + 2) % 4] - outline[(i + 1) % 4];
            double dot = ((double)a.X * b.X) + ((double)a.Y * b.Y);
            if (Math.Abs(dot) > RightAngleTolerance * a.Length() * b.Length())
            {
                return false;
            }
        }

        return true;
    }

    private static ShapeGeometry Single(PieceGeometry piece) => new ShapeGeometry(new[] { piece });
}
