using System;
using System.Collections.Generic;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <content>Simpler outlines from given ones.</content>
public partial class Vertices
{
    /// <summary>An order of vertices, as seen with y pointing down. (Of neighbouring versions of the original.)</summary>
    public enum WindingOrder
    {
        /// <summary>From the x axis towards the y axis: a positive signed area.</summary>
        Clockwise,

        /// <summary>The other way, which geoms use: see <see cref="IsCounterClockWise"/>.</summary>
        CounterClockwise,
    }

    /// <summary>
    /// The smallest convex outline around the vertices: the shape of a rubber band. Vertices on its edges are left out.
    /// (An addition to the original.)
    /// </summary>
    /// <returns>A new list in the order of <see cref="ForceCounterClockWiseOrder"/>; fewer than three vertices if all lie on one
    /// line.</returns>
    public Vertices GetConvexHull()
    {
        var points = new List<Vector2>(this);
        points.Sort((a, b) => a.X != b.X ? a.X.CompareTo(b.X) : a.Y.CompareTo(b.Y));
        for (int i = points.Count - 1; i > 0; i--)
        {
            if (points[i] == points[i - 1])
            {
                points.RemoveAt(i);
            }
        }

        var hull = new Vertices();
        AddChain(hull, points, 0);
        points.Reverse();
        int lower = Math.Max(0, hull.Count - 1);
        if (hull.Count > 1)
        {
            hull.RemoveAt(hull.Count - 1);
        }

        AddChain(hull, points, lower);

        // The last point is the first again.
        if (hull.Count > 1)
        {
            hull.RemoveAt(hull.Count - 1);
        }

        return hull;
    }

    /// <summary>
    /// The outline with fewer vertices: every vertex left out is no farther than the tolerance from an edge of the new outline. With 0
    /// only vertices in line with their neighbours go. (An addition to the original.)
    /// </summary>
    /// <param name="tolerance">Largest distance, a length; finite and at least 0.</param>
    /// <returns>A new list in the same order. A large tolerance can make an outline cross itself: see <see cref="CheckPolygon"/>.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="tolerance"/> is negative or not finite.</exception>
    public Vertices Simplify(float tolerance)
    {
        Require.NotNegative(tolerance, nameof(tolerance));
        if (Count < 4)
        {
            return new Vertices(this);
        }

        // Two vertices that surely stay: the leftmost, and the one farthest from it.
        int first = 0;
        for (int i = 1; i < Count; i++)
        {
            if (this[i].X < this[first].X || (this[i].X == this[first].X && this[i].Y < this[first].Y))
            {
                first = i;
            }
        }

        int second = first;
        for (int i = 0; i < Count; i++)
        {
            if (Vector2.DistanceSquared(this[i], this[first]) > Vector2.DistanceSquared(this[second], this[first]))
            {
                second = i;
            }
        }

        var keep = new bool[Count];
        keep[first] = keep[second] = true;
        KeepBetween(first, second, tolerance, keep);
        KeepBetween(second, first, tolerance, keep);
        var result = new Vertices();
        for (int i = 0; i < Count; i++)
        {
            if (keep[i])
            {
                result.Add(this[i]);
            }
        }

        return result;
    }

    private static void AddChain(Vertices hull, List<Vector2> points, int floor)
    {
        foreach (Vector2 point in points)
        {
            while (hull.Count >= floor + 2 && Turn(hull[hull.Count - 2], hull[hull.Count - 1], point) >= 0)
            {
                hull.RemoveAt(hull.Count - 1);
            }

            hull.Add(point);
        }
    }

    private static double Turn(Vector2 a, Vector2 b, Vector2 c) =>
        (((double)b.X - a.X) * ((double)c.Y - a.Y)) - (((double)b.Y - a.Y) * ((double)c.X - a.X));

    /// <summary>Keeps the vertex farthest from the line of two kept ones if it is too far, and so on in both halves.</summary>
    private void KeepBetween(int from, int to, float tolerance, bool[] keep)
    {
        var open = new Stack<(int From, int To)>();
        open.Push((from, to));
        while (open.Count > 0)
        {
            (int start, int end) = open.Pop();
            int farthest = -1;
            double most = tolerance;
            for (int i = NextIndex(start); i != end; i = NextIndex(i))
            {
                double distance = DistanceToSegment(this[i], this[start], this[end]);
                if (distance > most)
                {
                    most = distance;
                    farthest = i;
                }
            }

            if (farthest >= 0)
            {
                keep[farthest] = true;
                open.Push((start, farthest));
                open.Push((farthest, end));
            }
        }
    }

    private static double DistanceToSegment(Vector2 point, Vector2 a, Vector2 b)
    {
        double dx = (double)b.X - a.X;
        double dy = (double)b.Y - a.Y;
        double px = (double)point.X - a.X;
        double py = (double)point.Y - a.Y;
        double square = (dx * dx) + (dy * dy);
        double along = square > 0 ? Math.Min(1, Math.Max(0, ((px * dx) + (py * dy)) / square)) : 0;
        px -= along * dx;
        py -= along * dy;
        return Math.Sqrt((px * px) + (py * py));
    }
}
