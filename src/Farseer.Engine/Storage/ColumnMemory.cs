using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Storage;

/// <summary>
/// The memory of a <see cref="Column{T}"/>, whatever its records: code of a generic class is compiled for each kind of record by itself,
/// and there are some dozens of them in the first step of a process.
/// </summary>
internal abstract unsafe class ColumnMemory : IColumn
{
    /// <summary>The first byte; null while there is no room for any record.</summary>
    protected byte* _start;

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
    private readonly int _size;
    private int _capacity;
#if !NET8_0_OR_GREATER
    private GCHandle _pin;

    // Without a pinned heap the array is pinned by a handle, which must be given back.
    ~ColumnMemory()
    {
        if (_pin.IsAllocated)
        {
            _pin.Free();
        }
    }
#endif

    /// <param name="size">Bytes a record.</param>
    /// <param name="capacity">Records that there is room for.</param>
    protected ColumnMemory(int size, int capacity)
    {
        _size = size;
        _memory = Array.Empty<byte>();
        if (capacity > 0)
        {
            Move(capacity);
        }
    }

    public int Capacity => _capacity;

    byte* IColumn.Bytes => _start;

    int IColumn.ElementSize => _size;

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
    private void Grow(int capacity) => Move(ColumnGrowth.Next(_capacity, capacity, _size));

    private void Move(int wanted)
    {
        int alignment = (long)wanted * _size < SmallBytes ? SmallAlignment : Alignment;
        long bytes = ((long)wanted * _size) + alignment - ArrayAlignment;
        if (bytes > int.MaxValue)
        {
            throw new OutOfMemoryException($"A column of {wanted} records of {_size} bytes exceeds 2 GiB.");
        }

#if NET8_0_OR_GREATER
        byte[] memory = GC.AllocateArray<byte>((int)bytes, pinned: true);
        byte* start = (byte*)Unsafe.AsPointer(ref MemoryMarshal.GetArrayDataReference(memory));
#else
        byte[] memory = new byte[bytes];
        GCHandle pin = GCHandle.Alloc(memory, GCHandleType.Pinned);
        byte* start = (byte*)pin.AddrOfPinnedObject();
#endif
        byte* aligned = (byte*)(((nuint)start + (nuint)(alignment - 1)) & ~(nuint)(alignment - 1));
        if (_capacity > 0)
        {
            Unsafe.CopyBlock(aligned, _start, (uint)(_capacity * _size));
        }

#if !NET8_0_OR_GREATER
        if (_pin.IsAllocated)
        {
            _pin.Free();
        }

        _pin = pin;
#endif
        _memory = memory;
        _start = aligned;
        _capacity = wanted;
    }
}
