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
internal sealed unsafe class GridLevel
{
    // The slack covers the rounding of the cell numbers: they are below 2²⁶, so the division errs by less than 2⁻²⁶ cells.
    private const double CellSlack = 1 + (1.0 / (1 << 20));

    // Up to here the cells are numbered directly; a table for scattered boxes is smaller.
    private const int MostCellsABox = 4;
    private const int LeastCells = 64;

    private readonly BoxRows _rows = new BoxRows();
    private readonly Column<GridEntry> _entries = new Column<GridEntry>(1);
    private readonly Column<int> _cellOf = new Column<int>(1);
    private readonly Column<int> _rowOf = new Column<int>(1);
    private readonly Column<int> _start = new Column<int>(1);
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

    public int Count => _rows.Count;

    /// <summary>Members that look for pairs.</summary>
    public int Seekers { get; private set; }

    public GridEntry* Entries => _entries.Pointer;

    public Box Bounds(int index) => _rows.Wide.Get(index);

    /// <summary>Makes room for so many boxes, so that boxes which change their size class do not allocate in the middle of a run.</summary>
    public void Reserve(int count)
    {
        _cellOf.EnsureCapacity(count);
        _rowOf.EnsureCapacity(count);
        _entries.EnsureCapacity(count);
        _start.EnsureCapacity((MostCellsABox * count) + LeastCells + 2);
        _rows.EnsureCapacity(count);
    }

    public void Build(ProxyStore proxies, int* members, int count, double maxSize)
    {
        Box* boxes = proxies.Fat.Pointer;
        Measure(boxes, members, count, maxSize);
        _cellOf.EnsureCapacity(count);
        _rowOf.EnsureCapacity(count);
        _entries.EnsureCapacity(count);
        _start.EnsureCapacity(_cells + 2);
        _rows.SetCount(count);
        int* start = _start.Pointer;
        int* cellOf = _cellOf.Pointer;
        int* rowOf = _rowOf.Pointer;
        bool bounded = _inverseCell > 0;
        Unsafe.InitBlock(start, 0, (uint)(_cells + 2) * sizeof(int));
        for (int i = 0; i < count; i++)
        {
            Box* box = boxes + members[i];
            int column = bounded ? (int)((box->MinX - _originX) * _inverseCell) : 0;
            int row = bounded ? (int)((box->MinY - _originY) * _inverseCell) : 0;
            int cell = (int)(((uint)row * _stride) + (uint)column + 1 & _mask);
            cellOf[i] = cell;
            rowOf[i] = row;
            start[cell + 2]++;
        }

        for (int c = 2; c < _cells + 2; c++)
        {
            start[c] += start[c - 1];
        }

        // Now start[c + 1] is where cell c begins; filling moves it to where cell c + 1 does.
        ProxyInfo* info = proxies.Info.Pointer;
        GridEntry* entries = _entries.Pointer;
        WideBoxes wide = _rows.Wide;
        int seekers = 0;
        for (int i = 0; i < count; i++)
        {
            int proxy = members[i];
            int slot = start[cellOf[i] + 1]++;
            wide.Set(slot, boxes[proxy]);
            entries[slot].Proxy = proxy;
            entries[slot].Row = rowOf[i];
            entries[slot].Info = info[proxy];
            seekers += PairRule.Seeks(info[proxy].Flags) ? 1 : 0;
        }

        Seekers = seekers;
    }

    /// <summary>Pairs among the boxes of this level. Each looks at the rest of its cell, the next cell, and three cells of the next row.</summary>
    public void CollectWithin(PairBuffer pairs)
    {
        int* start = _start.Pointer;
        WideBoxes wide = _rows.Wide;
        GridEntry* entries = _entries.Pointer;
        for (int c = 0; c < _cells; c++)
        {
            int begin = start[c];
            int end = start[c + 1];
            if (begin == end)
            {
                continue;
            }

            uint above = ((uint)c + _stride - 1) & _mask;
            if (_hashed && (c + 1 >= _cells || above + 3 > (uint)_cells))
            {
                CollectAcrossEnd(c, pairs);
                continue;
            }

            int ownEnd = start[c + 2];
            int aboveBegin = start[above];
            int aboveEnd = start[above + 3];
            for (int i = begin; i < end; i++)
            {
                var box = new SpreadBox(wide.Get(i));
                GridEntry* entry = entries + i;
                Scan(wide, entries, box, entry, entry->Row, i + 1, ownEnd, pairs);
                Scan(wide, entries, box, entry, entry->Row + 1, aboveBegin, aboveEnd, pairs);
            }
        }
    }

    /// <summary>Pairs of a box of a coarser level with the boxes of this one.</summary>
    public void CollectAgainst(in Box box, GridEntry* entry, PairBuffer pairs)
    {
        var spread = new SpreadBox(box);
        if (_inverseCell == 0)
        {
            Scan(_rows.Wide, _entries.Pointer, spread, entry, -1, 0, Count, pairs);
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
            Scan(_rows.Wide, _entries.Pointer, spread, entry, -1, 0, Count, pairs);
            return;
        }

        int* start = _start.Pointer;
        for (int row = bottom; row <= top; row++)
        {
            uint first = (((uint)row * _stride) + (uint)left + 1) & _mask;
            uint last = first + (uint)(right - left);
            if (last < (uint)_cells)
            {
                Scan(_rows.Wide, _entries.Pointer, spread, entry, row, start[first], start[last + 1], pairs);
            }
            else
            {
                Scan(_rows.Wide, _entries.Pointer, spread, entry, row, start[first], Count, pairs);
                Scan(_rows.Wide, _entries.Pointer, spread, entry, row, 0, start[(last & _mask) + 1], pairs);
            }
        }
    }

    // A cell whose neighbours wrap around the end of the table: neighbours are taken one by one.
    private void CollectAcrossEnd(int c, PairBuffer pairs)
    {
        int* start = _start.Pointer;
        uint next = ((uint)c + 1) & _mask;
        for (int i = start[c]; i < start[c + 1]; i++)
        {
            var box = new SpreadBox(_rows.Wide.Get(i));
            GridEntry* entry = _entries.Pointer + i;
            Scan(_rows.Wide, _entries.Pointer, box, entry, entry->Row, i + 1, start[c + 1], pairs);
            Scan(_rows.Wide, _entries.Pointer, box, entry, entry->Row, start[next], start[next + 1], pairs);
            for (uint k = 0; k < 3; k++)
            {
                uint cell = ((uint)c + _stride - 1 + k) & _mask;
                Scan(_rows.Wide, _entries.Pointer, box, entry, entry->Row + 1, start[cell], start[cell + 1], pairs);
            }
        }
    }

    // Tests entries from … to; those of another row than the wanted one are left to the search that is theirs (−1: take all).
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Scan(
        in WideBoxes wide, GridEntry* entries, in SpreadBox box, GridEntry* entry, int row, int from, int to, PairBuffer pairs)
    {
        for (int k = from; k < to; k += WideBoxes.Width)
        {
            uint mask = wide.Overlaps(k, box);
            if (to - k < WideBoxes.Width)
            {
                mask &= (1u << (to - k)) - 1;
            }

            while (mask != 0)
            {
                GridEntry* other = entries + k + WideBoxes.LowestLane(mask);
                mask &= mask - 1;
                if ((row < 0 || other->Row == row) && PairRule.Wants(entry->Info, other->Info))
                {
                    pairs.Add(entry->Proxy, other->Proxy);
                }
            }
        }
    }

    private void Measure(Box* boxes, int* members, int count, double maxSize)
    {
        float minX = float.PositiveInfinity;
        float minY = float.PositiveInfinity;
        float maxX = float.NegativeInfinity;
        float maxY = float.NegativeInfinity;
        for (int i = 0; i < count; i++)
        {
            Box* box = boxes + members[i];
            minX = box->MinX < minX ? box->MinX : minX;
            minY = box->MinY < minY ? box->MinY : minY;
            maxX = box->MinX > maxX ? box->MinX : maxX;
            maxY = box->MinY > maxY ? box->MinY : maxY;
        }

        _originX = minX;
        _originY = minY;
        if (maxSize > double.MaxValue)
        {
            // Boxes without bounds: one cell for the whole plane, to which all numbers below come out as 0.
            _originX = 0;
            _originY = 0;
            maxX = maxY = 0;
        }

        // Only points at the origin have size 0: any cell holds them.
        _cell = maxSize > 0 ? maxSize * CellSlack : 1;
        _inverseCell = 1 / _cell;
        _columns = (int)((maxX - _originX) * _inverseCell) + 1;
        _rowCount = (int)((maxY - _originY) * _inverseCell) + 1;
        long direct = ((long)_columns + 1) * ((long)_rowCount + 1) + 2;
        _hashed = direct > ((long)MostCellsABox * count) + LeastCells;
        if (_hashed)
        {
            int cells = 16;
            while (cells < 2 * count)
            {
                cells *= 2;
            }

            // The golden section spreads the beginnings of consecutive rows as evenly as can be.
            _cells = cells;
            _mask = (uint)cells - 1;
            _stride = (uint)(cells * 0.6180339887498949) | 1;
        }
        else
        {
            _cells = (int)direct;
            _mask = uint.MaxValue;
            _stride = (uint)_columns + 1;
        }
    }
}

/// <summary>What a search needs of a box in a grid, beside its bounds; a copy, so that a hit does not cost a far load.</summary>
internal struct GridEntry
{
    public int Proxy;
    public int Row;
    public ProxyInfo Info;
}
