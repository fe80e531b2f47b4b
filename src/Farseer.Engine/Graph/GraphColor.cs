using Farseer.Engine.Contacts;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>The contacts of one colour: no two share a body that can move, so a bundle's lanes never meet.</summary>
internal sealed unsafe class GraphColor
{
    private readonly RowArena _arena;
    [NotState(Why.Elsewhere)]
    private byte _lanesUsed;
    [NotState(Why.Elsewhere)]
    private sbyte _place;
    private readonly byte _group;
    private int _first = RowExtent.None;
    private int _last = RowExtent.None;

    /// <summary>Bundles of the last extent that have rows.</summary>
    private int _inLast;

    /// <param name="arena">Where its rows are.</param>
    /// <param name="sequential">True for the overflow, whose contacts may share bodies: one filled lane a bundle.</param>
    /// <param name="grounded">True for a colour of contacts with the ground.</param>
    /// <param name="place">Its place in the order of solving.</param>
    /// <param name="group">The group that its rows are of.</param>
    /// <param name="shared">True for a colour whose rows may share the heavier of their bodies.</param>
    public GraphColor(RowArena arena, bool sequential = false, bool grounded = false, int place = -1, int group = 0, bool shared = false)
    {
        _arena = arena;
        _lanesUsed = sequential ? (byte)1 : (byte)WideLanes.BundleLanes;
        IsGrounded = grounded;
        IsShared = shared;
        _place = (sbyte)place;
        _group = (byte)group;
    }

    /// <summary>One body of each contact does not move, and several contacts may share it.</summary>
    [NotState(Why.Elsewhere)]
    public bool IsGrounded { get; private set; }

    /// <summary>
    /// Its contacts may have the heavier of their bodies in common, and are solved a bundle at a time: see <see cref="SharedKernel"/>.
    /// </summary>
    [NotState(Why.Elsewhere)]
    public bool IsShared { get; private set; }

    /// <summary>Its place in the order of solving, which the same colour of another group shares; -1: none.</summary>
    public int Place => _place;

    /// <summary>See <see cref="RowGroups"/>.</summary>
    public int Group => _group;

    public int RowCount { get; private set; }

    /// <summary>It has rows, or room for some.</summary>
    public bool HoldsAny => _first >= 0;

    /// <summary>Its contacts may share bodies and are solved one after the other.</summary>
    public bool IsSequential => _lanesUsed == 1;

    /// <summary>Contacts of it may have a body that moves in common: one worker does all of them, in their order.</summary>
    public bool HasOrder => IsSequential || IsShared;

    /// <summary>Bundles that have rows: asked for in every pass, so it is counted along.</summary>
    public int BundleCount { get; private set; }

    /// <summary>All its bundles, those that lie behind each other at a time.</summary>
    public BundleRuns Runs => new BundleRuns(_arena, _first, 0, BundleCount);

    /// <summary>All its bundles, one by one.</summary>
    public BundleWalk Bundles => new BundleWalk(Runs);

    /// <summary>Bundles <paramref name="from"/> to <paramref name="to"/>, this one not included.</summary>
    public BundleRuns Part(int from, int to) => new BundleRuns(_arena, _first, from, to - from);

    /// <summary>Takes rows of another colour from now on; it has none.</summary>
    public void Follow(GraphColor other)
    {
        _lanesUsed = other._lanesUsed;
        IsGrounded = other.IsGrounded;
        IsShared = other.IsShared;
        _place = other._place;
    }

    /// <summary>Drops all rows, which only have been lent to it.</summary>
    public void Clear()
    {
        RowCount = 0;
        BundleCount = 0;
        while (_last >= 0)
        {
            Shorten();
        }
    }

    /// <summary>Takes room for so many more rows, in one place if there is one.</summary>
    public void Reserve(int rows)
    {
        int bundles = (RowCount + rows + _lanesUsed - 1) / _lanesUsed;
        int extent = RowExtent.None;
        for (int next = _first; next >= 0; next = _arena.Extents[next].Next)
        {
            extent = next;
            bundles -= _arena.Extents[next].Count;
        }

        while (bundles > 0)
        {
            extent = Lengthen(extent, bundles);
            bundles -= _arena.Extents[extent].Count;
        }
    }

    /// <summary>Appends an empty row; the caller fills it.</summary>
    /// <returns>Its number in the arena.</returns>
    public int AddRow()
    {
        int lane = RowCount % _lanesUsed;
        if (lane == 0)
        {
            GoOn();
            _inLast++;
            BundleCount++;
            ContactBundle* bundle = ContactBundle.At(_arena.Extents[_last].Bundles, _inLast - 1);
            if (ContactBundle.IsFirst(bundle))
            {
                ContactLanes.ClearRecord(bundle);
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
            ContactLanes.MoveLane(end, RowArena.LaneOf(last), bundle, RowArena.LaneOf(row));
            moved = bundle->Contact[RowArena.LaneOf(row)];
        }

        ContactLanes.ClearLane(end, RowArena.LaneOf(last));
        RowCount--;
        if (RowCount % _lanesUsed == 0)
        {
            BundleCount--;
            if (--_inLast == 0)
            {
                Shorten();
            }
        }

        return moved;
    }

    private int LastRow => RowArena.FirstRow(_last) + ((_inLast - 1) * ContactBundle.Lanes) + ((RowCount - 1) % _lanesUsed);

    /// <summary>Goes on to the next extent if the last one is full.</summary>
    private void GoOn()
    {
        if (_last >= 0 && _inLast < _arena.Extents[_last].Count)
        {
            return;
        }

        int next = _last < 0 ? _first : _arena.Extents[_last].Next;
        _last = next >= 0 ? next : Lengthen(_last, RowArena.Share(BundleCount));
        _inLast = 0;
    }

    /// <returns>An extent behind another one, which was the last; it is empty.</returns>
    private int Lengthen(int previous, int bundles)
    {
        int extent = _arena.Take(bundles);
        RowExtent* extents = _arena.Extents;
        extents[extent].Previous = previous;
        extents[extent].Next = RowExtent.None;
        if (previous >= 0)
        {
            extents[previous].Next = extent;
        }
        else
        {
            _first = extent;
        }

        return extent;
    }

    /// <summary>Returns the last extent, which is empty, and those behind it.</summary>
    private void Shorten()
    {
        RowExtent* extents = _arena.Extents;
        int previous = extents[_last].Previous;
        for (int extent = _last; extent >= 0;)
        {
            int next = extents[extent].Next;
            _arena.Return(extent);
            extent = next;
        }

        _last = previous;
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

    /// <summary>
    /// Writes, or reads, what later steps read of it; the arena comes before. Of its memory only the bundles that have rows.
    /// </summary>
    public void Visit(StateStream s)
    {
        s.Section(this);
        s.Value(ref _first);
        s.Value(ref _last);
        s.Value(ref _inLast);
        RowCount = s.Value(RowCount);
        BundleCount = s.Value(BundleCount);
        if (_last < 0)
        {
            return;
        }

        for (int extent = _first; ; extent = _arena.Extents[extent].Next)
        {
            int bundles = extent == _last ? _inLast : _arena.Extents[extent].Count;
            int records = (bundles + ContactBundle.Beside - 1) / ContactBundle.Beside;
            ContactRowState.Visit(s, _arena.Extents[extent].Bundles, records);
            if (extent == _last)
            {
                break;
            }
        }
    }

    /// <summary>It has no rows, and holds no extents: those are somebody else's by now.</summary>
    public void ForgetAll()
    {
        _first = RowExtent.None;
        _last = RowExtent.None;
        _inLast = 0;
        RowCount = 0;
        BundleCount = 0;
    }
}
