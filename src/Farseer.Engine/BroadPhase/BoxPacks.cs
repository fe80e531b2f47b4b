using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// Boxes listed anew for a step, in packs of eight with a box around each pack: neighbours in a list of walls are mostly neighbours in the
/// world, and of 360 edges around a bin six tests of packs leave one or two packs to look into, where one after the other took 45 tests.
/// </summary>
[NotState(Why.Derived)]
internal sealed class BoxPacks
{
    private readonly LooseBoxes _boxes = new LooseBoxes();
    private readonly BoxRows _packs = new BoxRows();

    public int Count => _boxes.Count;

    /// <summary>The boxes, those of pack i from 8·i on.</summary>
    public WideBoxes Boxes => _boxes.Boxes;

    public int Proxy(int place) => _boxes.Proxy(place);

    /// <summary>Makes room for so many boxes.</summary>
    public void Reserve(int count)
    {
        _boxes.Reserve(count);
        _packs.EnsureCapacity((count + WideBoxes.Width - 1) / WideBoxes.Width);
    }

    public void Clear()
    {
        _boxes.Clear();
        _packs.SetCount(0);
    }

    public void Add(int proxy, in Box box)
    {
        int pack = _boxes.Add(proxy, box) / WideBoxes.Width;
        _packs.SetCount(pack + 1);
        _packs.Wide.Set(pack, _boxes.Boxes.Around(pack * WideBoxes.Width));
    }

    /// <summary>The first pack from one on that a box may meet, or −1.</summary>
    public int NextPack(int from, in SpreadBox box)
    {
        uint left = uint.MaxValue << (from % WideBoxes.Width);
        for (int first = from - (from % WideBoxes.Width); first < _packs.Count; first += WideBoxes.Width)
        {
            uint mask = _packs.Wide.Overlaps(first, box) & left;
            if (mask != 0)
            {
                return first + WideBoxes.LowestLane(mask);
            }

            left = uint.MaxValue;
        }

        return -1;
    }
}
