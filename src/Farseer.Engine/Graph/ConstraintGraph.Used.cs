using System;
using Farseer.Engine.Constraints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <content>The colours that have rows.</content>
internal sealed unsafe partial class ConstraintGraph
{
    // The colours that have rows: a small world has one or two, and to ask all of them in every pass was most of its step.
    [NotState(Why.Derived)]
    private GraphColor[] _solved = new GraphColor[ColorCount];
    [NotState(Why.Derived)]
    private GraphColor[] _used = new GraphColor[ColorCount];
    [NotState(Why.Derived)]
    private int _usedCount;

    /// <summary>
    /// The colours that have rows, in the order of solving: moving pairs, their overflow, ground pairs, their overflow; each of all groups.
    /// Valid until a row is added or removed.
    /// </summary>
    public ReadOnlySpan<GraphColor> Solved
    {
        get
        {
            FindUsed();
            return new ReadOnlySpan<GraphColor>(_solved, 0, _usedCount);
        }
    }

    /// <summary>The same by their number.</summary>
    public ReadOnlySpan<GraphColor> Used
    {
        get
        {
            FindUsed();
            return new ReadOnlySpan<GraphColor>(_used, 0, _usedCount);
        }
    }

    private void FindUsed()
    {
        if (!_usedChanged)
        {
            return;
        }

        _usedChanged = false;
        _usedCount = 0;
        if (_used.Length < _colorsMade)
        {
            _used = new GraphColor[Math.Min(2 * _colorsMade, (ColorCount + 1) * _colors.Count)];
            _solved = new GraphColor[_used.Length];
        }

        int solved = 0;
        for (int i = 0; i < ColorCount; i++)
        {
            int next = BodyColors.InOrder(i);
            foreach (GraphColor?[] colors in _colors)
            {
                if (colors[i] is { RowCount: > 0 } used)
                {
                    _used[_usedCount++] = used;
                }

                if (colors[next] is { RowCount: > 0 } nextSolved)
                {
                    _solved[solved++] = nextSolved;
                }
            }
        }
    }
}
