using System;
using System.Collections.Generic;
using System.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>Finds edges of an outline that cross or touch: a sweep along x, so far edges are never compared.</summary>
internal static class EdgeCrossing
{
    /// <summary>The start point of the first edge (in outline order) that meets a later one it should not; -1: none.</summary>
    public static int First(ReadOnlySpan<Vector2> points, List<int> kept)
    {
        int count = kept.Count;
        var corner = new Vector2[count];
        var left = new float[count];
        var order = new int[count];
        for (int i = 0; i < count; i++)
        {
            corner[i] = points[kept[i]];
            order[i] = i;
        }

        for (int i = 0; i < count; i++)
        {
            left[i] = Math.Min(corner[i].X, corner[(i + 1) % count].X);
        }

        Array.Sort(left, order);
        int first = count;
        for (int i = 0; i < count; i++)
        {
            int a = order[i];
            float right = Math.Max(corner[a].X, corner[(a + 1) % count].X);
            for (int j = i + 1; j < count && left[j] <= right; j++)
            {
                int b = order[j];
                if (Math.Min(a, b) < first && Meet(corner, a, b))
                {
                    first = Math.Min(a, b);
                }
            }
        }

        return first < count ? kept[first] : -1;
    }

    private static bool Meet(Vector2[] corner, int a, int b)
    {
        int count = corner.Length;
        if ((a + 1) % count == b || (b + 1) % count == a)
        {
            // Neighbours share a point by right; they may only not run back over each other.
            int start = (a + 1) % count == b ? a : b;
            Vector2 p = corner[start];
            Vector2 v = corner[(start + 1) % count];
            Vector2 q = corner[(start + 2) % count];
            return Outline.Cross(p, v, q) == 0 && Vector2.Dot(v - p, q - v) < 0;
        }

        Vector2 a0 = corner[a];
        Vector2 a1 = corner[(a + 1) % count];
        Vector2 b0 = corner[b];
        Vector2 b1 = corner[(b + 1) % count];
        if (Math.Max(a0.Y, a1.Y) < Math.Min(b0.Y, b1.Y) || Math.Max(b0.Y, b1.Y) < Math.Min(a0.Y, a1.Y))
        {
            return false;
        }

        return Straddles(a0, a1, b0, b1) && Straddles(b0, b1, a0, a1);
    }

    // On overlapping boxes both tests together are exact, also for collinear edges (all signs zero).
    private static bool Straddles(Vector2 a0, Vector2 a1, Vector2 b0, Vector2 b1)
    {
        double s = Outline.Cross(a0, a1, b0);
        double t = Outline.Cross(a0, a1, b1);
        return (s <= 0 && t >= 0) || (s >= 0 && t <= 0);
    }
}
