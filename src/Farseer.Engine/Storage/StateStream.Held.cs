using System;
using System.Collections.Generic;

namespace Farseer.Engine.Storage;

/// <content>What was written before and still holds; states that are read by another world, or in another process.</content>
internal sealed unsafe partial class StateStream
{
    // What was written before has so many sections, and is of this round.
    private int _formerCount;
    private long _since;

    // All sections so far lie where they lay in what was written before.
    private bool _isInStep;

    // Some reference differs from what was written before.
    private bool _isNew;

    // Sections begun by the reader, and columns of which it has asked for the room.
    private int _section;
    private int _roomAt;

    /// <summary>
    /// When what it holds was written, counted by those who visit it; 0: not told. What they have not changed since need neither be
    /// written anew nor be read: see <see cref="Holds"/>.
    /// </summary>
    public long Round { get; set; }

    /// <summary>The roster was visited: whatever is held from before is of the same items, or nothing is.</summary>
    public void EndRoster()
    {
        _isNew |= _update is not null && !IsReading && IsOtherInSize;
        _isInStep = _isInStep && !_isNew;
    }

    /// <summary>
    /// Comes behind the start of a section: whether what it has of before still holds, as nothing of it has changed from that round on.
    /// It is passed over then. The section that follows must begin where this one ends.
    /// </summary>
    /// <param name="changedIn">The last round when something that the section has was set.</param>
    public bool Holds(long changedIn)
    {
        if (_update is not null)
        {
            return changedIn < _since && Passes();
        }

        int next = IsReading ? _section : SectionCount;
        if (changedIn >= _since || next >= (IsReading ? SectionCount : _isInStep ? _formerCount : 0))
        {
            return false;
        }

        StatePlace place = _sections[next];
        _at = place.At;
        _objectAt = place.ObjectAt;
        return true;
    }

    private void BeginHolding()
    {
        // Names are noted of what is written; what goes elsewhere is written whole.
        _formerCount = _names is null && Room is null ? SectionCount : 0;
        _since = _formerCount > 0 ? Round : 0;
        _isInStep = _since > 0;
        _isNew = false;
        Round = 0;
    }

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
        Round = 0;
        SectionCount = 0;
        _bytes.EnsureCapacity(bytes.Length + Behind);
        Length = bytes.Length;
        EnsureObjects(objects.Length);
        CutObjects(objects.Length);
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
