using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// A bounding tree with eight children a node, for boxes that seldom change: built bottom up over a space-filling curve in O(n), searched
/// eight boxes a test in about O(log n + hits). No pointers: the nodes of a layer follow each other, and the children of node k of
/// a layer are 8k … 8k + 7 of the layer below, whose lowest one are the boxes themselves.
/// </summary>
internal sealed unsafe class PackedTree
{
    private const int Width = WideBoxes.Width;

    // 8¹¹ boxes are more than an int can count.
    private const int MaxLayers = 12;

    /// <summary>Bits for a layer below the number of a group that waits: there is memory for less than 2²⁸ groups.</summary>
    private const int LayerBits = 4;

    private readonly BoxRows _lanes = new BoxRows();
    private readonly Column<int> _proxies = new Column<int>(1);
    private readonly int[] _layerStart = new int[MaxLayers + 1];
    private readonly int[] _layerEnd = new int[MaxLayers + 1];
    private int _layers;

    /// <summary>Most groups and boxes that wait on the way down: each layer leaves at most its eight.</summary>
    public const int MostWaiting = (MaxLayers + 1) * Width;

    /// <summary>Boxes built in, removed ones included.</summary>
    public int SlotCount { get; private set; }

    /// <summary>Boxes left.</summary>
    public int Count { get; private set; }

    /// <summary>The boxes of all layers.</summary>
    public WideBoxes Boxes => _lanes.Wide;

    /// <summary>The layer that is one group.</summary>
    public int TopLayer => _layers - 1;

    /// <summary>Where the boxes of a layer begin; layer 0 are the boxes that were built in.</summary>
    public int LayerStart(int layer) => _layerStart[layer];

    /// <summary>The proxy in a slot, 0 … <see cref="SlotCount"/> − 1.</summary>
    public int Proxy(int slot) => _proxies[slot];

    /// <summary>Makes room for so many boxes, so that a later build does not allocate.</summary>
    public void Reserve(int count)
    {
        _proxies.EnsureCapacity(count + Width);

        // The layers above the boxes are together a seventh of them, each rounded up to a whole group.
        _lanes.EnsureCapacity(count + (count / (Width - 1)) + (MaxLayers * Width));
    }

    /// <summary>Builds the tree anew over the given proxies. Slots are numbered along the curve.</summary>
    public void Build(Scratch scratch, Box* boxes, int* members, int count)
    {
        SlotCount = count;
        Count = count;
        _proxies.EnsureCapacity(count + Width);
        int* proxies = _proxies.Pointer;
        SortAlongCurve(scratch, boxes, members, proxies, count);
        Layout(count);
        WideBoxes lanes = _lanes.Wide;
        for (int i = 0; i < count; i++)
        {
            lanes.Set(i, boxes[proxies[i]]);
        }

        for (int layer = 1; layer < _layers; layer++)
        {
            int children = _layerStart[layer - 1];
            int nodes = _layerEnd[layer] - _layerStart[layer];
            for (int k = 0; k < nodes; k++)
            {
                lanes.Set(_layerStart[layer] + k, lanes.Around(children + (k * Width)));
            }
        }
    }

    /// <summary>Takes a box out. The bounds above it stay: too large is only slower, and the next build mends it.</summary>
    public void Remove(int slot)
    {
        System.Diagnostics.Debug.Assert((uint)slot < (uint)SlotCount && _proxies[slot] >= 0, "removing an empty slot");
        _lanes.Wide.SetEmpty(slot);
        _proxies[slot] = -1;
        Count--;
    }

    /// <summary>Changes the box in a slot and the bounds above it, O(log n).</summary>
    public void Refit(int slot, in Box box)
    {
        WideBoxes lanes = _lanes.Wide;
        lanes.Set(slot, box);
        int k = slot;
        for (int layer = 1; layer < _layers; layer++)
        {
            k /= Width;
            lanes.Set(_layerStart[layer] + k, lanes.Around(_layerStart[layer - 1] + (k * Width)));
        }
    }

    /// <summary>Appends the proxies whose boxes share a point with <paramref name="box"/>, in the order of the curve.</summary>
    public void Overlap(in Box box, IndexList hits)
    {
        if (Count == 0)
        {
            return;
        }

        // Each layer on the way down leaves at most its eight lanes waiting.
        int* stack = stackalloc int[MaxLayers * Width];
        int depth = 0;
        stack[depth++] = _layers - 1;
        WideBoxes lanes = _lanes.Wide;
        var spread = new SpreadBox(box);
        while (depth > 0)
        {
            int group = stack[--depth] >> LayerBits;
            int layer = stack[depth] & ((1 << LayerBits) - 1);
            uint mask = lanes.Overlaps(_layerStart[layer] + (group * Width), spread);
            if (layer == 0)
            {
                for (; mask != 0; mask &= mask - 1)
                {
                    hits.Add(_proxies.Pointer[(group * Width) + WideBoxes.LowestLane(mask)]);
                }

                continue;
            }

            // The lowest lane on top, so that it is searched first. Which lanes there are cannot be foreseen, so each is not asked for:
            // half a percent of a step of piles.
            for (uint left = mask; left != 0; left &= left - 1)
            {
                depth++;
            }

            for (int place = depth; mask != 0; mask &= mask - 1)
            {
                stack[--place] = (((group * Width) + WideBoxes.LowestLane(mask)) << LayerBits) + layer - 1;
            }
        }
    }

    // Layers are padded to whole groups of empty boxes, the topmost is one group.
    private void Layout(int count)
    {
        int start = 0;
        int size = count;
        _layers = 0;
        while (true)
        {
            _layerStart[_layers] = start;
            _layerEnd[_layers] = start + size;
            _layers++;
            int groups = (size + Width - 1) / Width;
            start += groups * Width;
            if (size <= Width)
            {
                break;
            }

            size = groups;
        }

        _lanes.SetCount(start);
        for (int layer = 0; layer < _layers; layer++)
        {
            int end = layer + 1 < _layers ? _layerStart[layer + 1] : start;
            for (int i = _layerEnd[layer]; i < end; i++)
            {
                _lanes.Wide.SetEmpty(i);
            }
        }
    }

    // Orders the members by the Morton code of their centres, 16 bits an axis over the extent of all centres.
    private void SortAlongCurve(Scratch scratch, Box* boxes, int* members, int* sorted, int count)
    {
        double minX = double.PositiveInfinity;
        double minY = double.PositiveInfinity;
        double maxX = double.NegativeInfinity;
        double maxY = double.NegativeInfinity;
        for (int i = 0; i < count; i++)
        {
            Box* box = boxes + members[i];
            double x = (double)box->MinX + box->MaxX;
            double y = (double)box->MinY + box->MaxY;
            if (FloatBits.IsFinite(x) && FloatBits.IsFinite(y))
            {
                minX = x < minX ? x : minX;
                minY = y < minY ? y : minY;
                maxX = x > maxX ? x : maxX;
                maxY = y > maxY ? y : maxY;
            }
        }

        double extent = maxX - minX > maxY - minY ? maxX - minX : maxY - minY;
        double scale = extent > 0 ? 65535 / extent : 0;
        int mark = scratch.Mark;
        ulong* codes = scratch.Take<ulong>(count);
        for (int i = 0; i < count; i++)
        {
            Box* box = boxes + members[i];
            double x = ((double)box->MinX + box->MaxX - minX) * scale;
            double y = ((double)box->MinY + box->MaxY - minY) * scale;

            // A box without bounds has no centre; what a cast makes of it would depend on the processor.
            codes[i] = FloatBits.IsFinite(x) && FloatBits.IsFinite(y) ? Spread((uint)x) | (Spread((uint)y) << 1) : 0;
            sorted[i] = members[i];
        }

        RadixSort.Sort(scratch, codes, sorted, count);
        scratch.Release(mark);
    }

    // Puts a zero before each of the 16 low bits.
    private static uint Spread(uint value)
    {
        value &= 0xFFFF;
        value = (value | (value << 8)) & 0x00FF00FF;
        value = (value | (value << 4)) & 0x0F0F0F0F;
        value = (value | (value << 2)) & 0x33333333;
        return (value | (value << 1)) & 0x55555555;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _lanes.Visit(s);
        SlotCount = s.Value(SlotCount);
        s.Column(_proxies, SlotCount);
        s.Array(_layerStart);
        s.Array(_layerEnd);
        s.Value(ref _layers);
        Count = s.Value(Count);
    }
}
