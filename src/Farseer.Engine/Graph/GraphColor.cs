using Farseer.Engine.Contacts;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Graph;

/// <summary>The contacts of one colour: no two share a body that can move, so a bundle's lanes never meet.</summary>
internal sealed unsafe class GraphColor
{
    private readonly RowArena _arena;
    private readonly int _lanesUsed;
    private int _first = RowExtent.None;
    private int _last = RowExtent.None;

    /// <summary>Bundles of the last extent that have rows.</summary>
    private int _inLast;

    /// <param name="arena">Where its rows are.</param>
    /// <param name="sequential">True for the overflow, whose contacts may share bodies: one filled lane a bundle.</param>
    /// <param name="grounded">True for a colour of contacts with the ground.</param>
    /// <param name="source">Of a copy: the colour whose rows it borrows.</param>
    public GraphColor(RowArena arena, bool sequential = false, bool grounded = false, int source = -1)
    {
        _arena = arena;
        _lanesUsed = sequential ? 1 : WideLanes.BundleLanes;
        IsGrounded = grounded;
        Source = source;
    }

    /// <summary>One body of each contact does not move, and several contacts may share it.</summary>
    public bool IsGrounded { get; }

    /// <summary>Place of the colour whose rows this one borrows; -1 if they are its own.</summary>
    public int Source { get; }

    public int RowCount { get; private set; }

    /// <summary>Its contacts may share bodies and are solved one after the other.</summary>
    public bool IsSequential => _lanesUsed == 1;

    public int BundleCount => (RowCount + _lanesUsed - 1) / _lanesUsed;

    /// <summary>All its bundles, those that lie behind each other at a time.</summary>
    public BundleRuns Runs => new BundleRuns(_arena, _first, 0, BundleCount);

    /// <summary>All its bundles, one by one.</summary>
    public BundleWalk Bundles => new BundleWalk(Runs);

    /// <summary>Bundles <paramref name="from"/> to <paramref name="to"/>, this one not included.</summary>
    public BundleRuns Part(int from, int to) => new BundleRuns(_arena, _first, from, to - from);

    /// <summary>Drops all rows, which only have been lent to it.</summary>
    public void Clear()
    {
        RowCount = 0;
        while (_last >= 0)
        {
            Shorten();
        }
    }

    /// <summary>Appends an empty row; the caller fills it.</summary>
    /// <returns>Its number in the arena.</returns>
    public int AddRow()
    {
        int lane = RowCount % _lanesUsed;
        if (lane == 0)
        {
            if (_last < 0 || _inLast == _arena.Extents[_last].Count)
            {
                Lengthen();
            }

            _inLast++;
            ContactBundle* bundle = _arena.Extents[_last].Bundles + (_inLast - 1);
            for (int i = 0; i < WideLanes.BundleLanes; i++)
            {
                ContactRowWriter.ClearLane(bundle, i);
            }
        }

        RowCount++;
        return LastRow;
    }

    /// <summary>Removes a row; the last one takes its place.</summary>
    /// <returns>The contact that moved into <paramref name="row"/>, or -1.</returns>
    public int RemoveRow(int row)
    {
        int last = LastRow;
        ContactBundle* end = _arena.BundleOf(last);
        int moved = -1;
        if (row != last)
        {
            ContactBundle* bundle = _arena.BundleOf(row);
            ContactRowWriter.MoveLane(end, RowArena.LaneOf(last), bundle, RowArena.LaneOf(row));
            moved = bundle->Contact[RowArena.LaneOf(row)];
        }

        ContactRowWriter.ClearLane(end, RowArena.LaneOf(last));
        RowCount--;
        if (RowCount % _lanesUsed == 0 && --_inLast == 0)
        {
            Shorten();
        }

        return moved;
    }

    private int LastRow => RowArena.FirstRow(_last) + ((_inLast - 1) * ContactBundle.Lanes) + ((RowCount - 1) % _lanesUsed);

    private void Lengthen()
    {
        int extent = _arena.Take(BundleCount);
        RowExtent* extents = _arena.Extents;
        extents[extent].Previous = _last;
        extents[extent].Next = RowExtent.None;
        if (_last >= 0)
        {
            extents[_last].Next = extent;
        }
        else
        {
            _first = extent;
        }

        _last = extent;
        _inLast = 0;
    }

    /// <summary>Returns the last extent, which is empty.</summary>
    private void Shorten()
    {
        int extent = _last;
        RowExtent* extents = _arena.Extents;
        _last = extents[extent].Previous;
        _arena.Return(extent);
        if (_last >= 0)
        {
            extents[_last].Next = RowExtent.None;
            _inLast = extents[_last].Count;
        }
        else
        {
            _first = RowExtent.None;
            _inLast = 0;
        }
    }
}
