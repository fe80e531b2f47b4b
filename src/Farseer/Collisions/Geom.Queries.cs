using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>Questions about single points and pairs, answered from the exact outline.</content>
public partial class Geom
{
    /// <summary>
    /// Tells if a world point is inside the geom or on its edge. For a circle its <see cref="LocalVertices"/> count, as in all queries.
    /// </summary>
    /// <param name="point">Point in world coordinates.</param>
    /// <returns>True if inside.</returns>
    public bool Collide(Vector2 point)
    {
        if (_form is null)
        {
            return false;
        }

        TransformToLocalCoordinates(ref point, out Vector2 local);
        return OutlineQuery.Contains(this, local);
    }

    /// <summary>Tells if this geom and another share a point, whatever their filters.</summary>
    /// <param name="geometry">The other geom.</param>
    /// <returns>True if they overlap or touch.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="geometry"/> is null.</exception>
    public bool Collide(Geom geometry)
    {
        Require.NotNull(geometry, nameof(geometry));
        return _form is not null
            && geometry._form is not null
            && AABB.Intersect(AABB, geometry.AABB)
            && OutlineQuery.Overlap(this, geometry);
    }

    /// <summary>
    /// Distance from a point to <see cref="LocalVertices"/>: negative inside. Exact; the polygon counts also for a circle.
    /// </summary>
    /// <param name="point">Point in geom coordinates.</param>
    /// <returns>Signed distance.</returns>
    public float GetNearestDistance(Vector2 point)
    {
        float nearest = float.MaxValue;
        for (int i = 0; i < LocalVertices.Count; i++)
        {
            float distance = OutlineQuery.Distance(point, LocalVertices[i], LocalVertices[LocalVertices.NextIndex(i)], out _);
            nearest = Math.Min(nearest, distance);
        }

        return OutlineQuery.Inside(LocalVertices, point) ? -nearest : nearest;
    }

    /// <summary>The nearest point of an edge of <see cref="LocalVertices"/> to a point.</summary>
    /// <param name="point">Point in geom coordinates.</param>
    /// <param name="index">The edge: it runs from vertex <paramref name="index"/> to the next one.</param>
    /// <returns>
    /// The nearest point, the distance (negative on the inner side of the edge) and the outward unit normal of the edge, also where the
    /// nearest point is a corner.
    /// </returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="index"/> is not an index of a vertex.</exception>
    public Feature GetNearestFeature(Vector2 point, int index)
    {
        if (index < 0 || index >= LocalVertices.Count)
        {
            throw new ArgumentOutOfRangeException(nameof(index), index, "index must be the index of a vertex.");
        }

        Vector2 a = LocalVertices[index];
        Vector2 b = LocalVertices[LocalVertices.NextIndex(index)];
        float distance = OutlineQuery.Distance(point, a, b, out Vector2 nearest);
        Vector2 normal = LocalVertices.GetEdgeNormal(index);
        float side = Vector2.Dot(point - a, normal);
        return new Feature(nearest, normal, side < 0 ? -distance : distance);
    }

    /// <summary>Looks a point up in <see cref="Grid"/>: quick, and exact only up to the cell size.</summary>
    /// <param name="localVertex">Point in geom coordinates.</param>
    /// <param name="feature">Place, normal and negative distance of a point that is inside; otherwise the default.</param>
    /// <returns>True if the point is inside.</returns>
    public bool Intersect(ref Vector2 localVertex, out Feature feature) => Grid.Intersect(ref localVertex, out feature);
}
