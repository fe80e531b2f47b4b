using System;

namespace Farseer.Engine.Storage;

/// <summary>
/// Items in the order in which they came, known by how many came before: new ones are appended, and both ends can be cut off. Its memory
/// goes round, so that nothing is moved or allocated unless there are more of them than ever.
/// </summary>
internal sealed class Ring<T>
{
    private T[] _items = new T[16];

    /// <summary>Where the oldest item is.</summary>
    public long Begin { get; private set; }

    /// <summary>Where the next item will be.</summary>
    public long End { get; private set; }

    public ref T this[long place]
    {
        get
        {
            System.Diagnostics.Debug.Assert(place >= Begin && place < End, "place out of range");
            return ref _items[At(place)];
        }
    }

    public void Append(ReadOnlySpan<T> items)
    {
        EnsureRoom(items.Length);
        int first = Math.Min(items.Length, _items.Length - At(End));
        items.Slice(0, first).CopyTo(new Span<T>(_items, At(End), first));
        items.Slice(first).CopyTo(_items);
        End += items.Length;
    }

    public void Append(in T item)
    {
        EnsureRoom(1);
        _items[At(End++)] = item;
    }

    /// <summary>Reads so many items from a place on.</summary>
    public void CopyTo(long place, Span<T> items)
    {
        int first = Math.Min(items.Length, _items.Length - At(place));
        new ReadOnlySpan<T>(_items, At(place), first).CopyTo(items);
        new ReadOnlySpan<T>(_items, 0, items.Length - first).CopyTo(items.Slice(first));
    }

    /// <summary>Drops what lies before a place.</summary>
    public void DropBefore(long place)
    {
        Clear(Begin, place);
        Begin = place;
    }

    /// <summary>Drops what lies from a place on.</summary>
    public void DropFrom(long place)
    {
        Clear(place, End);
        End = place;
    }

    // The length is a power of two.
    private int At(long place) => (int)(place & (_items.Length - 1));

    /// <summary>What is dropped is not kept alive.</summary>
    private void Clear(long from, long to)
    {
        int count = typeof(T).IsValueType ? 0 : (int)(to - from);
        if (count > 0)
        {
            int first = Math.Min(count, _items.Length - At(from));
            Array.Clear(_items, At(from), first);
            Array.Clear(_items, 0, count - first);
        }
    }

    private void EnsureRoom(int more)
    {
        long needed = End - Begin + more;
        if (needed <= _items.Length)
        {
            return;
        }

        if (needed > 1 << 30)
        {
            throw new OutOfMemoryException($"A ring of {needed} items exceeds its limit of {1 << 30}.");
        }

        long length = _items.Length;
        while (length < needed)
        {
            length *= 2;
        }

        var items = new T[length];
        for (long place = Begin; place < End;)
        {
            // Up to where either of them goes round.
            int from = At(place);
            var to = (int)(place & (length - 1));
            var count = (int)Math.Min(End - place, Math.Min(_items.Length - from, length - to));
            Array.Copy(_items, from, items, to, count);
            place += count;
        }

        _items = items;
    }
}
