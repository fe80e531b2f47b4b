using System;
using System.Numerics;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>An axis-aligned bounding box (manual: "AABB").</summary>
/// <remarks>
/// Its sides stay parallel to the axes however the geom within turns, so two boxes can overlap although the geoms do not touch.
/// Lengths are in world units. Edges belong to the box: boxes that share only an edge or a corner intersect, and a point on
/// an edge is contained.
/// </remarks>
/// <example>
/// <code>
/// bool overlap = AABB.Intersect(geom.AABB, other.AABB);
/// </code>
/// </example>
public class AABB
{
    private Vector2 _min;
    private Vector2 _max;

    /// <summary>Makes an empty box at the origin: both corners (0, 0).</summary>
    public AABB()
    {
    }

    /// <summary>Makes a copy of a box.</summary>
    /// <param name="aabb">The box to copy.</param>
    /// <exception cref="ArgumentNullException"><paramref name="aabb"/> is null.</exception>
    public AABB(AABB aabb)
    {
        Require.NotNull(aabb, nameof(aabb));
        _min = aabb._min;
        _max = aabb._max;
    }

    /// <summary>Makes a box between two corners.</summary>
    /// <param name="min">The corner with the smaller coordinates.</param>
    /// <param name="max">The corner with the larger coordinates.</param>
    /// <exception cref="ArgumentOutOfRangeException">A coordinate is not finite, or one of <paramref name="max"/> is below
    /// that of <paramref name="min"/>.</exception>
    public AABB(Vector2 min, Vector2 max)
    {
        Require.Finite(min, nameof(min));
        Require.Finite(max, nameof(max));
        if (max.X < min.X || max.Y < min.Y)
        {
            throw new ArgumentOutOfRangeException(nameof(max), max, $"max must not be below min, which is {min}.");
        }

        _min = min;
        _max = max;
    }

    /// <summary>Makes the smallest box around points.</summary>
    /// <param name="vertices">One point or more.</param>
    /// <exception cref="ArgumentNullException"><paramref name="vertices"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="vertices"/> is empty or has a coordinate that is not finite.</exception>
    public AABB(Vertices vertices)
    {
        Update(ref vertices);
    }

    /// <summary>The height, in world units: 0 or more.</summary>
    public float Height => _max.Y - _min.Y;

    /// <summary>The corner with the larger coordinates. Default (0, 0).</summary>
    public Vector2 Max => _max;

    /// <summary>The corner with the smaller coordinates. Default (0, 0).</summary>
    public Vector2 Min => _min;

    /// <summary>The width, in world units: 0 or more.</summary>
    public float Width => _max.X - _min.X;

    /// <summary>Tells whether two boxes overlap or touch.</summary>
    /// <param name="aabb1">One box.</param>
    /// <param name="aabb2">The other box.</param>
    /// <returns>True if they share at least a point.</returns>
    /// <exception cref="ArgumentNullException">A box is null.</exception>
    public static bool Intersect(AABB aabb1, AABB aabb2)
    {
        Require.NotNull(aabb1, nameof(aabb1));
        Require.NotNull(aabb2, nameof(aabb2));
        return aabb1._min.X <= aabb2._max.X && aabb2._min.X <= aabb1._max.X
            && aabb1._min.Y <= aabb2._max.Y && aabb2._min.Y <= aabb1._max.Y;
    }

    /// <summary>Tells whether a point is within the box or on its edge.</summary>
    /// <param name="point">The point, in the coordinates of the box.</param>
    /// <returns>True if it is; false for a point with a coordinate that is not a number.</returns>
    public bool Contains(Vector2 point) => Contains(ref point);

    /// <summary>Tells whether a point is within the box or on its edge.</summary>
    /// <param name="point">The point, in the coordinates of the box; not changed.</param>
    /// <returns>True if it is; false for a point with a coordinate that is not a number.</returns>
    public bool Contains(ref Vector2 point) =>
        point.X >= _min.X && point.X <= _max.X && point.Y >= _min.Y && point.Y <= _max.Y;

    /// <summary>The middle of the box.</summary>
    /// <returns>The centre, in the coordinates of the box.</returns>
    public Vector2 GetCenter() => new Vector2(_min.X + (0.5f * (_max.X - _min.X)), _min.Y + (0.5f * (_max.Y - _min.Y)));

    /// <summary>The smaller of width and height.</summary>
    /// <returns>A length in world units, 0 or more.</returns>
    public float GetShortestSide() => Math.Min(Width, Height);

    /// <summary>The four corners, in the order that a geom's vertices have (<see cref="Vertices.IsCounterClockWise"/>).</summary>
    /// <returns>A new list: (min X, min Y), (min X, max Y), (max X, max Y), (max X, min Y).</returns>
    public Vertices GetVertices() => new Vertices
    {
        _min,
        new Vector2(_min.X, _max.Y),
        _max,
        new Vector2(_max.X, _min.Y),
    };

    /// <summary>Makes this the smallest box around points.</summary>
    /// <param name="vertices">One point or more; not changed.</param>
    /// <exception cref="ArgumentNullException"><paramref name="vertices"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="vertices"/> is empty or has a coordinate that is not finite; the box
    /// is then left as it was.</exception>
    public void Update(ref Vertices vertices)
    {
        Require.NotNull(vertices, nameof(vertices));
        if (vertices.Count == 0)
        {
            throw new ArgumentException("A box needs at least one vertex to enclose; the list has 0.", nameof(vertices));
        }

        var min = vertices[0];
        var max = vertices[0];
        for (var i = 0; i < vertices.Count; i++)
        {
            var vertex = vertices[i];
            if (!Require.IsFinite(vertex))
            {
                throw new ArgumentException($"Vertex {i} is {vertex}: the coordinates must be finite.", nameof(vertices));
            }

            min = Vector2.Min(min, vertex);
            max = Vector2.Max(max, vertex);
        }

        _min = min;
        _max = max;
    }

    /// <summary>A text that shows both corners.</summary>
    /// <returns>The text, for messages and the debugger.</returns>
    public override string ToString() => $"{_min} .. {_max}";

    /// <summary>Moves both corners; the caller vouches for their order.</summary>
    internal void Set(Vector2 min, Vector2 max)
    {
        _min = min;
        _max = max;
    }

    /// <summary>Writes, or reads, what later updates read of it.</summary>
    internal void Visit(StateStream s)
    {
        s.Value(ref _min);
        s.Value(ref _max);
    }
}
