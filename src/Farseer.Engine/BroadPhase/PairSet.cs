using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// A set of pairs that is kept from step to step: O(1) to add and remove, and a list to walk whose order does not come from a hash.
/// </summary>
internal sealed unsafe class PairSet
{
    private readonly PairMap _slots = new PairMap();
    private readonly Column<ulong> _list = new Column<ulong>(1);

    public int Count { get; private set; }

    public ulong this[int index] => _list[index];

    public void Clear()
    {
        _slots.Clear();
        Count = 0;
    }

    public void Add(ulong pair)
    {
        if (!_slots.Contains(pair))
        {
            _list.EnsureCapacity(Count + 1);
            _list[Count] = pair;
            _slots.Set(pair, Count++);
        }
    }

    /// <summary>The last pair of the list takes the place of the removed one.</summary>
    public void Remove(ulong pair)
    {
        if (_slots.Remove(pair, out int slot))
        {
            Count--;
            if (slot < Count)
            {
                ulong last = _list[Count];
                _list[slot] = last;
                _slots.Set(last, slot);
            }
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _slots.Visit(s);
        s.Column(_list);
        Count = s.Value(Count);
    }
}
