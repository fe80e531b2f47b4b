using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <summary>
/// What a simulation remembers from step to step, written or read. Each owner of state has one method that visits its fields in
/// turn; the same method saves and restores, so that the two cannot disagree. Memory is kept: a stream that has grown allocates
/// nothing.
/// </summary>
internal sealed unsafe class StateStream
{
    private byte[] _bytes = new byte[1 << 12];
    private object?[] _objects = new object?[16];
    private int _at;
    private int _objectAt;

    /// <summary>Names of the fields and where each begins, for those who look for a difference; null: nobody does.</summary>
    public List<(int At, int ObjectAt, string Name)>? Trace { get; set; }

    /// <summary>True while fields are set from the stream, false while they are written to it.</summary>
    public bool IsReading { get; private set; }

    /// <summary>Bytes written.</summary>
    public int Length { get; private set; }

    /// <summary>References written.</summary>
    public int ObjectCount { get; private set; }

    /// <summary>What was written, until it is written anew.</summary>
    public ReadOnlySpan<byte> Bytes => new ReadOnlySpan<byte>(_bytes, 0, Length);

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

    /// <summary>The names of all fields that differ; both were traced.</summary>
    public List<string> Differences(StateStream other)
    {
        var names = new List<string>();
        for (int i = 0; i < Math.Min(Trace!.Count, other.Trace!.Count); i++)
        {
            int end = i + 1 < Trace.Count ? Trace[i + 1].At : Length;
            int otherEnd = i + 1 < other.Trace.Count ? other.Trace[i + 1].At : other.Length;
            ReadOnlySpan<byte> mine = new ReadOnlySpan<byte>(_bytes, Trace[i].At, end - Trace[i].At);
            if (!mine.SequenceEqual(new ReadOnlySpan<byte>(other._bytes, other.Trace[i].At, otherEnd - other.Trace[i].At)))
            {
                names.Add(Trace[i].Name);
            }
        }

        return names;
    }

    /// <summary>The names of the fields around the first difference; this one was traced.</summary>
    public string FirstDifference(StateStream other)
    {
        int at = 0;
        while (at < Length && at < other.Length && _bytes[at] == other._bytes[at])
        {
            at++;
        }

        if (at < Math.Max(Length, other.Length))
        {
            int index = Trace!.FindLastIndex(t => t.At <= at);
            return $"byte {at} of {Length}, {other.Length}: {string.Join(", ", Trace.GetRange(Math.Max(0, index - 3), 4))}";
        }

        int item = 0;
        while (item < Math.Min(ObjectCount, other.ObjectCount) && ReferenceEquals(_objects[item], other._objects[item]))
        {
            item++;
        }

        int place = Trace!.FindLastIndex(t => t.ObjectAt <= item);
        return $"object {item} of {ObjectCount}, {other.ObjectCount}: {string.Join(", ", Trace.GetRange(Math.Max(0, place - 3), 4))}";
    }

    /// <summary>Forgets what was written and writes anew.</summary>
    public void BeginWriting()
    {
        IsReading = false;
        _at = 0;
        _objectAt = 0;
        Trace?.Clear();
    }

    public void EndWriting()
    {
        Length = _at;
        if (ObjectCount > _objectAt)
        {
            // Nothing is kept alive that is not part of the state.
            System.Array.Clear(_objects, _objectAt, ObjectCount - _objectAt);
        }

        ObjectCount = _objectAt;
    }

    /// <summary>Reads what was written, from its start.</summary>
    public void BeginReading()
    {
        IsReading = true;
        _at = 0;
        _objectAt = 0;
    }

    /// <summary>All that was written must have been read: the owners are the same ones then.</summary>
    public void EndReading()
    {
        IsReading = false;
        if (_at != Length || _objectAt != ObjectCount)
        {
            throw new InvalidOperationException(
                $"Of a state of {Length} bytes and {ObjectCount} references {_at} and {_objectAt} were read.");
        }
    }

    public void Value<T>(ref T value, [CallerArgumentExpression(nameof(value))] string name = "")
        where T : unmanaged
    {
        Trace?.Add((_at, _objectAt, name));
        byte* place = stackalloc byte[sizeof(T)];
        if (IsReading)
        {
            Raw(place, sizeof(T));
            value = Unsafe.ReadUnaligned<T>(place);
        }
        else
        {
            Unsafe.WriteUnaligned(place, value);
            Raw(place, sizeof(T));
        }
    }

    /// <summary>For properties: <c>Count = stream.Value(Count)</c>.</summary>
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
        int count = IsReading ? 0 : Used((byte*)column.Pointer, (long)column.Capacity * sizeof(T), sizeof(T));
        Value(ref count, name);
        Records(column, count);
        if (IsReading && column.Capacity > count)
        {
            Clear((byte*)(column.Pointer + count), (long)(column.Capacity - count) * sizeof(T));
        }
    }

    /// <summary>A column of which nobody reads what lies behind so many records before it is written.</summary>
    public void Column<T>(Column<T> column, int count, [CallerArgumentExpression(nameof(column))] string name = "")
        where T : unmanaged
    {
        Trace?.Add((_at, _objectAt, name));
        Records(column, count);
    }

    /// <summary>An array whose length never changes.</summary>
    public void Array<T>(T[] items, [CallerArgumentExpression(nameof(items))] string name = "")
        where T : unmanaged
    {
        Trace?.Add((_at, _objectAt, name));
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
        int count = Value(items.Length, name);
        if (items.Length != count)
        {
            items = new T[count];
        }

        Array(items, name);
    }

    public void List<T>(List<T> items, [CallerArgumentExpression(nameof(items))] string name = "")
        where T : unmanaged
    {
        int count = Value(items.Count, name);
        if (!IsReading)
        {
            for (int i = 0; i < count; i++)
            {
                Value(items[i]);
            }

            return;
        }

        items.Clear();
        for (int i = 0; i < count; i++)
        {
            items.Add(Value(default(T)));
        }
    }

    public void References<T>(List<T> items, [CallerArgumentExpression(nameof(items))] string name = "")
        where T : class
    {
        int count = Value(items.Count, name);
        if (!IsReading)
        {
            for (int i = 0; i < count; i++)
            {
                Reference(items[i]);
            }

            return;
        }

        items.Clear();
        for (int i = 0; i < count; i++)
        {
            items.Add(Reference<T>(null)!);
        }
    }

    public void Reference<T>(ref T? item, [CallerArgumentExpression(nameof(item))] string name = "")
        where T : class => item = Reference(item, name);

    public T? Reference<T>(T? item, [CallerArgumentExpression(nameof(item))] string name = "")
        where T : class
    {
        Trace?.Add((_at, _objectAt, name));
        if (IsReading)
        {
            return (T?)_objects[_objectAt++];
        }

        if (_objectAt == _objects.Length)
        {
            System.Array.Resize(ref _objects, _objects.Length * 2);
        }

        _objects[_objectAt++] = item;
        return item;
    }

    /// <summary>Bytes that somebody else writes or reads at once; the span holds until anything else is asked of the stream.</summary>
    public Span<byte> Take(int bytes)
    {
        if (IsReading ? bytes > Length - _at : _at + (long)bytes > _bytes.Length)
        {
            if (IsReading)
            {
                throw new InvalidOperationException($"{bytes} bytes were to be read, and {Length - _at} are left.");
            }

            Grow(_at + (long)bytes);
        }

        _at += bytes;
        return new Span<byte>(_bytes, _at - bytes, bytes);
    }

    /// <summary>Memory of a length that both sides know.</summary>
    public void Raw(void* start, long bytes)
    {
        if (IsReading)
        {
            if (bytes > Length - _at)
            {
                throw new InvalidOperationException($"{bytes} bytes were to be read, and {Length - _at} are left.");
            }

            fixed (byte* from = _bytes)
            {
                Buffer.MemoryCopy(from + _at, start, bytes, bytes);
            }

            _at += (int)bytes;
            return;
        }

        long end = _at + bytes;
        if (end > _bytes.Length)
        {
            Grow(end);
        }

        fixed (byte* to = _bytes)
        {
            Buffer.MemoryCopy(start, to + _at, bytes, bytes);
        }

        _at = (int)end;
    }

    private static int Used(byte* start, long bytes, int size)
    {
        long end = bytes;
        while (end > 0 && start[end - 1] == 0)
        {
            end -= end >= sizeof(ulong) && *(ulong*)(start + end - sizeof(ulong)) == 0 ? sizeof(ulong) : 1;
        }

        return (int)((end + size - 1) / size);
    }

    private static void Clear(byte* start, long bytes)
    {
        const long Most = 1 << 30;
        for (; bytes > 0; bytes -= Most, start += Most)
        {
            Unsafe.InitBlockUnaligned(start, 0, (uint)Math.Min(bytes, Most));
        }
    }

    private void Records<T>(Column<T> column, int count)
        where T : unmanaged
    {
        column.EnsureCapacity(count);
        Raw(column.Pointer, (long)count * sizeof(T));
    }

    private void Grow(long needed)
    {
        if (needed > int.MaxValue)
        {
            throw new OutOfMemoryException($"A state of {needed} bytes exceeds 2 GiB.");
        }

        System.Array.Resize(ref _bytes, (int)Math.Min(int.MaxValue, Math.Max(needed, _bytes.Length * 2L)));
    }
}
