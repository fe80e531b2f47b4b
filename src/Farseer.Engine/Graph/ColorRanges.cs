using System;

namespace Farseer.Engine.Graph;

/// <summary>
/// The bundles of several colours numbered one after the other: a phase that does not care for colours is then one range for the workers,
/// and not one a colour.
/// </summary>
internal sealed class ColorRanges
{
    private GraphColor[] _colors = new GraphColor[ConstraintGraph.ColorCount];
    private int[] _first = new int[ConstraintGraph.ColorCount + 1];

    private int _count;

    /// <summary>Bundles in all.</summary>
    public int Count { get; private set; }

    /// <summary>Takes the colours as they are; valid until a row is added or removed.</summary>
    public void Find(ReadOnlySpan<GraphColor> colors)
    {
        if (_colors.Length < colors.Length)
        {
            _colors = new GraphColor[2 * colors.Length];
            _first = new int[_colors.Length + 1];
        }

        Count = 0;
        for (int i = 0; i < colors.Length; i++)
        {
            _colors[i] = colors[i];
            _first[i] = Count;
            Count += colors[i].BundleCount;
        }

        _first[colors.Length] = Count;
        _count = colors.Length;
    }

    /// <summary>The bundles of one colour of a range.</summary>
    /// <param name="from">The number of the first.</param>
    /// <param name="to">One past the last that is wanted.</param>
    /// <param name="end">One past the last that is of the first one's colour, at most <paramref name="to"/>.</param>
    public BundleRuns From(int from, int to, out int end)
    {
        int color = 0;
        for (int above = _count; above - color > 1;)
        {
            int middle = (color + above) / 2;
            color = _first[middle] <= from ? middle : color;
            above = _first[middle] <= from ? above : middle;
        }

        end = Math.Min(to, _first[color + 1]);
        return _colors[color].Part(from - _first[color], end - _first[color]);
    }
}
