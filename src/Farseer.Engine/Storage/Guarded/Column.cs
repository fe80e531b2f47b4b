using System;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <summary>
/// A column in guarded memory: see <see cref="MemoryGuard"/>. Its old place cannot be touched any more when it has grown.
/// </summary>
internal sealed unsafe class Column<T> : IColumn
    where T : unmanaged
{
    private GuardedBlock? _block;

    public Column(int capacity = 0)
    {
        EnsureCapacity(capacity);
    }

    ~Column()
    {
        if (_block != null)
        {
            MemoryGuard.Return(_block, check: false);
        }
    }

    public T* Pointer { get; private set; }

    public int Capacity { get; private set; }

    byte* IColumn.Bytes => (byte*)Pointer;

    int IColumn.ElementSize => sizeof(T);

    public ref T this[int index]
    {
        get
        {
            MemoryGuard.CheckIndex(index, Capacity, typeof(T));
            return ref Pointer[index];
        }
    }

    public void EnsureCapacity(int capacity)
    {
        if (capacity <= Capacity)
        {
            return;
        }

        Move(ColumnGrowth.Next(Capacity, capacity, sizeof(T)));
    }

    void IColumn.GrowTo(int capacity)
    {
        if (capacity > Capacity)
        {
            Move(capacity);
        }
    }

    private void Move(int wanted)
    {
        GuardedBlock block = MemoryGuard.Take((long)wanted * sizeof(T), typeof(T));
        if (_block != null)
        {
            Unsafe.CopyBlock(block.Start, Pointer, (uint)(Capacity * sizeof(T)));
            MemoryGuard.Return(_block, check: true);
        }

        _block = block;
        Pointer = (T*)block.Start;
        Capacity = wanted;
    }
}
