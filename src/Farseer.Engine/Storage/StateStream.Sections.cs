using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <content>
/// References; what was written before and still holds; states whose sections have memory of their own, which are brought up to date; and
/// states that are read by another world, or in another process.
/// </content>
internal sealed unsafe partial class StateStream
{
    /// <summary>So many bytes are compared where they are; fewer are gathered first.</summary>
    private const int LeastGiven = 64;

    private readonly StateUpdate? _update;
    private StateSections _whole = null!;

    // Bytes of the present section that were compared; those that were gathered since lie before the present place.
    private int _given;

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

    public StateStream()
    {
    }

    /// <param name="update">What brings states up to date.</param>
    public StateStream(StateUpdate update) => _update = update;

    /// <summary>
    /// It is kept as differences: columns that follow from others may be written as what they differ by from that, so that they rarely
    /// change. It is read as it was written; a hash or a comparison is not made of it.
    /// </summary>
    public bool HoldsDifferences => _update is not null;

    /// <summary>An update has begun and is not finished.</summary>
    public bool IsUpdating { get; private set; }

    private bool IsOtherInSize => _update!.IsNew || _objectAt != _update.Section.ObjectCount;

    /// <summary>What is to be read, or brought up to date.</summary>
    public StateStream Use(StateSections whole)
    {
        _whole = whole;
        return this;
    }

    /// <summary>The state is as it was before the update.</summary>
    public void CancelUpdate()
    {
        if (IsUpdating)
        {
            IsUpdating = false;
            _update!.Cancel(_objectAt);
        }
    }

    private void BeginUpdate()
    {
        _since = _whole.Round;
        _isInStep = _since > 0;
        _isNew = false;
        _update!.Begin(_whole);
        IsUpdating = true;
        _given = 0;
        Begin(_bytes.Capacity);
        _update.Enter(null, 0);
        BeginObjects();
    }

    private void EndUpdate(long round)
    {
        FinishSection();
        _update!.End();
        _whole.Round = round;
        IsUpdating = false;
        _given = 0;
    }

    private void BeginSections()
    {
        _since = _whole.Round;
        Length = _whole.Length;
        _given = 0;
        OpenSection();
    }

    private void EndSections()
    {
        CheckSection();
        IsReading = false;
        if (_section != _whole.Count - 1)
        {
            throw new InvalidOperationException($"Of a state of {_whole.Count} sections {_section + 1} were read.");
        }
    }

    private void EnterSection(object? owner, int number)
    {
        if (IsReading)
        {
            CheckSection();
            _section++;
            OpenSection();
            return;
        }

        FinishSection();
        _update!.Enter(owner, number);
        BeginObjects();
    }

    private void BeginObjects()
    {
        _objects = _update!.Section.Objects;
        _objectAt = 0;
    }

    private void OpenSection()
    {
        StateSection section = _whole[_section];
        _start = section.Bytes;
        _at = 0;
        _end = section.Length;
        _objects = section.Objects;
        _objectAt = 0;
    }

    private void CheckSection()
    {
        Align();
        int objects = _whole[_section].ObjectCount;
        if (_at != _end || _objectAt != objects)
        {
            throw new InvalidOperationException(
                $"Of section {_section} of {_end} bytes and {objects} references {_at} and {_objectAt} were read.");
        }
    }

    private void FinishSection()
    {
        if (!_update!.IsOpen)
        {
            return;
        }

        Align();
        GiveGathered();
        _isNew |= IsOtherInSize;
        _update.Finish(_objectAt);
        _given = 0;
    }

    private void Give(byte* start, long bytes)
    {
        GiveGathered();
        int whole = checked((int)bytes) & -sizeof(uint);
        _update!.Give(start, whole);
        _given += whole;
        int rest = (int)bytes - whole;
        new ReadOnlySpan<byte>(start + whole, rest).CopyTo(new Span<byte>(Advance(rest), rest));
    }

    private void GiveGathered()
    {
        if (_at > 0)
        {
            _update!.Give(_start, _at);
            _given += _at;
            _at = 0;
        }
    }

    /// <summary>The present section is as it was: it is passed over.</summary>
    private bool Passes()
    {
        if (IsReading)
        {
            _at = _end;
            _objectAt = _whole[_section].ObjectCount;
            return true;
        }

        if (!_isInStep || _update!.IsNew)
        {
            return false;
        }

        _update.Pass();
        return true;
    }

    public void References<T>(List<T> items, [CallerArgumentExpression(nameof(items))] string name = "")
        where T : class
    {
        int count = Counted(items.Count, name);
        _names?.Note(_at, _objectAt, name, null, isColumn: true);
        if (!IsReading)
        {
            EnsureObjects(_objectAt + count);
            for (int i = 0; i < count; i++)
            {
                Put<T>(items[i]);
            }

            return;
        }

        // Mostly they are the same ones: to look is quicker than to set.
        int common = Math.Min(count, items.Count);
        for (int i = 0; i < common; i++)
        {
            if (!ReferenceEquals(items[i], _objects[_objectAt + i]))
            {
                items[i] = At<T>(i)!;
            }
        }

        for (int i = common; i < count; i++)
        {
            items.Add(At<T>(i)!);
        }

        items.RemoveRange(count, items.Count - count);
        _objectAt += count;
    }

    public void Reference<T>(ref T? item, [CallerArgumentExpression(nameof(item))] string name = "")
        where T : class => item = Reference(item, name);

    public T? Reference<T>(T? item, [CallerArgumentExpression(nameof(item))] string name = "")
        where T : class
    {
        _names?.Note(_at, _objectAt, name, null);
        if (IsReading)
        {
            return Taken(item);
        }

        EnsureObjects(_objectAt + 1);
        Put<T>(item);
        return item;
    }

    /// <summary>Reads a list that was written by <see cref="References"/>, as long as it is the same.</summary>
    /// <returns>Whether it is; if not the stream is to be read anew.</returns>
    public bool AreNext<T>(List<T> items)
        where T : class
    {
        if (Counted(items.Count, "") != items.Count)
        {
            return false;
        }

        for (int i = 0; i < items.Count; i++)
        {
            if (!ReferenceEquals(items[i], _objects[_objectAt + i]))
            {
                return false;
            }
        }

        _objectAt += items.Count;
        return true;
    }

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

    /// <summary>A reference of the list that comes next; none where the state leaves it to the reader.</summary>
    private T? At<T>(int index)
        where T : class
    {
        object? item = _objects[_objectAt + index];
        return ReferenceEquals(item, this) ? null : (T?)item;
    }

    private void EnsureObjects(int count)
    {
        if (count > _objects.Length && _update is not null)
        {
            _update.Section.EnsureObjects(count);
            _objects = _update.Section.Objects;
        }
        else if (count > _objects.Length)
        {
            System.Array.Resize(ref _objects, Math.Max(count, _objects.Length * 2));
        }
    }

    /// <summary>Nothing is kept alive that is not part of the state.</summary>
    private void CutObjects(int count)
    {
        if (ObjectCount > count)
        {
            System.Array.Clear(_objects, count, ObjectCount - count);
        }

        ObjectCount = count;
    }

    // Mostly it is the same as in the state before: to write it again costs more than to look. There is room.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Put<T>(T? one)
        where T : class
    {
        object? item = StaysWithReader is not null && StaysWithReader(typeof(T)) ? this : one;
        int at = _objectAt++;
        if (!ReferenceEquals(_objects[at], item))
        {
            _update?.Note(at, _objects[at]);
            _objects[at] = item;
            _isNew = true;
        }
    }

    /// <summary>The next reference; what the reader has of his own in its place, where the state leaves it to him.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private T? Taken<T>(T? own)
        where T : class
    {
        object? item = _objects[_objectAt++];
        return ReferenceEquals(item, this) ? own : (T?)item;
    }
}
