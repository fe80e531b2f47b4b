using System;
using System.Numerics;

namespace Farseer.Engine.Tests.NarrowPhase;

/// <summary>Brute force in double precision: distance of convex hulls, or minus the least depth along an edge normal.</summary>
internal static class ReferenceDistance
{
    public readonly record struct Point(double X, double Y);

    public static Point[] Place(ReadOnlySpan<Vector2> vertices, double cos, double sin, Vector2 offset)
    {
        var result = new Point[vertices.Length];
        for (int i = 0; i < result.Length; i++)
        {
            double x = vertices[i].X;
            double y = vertices[i].Y;
            result[i] = new Point((cos * x) - (sin * y) + offset.X, (sin * x) + (cos * y) + offset.Y);
        }

        return result;
    }

    public static double Signed(Point[] a, Point[] b)
    {
        double axis = Math.Max(BestAxis(a, b), BestAxis(b, a));
        return axis < 0 && (a.Length > 1 || b.Length > 1) ? axis : Nearest(a, b);
    }

    private static double BestAxis(Point[] a, Point[] b)
    {
        double best = double.NegativeInfinity;
        for (int i = 0; i < a.Length && a.Length > 1; i++)
        {
            Point p = a[i];
            Point q = a[(i + 1) % a.Length];
            double nx = q.Y - p.Y;
            double ny = p.X - q.X;
            double length = Math.Sqrt((nx * nx) + (ny * ny));
            double least = double.PositiveInfinity;
            foreach (Point v in b)
            {
                least = Math.Min(least, (((v.X - p.X) * nx) + ((v.Y - p.Y) * ny)) / length);
            }

            best = Math.Max(best, least);
        }

        return best;
    }

    private static double Nearest(Point[] a, Point[] b)
    {
        double best = double.PositiveInfinity;
        for (int i = 0; i < a.Length; i++)
        {
            for (int j = 0; j < b.Length; j++)
            {
                best = Math.Min(best, ToSegment(b[j], a[i], a[(i + 1) % a.Length]));
                best = Math.Min(best, ToSegment(a[i], b[j], b[(j + 1) % b.Length]));
            }
        }

        return best;
    }

    private static double ToSegment(Point p, Point a, Point b)
    {
        double dx = b.X - a.X;
        double dy = b.Y - a.Y;
        double square = (dx * dx) + (dy * dy);
        double t = square > 0 ? Math.Clamp((((p.X - a.X) * dx) + ((p.Y - a.Y) * dy)) / square, 0, 1) : 0;
        double x = p.X - a.X - (t * dx);
        double y = p.Y - a.Y - (t * dy);
        return Math.Sqrt((x * x) + (y * y));
    }
}
