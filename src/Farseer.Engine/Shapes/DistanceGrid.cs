using System;
using System.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>
/// Signed distances from an outline sampled on a square grid that starts at the lower corner of its bounds, and read back
/// bilinearly: what the original collided with. Here it serves ported code and queries; contacts use exact shapes.
/// </summary>
internal sealed class DistanceGrid
{
    private readonly Vector2[] _outline;
    private readonly float _inverseCellSize;
    private readonly float[] _distances;
    private readonly Vector2 _min;
    private readonly Vector2 _max;
    private readonly int _columns;
    private readonly int _rows;

    private DistanceGrid(Vector2[] outline, float cellSize)
    {
        _outline = outline;
        CellSize = cellSize;
        _inverseCellSize = 1 / cellSize;
        Bounds(outline, out _min, out _max);
        _columns = NodesAlong(_max.X - _min.X, cellSize);
        _rows = NodesAlong(_max.Y - _min.Y, cellSize);
        _distances = new float[checked(_columns * _rows)];
        for (int column = 0; column < _columns; column++)
        {
            for (int row = 0; row < _rows; row++)
            {
                var node = new Vector2(_min.X + (column * cellSize), _min.Y + (row * cellSize));
                _distances[(column * _rows) + row] = NearestDistance(node);
            }
        }
    }

    public float CellSize { get; }

    public Vector2 Min => _min;

    public Vector2 Max => _max;

    /// <summary>Nodes along x; node i lies at <see cref="Min"/>.X + i·<see cref="CellSize"/>.</summary>
    public int Columns => _columns;

    /// <summary>Nodes along y.</summary>
    public int Rows => _rows;

    /// <summary>Nodes that a grid of this outline would have; a double, so that an absurd cell size does not overflow.</summary>
    public static double NodeCount(ReadOnlySpan<Vector2> outline, float cellSize)
    {
        Bounds(outline, out Vector2 min, out Vector2 max);
        return (Math.Ceiling((max.X - min.X) / (double)cellSize) + 1) * (Math.Ceiling((max.Y - min.Y) / (double)cellSize) + 1);
    }

    /// <summary>Samples the outline (either order) with cells of the given size.</summary>
    public static DistanceGrid Compute(Vector2[] outline, float cellSize) => new DistanceGrid(outline, cellSize);

    /// <summary>
    /// True if the interpolated distance at the local point is below 0. No hit without a gradient either: deep inside a shape
    /// of coarse cells all four nodes can be equally far, and there is no way out to name.
    /// </summary>
    public bool Intersect(Vector2 point, out float distance, out Vector2 normal)
    {
        distance = 0;
        normal = Vector2.Zero;
        if (!(point.X >= _min.X && point.X <= _max.X && point.Y >= _min.Y && point.Y <= _max.Y) || _columns < 2 || _rows < 2)
        {
            return false;
        }

        float x = (point.X - _min.X) * _inverseCellSize;
        float y = (point.Y - _min.Y) * _inverseCellSize;
        int column = Math.Min((int)x, _columns - 2);
        int row = Math.Min((int)y, _rows - 2);
        x -= column;
        y -= row;
        int node = (column * _rows) + row;
        float bottomLeft = _distances[node];
        float topLeft = _distances[node + 1];
        float bottomRight = _distances[node + _rows];
        float topRight = _distances[node + _rows + 1];
        float bottom = bottomLeft + ((bottomRight - bottomLeft) * x);
        float top = topLeft + ((topRight - topLeft) * x);
        float left = bottomLeft + ((topLeft - bottomLeft) * y);
        float right = bottomRight + ((topRight - bottomRight) * y);
        distance = bottom + ((top - bottom) * y);
        float gradientX = right - left;
        float gradientY = top - bottom;
        float length = (float)Math.Sqrt((gradientX * gradientX) + (gradientY * gradientY));
        if (!(distance < 0) || length == 0)
        {
            return false;
        }

        normal = new Vector2(gradientX / length, gradientY / length);
        return true;
    }

    /// <summary>Exact distance from the outline, negative inside.</summary>
    public float NearestDistance(Vector2 point) => NearestDistance(_outline, point);

    /// <summary>Exact distance from an outline of either order, negative inside.</summary>
    public static float NearestDistance(ReadOnlySpan<Vector2> outline, Vector2 point)
    {
        double best = double.PositiveInfinity;
        bool inside = false;
        for (int i = 0; i < outline.Length; i++)
        {
            Vector2 a = outline[i];
            Vector2 b = outline[i + 1 == outline.Length ? 0 : i + 1];
            best = Math.Min(best, ToEdge(a, b, point, out _));
            if ((a.Y > point.Y) != (b.Y > point.Y))
            {
                // Right of the point by the sign of a cross product: no division, so no rounding decides.
                double side = Outline.Cross(a, b, point);
                inside ^= b.Y > a.Y ? side > 0 : side < 0;
            }
        }

        float distance = (float)Math.Sqrt(best);
        return inside ? -distance : distance;
    }

    /// <summary>
    /// Distance from edge <paramref name="index"/> of an outline, the nearest point on it and the normal (dy, -dx) of its way.
    /// </summary>
    public static float NearestOnEdge(ReadOnlySpan<Vector2> outline, int index, Vector2 point, out Vector2 position, out Vector2 normal)
    {
        Vector2 a = outline[index];
        Vector2 b = outline[index + 1 == outline.Length ? 0 : index + 1];
        double square = ToEdge(a, b, point, out double along);
        position = new Vector2((float)(a.X + (along * ((double)b.X - a.X))), (float)(a.Y + (along * ((double)b.Y - a.Y))));
        normal = PieceBaker.EdgeNormal(a, b);
        return (float)Math.Sqrt(square);
    }

    private static double ToEdge(Vector2 a, Vector2 b, Vector2 point, out double along)
    {
        double dx = (double)b.X - a.X;
        double dy = (double)b.Y - a.Y;
        double px = (double)point.X - a.X;
        double py = (double)point.Y - a.Y;
        double square = (dx * dx) + (dy * dy);
        along = square > 0 ? ((px * dx) + (py * dy)) / square : 0;
        along = along < 0 ? 0 : along > 1 ? 1 : along;
        px -= along * dx;
        py -= along * dy;
        return (px * px) + (py * py);
    }

    private static int NodesAlong(float length, float cellSize) => checked((int)Math.Ceiling(length / (double)cellSize) + 1);

    private static void Bounds(ReadOnlySpan<Vector2> outline, out Vector2 min, out Vector2 max)
    {
        min = outline[0];
        max = outline[0];
        foreach (Vector2 p in outline)
        {
            min = new Vector2(Math.Min(min.X, p.X), Math.Min(min.Y, p.Y));
            max = new Vector2(Math.Max(max.X, p.X), Math.Max(max.Y, p.Y));
        }
    }
}
