using System;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>Area, centroid, inertia and order. All sums are taken in double precision about the first vertex, so that the
/// results are as good far from the origin as near to it.</content>
public partial class Vertices
{
    /// <summary>The area within the outline.</summary>
    /// <returns>The area in square world units; 0 for fewer than 3 vertices.</returns>
    public float GetArea() => (float)Math.Abs(SignedArea());

    /// <summary>The area within the outline, with a sign for its order.</summary>
    /// <returns>The area in square world units: positive when the order leads from the x axis towards the y axis, negative after
    /// <see cref="ForceCounterClockWiseOrder"/>.</returns>
    public float GetSignedArea() => (float)SignedArea();

    /// <summary>
    /// Tells whether the vertices are in the order that geoms use: counter-clockwise as seen with y pointing down, which is a
    /// negative signed area (<see cref="GetSignedArea"/>).
    /// </summary>
    /// <returns>True if they are; false if they are in the other order or the outline has no area.</returns>
    public bool IsCounterClockWise() => SignedArea() < 0d;

    /// <summary>Reverses the list if its order is not the one geoms use (<see cref="IsCounterClockWise"/>).</summary>
    /// <remarks>A list without area is left as it is. Geoms do this to the list they are given.</remarks>
    public void ForceCounterClockWiseOrder()
    {
        if (SignedArea() > 0d)
        {
            Reverse();
        }
    }

    /// <summary>The centre of mass of the area within the outline.</summary>
    /// <returns>The centroid, in the coordinates of the vertices.</returns>
    /// <exception cref="InvalidOperationException">The outline has fewer than 3 vertices, no area, or a vertex that is not
    /// finite.</exception>
    public Vector2 GetCentroid()
    {
        Centroid(out var x, out var y);
        return new Vector2((float)x, (float)y);
    }

    /// <summary>The centre of mass of the area within the outline, for a program that knows the area already.</summary>
    /// <param name="area">The area as <see cref="GetArea"/> gives it; above 0. The centroid is inversely proportional to it, so
    /// another value gives another point.</param>
    /// <returns>The centroid, in the coordinates of the vertices.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="area"/> is not a finite number above 0.</exception>
    /// <exception cref="InvalidOperationException">The outline has fewer than 3 vertices, no area, or a vertex that is not
    /// finite.</exception>
    public Vector2 GetCentroid(float area)
    {
        Require.Positive(area, nameof(area));
        Centroid(out var x, out var y);
        var ratio = Math.Abs(SignedArea()) / area;
        return new Vector2((float)(x * ratio), (float)(y * ratio));
    }

    /// <summary>The moment of inertia about the centroid of a plate of this outline and mass 1.</summary>
    /// <returns>The moment of inertia per mass, in square world units; multiply it by the mass.</returns>
    /// <remarks>
    /// Version 2.0.1 counted every triangle between the centroid and an edge as positive, which made the result too small or
    /// too large for outlines that are not all visible from their centroid; here it is right for every simple polygon.
    /// </remarks>
    /// <exception cref="InvalidOperationException">The outline has fewer than 3 vertices, no area, or a vertex that is not
    /// finite.</exception>
    public float GetMomentOfInertia() => MomentOfInertia(absoluteTriangles: false);

    /// <summary>The moment of inertia as version 2.0.1 has it: the absolute value of every triangle.</summary>
    internal float GetMomentOfInertiaOfAbsoluteTriangles() => MomentOfInertia(absoluteTriangles: true);

    private double SignedArea()
    {
        if (Count < 3)
        {
            return 0d;
        }

        var origin = this[0];
        var sum = 0d;
        for (var i = 1; i < Count - 1; i++)
        {
            sum += Cross(origin, this[i], this[i + 1]);
        }

        return 0.5 * sum;
    }

    /// <summary>Twice the signed area of the triangle of three points. The differences of floats are exact in double.</summary>
    private static double Cross(Vector2 origin, Vector2 a, Vector2 b) =>
        (((double)a.X - origin.X) * ((double)b.Y - origin.Y)) - (((double)a.Y - origin.Y) * ((double)b.X - origin.X));

    private void Centroid(out double x, out double y)
    {
        if (Count < 3)
        {
            throw new InvalidOperationException($"A centroid needs at least 3 vertices; there are {Count}.");
        }

        var origin = this[0];
        var area = 0d;
        double sumX = 0d, sumY = 0d;
        for (var i = 1; i < Count - 1; i++)
        {
            var cross = Cross(origin, this[i], this[i + 1]);
            area += cross;
            sumX += cross * (((double)this[i].X - origin.X) + ((double)this[i + 1].X - origin.X));
            sumY += cross * (((double)this[i].Y - origin.Y) + ((double)this[i + 1].Y - origin.Y));
        }

        x = origin.X + (sumX / (3d * area));
        y = origin.Y + (sumY / (3d * area));
        if (!(Math.Abs(area) > 0d) || double.IsNaN(x + y) || double.IsInfinity(x + y))
        {
            throw new InvalidOperationException(
                $"The outline of {Count} vertices has no centroid: its area is {0.5 * area}. See CheckPolygon.");
        }
    }

    private float MomentOfInertia(bool absoluteTriangles)
    {
        Centroid(out var x, out var y);
        double area = 0d, sum = 0d;
        for (var i = 0; i < Count; i++)
        {
            var next = NextIndex(i);
            var ax = this[i].X - x;
            var ay = this[i].Y - y;
            var bx = this[next].X - x;
            var by = this[next].Y - y;
            var cross = (ax * by) - (ay * bx);
            if (absoluteTriangles)
            {
                cross = Math.Abs(cross);
            }

            area += cross;
            sum += cross * ((ax * ax) + (ay * ay) + (ax * bx) + (ay * by) + (bx * bx) + (by * by));
        }

        return (float)(sum / (6d * area));
    }
}
