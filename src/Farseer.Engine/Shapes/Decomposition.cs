using System;
using System.Collections.Generic;
using System.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>
/// Cuts a simple outline into convex pieces whose corners are corners of the outline: ears are cut off, the best shaped first,
/// then every cut that is not needed for convexity is taken back (Hertel and Mehlhorn: at most four times the least number of
/// pieces, in practice near it). New points inside the outline would save pieces but put corners where the user has none.
/// </summary>
internal sealed class Decomposition
{
    /// <summary>Sine of the least bend a corner of a merged piece must have: straight corners would double an edge.</summary>
    private const double LeastBend = 1e-4;

    private readonly Vector2[] _outline;
    private readonly List<int[]> _triangles = new List<int[]>();
    private readonly List<(int From, int To)> _cuts = new List<(int From, int To)>();

    private Decomposition(Vector2[] outline) => _outline = outline;

    /// <summary>The pieces as lists of outline indices in positive order; <paramref name="outline"/> is tidy and positive.</summary>
    public static List<List<int>> Split(Vector2[] outline)
    {
        var work = new Decomposition(outline);
        work.CutEars();
        return work.Merge();
    }

    /// <summary>Triangles as indices in positive order, three each; <paramref name="outline"/> is tidy and positive.</summary>
    public static List<int[]> Triangles(Vector2[] outline)
    {
        var work = new Decomposition(outline);
        work.CutEars();
        return work._triangles;
    }

    private void CutEars()
    {
        int count = _outline.Length;
        var ring = new List<int>(count);
        var quality = new List<double>(count);
        for (int i = 0; i < count; i++)
        {
            ring.Add(i);
            quality.Add(0);
        }

        for (int i = 0; i < count; i++)
        {
            quality[i] = EarQuality(ring, i);
        }

        while (ring.Count > 3)
        {
            int best = 0;
            for (int i = 1; i < ring.Count; i++)
            {
                best = quality[i] > quality[best] ? i : best;
            }

            int previous = ring[(best + ring.Count - 1) % ring.Count];
            int next = ring[(best + 1) % ring.Count];
            _triangles.Add(new[] { previous, ring[best], next });
            _cuts.Add((previous, next));
            ring.RemoveAt(best);
            quality.RemoveAt(best);
            int before = (best + ring.Count - 1) % ring.Count;
            int after = best % ring.Count;
            quality[before] = EarQuality(ring, before);
            quality[after] = EarQuality(ring, after);
        }

        _triangles.Add(ring.ToArray());
    }

    // Twice the area over the square of the longest side; not positive: no ear. Should rounding leave no ear at all, the
    // caller still takes the least bad corner, so it always ends.
    private double EarQuality(List<int> ring, int at)
    {
        int ia = ring[(at + ring.Count - 1) % ring.Count];
        int ib = ring[at];
        int ic = ring[(at + 1) % ring.Count];
        Vector2 a = _outline[ia];
        Vector2 b = _outline[ib];
        Vector2 c = _outline[ic];
        double area = Outline.Cross(a, b, c);
        double longest = Math.Max(Square(a, b), Math.Max(Square(b, c), Square(c, a)));
        double quality = area / longest;
        if (area <= 0)
        {
            return quality - 1;
        }

        foreach (int i in ring)
        {
            if (i == ia || i == ib || i == ic)
            {
                continue;
            }

            Vector2 p = _outline[i];
            if (Outline.Cross(a, b, p) >= 0 && Outline.Cross(b, c, p) >= 0 && Outline.Cross(c, a, p) >= 0)
            {
                return -1;
            }
        }

        return quality;
    }

    private List<List<int>> Merge()
    {
        var pieces = new List<List<int>?>();
        var owner = new int[_triangles.Count];
        for (int i = 0; i < _triangles.Count; i++)
        {
            pieces.Add(new List<int>(_triangles[i]));
            owner[i] = i;
        }

        // Cut i bounds triangle i from the side of the rest, which is a later triangle.
        for (int i = _cuts.Count - 1; i >= 0; i--)
        {
            int mine = Owner(owner, i);
            int other = -1;
            for (int j = i + 1; j < _triangles.Count && other < 0; j++)
            {
                int[] t = _triangles[j];
                for (int k = 0; k < 3; k++)
                {
                    if (t[k] == _cuts[i].From && t[(k + 1) % 3] == _cuts[i].To)
                    {
                        other = Owner(owner, j);
                    }
                }
            }

            List<int>? joined = other < 0 ? null : Join(pieces[mine]!, pieces[other]!, _cuts[i].From, _cuts[i].To);
            if (joined != null)
            {
                pieces[other] = joined;
                pieces[mine] = null;
                owner[mine] = other;
            }
        }

        var result = new List<List<int>>();
        foreach (List<int>? piece in pieces)
        {
            if (piece != null)
            {
                result.Add(piece);
            }
        }

        return result;
    }

    private static int Owner(int[] owner, int index)
    {
        while (owner[index] != index)
        {
            index = owner[index];
        }

        return index;
    }

    // "mine" holds the edge to -> from, "other" the edge from -> to.
    private List<int>? Join(List<int> mine, List<int> other, int from, int to)
    {
        int m = mine.IndexOf(from);
        int o = other.IndexOf(to);
        var joined = new List<int>(mine.Count + other.Count - 2);
        for (int i = 0; i < mine.Count; i++)
        {
            joined.Add(mine[(m + i) % mine.Count]);
        }

        for (int i = 1; i < other.Count - 1; i++)
        {
            joined.Add(other[(o + i) % other.Count]);
        }

        return Bends(joined, 0) && Bends(joined, mine.Count - 1) ? joined : null;
    }

    private bool Bends(List<int> ring, int at)
    {
        Vector2 a = _outline[ring[(at + ring.Count - 1) % ring.Count]];
        Vector2 b = _outline[ring[at]];
        Vector2 c = _outline[ring[(at + 1) % ring.Count]];
        double cross = Outline.Cross(a, b, c);
        return cross > LeastBend * Math.Sqrt(Square(a, b) * Square(b, c));
    }

    private static double Square(Vector2 a, Vector2 b)
    {
        double x = (double)b.X - a.X;
        double y = (double)b.Y - a.Y;
        return (x * x) + (y * y);
    }
}
