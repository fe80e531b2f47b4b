using System;
using System.Collections.Generic;
using System.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>Finds edges of an outline that cross or touch; edges far from each other are not compared.</summary>
internal static class EdgeCrossing
{
    /// <summary>The start point of the first edge (in outline order) that meets a later one it should not; -1: none.</summary>
    public static int First(ReadOnlySpan<Vector2> points, List<int> kept)
    {
        int count = kept.Count;
        var corner = new Vector2[count];
        for (int i = 0; i < count; i++)
        {
            corner[i] = points[kept[i]];
        }

        int first = First(corner);
        return first < 0 ? -1 : kept[first];
    }

    /// <summary>As above, of the outline of all points.</summary>
    public static int First(Vector2[] corner)
    {
        int count = corner.Length;
        var min = new Vector2[count];
        var max = new Vector2[count];
        for (int i = 0; i < count; i++)
        {
            Vector2 next = corner[(i + 1) % count];
            min[i] = Vector2.Min(corner[i], next);
            max[i] = Vector2.Max(corner[i], next);
        }

        var tree = new OutlineTree(min, max);
        for (int i = 0; i < count; i++)
        {
            if (tree.Any(new Probe(corner, i)))
            {
                return i;
            }
        }

        return -1;
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
        return Outline.Overlap(Vector2.Min(a0, a1), Vector2.Max(a0, a1), Vector2.Min(b0, b1), Vector2.Max(b0, b1))
            && Straddles(a0, a1, b0, b1) && Straddles(b0, b1, a0, a1);
    }

    // On overlapping boxes both tests together are exact, also for collinear edges (all signs zero).
    private static bool Straddles(Vector2 a0, Vector2 a1, Vector2 b0, Vector2 b1)
    {
        double s = Outline.Cross(a0, a1, b0);
        double t = Outline.Cross(a0, a1, b1);
        return (s <= 0 && t >= 0) || (s >= 0 && t <= 0);
    }

    /// <summary>Looks for edges after one that meet it.</summary>
    private readonly struct Probe : IOutlineProbe
    {
        private readonly Vector2[] _corner;
        private readonly int _edge;
        private readonly Vector2 _from;
        private readonly Vector2 _to;

        public Probe(Vector2[] corner, int edge)
        {
            _corner = corner;
            _edge = edge;
            _from = corner[edge];
            _to = corner[(edge + 1) % corner.Length];
        }

        public bool Reaches(Vector2 min, Vector2 max, int last) =>
            last > _edge
            && Outline.Overlap(Vector2.Min(_from, _to), Vector2.Max(_from, _to), min, max)
            && Outline.LargestCross(_from, _to, min, max) >= 0
            && Outline.LargestCross(_to, _from, min, max) >= 0;

        public bool Hits(int part) => part > _edge && Meet(_corner, _edge, part);
    }
}
