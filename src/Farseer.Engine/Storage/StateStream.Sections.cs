using System;

namespace Farseer.Engine.Storage;

/// <content>A state whose sections have memory of their own, which is brought up to date: what has not changed is not written.</content>
internal sealed unsafe partial class StateStream
{
    /// <summary>So many bytes are compared where they are; fewer are gathered first.</summary>
    private const int LeastGiven = 64;

    private readonly StateUpdate? _update;
    private StateSections _whole = null!;

    // Bytes of the present section that were compared; those that were gathered since lie before the present place.
    private int _given;

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
}
