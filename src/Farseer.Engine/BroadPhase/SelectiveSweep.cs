using System.Collections.Generic;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// Sorts the boxes along one axis only, the one along which they spread the most for their width, and searches runs of that order eight
/// boxes at a time. A moved box costs O(log n + boxes beside it on the axis) a size class; when many move, everything is
/// sorted anew and swept once, O(n + overlaps along the axis). Boxes are kept by size class, so that a few wide ones
/// do not lengthen the runs of all.
/// </summary>
internal sealed unsafe class SelectiveSweep : IBroadPhase
{
    // One box in so many may move before a new sort is cheaper than shifting them one by one.
    private const int ShiftFraction = 8;

    // Boxes that made way, in units of all boxes, after which the axis and the classes are chosen anew.
    private const int ShiftsBeforeRebuild = 64;

    private const int Nowhere = -1;

    private readonly List<SweepLevel> _sweeps = new List<SweepLevel>();
    private readonly SizeLevels _levels = new SizeLevels();
    private readonly IndexList _live = new IndexList();
    private readonly IndexList _seekers = new IndexList();
    private readonly Column<Place> _places = new Column<Place>(1);
    private int _known;
    private int _levelCount;
    private long _shifts;

    public void Added(ProxyStore proxies, int proxy)
    {
        Know(proxy + 1);
        Leave(proxy);
    }

    public void Removed(ProxyStore proxies, int proxy)
    {
        Know(proxy + 1);
        Leave(proxy);
    }

    public void Collect(ProxyStore proxies, PairBuffer pairs)
    {
        Know(proxies.End);
        Gather(proxies);
        if (_seekers.Count == 0)
        {
            return;
        }

        bool many = (long)_seekers.Count * ShiftFraction > _live.Count;
        if (many || _shifts > (long)ShiftsBeforeRebuild * _live.Count || !ShiftSeekers(proxies))
        {
            Rebuild(proxies);
        }

        if (many)
        {
            SweepAll(proxies, pairs);
        }
        else
        {
            AskForSeekers(proxies, pairs);
        }
    }

    private void Gather(ProxyStore proxies)
    {
        _live.Clear();
        _seekers.Clear();
        ProxyInfo* info = proxies.Info.Pointer;
        for (int i = 0; i < proxies.End; i++)
        {
            if ((info[i].Flags & ProxyFlags.Alive) != 0)
            {
                _live.Add(i);
                if ((info[i].Flags & ProxyFlags.Moved) != 0)
                {
                    _seekers.Add(i);
                }
            }
        }
    }

    // Every box of a coarser level asks the finer ones, and each level is swept once: no pair is met twice.
    private void SweepAll(ProxyStore proxies, PairBuffer pairs)
    {
        ProxyInfo* info = proxies.Info.Pointer;
        for (int coarse = 0; coarse < _levelCount; coarse++)
        {
            _sweeps[coarse].CollectWithin(info, pairs);
            for (int fine = 0; fine < coarse; fine++)
            {
                _sweeps[coarse].CollectAgainst(_sweeps[fine], info, pairs);
            }
        }
    }

    private void AskForSeekers(ProxyStore proxies, PairBuffer pairs)
    {
        Box* boxes = proxies.Fat.Pointer;
        ProxyInfo* info = proxies.Info.Pointer;
        for (int i = 0; i < _seekers.Count; i++)
        {
            int proxy = _seekers.Pointer[i];
            for (int l = 0; l < _levelCount; l++)
            {
                _sweeps[l].Ask(boxes[proxy], proxy, info, true, pairs);
            }
        }
    }

    // False if a box fits no level: the levels must then be made anew.
    private bool ShiftSeekers(ProxyStore proxies)
    {
        Box* boxes = proxies.Fat.Pointer;
        for (int i = 0; i < _seekers.Count; i++)
        {
            int proxy = _seekers.Pointer[i];
            ref Box box = ref boxes[proxy];
            ref Place place = ref _places[proxy];
            double size = SizeLevels.EffectiveSize(box);
            if (place.Level != Nowhere && size <= _sweeps[place.Level].Margin)
            {
                _shifts += _sweeps[place.Level].Shift(place.Key, box, proxy);
                place.Key = _sweeps[place.Level].Key(box);
                continue;
            }

            Leave(proxy);
            int level = 0;
            while (level < _levelCount && size > _sweeps[level].Margin)
            {
                level++;
            }

            if (level == _levelCount)
            {
                return false;
            }

            _sweeps[level].Insert(box, proxy);
            place.Level = level;
            place.Key = _sweeps[level].Key(box);
            _shifts += _sweeps[level].Count;
        }

        return true;
    }

    private void Rebuild(ProxyStore proxies)
    {
        Box* boxes = proxies.Fat.Pointer;
        bool vertical = SpreadsMoreVertically(boxes);
        Scratch scratch = proxies.Scratch;
        int mark = scratch.Mark;
        _levels.Assign(null, scratch, boxes, _live.Pointer, _live.Count);
        _levelCount = _levels.Count;
        while (_sweeps.Count < _levelCount)
        {
            _sweeps.Add(new SweepLevel());
        }

        for (int l = 0; l < _levelCount; l++)
        {
            int* members = _levels.Members(l);
            int count = _levels.Size(l);
            _sweeps[l].Reserve(_live.Count);
            _sweeps[l].Build(boxes, members, count, _levels.MaxSize(l), vertical, scratch);
            for (int i = 0; i < count; i++)
            {
                _places[members[i]].Level = l;
                _places[members[i]].Key = _sweeps[l].Key(boxes[members[i]]);
            }
        }

        scratch.Release(mark);
        _shifts = 0;
    }

    // The expected number of boxes beside a box on an axis is proportional to the mean width over the spread.
    private bool SpreadsMoreVertically(Box* boxes)
    {
        double x = 0;
        double y = 0;
        double xx = 0;
        double yy = 0;
        double width = 0;
        double height = 0;
        ref Box origin = ref boxes[_live.Pointer[0]];
        for (int i = 0; i < _live.Count; i++)
        {
            ref Box box = ref boxes[_live.Pointer[i]];
            double dx = (double)box.MinX - origin.MinX;
            double dy = (double)box.MinY - origin.MinY;
            x += dx;
            y += dy;
            xx += dx * dx;
            yy += dy * dy;
            width += (double)box.MaxX - box.MinX;
            height += (double)box.MaxY - box.MinY;
        }

        double n = _live.Count;
        double varianceX = (xx * n) - (x * x);
        double varianceY = (yy * n) - (y * y);
        return varianceY * width * width > varianceX * height * height;
    }

    private void Know(int end)
    {
        if (end > _known)
        {
            _places.EnsureCapacity(end);
            for (int i = _known; i < end; i++)
            {
                _places.Pointer[i].Level = Nowhere;
            }

            _known = end;
        }
    }

    private void Leave(int proxy)
    {
        ref Place place = ref _places[proxy];
        if (place.Level != Nowhere)
        {
            _sweeps[place.Level].Remove(place.Key, proxy);
            place.Level = Nowhere;
        }
    }

    private struct Place
    {
        /// <summary>The size class, or −1 for a box that is not in the order yet.</summary>
        public int Level;

        /// <summary>The lower edge by which the box was sorted in.</summary>
        public float Key;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        int sweeps = s.Value(_levelCount);
        while (_sweeps.Count < sweeps)
        {
            _sweeps.Add(new SweepLevel());
        }

        for (int i = 0; i < sweeps; i++)
        {
            _sweeps[i].Visit(s);
        }

        _levels.Visit(s);
        _live.Visit(s);
        _seekers.Visit(s);
        s.Column(_places);
        s.Value(ref _known);
        s.Value(ref _levelCount);
        s.Value(ref _shifts);
    }
}
