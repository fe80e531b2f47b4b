using System;

namespace Farseer.Engine.Graph;

/// <summary>
/// The bundles of several colours numbered one after the other: a phase that does not care for colours is then one range for the workers,
/// and not one a colour.
/// </summary>
internal sealed class ColorRanges
{
    private readonly GraphColor[] _colors = new GraphColor[ConstraintGraph.ColorCount];
    private readonly int[] _first = new int[ConstraintGraph.ColorCount + 1];

    /// <summary>Bundles in all.</summary>
    public int Count { get; private set; }

    /// <summary>Takes the colours as they are; valid until a row is added or removed.</summary>
    public void Find(ReadOnlySpan<GraphColor> colors)
    {
        Count = 0;
        for (int i = 0; i < colors.Length; i++)
        {
            _colors[i] = colors[i];
            _first[i] = Count;
            Count += colors[i].BundleCount;
        }

        _first[colors.Length] = Count;
    }

    /// <summary>The bundles of one colour of a range.</summary>
    /// <param name="from">The number of the first.</param>
    /// <param name="to">One past the last that is wanted.</param>
    /// <param name="end">One past the last that is of the first one's colour, at most <paramref name="to"/>.</param>
    public BundleRuns From(int from, int to, out int end)
    {
        int color = 0;
        while (_first[color + 1] <= from)
        {
            color++;
        }

        end = Math.Min(to, _first[color + 1]);
        return _colors[color].Part(from - _first[color], end - _first[color]);
    }
}
