using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>What is wrong with the points of an outline.</summary>
internal enum OutlineProblem
{
    None,

    /// <summary>A coordinate is NaN or infinite.</summary>
    NotFinite,

    /// <summary>Fewer than three distinct points.</summary>
    TooFewPoints,

    /// <summary>All points lie on one line.</summary>
    NoArea,

    /// <summary>Two edges cross, touch or run back over each other.</summary>
    SelfIntersecting,
}

/// <summary>Checks and tidies closed outlines. All tolerances are relative to the outline's size and its coordinates.</summary>
internal static class Outline
{
    /// <summary>Share of the outline's size below which a bend or a step is taken for rounding.</summary>
    private const double SizeTolerance = 2e-6;

    /// <summary>Two ulp of the largest coordinate: what a point far from the origin cannot express anyway.</summary>
    private const double CoordinateTolerance = 2.4e-7;

    /// <summary>
    /// Finds the first fault. <paramref name="index"/> is the point, or the point where the faulty edge starts; -1 if the fault
    /// is of the whole outline.
    /// </summary>
    public static OutlineProblem Check(ReadOnlySpan<Vector2> points, out int index)
    {
        index = -1;
        for (int i = 0; i < points.Length; i++)
        {
            if (!FloatBits.IsFinite(points[i].X) || !FloatBits.IsFinite(points[i].Y))
            {
                index = i;
                return OutlineProblem.NotFinite;
            }
        }

        double tolerance = Tolerance(points);
        List<int> kept = WithoutRepeats(points, tolerance);
        if (kept.Count < 3)
        {
            return OutlineProblem.TooFewPoints;
        }

        if (IsLine(points, kept, tolerance))
        {
            return OutlineProblem.NoArea;
        }

        RemoveStraight(points, kept, tolerance);
        if (kept.Count < 3)
        {
            return OutlineProblem.NoArea;
        }

        index = EdgeCrossing.First(points, kept);
        return index >= 0 ? OutlineProblem.SelfIntersecting : OutlineProblem.None;
    }

    /// <summary>The outline in positive order, without repeated points and without points on a straight edge.</summary>
    public static Vector2[] Tidy(ReadOnlySpan<Vector2> points)
    {
        double tolerance = Tolerance(points);
        List<int> kept = WithoutRepeats(points, tolerance);
        RemoveStraight(points, kept, tolerance);
        var result = new Vector2[kept.Count];
        for (int i = 0; i < result.Length; i++)
        {
            result[i] = points[kept[i]];
        }

        if (MassProperties.SignedArea(result) < 0)
        {
            Array.Reverse(result);
        }

        return result;
    }

    public static double Cross(Vector2 a, Vector2 b, Vector2 c) =>
        (((double)b.X - a.X) * ((double)c.Y - a.Y)) - (((double)b.Y - a.Y) * ((double)c.X - a.X));

    /// <summary>
    /// The largest <see cref="Cross"/> of any c within a box: below 0 if all of it is right of the way from a to b. Each step of the sum
    /// only rises, or only falls, with a coordinate, also as it is rounded: none of the box has a larger one.
    /// </summary>
    public static double LargestCross(Vector2 a, Vector2 b, Vector2 min, Vector2 max)
    {
        double x = (double)b.X - a.X;
        double y = (double)b.Y - a.Y;
        return (x * ((double)(x > 0 ? max.Y : min.Y) - a.Y)) - (y * ((double)(y > 0 ? min.X : max.X) - a.X));
    }

    /// <summary>Whether two boxes have a point in common.</summary>
    public static bool Overlap(Vector2 minA, Vector2 maxA, Vector2 minB, Vector2 maxB) =>
        maxA.X >= minB.X && maxB.X >= minA.X && maxA.Y >= minB.Y && maxB.Y >= minA.Y;

    /// <summary>True if the tidied outline bends one way only.</summary>
    public static bool IsConvex(Vector2[] outline)
    {
        for (int i = 0; i < outline.Length; i++)
        {
            if (Cross(outline[i], outline[(i + 1) % outline.Length], outline[(i + 2) % outline.Length]) <= 0)
            {
                return false;
            }
        }

        return true;
    }

    private static double Tolerance(ReadOnlySpan<Vector2> points)
    {
        double minX = double.MaxValue;
        double minY = double.MaxValue;
        double maxX = -double.MaxValue;
        double maxY = -double.MaxValue;
        foreach (Vector2 p in points)
        {
            minX = Math.Min(minX, p.X);
            minY = Math.Min(minY, p.Y);
            maxX = Math.Max(maxX, p.X);
            maxY = Math.Max(maxY, p.Y);
        }

        double size = Math.Max(maxX - minX, maxY - minY);
        double coordinate = Math.Max(Math.Max(Math.Abs(minX), Math.Abs(maxX)), Math.Max(Math.Abs(minY), Math.Abs(maxY)));
        return Math.Max(SizeTolerance * size, CoordinateTolerance * coordinate);
    }

    private static List<int> WithoutRepeats(ReadOnlySpan<Vector2> points, double tolerance)
    {
        var kept = new List<int>(points.Length);
        for (int i = 0; i < points.Length; i++)
        {
            if (kept.Count == 0 || Distance(points[kept[kept.Count - 1]], points[i]) > tolerance)
            {
                kept.Add(i);
            }
        }

        while (kept.Count > 1 && Distance(points[kept[kept.Count - 1]], points[kept[0]]) <= tolerance)
        {
            kept.RemoveAt(kept.Count - 1);
        }

        return kept;
    }

    // Only points between their neighbours go; the tip of a spike stays, to be reported as an edge that runs back.
    private static void RemoveStraight(ReadOnlySpan<Vector2> points, List<int> kept, double tolerance)
    {
        int i = 0;
        int unchanged = 0;
        while (kept.Count > 2 && unchanged < kept.Count)
        {
            i %= kept.Count;
            int previous = i == 0 ? kept.Count - 1 : i - 1;
            Vector2 a = points[kept[previous]];
            Vector2 v = points[kept[i]];
            Vector2 b = points[kept[(i + 1) % kept.Count]];
            bool between = Dot(a, v, b) > 0;
            if (between && Math.Abs(Cross(a, b, v)) <= tolerance * Distance(a, b))
            {
                kept.RemoveAt(i);
                i = i == 0 ? kept.Count - 1 : i - 1;
                unchanged = 0;
            }
            else
            {
                i++;
                unchanged++;
            }
        }
    }

    private static bool IsLine(ReadOnlySpan<Vector2> points, List<int> kept, double tolerance)
    {
        int far = kept[0];
        foreach (int i in kept)
        {
            far = Distance(points[kept[0]], points[i]) > Distance(points[kept[0]], points[far]) ? i : far;
        }

        double length = Distance(points[kept[0]], points[far]);
        foreach (int i in kept)
        {
            if (Math.Abs(Cross(points[kept[0]], points[far], points[i])) > tolerance * length)
            {
                return false;
            }
        }

        return true;
    }

    private static double Distance(Vector2 a, Vector2 b)
    {
        double x = (double)b.X - a.X;
        double y = (double)b.Y - a.Y;
        return Math.Sqrt((x * x) + (y * y));
    }

    private static double Dot(Vector2 a, Vector2 v, Vector2 b) =>
        (((double)v.X - a.X) * ((double)b.X - v.X)) + (((double)v.Y - a.Y) * ((double)b.Y - v.Y));
}
