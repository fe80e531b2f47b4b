using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// Boxes of like size in ascending order of their lower edge along one axis (then of their number). What may overlap a
/// box lies in one run of this order, from one margin before the box to its upper edge.
/// </summary>
internal sealed unsafe class SweepLevel
{
    // Covers the rounding of "lower edge minus margin", which is below 2⁻²⁸ margins.
    private const double MarginSlack = 1 + (1.0 / (1 << 20));

    private readonly BoxRows _rows = new BoxRows();
    private readonly Column<int> _proxies = new Column<int>(1);
    private bool _vertical;
    private double _margin;

    public int Count => _rows.Count;

    /// <summary>No box of this level may be larger.</summary>
    public double Margin => _margin;

    private float* Lower => _vertical ? _rows.Wide.MinY : _rows.Wide.MinX;

    /// <summary>Makes room for so many boxes, so that boxes which change their size class do not allocate in the middle of a run.</summary>
    public void Reserve(int count)
    {
        _proxies.EnsureCapacity(count);
        _rows.EnsureCapacity(count);
    }

    /// <param name="boxes">All boxes.</param>
    /// <param name="members">The boxes of this level, ascending.</param>
    /// <param name="count">Number of them.</param>
    /// <param name="margin">No box is larger.</param>
    /// <param name="vertical">Sorts along y.</param>
    /// <param name="scratch">Where room is found meanwhile.</param>
    public void Build(Box* boxes, int* members, int count, double margin, bool vertical, Scratch scratch)
    {
        _vertical = vertical;
        _margin = margin;
        _proxies.EnsureCapacity(count);
        int* proxies = _proxies.Pointer;
        int mark = scratch.Mark;
        ulong* keys = scratch.Take<ulong>(count);
        for (int i = 0; i < count; i++)
        {
            proxies[i] = members[i];
            keys[i] = RadixSort.OrderedBits(Key(boxes[members[i]]));
        }

        // The members come in ascending order, which the stable sort keeps among equals.
        RadixSort.Sort(scratch, keys, proxies, count);
        scratch.Release(mark);
        _rows.SetCount(count);
        WideBoxes wide = _rows.Wide;
        for (int i = 0; i < count; i++)
        {
            wide.Set(i, boxes[proxies[i]]);
        }
    }

    public float Key(in Box box) => _vertical ? box.MinY : box.MinX;

    /// <summary>Puts a box in; O(log n) and a move of the tail.</summary>
    public void Insert(in Box box, int proxy)
    {
        int count = Count;
        int slot = Find(Key(box), proxy);
        _proxies.EnsureCapacity(count + 1);
        _rows.SetCount(count + 1);
        Slide(slot, slot + 1, count - slot);
        Put(slot, box, proxy);
    }

    /// <summary>Takes a box out that was put in with the given key.</summary>
    public void Remove(float key, int proxy)
    {
        int slot = Find(key, proxy);
        System.Diagnostics.Debug.Assert(_proxies[slot] == proxy, "the box is not where its key says");
        Slide(slot + 1, slot, Count - slot - 1);
        _rows.SetCount(Count - 1);
    }

    /// <summary>Moves a box from its old key to its new place. Returns how many boxes had to make way.</summary>
    public int Shift(float oldKey, in Box box, int proxy)
    {
        int from = Find(oldKey, proxy);
        System.Diagnostics.Debug.Assert(_proxies[from] == proxy, "the box is not where its key says");
        float key = Key(box);

        // Found with the old entry still in place: behind it, the target is one too far.
        int to = key > oldKey ? Find(key, proxy) - 1 : Find(key, proxy);
        if (to < from)
        {
            Slide(to, to + 1, from - to);
        }
        else if (to > from)
        {
            Slide(from + 1, from, to - from);
        }

        Put(to, box, proxy);
        return to < from ? from - to : to - from;
    }

    /// <summary>All pairs within the level, each from its earlier box.</summary>
    public void CollectWithin(ProxyInfo* info, PairBuffer pairs)
    {
        for (int i = 0; i < Count; i++)
        {
            Scan(_rows.Wide.Get(i), _proxies.Pointer[i], i + 1, info, false, pairs);
        }
    }

    /// <summary>All pairs of this level's boxes with those of another level.</summary>
    public void CollectAgainst(SweepLevel other, ProxyInfo* info, PairBuffer pairs)
    {
        for (int i = 0; i < Count; i++)
        {
            other.Ask(_rows.Wide.Get(i), _proxies.Pointer[i], info, false, pairs);
        }
    }

    /// <summary>
    /// Pairs of one box with this level. With <paramref name="once"/> a pair of two moved boxes is reported only when the lower one asks.
    /// </summary>
    public void Ask(in Box box, int proxy, ProxyInfo* info, bool once, PairBuffer pairs)
    {
        double from = Key(box) - (_margin * MarginSlack);
        float* lower = Lower;
        int low = 0;
        int high = Count;
        while (low < high)
        {
            int middle = (int)((uint)(low + high) >> 1);
            if (lower[middle] < from)
            {
                low = middle + 1;
            }
            else
            {
                high = middle;
            }
        }

        Scan(box, proxy, low, info, once, pairs);
    }

    private void Scan(in Box box, int proxy, int from, ProxyInfo* info, bool once, PairBuffer pairs)
    {
        WideBoxes wide = _rows.Wide;
        float* lower = Lower;
        float upper = _vertical ? box.MaxY : box.MaxX;
        int count = Count;
        var spread = new SpreadBox(box);
        for (int k = from; k < count && lower[k] <= upper; k += WideBoxes.Width)
        {
            uint mask = wide.Overlaps(k, spread);
            while (mask != 0)
            {
                int other = _proxies.Pointer[k + WideBoxes.LowestLane(mask)];
                mask &= mask - 1;
                if (PairRule.Wants(info[proxy], info[other])
                    && (!once || proxy < other || !PairRule.Seeks(info[other].Flags)))
                {
                    pairs.Add(proxy, other);
                }
            }
        }
    }

    // The first slot whose (key, proxy) is not below the given one.
    private int Find(float key, int proxy)
    {
        float* lower = Lower;
        int low = 0;
        int high = Count;
        while (low < high)
        {
            int middle = (int)((uint)(low + high) >> 1);
            if (lower[middle] < key || (lower[middle] == key && _proxies.Pointer[middle] < proxy))
            {
                low = middle + 1;
            }
            else
            {
                high = middle;
            }
        }

        return low;
    }

    private void Put(int slot, in Box box, int proxy)
    {
        _rows.Wide.Set(slot, box);
        _proxies[slot] = proxy;
    }

    private void Slide(int from, int to, int count)
    {
        WideBoxes wide = _rows.Wide;
        Slide(wide.MinX, from, to, count);
        Slide(wide.MinY, from, to, count);
        Slide(wide.MaxX, from, to, count);
        Slide(wide.MaxY, from, to, count);
        Slide((float*)_proxies.Pointer, from, to, count);
    }

    private static void Slide(float* items, int from, int to, int count) =>
        System.Buffer.MemoryCopy(items + from, items + to, (long)count * sizeof(float), (long)count * sizeof(float));

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _rows.Visit(s);
        s.Column(_proxies, Count);
        s.Value(ref _vertical);
        s.Value(ref _margin);
    }
}
