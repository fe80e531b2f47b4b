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
    private readonly int _count;
    private readonly int[] _previous;
    private readonly int[] _next;
    private readonly OutlineTree _corners;
    private readonly BestCorner _best;

    /// <summary>Triangle i cuts its second corner off: between its third and its first corner the rest goes on.</summary>
    private readonly int[][] _triangles;

    /// <summary>The side, of a later triangle, behind the cut of each triangle: three times the triangle, and which of its sides.</summary>
    private readonly int[] _behind;

    private Decomposition(Vector2[] outline)
    {
        _outline = outline;
        _count = outline.Length;
        _previous = new int[_count];
        _next = new int[_count];
        _triangles = new int[_count - 2][];
        _behind = new int[_count - 2];
        _corners = new OutlineTree(outline, outline);
        _best = new BestCorner(_count);
    }

    /// <summary>The pieces as lists of outline indices in positive order; <paramref name="outline"/> is tidy and positive.</summary>
    public static List<List<int>> Split(Vector2[] outline)
    {
        if (outline.Length < 4)
        {
            // A side so short beside the other that both its ends are one point is a line: the core of a rounded shape may be one.
            var all = new List<int>();
            for (int i = 0; i < outline.Length; i++)
            {
                all.Add(i);
            }

            return new List<List<int>> { all };
        }

        var work = new Decomposition(outline);
        work.CutEars();
        return work.Merge();
    }

    /// <summary>Triangles as indices in positive order, three each; <paramref name="outline"/> is tidy and positive.</summary>
    public static int[][] Triangles(Vector2[] outline)
    {
        var work = new Decomposition(outline);
        work.CutEars();
        return work._triangles;
    }

    private void CutEars()
    {
        for (int i = 0; i < _count; i++)
        {
            _previous[i] = (i + _count - 1) % _count;
            _next[i] = (i + 1) % _count;
        }

        for (int i = 0; i < _count; i++)
        {
            _best.Set(i, EarQuality(i));
        }

        // The triangle whose cut the side after each corner is; -1: a side of the outline.
        var cut = new int[_count];
        cut.AsSpan().Fill(-1);
        int last = _triangles.Length - 1;
        for (int i = 0; i < last; i++)
        {
            int tip = _best.Index;
            int before = _previous[tip];
            int after = _next[tip];
            Add(i, before, tip, after, cut);
            cut[before] = i;
            _next[before] = after;
            _previous[after] = before;
            _corners.Remove(tip);
            _best.Remove(tip);
            _best.Set(before, EarQuality(before));
            _best.Set(after, EarQuality(after));
        }

        // The three that are left, first things first.
        int first = 0;
        while (!_best.Holds(first))
        {
            first++;
        }

        Add(last, first, _next[first], _previous[first], cut);
    }

    private void Add(int triangle, int a, int b, int c, int[] cut)
    {
        _triangles[triangle] = new[] { a, b, c };
        for (int side = 0; side < 3; side++)
        {
            int from = _triangles[triangle][side];
            if (_next[from] == _triangles[triangle][(side + 1) % 3] && cut[from] >= 0)
            {
                _behind[cut[from]] = (3 * triangle) + side;
            }
        }
    }

    // Twice the area over the square of the longest side; not positive: no ear. Should rounding leave no ear at all, the
    // caller still takes the least bad corner, so it always ends.
    private double EarQuality(int tip)
    {
        var ear = new Ear(_outline, _previous[tip], tip, _next[tip]);
        double quality = ear.Area / ear.LongestSquare;
        return ear.Area <= 0 ? quality - 1 : _corners.Any(ear) ? -1 : quality;
    }

    private List<List<int>> Merge()
    {
        var rings = new PieceRings(_triangles);
        var owner = new int[_triangles.Length];
        for (int i = 0; i < owner.Length; i++)
        {
            owner[i] = i;
        }

        for (int i = owner.Length - 2; i >= 0; i--)
        {
            int mine = (3 * i) + 2;
            int behind = _behind[i];
            if (Bends(rings.Before(behind), rings.From(behind), rings.AfterNext(mine))
                && Bends(rings.Before(mine), rings.From(mine), rings.AfterNext(behind)))
            {
                int other = Owner(owner, behind / 3);
                rings.Join(mine, behind, other);
                owner[i] = other;
            }
        }

        var result = new List<List<int>>();
        for (int i = 0; i < owner.Length; i++)
        {
            if (owner[i] == i)
            {
                result.Add(rings.Corners(i));
            }
        }

        return result;
    }

    private static int Owner(int[] owner, int index)
    {
        while (owner[index] != index)
        {
            owner[index] = owner[owner[index]];
            index = owner[index];
        }

        return index;
    }

    private bool Bends(int before, int at, int after)
    {
        Vector2 a = _outline[before];
        Vector2 b = _outline[at];
        Vector2 c = _outline[after];
        double cross = Outline.Cross(a, b, c);
        return cross > LeastBend * Math.Sqrt(Square(a, b) * Square(b, c));
    }

    private static double Square(Vector2 a, Vector2 b)
    {
        double x = (double)b.X - a.X;
        double y = (double)b.Y - a.Y;
        return (x * x) + (y * y);
    }

    /// <summary>A corner with its neighbours, and the question whether any other corner lies in that triangle.</summary>
    private readonly struct Ear : IOutlineProbe
    {
        private readonly Vector2[] _outline;
        private readonly int _ia;
        private readonly int _ib;
        private readonly int _ic;
        private readonly Vector2 _a;
        private readonly Vector2 _b;
        private readonly Vector2 _c;

        public Ear(Vector2[] outline, int ia, int ib, int ic)
        {
            _outline = outline;
            _ia = ia;
            _ib = ib;
            _ic = ic;
            _a = outline[ia];
            _b = outline[ib];
            _c = outline[ic];
        }

        public double Area => Outline.Cross(_a, _b, _c);

        public double LongestSquare => Math.Max(Square(_a, _b), Math.Max(Square(_b, _c), Square(_c, _a)));

        public bool Reaches(Vector2 min, Vector2 max, int last) =>
            Outline.Overlap(Vector2.Min(_a, Vector2.Min(_b, _c)), Vector2.Max(_a, Vector2.Max(_b, _c)), min, max)
            && Outline.LargestCross(_a, _b, min, max) >= 0
            && Outline.LargestCross(_b, _c, min, max) >= 0
            && Outline.LargestCross(_c, _a, min, max) >= 0;

        public bool Hits(int part)
        {
            Vector2 p = _outline[part];
            return part != _ia && part != _ib && part != _ic
                && Outline.Cross(_a, _b, p) >= 0 && Outline.Cross(_b, _c, p) >= 0 && Outline.Cross(_c, _a, p) >= 0;
        }
    }
}
