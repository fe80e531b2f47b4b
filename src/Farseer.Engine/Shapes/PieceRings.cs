using System.Collections.Generic;

namespace Farseer.Engine.Shapes;

/// <summary>
/// Rings of sides, at first one for each triangle, side k of triangle t being 3t + k; two that share a side are joined without copying.
/// </summary>
internal sealed class PieceRings
{
    private readonly int[] _from;
    private readonly int[] _next;
    private readonly int[] _previous;
    private readonly int[] _first;

    public PieceRings(int[][] triangles)
    {
        _from = new int[3 * triangles.Length];
        _next = new int[_from.Length];
        _previous = new int[_from.Length];
        _first = new int[triangles.Length];
        for (int t = 0; t < triangles.Length; t++)
        {
            _first[t] = 3 * t;
            for (int k = 0; k < 3; k++)
            {
                _from[(3 * t) + k] = triangles[t][k];
                _next[(3 * t) + k] = (3 * t) + ((k + 1) % 3);
                _previous[(3 * t) + k] = (3 * t) + ((k + 2) % 3);
            }
        }
    }

    /// <summary>The corner at which a side starts.</summary>
    public int From(int side) => _from[side];

    /// <summary>The corner before that at which a side starts.</summary>
    public int Before(int side) => _from[_previous[side]];

    /// <summary>The corner after that at which a side ends.</summary>
    public int AfterNext(int side) => _from[_next[_next[side]]];

    /// <summary>Takes out a side that two rings share; the ring of <paramref name="piece"/> begins after <paramref name="side"/>.</summary>
    public void Join(int side, int opposite, int piece)
    {
        _first[piece] = _next[side];
        Link(_previous[side], _next[opposite]);
        Link(_previous[opposite], _next[side]);
    }

    public List<int> Corners(int piece)
    {
        var corners = new List<int>();
        int side = _first[piece];
        do
        {
            corners.Add(_from[side]);
            side = _next[side];
        }
        while (side != _first[piece]);

        return corners;
    }

    private void Link(int side, int next)
    {
        _next[side] = next;
        _previous[next] = side;
    }
}
