using System.Collections.Generic;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>Where lines meet lines, boxes, outlines and geoms.</summary>
/// <remarks>The ends of a segment belong to it. Lines that are parallel, also those that lie on each other, do not meet.</remarks>
/// <example>
/// <code>
/// bool cross = CollisionHelper.LineIntersect(
///     new Vector2(-1, 0), new Vector2(1, 0), new Vector2(0, -1), new Vector2(0, 1), true, true, 1e-6f, out Vector2 point);
/// </code>
/// </example>
public static class CollisionHelper
{
    /// <summary>Tells whether two numbers differ by no more than a tolerance.</summary>
    /// <param name="a">One number.</param>
    /// <param name="b">The other number.</param>
    /// <param name="delta">The largest difference; 0 or more.</param>
    /// <returns>True if they do.</returns>
    public static bool FloatEquals(float a, float b, float delta) => FloatInRange(a, b - delta, b + delta);

    /// <summary>Tells whether a number is within a range, its ends included.</summary>
    /// <param name="a">The number.</param>
    /// <param name="min">The lower end.</param>
    /// <param name="max">The upper end.</param>
    /// <returns>True if it is.</returns>
    public static bool FloatInRange(float a, float min, float max) => a >= min && a <= max;

    /// <summary>Finds the point at which two segments meet.</summary>
    /// <param name="p1">One end of the first segment.</param>
    /// <param name="p2">The other end of the first segment.</param>
    /// <param name="p3">One end of the second segment.</param>
    /// <param name="p4">The other end of the second segment.</param>
    /// <param name="point">The point; (0, 0) if they do not meet.</param>
    /// <returns>True if they meet.</returns>
    public static bool LineIntersect(Vector2 p1, Vector2 p2, Vector2 p3, Vector2 p4, out Vector2 point) =>
        Meet(p1, p2, p3, p4, true, true, 0f, out point);

    /// <summary>Finds the point at which two segments meet.</summary>
    /// <param name="p1">One end of the first segment; not changed.</param>
    /// <param name="p2">The other end of the first segment; not changed.</param>
    /// <param name="p3">One end of the second segment; not changed.</param>
    /// <param name="p4">The other end of the second segment; not changed.</param>
    /// <param name="point">The point; (0, 0) if they do not meet.</param>
    /// <returns>True if they meet.</returns>
    public static bool LineIntersect(ref Vector2 p1, ref Vector2 p2, ref Vector2 p3, ref Vector2 p4, out Vector2 point) =>
        Meet(p1, p2, p3, p4, true, true, 0f, out point);

    /// <summary>Finds the point at which two lines or segments meet.</summary>
    /// <param name="p1">One point of the first line.</param>
    /// <param name="p2">Another point of the first line.</param>
    /// <param name="p3">One point of the second line.</param>
    /// <param name="p4">Another point of the second line.</param>
    /// <param name="firstIsSegment">True if the first line ends at its points.</param>
    /// <param name="secondIsSegment">True if the second line ends at its points.</param>
    /// <param name="floatTolerance">Lines count as parallel when the vector product of p2 - p1 and p4 - p3 is not larger than
    /// this, in square world units; 0 or more.</param>
    /// <param name="point">The point; (0, 0) if they do not meet.</param>
    /// <returns>True if they meet.</returns>
    /// <exception cref="System.ArgumentOutOfRangeException"><paramref name="floatTolerance"/> is negative or not finite.</exception>
    public static bool LineIntersect(
        Vector2 p1,
        Vector2 p2,
        Vector2 p3,
        Vector2 p4,
        bool firstIsSegment,
        bool secondIsSegment,
        float floatTolerance,
        out Vector2 point)
    {
        Require.NotNegative(floatTolerance, nameof(floatTolerance));
        return Meet(p1, p2, p3, p4, firstIsSegment, secondIsSegment, floatTolerance, out point);
    }

    /// <summary>Finds the point at which two lines or segments meet.</summary>
    /// <param name="p1">One point of the first line; not changed.</param>
    /// <param name="p2">Another point of the first line; not changed.</param>
    /// <param name="p3">One point of the second line; not changed.</param>
    /// <param name="p4">Another point of the second line; not changed.</param>
    /// <param name="firstIsSegment">True if the first line ends at its points.</param>
    /// <param name="secondIsSegment">True if the second line ends at its points.</param>
    /// <param name="floatTolerance">Lines count as parallel when the vector product of p2 - p1 and p4 - p3 is not larger than
    /// this, in square world units; 0 or more.</param>
    /// <param name="point">The point; (0, 0) if they do not meet.</param>
    /// <returns>True if they meet.</returns>
    /// <exception cref="System.ArgumentOutOfRangeException"><paramref name="floatTolerance"/> is negative or not finite.</exception>
    public static bool LineIntersect(
        ref Vector2 p1,
        ref Vector2 p2,
        ref Vector2 p3,
        ref Vector2 p4,
        bool firstIsSegment,
        bool secondIsSegment,
        float floatTolerance,
        out Vector2 point) =>
        LineIntersect(p1, p2, p3, p4, firstIsSegment, secondIsSegment, floatTolerance, out point);

    /// <summary>Finds the points at which a segment meets the sides of a box.</summary>
    /// <param name="p1">One end of the segment; not changed.</param>
    /// <param name="p2">The other end of the segment; not changed.</param>
    /// <param name="aabb">The box.</param>
    /// <param name="points">The points are added here, in the order of the box's sides, none twice; a null list is replaced
    /// by a new one.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="aabb"/> is null.</exception>
    public static void LineSegmentAABBIntersect(ref Vector2 p1, ref Vector2 p2, AABB aabb, ref List<Vector2> points) =>
        LineSegmentVerticesIntersect(ref p1, ref p2, Require.NotNull(aabb, nameof(aabb)).GetVertices(), ref points);

    /// <summary>Finds the points at which a segment meets the edges of an outline.</summary>
    /// <param name="p1">One end of the segment; not changed.</param>
    /// <param name="p2">The other end of the segment; not changed.</param>
    /// <param name="vertices">The outline, in the coordinates of the segment.</param>
    /// <param name="points">The points are added here, in the order of the edges, none twice; a null list is replaced by a
    /// new one.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="vertices"/> is null.</exception>
    public static void LineSegmentVerticesIntersect(
        ref Vector2 p1,
        ref Vector2 p2,
        Vertices vertices,
        ref List<Vector2> points)
    {
        Require.NotNull(vertices, nameof(vertices));
        points ??= new List<Vector2>();
        for (var i = 0; i < vertices.Count; i++)
        {
            var end = vertices[vertices.NextIndex(i)];
            if (Meet(p1, p2, vertices[i], end, true, true, 0f, out var point) && !points.Contains(point))
            {
                points.Add(point);
            }
        }
    }

    /// <summary>Finds the points at which a segment meets a geom.</summary>
    /// <param name="p1">One end of the segment, in world coordinates.</param>
    /// <param name="p2">The other end of the segment, in world coordinates.</param>
    /// <param name="geom">The geom; its vertices count, also those of a circle.</param>
    /// <param name="detectUsingAABB">True to take the geom's box instead of its vertices: quicker, and less exact.</param>
    /// <param name="lineIntersectInfoList">If there are such points, one entry is added here; a null list is replaced by a new
    /// one.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="geom"/> is null.</exception>
    public static void LineSegmentGeomIntersect(
        Vector2 p1,
        Vector2 p2,
        Geom geom,
        bool detectUsingAABB,
        ref List<LineIntersectInfo> lineIntersectInfoList)
    {
        // The operator of a geom compares numbers; null has none.
        Require.NotNull<object>(geom, nameof(geom));
        lineIntersectInfoList ??= new List<LineIntersectInfo>();
        var points = new List<Vector2>();
        if (detectUsingAABB)
        {
            LineSegmentAABBIntersect(ref p1, ref p2, geom.AABB, ref points);
        }
        else
        {
            LineSegmentVerticesIntersect(ref p1, ref p2, geom.WorldVertices, ref points);
        }

        if (points.Count > 0)
        {
            lineIntersectInfoList.Add(new LineIntersectInfo(geom, points));
        }
    }

    /// <summary>Finds the points at which a segment meets a geom.</summary>
    /// <param name="p1">One end of the segment, in world coordinates; not changed.</param>
    /// <param name="p2">The other end of the segment, in world coordinates; not changed.</param>
    /// <param name="geom">The geom; its vertices count, also those of a circle.</param>
    /// <param name="detectUsingAABB">True to take the geom's box instead of its vertices: quicker, and less exact.</param>
    /// <param name="lineIntersectInfoList">If there are such points, one entry is added here; a null list is replaced by a new
    /// one.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="geom"/> is null.</exception>
    public static void LineSegmentGeomIntersect(
        ref Vector2 p1,
        ref Vector2 p2,
        Geom geom,
        bool detectUsingAABB,
        ref List<LineIntersectInfo> lineIntersectInfoList) =>
        LineSegmentGeomIntersect(p1, p2, geom, detectUsingAABB, ref lineIntersectInfoList);

    /// <summary>
    /// p1 + s (p2 - p1) = p3 + t (p4 - p3), solved for s and t by vector products; in double, where the differences of floats
    /// are exact, so that segments that share an end meet there without a tolerance.
    /// </summary>
    private static bool Meet(
        Vector2 p1,
        Vector2 p2,
        Vector2 p3,
        Vector2 p4,
        bool firstIsSegment,
        bool secondIsSegment,
        float tolerance,
        out Vector2 point)
    {
        double ax = (double)p2.X - p1.X, ay = (double)p2.Y - p1.Y;
        double bx = (double)p4.X - p3.X, by = (double)p4.Y - p3.Y;
        double cx = (double)p3.X - p1.X, cy = (double)p3.Y - p1.Y;
        var product = (ax * by) - (ay * bx);
        var s = ((cx * by) - (cy * bx)) / product;
        var t = ((cx * ay) - (cy * ax)) / product;
        var isParallel = !(System.Math.Abs(product) > tolerance);
        if (isParallel || (firstIsSegment && !(s >= 0d && s <= 1d)) || (secondIsSegment && !(t >= 0d && t <= 1d)))
        {
            point = Vector2.Zero;
            return false;
        }

        point = new Vector2((float)(p1.X + (s * ax)), (float)(p1.Y + (s * ay)));
        return true;
    }
}
