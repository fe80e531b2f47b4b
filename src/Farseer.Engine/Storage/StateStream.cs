using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.InteropServices;
#endif

namespace Farseer.Engine.Storage;

/// <summary>
/// What a simulation remembers from step to step, written or read. Each owner of state has one method that visits its fields in
/// turn; the same method saves and restores, so that the two cannot disagree. Memory is kept: a stream that has grown allocates
/// nothing.
/// </summary>
internal sealed unsafe partial class StateStream
{
    /// <summary>Sections begin at multiples of it.</summary>
    public const int Alignment = 8;

    /// <summary>Bytes behind the end that those who change four words at once may write to.</summary>
    private const int Behind = 16;

    private readonly Column<byte> _bytes = new Column<byte>(1 << 12);
    private readonly Column<StatePlace> _sections = new Column<StatePlace>(16);
    private object?[] _objects = new object?[16];
    private int _at;
    private int _objectAt;

    // Where the bytes are, and where the room ends, or what was written: fields are visited by the hundred thousand.
    private byte* _start;
    private int _end;

    /// <summary>True while fields are set from the stream, false while they are written to it.</summary>
    public bool IsReading { get; private set; }

    /// <summary>Bytes written.</summary>
    public int Length { get; private set; }

    /// <summary>References written.</summary>
    public int ObjectCount { get; private set; }

    /// <summary>What was written, until it is written anew.</summary>
    public ReadOnlySpan<byte> Bytes => new ReadOnlySpan<byte>(_bytes.Pointer, Length);

    /// <summary>Words of what was written.</summary>
    public uint* Words => (uint*)_bytes.Pointer;

    /// <summary>References of what was written; behind them unused room.</summary>
    public object?[] Objects => _objects;

    /// <summary>Sections written.</summary>
    public int SectionCount { get; private set; }

    public bool IsSameAs(StateStream other)
    {
        if (!Bytes.SequenceEqual(other.Bytes) || ObjectCount != other.ObjectCount)
        {
            return false;
        }

        for (int i = 0; i < ObjectCount; i++)
        {
            // Handlers are equal by what they call.
            if (!ReferenceEquals(_objects[i], other._objects[i]) && !(_objects[i] is Delegate one && one.Equals(other._objects[i])))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Holds no reference any more.</summary>
    public void ForgetObjects()
    {
        CutObjects(0);
        Round = 0;
    }

    /// <summary>Forgets what was written and writes anew.</summary>
    public void BeginWriting()
    {
        IsReading = false;
        Room?.Clear();
        _names = Trace;
        _names?.Begin();
        _localCount = 0;
        if (_update is not null)
        {
            BeginUpdate();
            return;
        }

        BeginHolding();
        SectionCount = 0;
        Begin(_bytes.Capacity);
    }

    /// <param name="round">See <see cref="Round"/>.</param>
    public void EndWriting(long round = 0)
    {
        if (_update is not null)
        {
            EndUpdate(round);
            return;
        }

        Round = round;
        _names = null;
        Align();
        Length = _at;
        _bytes.EnsureCapacity(Length + Behind);
        CutObjects(_objectAt);
    }

    /// <summary>Reads what was written, from its start.</summary>
    public void BeginReading()
    {
        IsReading = true;
        _roomAt = 0;
        _section = 0;
        if (_update is not null)
        {
            BeginSections();
            return;
        }

        _since = Round;
        Begin(Length);
    }

    /// <summary>All that was written must have been read: the owners are the same ones then.</summary>
    public void EndReading()
    {
        if (_update is not null)
        {
            EndSections();
            return;
        }

        Align();
        IsReading = false;
        if (_at != Length || _objectAt != ObjectCount)
        {
            throw new InvalidOperationException(
                $"Of a state of {Length} bytes and {ObjectCount} references {_at} and {_objectAt} were read.");
        }
    }

    /// <summary>
    /// Something begins whose size may differ from state to state: states are compared section by section, so that one that is longer by a
    /// record does not make all behind it different.
    /// </summary>
    /// <param name="owner">Whose it is, if there may be others before it that come or go: it is found again by that.</param>
    /// <param name="number">Which of the owner's it is.</param>
    public void Section(object? owner = null, int number = 0)
    {
        if (_update is not null)
        {
            EnterSection(owner, number);
            return;
        }

        Align();
        if (IsReading)
        {
            _section++;
            return;
        }

        _sections.EnsureCapacity(SectionCount + 1);
        var place = new StatePlace { At = _at, ObjectAt = _objectAt };
        _isInStep = _isInStep && _sections[SectionCount].Equals(place);
        _sections[SectionCount++] = place;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Value<T>(ref T value, [CallerArgumentExpression(nameof(value))] string name = "")
        where T : unmanaged
    {
        if (_names is not null)
        {
            Note<T>(name);
        }

        byte* place = Advance(sizeof(T));
        if (IsReading)
        {
            value = Unsafe.ReadUnaligned<T>(place);
        }
        else
        {
            Unsafe.WriteUnaligned(place, value);
        }
    }

    /// <summary>For properties: <c>Count = stream.Value(Count)</c>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public T Value<T>(T value, [CallerArgumentExpression(nameof(value))] string name = "")
        where T : unmanaged
    {
        Value(ref value, name);
        return value;
    }

    /// <summary>
    /// A column of records that stay where they are. What lies behind the last one that is not zero is zero, as in new memory.
    /// </summary>
    public void Column<T>(Column<T> column, [CallerArgumentExpression(nameof(column))] string name = "")
        where T : unmanaged
    {
        Section(column);
        int count = IsReading ? 0 : StateBlock.Used((byte*)column.Pointer, (long)column.Capacity * sizeof(T), sizeof(T));
        count = Counted(count, name);
        _names?.Note(_at, _objectAt, name, new StateKind<T>(), isColumn: true);
        MakeRoom(column);
        Records(column, count);
        ClearBehind(column, count);
    }

    /// <summary>A column of which nobody reads what lies behind so many records before it is written.</summary>
    public void Column<T>(Column<T> column, int count, [CallerArgumentExpression(nameof(column))] string name = "")
        where T : unmanaged
    {
        Section(column);
        _names?.Note(_at, _objectAt, name, new StateKind<T>(), isColumn: true);
        MakeRoom(column);
        Records(column, count);
    }

    /// <summary>
    /// A list in a column that may have room for far more: what lies behind so many records is written before it is read, and is not
    /// looked at here.
    /// </summary>
    public void Filled<T>(Column<T> column, int count, [CallerArgumentExpression(nameof(column))] string name = "")
        where T : unmanaged
    {
        Section(column);
        count = Counted(count, name);
        _names?.Note(_at, _objectAt, name, new StateKind<T>(), isColumn: true);
        MakeRoom(column);
        Records(column, count);
    }

    /// <summary>
    /// What lies behind so many records is zero when a state was read, as in new memory: what follows does not depend on what was there.
    /// </summary>
    public void ClearBehind<T>(Column<T> column, int count)
        where T : unmanaged
    {
        if (IsReading && column.Capacity > count)
        {
            // Mostly it is: there may be room for far more than was ever used, and to look is quicker than to write.
            byte* start = (byte*)(column.Pointer + count);
            StateBlock.Clear(start, StateBlock.Used(start, (long)(column.Capacity - count) * sizeof(T), 1));
        }
    }

    /// <summary>An array whose length never changes.</summary>
    public void Array<T>(T[] items, [CallerArgumentExpression(nameof(items))] string name = "")
        where T : unmanaged
    {
        _names?.Note(_at, _objectAt, name, new StateKind<T>(), isColumn: true);
        if (items.Length > 0)
        {
            fixed (T* first = items)
            {
                Raw(first, checked(items.Length * sizeof(T)));
            }
        }
    }

    /// <summary>An array that is replaced by a longer one as need be.</summary>
    public void Sized<T>(ref T[] items, [CallerArgumentExpression(nameof(items))] string name = "")
        where T : unmanaged
    {
        int count = Counted(items.Length, name);
        if (items.Length != count)
        {
            items = new T[count];
        }

        Array(items, name);
    }

    public void List<T>(List<T> items, [CallerArgumentExpression(nameof(items))] string name = "")
        where T : unmanaged
    {
        int count = Counted(items.Count, name);
        _names?.Note(_at, _objectAt, name, new StateKind<T>(), isColumn: true);
#if NET8_0_OR_GREATER
        if (IsReading)
        {
            CollectionsMarshal.SetCount(items, count);
        }

        fixed (T* first = CollectionsMarshal.AsSpan(items))
        {
            Raw(first, (long)count * sizeof(T));
        }
#else
        if (!IsReading)
        {
            for (int i = 0; i < count; i++)
            {
                T item = items[i];
                Raw(&item, sizeof(T));
            }

            return;
        }

        items.Clear();
        for (int i = 0; i < count; i++)
        {
            T item;
            Raw(&item, sizeof(T));
            items.Add(item);
        }
#endif
    }

    /// <summary>Bytes that somebody else writes or reads at once; the span holds until anything else is asked of the stream.</summary>
    public Span<byte> Take(int bytes, string name)
    {
        _names?.Note(_at, _objectAt, name, new StateKind<byte>(), isColumn: true);
        return new Span<byte>(Advance(bytes), bytes);
    }

    /// <summary>Memory of a length that both sides know.</summary>
    public void Raw(void* start, long bytes)
    {
        if (_update is not null && !IsReading && bytes >= LeastGiven && (_at & (sizeof(uint) - 1)) == 0)
        {
            Give((byte*)start, bytes);
            return;
        }

        byte* place = Advance(bytes);
        if (IsReading)
        {
            StateBlock.Copy(place, (byte*)start, bytes);
        }
        else
        {
            StateBlock.Copy((byte*)start, place, bytes);
        }
    }

    private void Records<T>(Column<T> column, int count)
        where T : unmanaged
    {
        column.EnsureCapacity(count);
        Raw(column.Pointer, (long)count * sizeof(T));
    }

    /// <summary>The place of so many bytes; what comes next lies behind them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private byte* Advance(long bytes)
    {
        int at = _at;
        if (bytes > _end - at)
        {
            Grow(bytes);
        }

        _at = at + (int)bytes;
        return _start + at;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Grow(long bytes)
    {
        if (IsReading)
        {
            throw new InvalidOperationException($"{bytes} bytes were to be read, and {_end - _at} are left.");
        }

        if (_at + bytes > int.MaxValue)
        {
            throw new OutOfMemoryException($"A state of {_at + bytes} bytes exceeds 2 GiB.");
        }

        _bytes.EnsureCapacity((int)(_at + bytes));
        _start = _bytes.Pointer;
        _end = _bytes.Capacity;
    }

    private void Begin(int end)
    {
        _at = 0;
        _objectAt = 0;
        _start = _bytes.Pointer;
        _end = end;
    }

    /// <summary>Goes on at the next multiple; what lies between is zero.</summary>
    private void Align()
    {
        int bytes = -(_given + _at) & (Alignment - 1);
        byte* place = Advance(bytes);
        for (int i = 0; i < bytes && !IsReading; i++)
        {
            place[i] = 0;
        }
    }

    /// <summary>The number of what follows.</summary>
    private int Counted(int count, string name)
    {
        _names?.Note(_at, _objectAt, name + ".Count", new StateKind<int>(), isCount: true);
        byte* place = Advance(sizeof(int));
        if (IsReading)
        {
            return Unsafe.ReadUnaligned<int>(place);
        }

        Unsafe.WriteUnaligned(place, count);
        return count;
    }
}
