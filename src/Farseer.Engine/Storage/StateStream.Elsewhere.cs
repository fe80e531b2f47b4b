using System;
using System.Collections.Generic;

namespace Farseer.Engine.Storage;

/// <content>States that are read by another world, or in another process, than they were written in.</content>
internal sealed unsafe partial class StateStream
{
    private int _roomAt;

    /// <summary>
    /// How many records each column has room for, in the order of visits, where the state is to be read by a world that never was in it:
    /// columns that grow together must have room together there as well. Null: none.
    /// </summary>
    public List<int>? Room { get; set; }

    /// <summary>The state is for another world than the one that it is written of.</summary>
    public bool IsElsewhere => Room is not null;

    /// <summary>Of such a state, references of which types are none of it: each world has its own, or none. Null: all are.</summary>
    public Func<Type, bool>? StaysWithReader { get; set; }

    /// <summary>
    /// Comes before the visit of a part that is made when it is first needed: the state, of another world, has one, and this world has none
    /// yet.
    /// </summary>
    public bool Lacks(object? part) => IsReading && part is null && _objectAt < ObjectCount && ReferenceEquals(_objects[_objectAt], this);

    /// <summary>
    /// Becomes what was written elsewhere. A reference to the stream itself stands for what the reader has of his own in its place.
    /// </summary>
    public void Load(ReadOnlySpan<byte> bytes, ReadOnlySpan<object?> objects)
    {
        Shape(default, new StatePlace { At = bytes.Length, ObjectAt = objects.Length });
        bytes.CopyTo(new Span<byte>(_bytes.Pointer, Length));
        objects.CopyTo(_objects);
    }

    private void MakeRoom<T>(Column<T> column)
        where T : unmanaged
    {
        if (Room is null)
        {
            return;
        }

        if (IsReading)
        {
            column.EnsureCapacity(Room[_roomAt++]);
        }
        else
        {
            Room.Add(column.Capacity);
        }
    }
}
