using System.Collections.Generic;

namespace Farseer.Engine.Storage;

/// <summary>
/// Memory that the phases of a step use one after the other, aligned to cache lines. Each phase had columns of its own for what it forgets
/// at its end, which together were more than all that is kept of a body. What is taken holds whatever was there before; it stays
/// where it is until it is released, also if more is taken meanwhile. Taken by the calling thread alone.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class Scratch
{
    private const int Alignment = 64;

    /// <summary>Blocks that turned out too small, kept until all is released.</summary>
    private readonly List<Column<byte>> _outgrown = new List<Column<byte>>();
    private readonly Column<byte> _lasting = new Column<byte>();
    private Column<byte> _block = new Column<byte>();

    /// <summary>Bytes taken of the blocks that were outgrown, and of the present one.</summary>
    private int _usedBefore;
    private int _used;

    /// <summary>The most that was taken at a time since it was last counted anew.</summary>
    private int _high;

    /// <summary>Memory for so many records that stays, beside what is taken: zero at first, then as its users left it.</summary>
    public T* Lasting<T>(int count)
        where T : unmanaged
    {
        _lasting.EnsureCapacity(checked(count * sizeof(T)));
        return (T*)_lasting.Pointer;
    }

    /// <summary>Bytes that it has, but for those it has outgrown.</summary>
    public int Capacity => _block.Capacity;

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

    /// <summary>How much is taken: what is taken from here on is released by <see cref="Release"/>.</summary>
    public int Mark => _usedBefore + _used;

    /// <summary>Room for so many records, whose content is undefined.</summary>
    public T* Take<T>(int count)
        where T : unmanaged
    {
        int bytes = checked((int)((((long)count * sizeof(T)) + (Alignment - 1)) & -Alignment));
        if (bytes > _block.Capacity - _used)
        {
            Outgrow(bytes);
        }

        T* start = (T*)(_block.Pointer + _used);
        _used += bytes;
        _high = System.Math.Max(_high, Mark);
        return start;
    }

    /// <summary>Makes room for so many bytes; nothing is taken yet.</summary>
    public void Reserve(int bytes)
    {
        System.Diagnostics.Debug.Assert(Mark == 0, "room is made while nothing is taken");
        _block.EnsureCapacity(bytes);
    }

    /// <summary>Gives back what was taken since the mark. The last one to leave makes one block of several.</summary>
    public void Release(int mark)
    {
        if (mark >= _usedBefore)
        {
            _used = mark - _usedBefore;
        }

        if (mark == 0 && _outgrown.Count > 0)
        {
            int most = 0;
            foreach (Column<byte> block in _outgrown)
            {
                most = System.Math.Max(most, block.Capacity);
            }

            _outgrown.Clear();
            _used = 0;
            _usedBefore = 0;
            _block.EnsureCapacity(most);
        }
    }

    /// <summary>Counts anew from here on what is taken at a time.</summary>
    public void Watch() => _high = 0;

    /// <summary>Gives back memory of which much less was taken at a time since <see cref="Watch"/>; a sixteenth stays to spare.</summary>
    public void Trim()
    {
        System.Diagnostics.Debug.Assert(Mark == 0, "memory is given back while nothing is taken");
        int wanted = _high + (_high / 16);
        if (wanted < _block.Capacity - (_block.Capacity / 16))
        {
            _block = new Column<byte>(wanted);
        }
    }

    private void Outgrow(int bytes)
    {
        _outgrown.Add(_block);
        _usedBefore = checked(_usedBefore + _used);
        _used = 0;
        _block = new Column<byte>(ColumnGrowth.Next(_block.Capacity, checked(_usedBefore + bytes), 1));
    }
}
