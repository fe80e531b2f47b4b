using System;
using System.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>A point of an outline and the outward normal of the edge that it is on.</summary>
internal struct OutlinePoint
{
    public double X;
    public double Y;
    public double NormalX;
    public double NormalY;
}

/// <summary>Distances of points from pieces, in double precision and body coordinates.</summary>
internal static unsafe class Distance
{
    /// <summary>Distance of a point from a convex piece; negative inside, 0 on the border.</summary>
    public static float SignedDistance(ShapeStore store, int piece, Vector2 point) =>
        (float)SignedDistance(store, piece, point.X, point.Y);

    public static double SignedDistance(ShapeStore store, int piece, double x, double y)
    {
        ref Piece p = ref store.Pieces[piece];
        double nearest = ToOutline(store, piece, x, y, seamsToo: true);
        return (IsInCore(store, piece, x, y) ? -nearest : nearest) - p.Radius;
    }

    /// <summary>
    /// True if the point lies in or on the polygon without its rounding: cross products of float differences, whose signs
    /// double precision gets right, so on a seam a point belongs to both neighbours and none slips through.
    /// </summary>
    public static bool IsInCore(ShapeStore store, int piece, double x, double y)
    {
        ref Piece p = ref store.Pieces[piece];
        if (p.VertexCount < 3)
        {
            return false;
        }

        Vector2* v = store.Vertices.Pointer + p.VertexStart;
        for (int i = 0; i < p.VertexCount; i++)
        {
            Vector2 a = v[i];
            Vector2 b = v[i + 1 == p.VertexCount ? 0 : i + 1];
            double cross = (((double)b.X - a.X) * (y - a.Y)) - (((double)b.Y - a.Y) * (x - a.X));
            if (cross < 0)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Distance from the edges of the piece, with or without its seams; infinite if it has no such edge.</summary>
    public static double ToOutline(ShapeStore store, int piece, double x, double y, bool seamsToo)
    {
        ref Piece p = ref store.Pieces[piece];
        Vector2* v = store.Vertices.Pointer + p.VertexStart;
        double best = double.PositiveInfinity;
        for (int i = 0; i < p.VertexCount; i++)
        {
            int k = p.VertexStart + i;
            if (seamsToo || store.OutlineAfter[k] == store.Normals[k])
            {
                best = Math.Min(best, SquareToSegment(v[i], v[i + 1 == p.VertexCount ? 0 : i + 1], x, y));
            }
        }

        return Math.Sqrt(best);
    }

    /// <summary>
    /// The point of the piece's own outline, seams and rounding left out, that is nearest, if it is nearer than
    /// <paramref name="square"/> says.
    /// </summary>
    public static void Nearest(ShapeStore store, int piece, double x, double y, ref double square, ref OutlinePoint nearest)
    {
        ref Piece p = ref store.Pieces[piece];
        Vector2* v = store.Vertices.Pointer + p.VertexStart;
        for (int i = 0; i < p.VertexCount; i++)
        {
            Vector2 normal = store.Normals[p.VertexStart + i];
            if (store.OutlineAfter[p.VertexStart + i] != normal)
            {
                continue;
            }

            Vector2 a = v[i];
            Vector2 b = v[i + 1 == p.VertexCount ? 0 : i + 1];
            double dx = (double)b.X - a.X;
            double dy = (double)b.Y - a.Y;
            double length = (dx * dx) + (dy * dy);
            double t = length > 0 ? (((x - a.X) * dx) + ((y - a.Y) * dy)) / length : 0;
            t = t < 0 ? 0 : t > 1 ? 1 : t;
            double nearX = a.X + (t * dx);
            double nearY = a.Y + (t * dy);
            double found = ((x - nearX) * (x - nearX)) + ((y - nearY) * (y - nearY));
            if (found < square)
            {
                square = found;
                nearest.X = nearX;
                nearest.Y = nearY;
                nearest.NormalX = normal.X;
                nearest.NormalY = p.VertexCount > 1 ? normal.Y : 1;
            }
        }
    }

    private static double SquareToSegment(Vector2 a, Vector2 b, double x, double y)
    {
        double dx = (double)b.X - a.X;
        double dy = (double)b.Y - a.Y;
        double px = x - a.X;
        double py = y - a.Y;
        double square = (dx * dx) + (dy * dy);
        double t = square > 0 ? ((px * dx) + (py * dy)) / square : 0;
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        px -= t * dx;
        py -= t * dy;
        return (px * px) + (py * py);
    }
}
