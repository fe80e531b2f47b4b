using System;
using Farseer.Engine.Constraints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <content>The colours that have rows.</content>
internal sealed unsafe partial class ConstraintGraph
{
    // The colours that have rows: a small world has one or two, and to ask all of them in every pass was most of its step.
    [NotState(Why.Derived)]
    private GraphColor[] _solved = Array.Empty<GraphColor>();
    [NotState(Why.Derived)]
    private GraphColor[] _used = Array.Empty<GraphColor>();
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

    /// <summary>
    /// Colours that may have rows, as each has some of the arena: what grows with it does not when some of them get their first.
    /// </summary>
    public int ColorRoom => Math.Min(ColorCount * _colors.Count, _arena.Granules);

    /// <summary>Numbers the bundles of all colours. There is one such numbering at a time: whoever walks by it makes his own.</summary>
    /// <param name="parts">See <see cref="ColorRanges.Find"/>.</param>
    public ColorRanges NumberBundles(int parts)
    {
        ColorRanges ranges = _ranges ??= new ColorRanges();
        ranges.Find(this, parts);
        return ranges;
    }

    private void FindUsed()
    {
        if (!_usedChanged)
        {
            return;
        }

        _usedChanged = false;
        _usedCount = 0;
        if (_used.Length < ColorRoom)
        {
            _used = new GraphColor[ColorRoom];
            _solved = new GraphColor[ColorRoom];
        }

        int solved = 0;
        for (int i = 0; i < ColorCount; i++)
        {
            int next = BodyColors.InOrder(i);
            foreach (GraphColor[] colors in _colors)
            {
                if (colors[i].RowCount > 0)
                {
                    _used[_usedCount++] = colors[i];
                }

                if (colors[next].RowCount > 0)
                {
                    _solved[solved++] = colors[next];
                }
            }
        }
    }
}
