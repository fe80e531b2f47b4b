using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// Keeps the box edges sorted along both axes and the set of overlapping pairs beside them. Little motion costs O(n + exchanges +
/// pairs); a jump past k edges costs k exchanges, and when these become too many (a mass of new or thrown boxes) both axes
/// are sorted anew in O(n + overlaps along x). Suits worlds that move little and evenly.
/// </summary>
internal sealed unsafe class SweepAndPrune : IBroadPhase
{
    // Exchanges an edge beyond which sorting anew is cheaper: an exchange with a pair change costs about ten of the radix sort's moves.
    private const int ExchangesAnEdge = 16;

    private readonly SweepAxis _x = new SweepAxis(vertical: false);
    private readonly SweepAxis _y = new SweepAxis(vertical: true);
    private readonly PairSet _pairs = new PairSet();
    private readonly BitSet _tracked = new BitSet();
    private readonly BitSet _added = new BitSet();
    private readonly BitSet _removed = new BitSet();
    private readonly IndexList _open = new IndexList();
    private readonly Column<int> _openSlot = new Column<int>(1);
    private bool _anyRemoved;

    public void Added(ProxyStore proxies, int proxy) => _added.Set(proxy);

    public void Removed(ProxyStore proxies, int proxy)
    {
        _added.Clear(proxy);
        if (_tracked.Test(proxy))
        {
            _tracked.Clear(proxy);
            _removed.Set(proxy);
            _anyRemoved = true;
        }
    }

    public void Collect(ProxyStore proxies, PairBuffer pairs)
    {
        if (!AnySeeks(proxies))
        {
            return;
        }

        DropRemoved();
        _x.Refresh(proxies);
        _y.Refresh(proxies);
        Box* boxes = proxies.Fat.Pointer;
        int before = _x.Count;
        for (int proxy = _added.Next(0); proxy >= 0; proxy = _added.Next(proxy + 1))
        {
            _x.Append(boxes, proxy);
            _y.Append(boxes, proxy);
            _added.Clear(proxy);
            _tracked.Set(proxy);
        }

        // Appended edges travel over half of the axis on average: many of them at once are hopeless.
        long budget = (long)ExchangesAnEdge * _x.Count;
        bool hopeless = (_x.Count - before) * (long)_x.Count / 2 > budget;
        if (hopeless || !_x.SortStep(boxes, _pairs, budget) || !_y.SortStep(boxes, _pairs, budget))
        {
            Rebuild(proxies);
        }

        ProxyInfo* info = proxies.Info.Pointer;
        for (int i = 0; i < _pairs.Count; i++)
        {
            int a = PairBuffer.Lower(_pairs[i]);
            int b = PairBuffer.Higher(_pairs[i]);
            if (PairRule.Wants(info[a], info[b]))
            {
                pairs.Add(a, b);
            }
        }
    }

    private static bool AnySeeks(ProxyStore proxies)
    {
        for (int i = 0; i < proxies.End; i++)
        {
            if (PairRule.Seeks(proxies.Info.Pointer[i].Flags))
            {
                return true;
            }
        }

        return false;
    }

    private void DropRemoved()
    {
        if (!_anyRemoved)
        {
            return;
        }

        _x.Drop(_removed);
        _y.Drop(_removed);
        for (int i = _pairs.Count - 1; i >= 0; i--)
        {
            ulong pair = _pairs[i];
            if (_removed.Test(PairBuffer.Lower(pair)) || _removed.Test(PairBuffer.Higher(pair)))
            {
                _pairs.Remove(pair);
            }
        }

        _removed.ClearAll();
        _anyRemoved = false;
    }

    // Sorts both axes and sweeps along x with the list of boxes the sweep line is in.
    private void Rebuild(ProxyStore proxies)
    {
        _x.SortAnew();
        _y.SortAnew();
        _pairs.Clear();
        _open.Clear();
        _openSlot.EnsureCapacity(proxies.End);
        Box* boxes = proxies.Fat.Pointer;
        int* slots = _openSlot.Pointer;
        for (int i = 0; i < _x.Count; i++)
        {
            int proxy = SweepAxis.Proxy(_x[i]);
            if (SweepAxis.IsUpper(_x[i]))
            {
                int last = _open[_open.Count - 1];
                _open.Pointer[slots[proxy]] = last;
                slots[last] = slots[proxy];
                _open.SetCount(_open.Count - 1);
                continue;
            }

            for (int k = 0; k < _open.Count; k++)
            {
                if (Box.Overlap(boxes[proxy], boxes[_open.Pointer[k]]))
                {
                    _pairs.Add(PairBuffer.Pack(proxy, _open.Pointer[k]));
                }
            }

            slots[proxy] = _open.Count;
            _open.Add(proxy);
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _x.Visit(s);
        _y.Visit(s);
        _pairs.Visit(s);
        _tracked.Visit(s);
        _added.Visit(s);
        _removed.Visit(s);
        _open.Visit(s);
        s.Column(_openSlot);
        s.Value(ref _anyRemoved);
    }
}
