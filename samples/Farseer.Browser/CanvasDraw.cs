using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Views;

namespace Farseer.Browser;

/// <summary>
/// Writes what is drawn as numbers, which page.js reads: a kind, a line colour and a fill colour (0xRRGGBBAA), how many numbers follow, and
/// those. One call into the page a frame is much cheaper than one a shape.
/// </summary>
internal sealed class CanvasDraw : IDebugDraw
{
    private readonly List<double> _numbers = [];

    private enum Kind
    {
        /// <summary>x and y of both ends.</summary>
        Line,

        /// <summary>x and y of each corner.</summary>
        Polygon,

        /// <summary>x, y and radius.</summary>
        Circle,

        /// <summary>x, y and diameter in pixels.</summary>
        Point,
    }

    /// <summary>All since <see cref="Clear"/>; holds until the next call.</summary>
    public Span<double> Numbers => CollectionsMarshal.AsSpan(_numbers);

    public void Clear() => _numbers.Clear();

    public void DrawLine(Vector2 start, Vector2 end, DebugColor color)
    {
        Begin(Kind.Line, color, default, 4);
        Add(start);
        Add(end);
    }

    public void DrawPolygon(Vertices vertices, DebugColor line, DebugColor fill)
    {
        Begin(Kind.Polygon, line, fill, 2 * vertices.Count);
        foreach (Vector2 vertex in vertices)
        {
            Add(vertex);
        }
    }

    public void DrawCircle(Vector2 center, float radius, DebugColor line, DebugColor fill)
    {
        Begin(Kind.Circle, line, fill, 3);
        Add(center);
        _numbers.Add(radius);
    }

    public void DrawPoint(Vector2 position, float size, DebugColor color)
    {
        Begin(Kind.Point, default, color, 3);
        Add(position);
        _numbers.Add(size);
    }

    private void Begin(Kind kind, DebugColor line, DebugColor fill, int count)
    {
        _numbers.Add((int)kind);
        _numbers.Add(Packed(line));
        _numbers.Add(Packed(fill));
        _numbers.Add(count);
    }

    private void Add(Vector2 point)
    {
        _numbers.Add(point.X);
        _numbers.Add(point.Y);
    }

    private static uint Packed(DebugColor color) => ((uint)color.R << 24) | ((uint)color.G << 16) | ((uint)color.B << 8) | color.A;
}
