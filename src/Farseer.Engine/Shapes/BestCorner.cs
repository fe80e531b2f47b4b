using System;

namespace Farseer.Engine.Shapes;

/// <summary>The corner of the highest quality, the first one of equal ones, while qualities change: a tournament of all corners.</summary>
internal sealed class BestCorner
{
    private readonly double[] _quality;

    /// <summary>Winners, the final one at 1; those of i are 2i and 2i + 1, and the corners the last half. -1: nobody.</summary>
    private readonly int[] _winner;
    private readonly int _leaves = 1;

    public BestCorner(int count)
    {
        while (_leaves < count)
        {
            _leaves *= 2;
        }

        _quality = new double[count];
        _winner = new int[2 * _leaves];
        _winner.AsSpan().Fill(-1);
    }

    public int Index => _winner[1];

    public bool Holds(int corner) => _winner[_leaves + corner] >= 0;

    public void Set(int corner, double quality)
    {
        _quality[corner] = quality;
        Play(corner, corner);
    }

    public void Remove(int corner) => Play(corner, -1);

    private void Play(int corner, int entry)
    {
        int at = _leaves + corner;
        _winner[at] = entry;
        for (at /= 2; at > 0; at /= 2)
        {
            int first = _winner[2 * at];
            int second = _winner[(2 * at) + 1];
            _winner[at] = first < 0 || (second >= 0 && _quality[second] > _quality[first]) ? second : first;
        }
    }
}
