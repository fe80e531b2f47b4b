using System;
using System.Collections.Generic;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>Bundles that lie behind each other in memory, all in the hands of one colour.</summary>
internal unsafe struct RowExtent
{
    /// <summary>Nobody: the end of a list.</summary>
    public const int None = -1;

    public ContactBundle* Bundles;

    /// <summary>Bundles that it has.</summary>
    public int Count;

    /// <summary>The next one of its colour, or of those that nobody has, and the one before of its colour.</summary>
    public int Next;
    public int Previous;
}

/// <summary>
/// The memory of the rows of all colours. Rows move from colour to colour as a pile packs, so a colour that grew by itself went on
/// allocating long after the number of rows had come to rest, and each kept a quarter to spare. Here a colour takes extents of bundles,
/// larger ones the more it has, and returns them when they are empty; only when all are taken does the arena grow, and nothing is ever
/// copied. A bundle is known by its number in the arena, which never changes.
/// </summary>
internal sealed unsafe class RowArena
{
    /// <summary>Bundles of the smallest extent, those of one record, 2.75 KB: most colours of a small world have a row or two.</summary>
    private const int Granule = 1 << GranuleShift;
    private const int GranuleShift = 1;

    /// <summary>Sizes of extents: 2, 4, 8, … 128 bundles.</summary>
    private const int Sizes = 7;

    /// <summary>Up to so many bundles a colour takes as many again; beyond, so many, or this part of what it has.</summary>
    private const int FewBundles = 32;
    private const int Parts = 8;

    /// <summary>The arena grows by an eighth: growing copies nothing, so often is cheap, and a sixteenth lies idle on average.</summary>
    private const int GrowthShift = 3;

    /// <summary>Least bundles by which it grows, 11 KB; while it has fewer than <see cref="ManyBundles"/> it doubles.</summary>
    private const int LeastGrowth = 8;
    private const int ManyBundles = 64;

    [NotState(Why.Room)]
    private readonly List<Column<ContactBundle>> _segments = new List<Column<ContactBundle>>();

    // One for each granule; of an extent the first one counts.
    private readonly Column<RowExtent> _extents = new Column<RowExtent>();
    private readonly int[] _free = new int[Sizes];
    private int _granules;

    // The segments in use, and how many granules each has. Behind them lie those that a state which was restored had not yet.
    private readonly Column<int> _segmentSize = new Column<int>();
    private int _segmentCount;

    public RowArena()
    {
        for (int i = 0; i < Sizes; i++)
        {
            _free[i] = RowExtent.None;
        }
    }

    /// <summary>All extents by their number: valid until one is taken.</summary>
    public RowExtent* Extents => _extents.Pointer;

    /// <summary>Bundles that there is memory for.</summary>
    public int Capacity => _granules << GranuleShift;

    /// <summary>Extents that there may be at the same time.</summary>
    public int Granules => _granules;

    public ContactBundle* BundleOf(int row)
    {
        int bundle = row / ContactBundle.Lanes;
        return ContactBundle.At(_extents.Pointer[bundle >> GranuleShift].Bundles, bundle & (Granule - 1));
    }

    public static int LaneOf(int row) => row % ContactBundle.Lanes;

    /// <summary>Number of the first row of an extent.</summary>
    public static int FirstRow(int extent) => (extent << GranuleShift) * ContactBundle.Lanes;

    /// <summary>Bundles by which a colour grows that has so many.</summary>
    public static int Share(int bundles) => bundles <= FewBundles ? Math.Max(bundles, Granule) : Math.Max(FewBundles, bundles / Parts);

    /// <summary>Hands out an extent of about so many bundles. It may be smaller if there is no other, and larger than one.</summary>
    public int Take(int bundles)
    {
        int size = SizeOf(bundles);
        int taken = size;
        while (taken < Sizes && _free[taken] < 0)
        {
            taken++;
        }

        if (taken == Sizes)
        {
            taken = size;
            while (taken >= 0 && _free[taken] < 0)
            {
                taken--;
            }
        }

        if (taken < 0)
        {
            Grow(Math.Max(Math.Max(LeastGrowth, Math.Min(Capacity, ManyBundles)), Capacity >> GrowthShift));
            return Take(bundles);
        }

        int extent = _free[taken];
        _free[taken] = _extents[extent].Next;
        while (taken > size)
        {
            taken--;
            _extents[extent].Count = Granule << taken;
            Free(extent + (1 << taken), taken);
        }

        return extent;
    }

    /// <summary>Takes an extent back.</summary>
    public void Return(int extent) => Free(extent, SizeOf(_extents[extent].Count));

    /// <summary>The largest size of at most so many bundles.</summary>
    private static int SizeOf(int bundles)
    {
        int size = 0;
        while (size < Sizes - 1 && (Granule << (size + 1)) <= bundles)
        {
            size++;
        }

        return size;
    }

    private void Free(int extent, int size)
    {
        _extents[extent].Count = Granule << size;
        _extents[extent].Next = _free[size];
        _free[size] = extent;
    }

    /// <summary>
    /// Makes room for so many rows, and a quarter more: extents end half empty, and rows that overflow have a bundle each.
    /// </summary>
    public void Reserve(int rows)
    {
        int bundles = rows / ContactBundle.Lanes * 5 / 4;
        if (bundles > Capacity)
        {
            Grow(Math.Max(LeastGrowth, bundles - Capacity));
        }
    }

    private void Grow(int bundles)
    {
        int first = _granules;
        int count = bundles >> GranuleShift;
        _granules += count;
        _extents.EnsureCapacity(_granules);
        _segmentSize.EnsureCapacity(_segmentCount + 1);
        _segmentSize[_segmentCount] = count;
        PlaceSegment(_segmentCount, first);
        _segmentCount++;

        // From the end, so that what lies first is taken first.
        while (count > 0)
        {
            int size = SizeOf(count << GranuleShift);
            count -= 1 << size;
            Free(first + count, size);
        }
    }

    /// <summary>Writes, or reads, what later steps read of it, but for the rows: the colours know which there are.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _granules);
        s.Value(ref _segmentCount);
        s.Array(_free);
        s.Column(_segmentSize, _segmentCount);
        _extents.EnsureCapacity(_granules);
        for (int i = 0; i < _granules; i++)
        {
            // Not where its bundles are: that is another place in another process.
            s.Value(ref _extents[i].Count);
            s.Value(ref _extents[i].Next);
            s.Value(ref _extents[i].Previous);
        }

        s.ClearBehind(_extents, _granules);

        if (!s.IsReading)
        {
            return;
        }

        int first = 0;
        for (int i = 0; i < _segmentCount; i++)
        {
            PlaceSegment(i, first);
            first += _segmentSize[i];
        }
    }

    /// <summary>Finds memory for a segment, and tells its extents where they are.</summary>
    private void PlaceSegment(int index, int first)
    {
        int count = _segmentSize[index];
        if (index == _segments.Count)
        {
            _segments.Add(new Column<ContactBundle>(count));
        }
        else if (_segments[index].Capacity < count)
        {
            _segments[index] = new Column<ContactBundle>(count);
        }

        ContactBundle* start = _segments[index].Pointer;
        for (int i = 0; i < count; i++)
        {
            _extents[first + i].Bundles = start + i;
        }
    }
}
