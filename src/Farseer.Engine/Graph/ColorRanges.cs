using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>
/// The bundles of several colours numbered one after the other: a phase that does not care for colours is then one range for the workers,
/// and not one a colour. The first parts of all colours come first, then their second ones, a part for each worker: so a worker begins with
/// the rows that are its own in the passes, where each colour is cut by itself, and they stay in its cache (groups that are solved together
/// are cut there as one, halves between them). Each part begins with a record and with a number that is a whole number of records: where a
/// colour ends in the middle of one, the number of the bundle that is not there is left out.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed class ColorRanges
{
    private readonly Column<int> _first = new Column<int>();
    private GraphColor[] _colors = Array.Empty<GraphColor>();
    private int _colorCount;
    private int _parts = 1;
    private bool _areHalves;

    /// <summary>Numbers in all.</summary>
    public int Count { get; private set; }

    /// <summary>Takes the colours as they are; valid until a row is added or removed.</summary>
    /// <param name="graph">Where they are.</param>
    /// <param name="parts">Into how many parts each is cut; the numbers of the bundles follow from it.</param>
    public void Find(ConstraintGraph graph, int parts)
    {
        ReadOnlySpan<GraphColor> colors = graph.Used;
        _areHalves = graph.Groups.AreHalves;
        if (_colors.Length < graph.ColorRoom)
        {
            _colors = new GraphColor[graph.ColorRoom];
        }

        _first.EnsureCapacity((parts * graph.ColorRoom) + 1);
        _colorCount = colors.Length;
        _parts = parts;
        Count = 0;
        for (int i = 0; i < colors.Length; i++)
        {
            _colors[i] = colors[i];
        }

        for (int part = 0; part < parts; part++)
        {
            for (int i = 0; i < colors.Length; i++)
            {
                _first[(part * colors.Length) + i] = Count;
                Count += Whole(Start(i, part + 1) - Start(i, part));
            }
        }

        _first[parts * colors.Length] = Count;
    }

    /// <summary>Lets go of the colours.</summary>
    public void Forget() => Array.Clear(_colors, 0, _colorCount);

    /// <summary>The bundles of one part of a colour that a range begins with.</summary>
    /// <param name="from">The number of the first.</param>
    /// <param name="to">One past the last that is wanted.</param>
    /// <param name="end">One past the last that is of the first one's part, at most <paramref name="to"/>.</param>
    public BundleRuns From(int from, int to, out int end)
    {
        int place = 0;
        for (int above = _parts * _colorCount; above - place > 1;)
        {
            int middle = (place + above) / 2;
            place = _first[middle] <= from ? middle : place;
            above = _first[middle] <= from ? above : middle;
        }

        end = Math.Min(to, _first[place + 1]);
        int color = place % _colorCount;
        int shift = Start(color, place / _colorCount) - _first[place];
        return _colors[color].Part(from + shift, Math.Min(end + shift, _colors[color].BundleCount));
    }

    /// <summary>
    /// The numbers of the bundles of a part of a colour. In the order of the colours, and of the parts of each, the bundles are in an order
    /// that no number of workers changes.
    /// </summary>
    /// <param name="place">From 0, below <see cref="Places"/>.</param>
    /// <param name="from">The first number.</param>
    /// <param name="to">One past the last.</param>
    /// <returns>The bundles.</returns>
    public BundleRuns At(int place, out int from, out int to)
    {
        int color = place / _parts;
        int part = place % _parts;
        from = _first[(part * _colorCount) + color];
        int start = Start(color, part);
        int end = Start(color, part + 1);
        to = from + (end - start);
        return _colors[color].Part(start, end);
    }

    /// <summary>Parts of all colours.</summary>
    public int Places => _parts * _colorCount;

    /// <summary>Where a part of a colour begins.</summary>
    private int Start(int color, int part)
    {
        int bundles = _colors[color].BundleCount;
        if (part == 0 || part == _parts)
        {
            return part == 0 ? 0 : bundles;
        }

        // Of halves that are solved as one, each has the parts that its rows would come to.
        int share = _areHalves ? Math.Max(0, Math.Min((2 * part) - (_colors[color].Group * _parts), _parts)) : part;
        long records = Whole(bundles) / ContactBundle.Beside;
        return Math.Min((int)(records * share / _parts) * ContactBundle.Beside, bundles);
    }

    /// <summary>The bundles of as many whole records.</summary>
    private static int Whole(int bundles) => (bundles + ContactBundle.Beside - 1) / ContactBundle.Beside * ContactBundle.Beside;
}
