using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <summary>A reused list of indices that keeps its memory.</summary>
internal sealed unsafe class IndexList
{
    private readonly Column<int> _items = new Column<int>();

    public int Count { get; private set; }

    public int* Pointer => _items.Pointer;

    public int Capacity => _items.Capacity;

    public int this[int position]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            MemoryGuard.CheckIndex(position, Count, typeof(IndexList));
            return _items[position];
        }
    }

    public void Clear() => Count = 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(int index)
    {
        if (Count == _items.Capacity)
        {
            _items.EnsureCapacity(Count + 1);
        }

        _items.Pointer[Count++] = index;
    }

    /// <summary>Makes room for so many.</summary>
    public void Reserve(int count) => _items.EnsureCapacity(count);

    /// <summary>Sets the length; what lies beyond the old one is undefined until written.</summary>
    public void SetCount(int count)
    {
        _items.EnsureCapacity(count);
        Count = count;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        Count = s.Value(Count);
        s.Column(_items, Count);
    }

    /// <summary>The same where the order is that in which workers came, and says nothing.</summary>
    public void VisitUnordered(StateStream s)
    {
        Count = s.Value(Count);
        s.Local(_items, Count);
    }
}
