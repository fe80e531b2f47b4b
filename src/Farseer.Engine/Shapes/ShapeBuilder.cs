using System;
using System.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>Makes shapes from what a user gives. Arguments are checked at the facade's door; outlines too.</summary>
internal static class ShapeBuilder
{
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

    /// <summary>A convex polygon in positive order.</summary>
    public static ShapeGeometry Polygon(ReadOnlySpan<Vector2> points) =>
        Single(new PieceGeometry(ShapeKind.Polygon, points.ToArray(), 0));

    private static ShapeGeometry Single(PieceGeometry piece) => new ShapeGeometry(new[] { piece });
}
