using System;
using System.Collections.Generic;

namespace Farseer.Engine.Storage;

/// <summary>
/// Memory of the phases of a step, of which each piece is a guarded block of its own. What is taken is spoilt before, and again when it is
/// released.
/// </summary>
internal sealed unsafe class Scratch
{
    /// <summary>Bytes of the smallest blocks, as a power of two.</summary>
    private const int LeastShift = 14;

    private readonly Column<byte> _lasting = new Column<byte>();

    private readonly List<GuardedBlock> _taken = new List<GuardedBlock>();

    /// <summary>How much was taken before each of them.</summary>
    private readonly List<int> _marks = new List<int>();

    /// <summary>Released blocks, by doublings of their size: the one that was released first is taken first.</summary>
    private readonly List<Queue<GuardedBlock>> _released = new List<Queue<GuardedBlock>>();

    ~Scratch()
    {
        foreach (Queue<GuardedBlock> blocks in _released)
        {
            foreach (GuardedBlock block in blocks)
            {
                block.Release();
            }
        }

        foreach (GuardedBlock block in _taken)
        {
            block.Release();
        }
    }

    public T* Lasting<T>(int count)
        where T : unmanaged
    {
        _lasting.EnsureCapacity(checked(count * sizeof(T)));
        return (T*)_lasting.Pointer;
    }

    /// <summary>Nobody keeps it.</summary>
    public int Capacity => 0;

    /// <summary>What is used together with it by whoever it is lent to; null: nothing yet.</summary>
    public object? Tools { get; set; }

    /// <summary>Another one of the thread that shares it among its worlds.</summary>
    public Scratch? Next { get; set; }

    /// <summary>Memory of so many bytes.</summary>
    public static Scratch Of(int bytes)
    {
        var scratch = new Scratch();
        scratch.Reserve(bytes);
        return scratch;
    }

    public int Mark { get; private set; }

    public T* Take<T>(int count)
        where T : unmanaged
    {
        long bytes = (long)count * sizeof(T);
        GuardedBlock block = BlockOf(bytes, typeof(T));
        _taken.Add(block);
        _marks.Add(Mark);
        Mark = checked((int)(Mark + bytes + MemoryGuard.Alignment));
        MemoryGuard.Spoil(block.Start, bytes);
        return (T*)block.Start;
    }

    public void Reserve(int bytes) => System.Diagnostics.Debug.Assert(Mark == 0 && bytes >= 0, "room is made while nothing is taken");

    public void Release(int mark)
    {
        for (int last = _taken.Count - 1; last >= 0 && _marks[last] >= mark; last--)
        {
            GuardedBlock block = _taken[last];
            MemoryGuard.Check(block);
            MemoryGuard.Spoil(block.Start, block.Bytes);
            _released[SizeOf(block.Room)].Enqueue(block);
            _taken.RemoveAt(last);
            _marks.RemoveAt(last);
        }

        Mark = Math.Min(Mark, mark);
    }

    public void Watch()
    {
    }

    public void Trim() => System.Diagnostics.Debug.Assert(Mark == 0, "memory is given back while nothing is taken");

    private GuardedBlock BlockOf(long bytes, Type type)
    {
        int size = SizeOf(bytes);
        while (_released.Count <= size)
        {
            _released.Add(new Queue<GuardedBlock>());
        }

        if (_released[size].Count > 0)
        {
            GuardedBlock block = _released[size].Dequeue();
            block.SetBytes(bytes, type);
            return block;
        }

        GuardedBlock taken = MemoryGuard.TakeUnlisted(1L << (size + LeastShift), type);
        taken.SetBytes(bytes, type);
        return taken;
    }

    private static int SizeOf(long bytes)
    {
        int size = 0;
        while (1L << (size + LeastShift) < bytes)
        {
            size++;
        }

        return size;
    }
}
