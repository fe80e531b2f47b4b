using System;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <summary>A list that lives within a phase, in memory of a <see cref="Scratch"/>.</summary>
[NotState(Why.OfOneStep)]
internal unsafe struct ScratchList<T>
    where T : unmanaged
{
    private const int Least = 64;

    private readonly Scratch _scratch;
    private int _capacity;

    public ScratchList(Scratch scratch)
        : this()
    {
        _scratch = scratch;
    }

    public T* Pointer { get; private set; }

    public int Count { get; private set; }

    public readonly ref T this[int position]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            MemoryGuard.CheckIndex(position, Count, typeof(T));
            return ref Pointer[position];
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(in T item)
    {
        if (Count == _capacity)
        {
            Grow(Count + 1);
        }

        Pointer[Count++] = item;
    }

    /// <summary>Sets the length, of which what lies beyond the old one is undefined until written.</summary>
    public void SetCount(int count)
    {
        if (count > _capacity)
        {
            Grow(count);
        }

        Count = count;
    }

    // The old place is lost until the phase ends: by doubling that is as much again at most.
    private void Grow(int needed)
    {
        int capacity = Math.Max(needed, Math.Max(Least, 2 * _capacity));
        T* grown = _scratch.Take<T>(capacity);
        for (int i = 0; i < Count; i++)
        {
            grown[i] = Pointer[i];
        }

        Pointer = grown;
        _capacity = capacity;
    }
}
