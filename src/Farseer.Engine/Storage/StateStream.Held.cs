using System;
using System.Collections.Generic;

namespace Farseer.Engine.Storage;

/// <content>What was written before and still holds; states that are read by another world, or in another process.</content>
internal sealed unsafe partial class StateStream
{
    // Sections that were passed over by the writer, as they still held.
    private readonly Column<bool> _held = new Column<bool>();

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

    /// <summary>Looks at each section while it has just been written and is still near the processor; null: nobody does.</summary>
    public StateDelta? Watcher { get; set; }

    /// <summary>
    /// It is kept as differences: columns that follow from others may be written as what they differ by from that, so that they rarely
    /// change. It is read as it was written; a hash or a comparison is not made of it.
    /// </summary>
    public bool HoldsDifferences { get; set; }

    /// <summary>The roster was visited: whatever is held from before is of the same items, or nothing is.</summary>
    public void EndRoster() => _isInStep = _isInStep && !_isNew;

    /// <summary>
    /// Comes behind the start of a section: whether what it has of before still holds, as nothing of it has changed from that round on.
    /// It is passed over then. The section that follows must begin where this one ends.
    /// </summary>
    /// <param name="changedIn">The last round when something that the section has was set.</param>
    public bool Holds(long changedIn)
    {
        int next = IsReading ? _section : SectionCount;
        if (changedIn >= _since || next >= (IsReading ? SectionCount : _isInStep ? _formerCount : 0))
        {
            return false;
        }

        if (!IsReading)
        {
            _held[next - 1] = true;
        }

        StatePlace place = _sections[next];
        _at = place.At;
        _objectAt = place.ObjectAt;
        return true;
    }

    /// <summary>
    /// Whether a section is known to be the same as in another stream of the same simulation, which holds what it was before: it has not
    /// changed since both were written.
    /// </summary>
    public bool IsHeld(int section, StateStream before) => section >= 0 && section < _held.Capacity && _held[section]
        && before.Round >= _since && section + 1 < before.SectionCount
        && before._sections[section].Equals(_sections[section]) && before._sections[section + 1].Equals(_sections[section + 1]);

    private void BeginHolding()
    {
        // Names are noted of what is written; what goes elsewhere is written whole.
        _formerCount = _names is null && Room is null ? SectionCount : 0;
        _since = _formerCount > 0 ? Round : 0;
        _isInStep = _since > 0;
        _isNew = false;
        Round = 0;
        _held.EnsureCapacity(_formerCount);
        StateBlock.Clear((byte*)_held.Pointer, _held.Capacity);
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
