using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <content>The sorting of boxes into cells, which workers share.</content>
/// <remarks>
/// Boxes are sorted by the upper part of the numbers of their cells first, block by block, and then within each of these bins by the cells.
/// Both keep the order in which the boxes were given, so the result is that of sorting them at once, whoever did which block and which bin.
/// One worker alone has one bin: to deal boxes out takes as long as half of the rest.
/// </remarks>
[NotState(Why.OfOneStep)]
internal sealed unsafe partial class GridLevel : IStageWork
{
    // The slack covers the rounding of the cell numbers: they are below 2²⁶, so the division errs by less than 2⁻²⁶ cells.
    private const double CellSlack = 1 + (1.0 / (1 << 20));

    // Up to here the cells are numbered directly; a table for scattered boxes is smaller.
    private const int MostCellsABox = 4;
    private const int LeastCells = 64;

    // Boxes of a block, some 2 µs.
    private const int Block = 512;

    // Boxes of a bin if they lie evenly, some 1 µs, and most bins: a worker that deals boxes out writes to as many lines.
    private const int BinBoxes = 64;
    private const int MostBins = 256;

    // In scratch memory, while the boxes are sorted.
    private Corners* _corners;
    private GridBox* _placed;
    private GridBox* _binned;

    // For each block and bin, the next place of the block's boxes in the bin; where each bin begins; how many of it seek.
    private int* _next;
    private int* _firstOfBin;
    private int* _seekersOfBin;
    private ProxyStore _proxies = null!;
    private int* _members;
    private int _bins;
    private int _binShift;
    private Part _part;

    private enum Part
    {
        Measure,
        Place,
        Deal,
        Fill,
    }

    /// <summary>Sorts the boxes into the grid, in scratch memory.</summary>
    /// <param name="runner">Who shares the work out; null: nobody.</param>
    /// <param name="proxies">All boxes.</param>
    /// <param name="members">Those of this level.</param>
    /// <param name="count">How many they are.</param>
    /// <param name="maxSize">The largest side of one.</param>
    public void Build(StageRunner? runner, ProxyStore proxies, int* members, int count, double maxSize)
    {
        Scratch scratch = proxies.Scratch;
        int blocks = (count + Block - 1) / Block;
        _proxies = proxies;
        _members = members;
        Count = count;
        _corners = scratch.Take<Corners>(blocks);
        Run(runner, Part.Measure, blocks, 1);
        Lay(blocks, maxSize);
        _entries = scratch.Take<GridEntry>(count);
        _start = scratch.Take<int>(_cells + 2);
        _rows = BoxRows.Take(scratch, count);
        _sought = BoxRows.Take(scratch, count);
        int mark = scratch.Mark;
        bool shared = runner != null && runner.IsShared(blocks, 1);
        for (_bins = 1; shared && _bins < MostBins && _bins * BinBoxes < count;)
        {
            _bins *= 2;
        }

        for (_binShift = 0; ((_cells - 1) >> _binShift) >= _bins;)
        {
            _binShift++;
        }

        _placed = scratch.Take<GridBox>(count);
        _next = scratch.Take<int>(blocks * _bins);
        _firstOfBin = scratch.Take<int>(_bins + 1);
        _seekersOfBin = scratch.Take<int>(_bins);
        Run(runner, Part.Place, blocks, 1);
        FindBins(blocks);
        _binned = _placed;
        if (_bins > 1)
        {
            _binned = scratch.Take<GridBox>(count);
            Run(runner, Part.Deal, blocks, 1);
        }

        Run(runner, Part.Fill, _bins, 2);
        Seekers = 0;
        for (int bin = 0; bin < _bins; bin++)
        {
            Seekers += _seekersOfBin[bin];
        }

        scratch.Release(mark);
    }

    /// <summary>Blocks of the boxes, or bins.</summary>
    void IStageWork.Run(int worker, int from, int to)
    {
        for (int i = from; i < to; i++)
        {
            int first = i * Block;
            int end = Math.Min(first + Block, Count);
            switch (_part)
            {
                case Part.Measure:
                    _corners[i] = Corners.Of(_proxies.Fat.Pointer, _members + first, end - first);
                    break;
                case Part.Place:
                    Place(_next + (i * _bins), first, end);
                    break;
                case Part.Deal:
                    Deal(_next + (i * _bins), first, end);
                    break;
                case Part.Fill:
                    Fill(i);
                    break;
            }
        }
    }

    private void Run(StageRunner? runner, Part part, int count, int least)
    {
        _part = part;
        StageRunner.Share(runner, this, count, least);
    }

    // Finds the cells of a block of boxes, and how many of the block are in each bin.
    private void Place(int* counts, int from, int to)
    {
        Box* boxes = _proxies.Fat.Pointer;
        GridBox* placed = _placed;
        int shift = _binShift;
        bool bounded = _inverseCell > 0;
        Unsafe.InitBlock(counts, 0, (uint)_bins * sizeof(int));
        for (int i = from; i < to; i++)
        {
            Box* box = boxes + _members[i];
            int column = bounded ? (int)((box->MinX - _originX) * _inverseCell) : 0;
            int row = bounded ? (int)((box->MinY - _originY) * _inverseCell) : 0;
            int cell = (int)(((uint)row * _stride) + (uint)column + 1 & _mask);
            placed[i].Proxy = _members[i];
            placed[i].Place.Cell = cell;
            placed[i].Place.Row = row;
            counts[cell >> shift]++;
        }
    }

    // Turns the counts into places: bin after bin, and in each block after block.
    private void FindBins(int blocks)
    {
        int sum = 0;
        for (int bin = 0; bin < _bins; bin++)
        {
            _firstOfBin[bin] = sum;
            for (int* next = _next + bin; next < _next + (blocks * _bins); next += _bins)
            {
                int here = *next;
                *next = sum;
                sum += here;
            }
        }

        _firstOfBin[_bins] = sum;
    }

    private void Deal(int* next, int from, int to)
    {
        GridBox* placed = _placed;
        GridBox* binned = _binned;
        int shift = _binShift;
        for (int i = from; i < to; i++)
        {
            binned[next[placed[i].Place.Cell >> shift]++] = placed[i];
        }
    }

    // Sorts the boxes of a bin by their cells. The starts of its cells count, are summed to where cells end, and go back to where they
    // begin as the boxes are filled in from the last one on. The places behind the last cell are of the last bin. Each box is written to
    // one place, and spread into the rows of bounds in a second walk: five far stores a box would each miss the cache in a large world.
    private void Fill(int bin)
    {
        int firstCell = Math.Min(bin << _binShift, _cells);
        int endCell = bin == _bins - 1 ? _cells + 2 : Math.Min((bin + 1) << _binShift, _cells);
        int first = _firstOfBin[bin];
        int end = _firstOfBin[bin + 1];
        GridBox* binned = _binned;
        int* start = _start;
        for (int cell = firstCell; cell < endCell; cell++)
        {
            start[cell] = 0;
        }

        for (int i = first; i < end; i++)
        {
            start[binned[i].Place.Cell]++;
        }

        int sum = first;
        for (int cell = firstCell; cell < endCell; cell++)
        {
            sum += start[cell];
            start[cell] = sum;
        }

        Box* boxes = _proxies.Fat.Pointer;
        ProxyInfo* info = _proxies.Info.Pointer;
        GridEntry* entries = _entries;
        int seekers = 0;
        for (int i = end - 1; i >= first; i--)
        {
            int proxy = binned[i].Proxy;
            GridEntry* entry = entries + --start[binned[i].Place.Cell];
            entry->Box = boxes[proxy];
            entry->Proxy = proxy;
            entry->Key = PairRule.Key(info[proxy]);
            entry->Place = binned[i].Place;
            seekers += PairRule.Seeks(entry->Key) ? 1 : 0;
        }

        _seekersOfBin[bin] = seekers;
        WideBoxes wide = _rows;
        WideBoxes before = _sought;
        Box* sought = _proxies.Sought.Pointer;
        for (int slot = first; slot < end; slot++)
        {
            wide.Set(slot, entries[slot].Box);
            before.Set(slot, sought[entries[slot].Proxy]);
        }
    }

    // Lays the grid around the boxes.
    private void Lay(int blocks, double maxSize)
    {
        Corners all = Corners.None;
        for (int i = 0; i < blocks; i++)
        {
            all.Add(_corners[i]);
        }

        _originX = all.MinX;
        _originY = all.MinY;
        if (maxSize > double.MaxValue)
        {
            // Boxes without bounds: one cell for the whole plane, to which all numbers below come out as 0.
            _originX = 0;
            _originY = 0;
            all.MaxX = all.MaxY = 0;
        }

        // Only points at the origin have size 0: any cell holds them.
        _cell = maxSize > 0 ? maxSize * CellSlack : 1;
        _inverseCell = 1 / _cell;
        _columns = (int)((all.MaxX - _originX) * _inverseCell) + 1;
        _rowCount = (int)((all.MaxY - _originY) * _inverseCell) + 1;
        long direct = ((long)_columns + 1) * ((long)_rowCount + 1) + 2;
        _hashed = direct > ((long)MostCellsABox * Count) + LeastCells;
        if (_hashed)
        {
            int cells = 16;
            while (cells < 2 * Count)
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

    // A box before it has its place among the others.
    private struct GridBox
    {
        public int Proxy;
        public GridPlace Place;
    }

    // How far lower corners reach.
    private struct Corners
    {
        public float MinX;
        public float MinY;
        public float MaxX;
        public float MaxY;

        public static Corners None => new Corners
        {
            MinX = float.PositiveInfinity,
            MinY = float.PositiveInfinity,
            MaxX = float.NegativeInfinity,
            MaxY = float.NegativeInfinity,
        };

        public static Corners Of(Box* boxes, int* members, int count)
        {
            Corners corners = None;
            for (int i = 0; i < count; i++)
            {
                Box* box = boxes + members[i];
                corners.MinX = box->MinX < corners.MinX ? box->MinX : corners.MinX;
                corners.MinY = box->MinY < corners.MinY ? box->MinY : corners.MinY;
                corners.MaxX = box->MinX > corners.MaxX ? box->MinX : corners.MaxX;
                corners.MaxY = box->MinY > corners.MaxY ? box->MinY : corners.MaxY;
            }

            return corners;
        }

        public void Add(in Corners other)
        {
            MinX = other.MinX < MinX ? other.MinX : MinX;
            MinY = other.MinY < MinY ? other.MinY : MinY;
            MaxX = other.MaxX > MaxX ? other.MaxX : MaxX;
            MaxY = other.MaxY > MaxY ? other.MaxY : MaxY;
        }
    }
}
