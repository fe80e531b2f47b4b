using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// A uniform grid over boxes of like size, rebuilt by counting sort: O(n) to build, O(n + pairs) to search when boxes lie as dense as their
/// sizes allow. A box sits in the cell of its lower corner only; a cell is as wide as the largest box, so that overlapping boxes
/// sit in the same or in neighbouring cells.
/// </summary>
/// <remarks>
/// Cell (row, column) has the number row · stride + column. While the numbers are few they are used as they are (with an empty column
/// between rows); for scattered boxes they are cut to a power of two, a hash that keeps neighbouring columns
/// neighbours and maps "one row up" to "plus stride". Cut numbers let boxes of other rows into a search, which their row numbers then tell.
/// </remarks>
internal sealed unsafe partial class GridLevel
{
    // In scratch memory, which is taken back when the search is over.
    private WideBoxes _rows;
    private WideBoxes _sought;
    private GridEntry* _entries;
    private int* _start;
    private double _originX;
    private double _originY;
    private double _cell;
    private double _inverseCell;
    private int _columns;
    private int _rowCount;
    private int _cells;
    private uint _stride;
    private uint _mask;
    private bool _hashed;

    public int Count { get; private set; }

    /// <summary>Members that look for pairs.</summary>
    public int Seekers { get; private set; }

    public GridEntry* Entries => _entries;

    /// <summary>The box around which a member last found its pairs.</summary>
    public Box Sought(int place) => _sought.Get(place);

    /// <summary>
    /// Pairs of a range of the boxes of this level with those behind them. Each looks at the rest of its cell, the next cell, and three
    /// cells of the next row.
    /// </summary>
    /// <remarks>
    /// Both looks nearly always fit one test of eight boxes each, so these two are made without asking and their hits gathered in one mask:
    /// an unforeseen branch costs as much as both tests. In a pile nine tenths of the hits are pairs that are known, and are left out eight
    /// at a time.
    /// </remarks>
    public void CollectWithin(PairBuffer pairs, int from, int to)
    {
        int* start = _start;
        WideBoxes wide = _rows;
        WideBoxes sought = _sought;
        GridEntry* entries = _entries;
        for (int i = from; i < to; i++)
        {
            GridEntry* entry = entries + i;
            int c = entry->Place.Cell;
            uint above = ((uint)c + _stride - 1) & _mask;
            if (_hashed && (c + 1 >= _cells || above + 3 > (uint)_cells))
            {
                CollectAcrossEnd(i, pairs);
                continue;
            }

            int ownBegin = i + 1;
            int ownEnd = start[c + 2];
            int aboveBegin = start[above];
            int aboveEnd = start[above + 3];
            var box = new SpreadBox(entry->Box);
            var before = new SpreadBox(sought.Get(i));
            uint hits = (wide.Overlaps(ownBegin, box) & WideBoxes.FirstLanes(ownEnd - ownBegin))
                | ((wide.Overlaps(aboveBegin, box) & WideBoxes.FirstLanes(aboveEnd - aboveBegin)) << WideBoxes.Width);
            hits &= ~(sought.Overlaps(ownBegin, before) | (sought.Overlaps(aboveBegin, before) << WideBoxes.Width));
            if (hits != 0)
            {
                ulong* next = pairs.Reserve(2 * WideBoxes.Width);
                do
                {
                    int lane = WideBoxes.LowestLane(hits);
                    hits &= hits - 1;
                    int up = lane / WideBoxes.Width;
                    GridEntry* other = entries + (up == 0 ? ownBegin + lane : aboveBegin + lane - WideBoxes.Width);
                    *next = PairBuffer.Pack(entry->Proxy, other->Proxy);
                    next += (other->Place.Row == entry->Place.Row + up) & PairRule.Wants(entry->Key, other->Key) ? 1 : 0;
                }
                while (hits != 0);
                pairs.SetEnd(next);
            }

            if (ownEnd - ownBegin > WideBoxes.Width)
            {
                Scan(box, before, entry, entry->Place.Row, ownBegin + WideBoxes.Width, ownEnd, pairs);
            }

            if (aboveEnd - aboveBegin > WideBoxes.Width)
            {
                Scan(box, before, entry, entry->Place.Row + 1, aboveBegin + WideBoxes.Width, aboveEnd, pairs);
            }
        }
    }

    /// <summary>Pairs of a box of a coarser level with the boxes of this one.</summary>
    public void CollectAgainst(GridEntry* entry, in Box sought, PairBuffer pairs)
    {
        Box box = entry->Box;
        var spread = new SpreadBox(box);
        var before = new SpreadBox(sought);
        if (_inverseCell == 0)
        {
            Scan(spread, before, entry, -1, 0, Count, pairs);
            return;
        }

        // Lower corners of overlapping boxes lie between one cell before the box and its upper corner.
        double fromX = ((double)box.MinX - _cell - _originX) * _inverseCell;
        double fromY = ((double)box.MinY - _cell - _originY) * _inverseCell;
        double toX = ((double)box.MaxX - _originX) * _inverseCell;
        double toY = ((double)box.MaxY - _originY) * _inverseCell;
        if (toX < 0 || toY < 0 || fromX >= _columns || fromY >= _rowCount)
        {
            return;
        }

        int left = fromX < 0 ? 0 : (int)fromX;
        int bottom = fromY < 0 ? 0 : (int)fromY;
        int right = toX >= _columns ? _columns - 1 : (int)toX;
        int top = toY >= _rowCount ? _rowCount - 1 : (int)toY;

        // A row costs about as much to find as two tests of eight boxes.
        if ((_hashed && right - left + 3 > _cells) || ((long)top - bottom + 1) * 2 * WideBoxes.Width >= Count)
        {
            Scan(spread, before, entry, -1, 0, Count, pairs);
            return;
        }

        int* start = _start;
        for (int row = bottom; row <= top; row++)
        {
            uint first = (((uint)row * _stride) + (uint)left + 1) & _mask;
            uint last = first + (uint)(right - left);
            if (last < (uint)_cells)
            {
                Scan(spread, before, entry, row, start[first], start[last + 1], pairs);
            }
            else
            {
                Scan(spread, before, entry, row, start[first], Count, pairs);
                Scan(spread, before, entry, row, 0, start[(last & _mask) + 1], pairs);
            }
        }
    }

    // A box whose neighbouring cells wrap around the end of the table: they are taken one by one.
    private void CollectAcrossEnd(int i, PairBuffer pairs)
    {
        int* start = _start;
        GridEntry* entry = _entries + i;
        int row = entry->Place.Row;
        uint c = (uint)entry->Place.Cell;
        uint next = (c + 1) & _mask;
        var box = new SpreadBox(entry->Box);
        var before = new SpreadBox(_sought.Get(i));
        Scan(box, before, entry, row, i + 1, start[c + 1], pairs);
        Scan(box, before, entry, row, start[next], start[next + 1], pairs);
        for (uint k = 0; k < 3; k++)
        {
            uint cell = (c + _stride - 1 + k) & _mask;
            Scan(box, before, entry, row + 1, start[cell], start[cell + 1], pairs);
        }
    }

    // Tests entries from … to; those of another row than the wanted one are left to the search that is theirs (−1: take all).
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Scan(in SpreadBox box, in SpreadBox before, GridEntry* entry, int row, int from, int to, PairBuffer pairs)
    {
        for (int k = from; k < to; k += WideBoxes.Width)
        {
            uint mask = _rows.Overlaps(k, box) & WideBoxes.FirstLanes(to - k) & ~_sought.Overlaps(k, before);
            while (mask != 0)
            {
                GridEntry* other = _entries + k + WideBoxes.LowestLane(mask);
                mask &= mask - 1;
                if ((row < 0 || other->Place.Row == row) && PairRule.Wants(entry->Key, other->Key))
                {
                    pairs.Add(entry->Proxy, other->Proxy);
                }
            }
        }
    }
}

/// <summary>What a search needs of a box in a grid; a copy of half a cache line, so that a hit does not cost a far load.</summary>
internal struct GridEntry
{
    public Box Box;
    public int Proxy;

    /// <summary>Body and flags, see <see cref="PairRule.Key"/>.</summary>
    public int Key;
    public GridPlace Place;
}

/// <summary>Where the lower corner of a box lies: the number of its cell, and its row, which the number may share with others.</summary>
internal struct GridPlace
{
    public int Cell;
    public int Row;
}
