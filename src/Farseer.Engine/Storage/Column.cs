using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Storage;

/// <summary>
/// A growable array of small unmanaged records in pinned, 64-byte-aligned memory that the garbage collector owns. Kernels take
/// <see cref="Pointer"/>; it stays valid until the column grows, which happens only between phases. New records are zero.
/// </summary>
internal sealed unsafe class Column<T> : IColumn
    where T : unmanaged
{
    /// <summary>
    /// That of a cache line, and of a vector, which is enough for the few records of a small column: most of the hundreds of a small world
    /// are.
    /// </summary>
    private const int Alignment = 64;
    private const int SmallAlignment = 16;
    private const int SmallBytes = 1 << 10;

    /// <summary>Where the data of an array begins is a multiple of it.</summary>
    private const int ArrayAlignment = 8;

    private byte[] _memory;
    private int _capacity;
#if !NET8_0_OR_GREATER
    private GCHandle _pin;

    // Without a pinned heap the array is pinned by a handle, which must be given back.
    ~Column()
    {
        if (_pin.IsAllocated)
        {
            _pin.Free();
        }
    }
#endif

    /// <summary>Takes no memory before there is room for a first record: a scene that has none of a kind pays nothing for it.</summary>
    public Column(int capacity = 0)
    {
        _memory = Array.Empty<byte>();
        if (capacity > 0)
        {
            Move(capacity);
        }
    }

    /// <summary>The first record; null while there is no room for any.</summary>
    public T* Pointer { get; private set; }

    public int Capacity => _capacity;

    byte* IColumn.Bytes => (byte*)Pointer;

    int IColumn.ElementSize => sizeof(T);

    public ref T this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            System.Diagnostics.Debug.Assert((uint)index < (uint)_capacity, "column index out of range");
            return ref Pointer[index];
        }
    }

    /// <summary>Grows to at least <paramref name="capacity"/> records, as <see cref="ColumnGrowth"/> says, and keeps the content.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void EnsureCapacity(int capacity)
    {
        if (capacity > _capacity)
        {
            Grow(capacity);
        }
    }

    void IColumn.GrowTo(int capacity)
    {
        if (capacity > _capacity)
        {
            Move(capacity);
        }
    }

    /// <summary>
    /// By itself: it allocates, and what that needs of the thread was looked up by each of the dozens of questions of a step whether there
    /// is room (3 % of one with 20 boxes).
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Grow(int capacity) => Move(ColumnGrowth.Next(_capacity, capacity, sizeof(T)));

    private void Move(int wanted)
    {
        int alignment = (long)wanted * sizeof(T) < SmallBytes ? SmallAlignment : Alignment;
        long bytes = ((long)wanted * sizeof(T)) + alignment - ArrayAlignment;
        if (bytes > int.MaxValue)
        {
            throw new OutOfMemoryException($"A column of {wanted} records of {sizeof(T)} bytes exceeds 2 GiB.");
        }

#if NET8_0_OR_GREATER
        byte[] memory = GC.AllocateArray<byte>((int)bytes, pinned: true);
        byte* start = (byte*)Unsafe.AsPointer(ref MemoryMarshal.GetArrayDataReference(memory));
#else
        byte[] memory = new byte[bytes];
        GCHandle pin = GCHandle.Alloc(memory, GCHandleType.Pinned);
        byte* start = (byte*)pin.AddrOfPinnedObject();
#endif
        T* aligned = (T*)(((nuint)start + (nuint)(alignment - 1)) & ~(nuint)(alignment - 1));
        if (_capacity > 0)
        {
            Unsafe.CopyBlock(aligned, Pointer, (uint)(_capacity * sizeof(T)));
        }

#if !NET8_0_OR_GREATER
        if (_pin.IsAllocated)
        {
            _pin.Free();
        }

        _pin = pin;
#endif
        _memory = memory;
        Pointer = aligned;
        _capacity = wanted;
    }
}
