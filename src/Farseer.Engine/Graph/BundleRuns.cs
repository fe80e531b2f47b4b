using System;
using Farseer.Engine.Contacts;

namespace Farseer.Engine.Graph;

/// <summary>The bundles of a colour, those that lie behind each other at a time. Valid until rows of this colour come or go.</summary>
internal unsafe ref struct BundleRuns
{
    private readonly RowArena _arena;
    private int _extent;
    private int _skip;
    private int _left;

    /// <param name="arena">Where the bundles are.</param>
    /// <param name="extent">The first extent of the colour.</param>
    /// <param name="from">Bundles to leave out.</param>
    /// <param name="count">Bundles to walk over behind these.</param>
    public BundleRuns(RowArena arena, int extent, int from, int count)
    {
        _arena = arena;
        _extent = extent;
        _left = count;
        Bundles = null;
        Count = 0;
        for (RowExtent* at = arena.Extents + extent; from > 0 && from >= at->Count; at = arena.Extents + _extent)
        {
            from -= at->Count;
            _extent = at->Next;
        }

        _skip = from;
    }

    /// <summary>The first bundle of the run.</summary>
    public ContactBundle* Bundles { get; private set; }

    public int Count { get; private set; }

    /// <summary>The run behind this one, to ask for it ahead; of the last one itself.</summary>
    public readonly ContactBundle* Following => _left > 0 ? _arena.Extents[_extent].Bundles : Bundles;

    /// <summary>Goes on to the next run, at first to the first.</summary>
    public bool Next()
    {
        if (_left <= 0)
        {
            return false;
        }

        RowExtent* extent = _arena.Extents + _extent;
        Bundles = ContactBundle.At(extent->Bundles, _skip);
        int count = extent->Count - _skip;
        _extent = extent->Next;
        while (count < _left && _arena.Extents[_extent].Bundles == ContactBundle.At(Bundles, count))
        {
            count += _arena.Extents[_extent].Count;
            _extent = _arena.Extents[_extent].Next;
        }

        Count = Math.Min(count, _left);
        _left -= Count;
        _skip = 0;
        return true;
    }
}
