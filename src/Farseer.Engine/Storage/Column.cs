using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <summary>
/// A growable array of small unmanaged records in pinned, 64-byte-aligned memory that the garbage collector owns. Kernels take
/// <see cref="Pointer"/>; it stays valid until the column grows, which happens only between phases. New records are zero.
/// </summary>
internal sealed unsafe class Column<T> : ColumnMemory
    where T : unmanaged
{
    /// <summary>Takes no memory before there is room for a first record: a scene that has none of a kind pays nothing for it.</summary>
    public Column(int capacity = 0)
        : base(sizeof(T), capacity)
    {
    }

    /// <summary>The first record; null while there is no room for any.</summary>
    public T* Pointer
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (T*)_start;
    }

    public ref T this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            System.Diagnostics.Debug.Assert((uint)index < (uint)Capacity, "column index out of range");
            return ref ((T*)_start)[index];
        }
    }
}
