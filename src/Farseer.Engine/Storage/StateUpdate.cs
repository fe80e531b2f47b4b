using System;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <summary>
/// Makes a whole state that of now, section by section as they are visited, and notes the way back: what is visited is compared with what
/// there was, and written only where it differs.
/// </summary>
internal sealed unsafe class StateUpdate
{
    private const int Block = StateDelta.Block;

    private readonly StateDelta _delta;
    private StateSections _state = null!;

    // The section that is visited now, and how many are finished.
    private StateSection? _section;
    private int _finished;

    // Sections that are the same since the last that was not.
    private int _same;

    // What is told of the present section begins there; −1: nothing differs so far.
    private int _told;

    // Its bytes that are visited, and its references that were others: (place, what was there).
    private int _at;
    private readonly Column<int> _places = new Column<int>(16);
    private object?[] _olds = new object?[16];
    private int _oldCount;

    /// <param name="delta">Where the way back goes to.</param>
    public StateUpdate(StateDelta delta) => _delta = delta;

    /// <summary>The section that is visited now.</summary>
    public StateSection Section => _section!;

    /// <summary>It was not there before.</summary>
    public bool IsNew { get; private set; }

    /// <summary>It is neither finished nor passed over.</summary>
    public bool IsOpen => _section is not null;

    /// <summary>Begins with a state; nothing of it is visited yet.</summary>
    public void Begin(StateSections state)
    {
        _state = state;
        _section = null;
        _finished = 0;
        _same = 0;
        _delta.Begin();
    }

    /// <summary>Goes on to a section; the one before is finished.</summary>
    /// <param name="owner">See <see cref="StateSection.Owner"/>.</param>
    /// <param name="number">See <see cref="StateSection.Number"/>.</param>
    public void Enter(object? owner, int number)
    {
        int place = _finished;
        IsNew = place >= _state.Count || !_state[place].Is(owner, number);
        if (IsNew)
        {
            // One that is told by its place alone is not looked for: it would be another one.
            int found = owner is null ? -1 : _state.Find(place, owner, number);
            IsNew = found < 0;
            if (IsNew)
            {
                _state.Insert(place, owner, number);
            }
            else
            {
                DropUntil(found);
            }
        }

        _section = _state[place];
        _told = -1;
        _at = 0;
        _oldCount = 0;
    }

    /// <summary>All of the present section is as it was.</summary>
    public void Pass() => Finished();

    /// <summary>What comes next of the section.</summary>
    /// <param name="source">Where it is.</param>
    /// <param name="bytes">How much it is; a multiple of four.</param>
    public void Give(byte* source, int bytes)
    {
        StateSection section = _section!;
        int common = Math.Max(0, Math.Min(bytes, section.Length - _at));
        if (common > 0)
        {
            Compare((uint*)source, (uint*)(section.Bytes + _at), common / sizeof(uint));
        }

        if (bytes > common)
        {
            section.EnsureBytes(_at + bytes);
            StateBlock.Copy(source + common, section.Bytes + _at + common, bytes - common);
        }

        _at += bytes;
    }

    /// <summary>A reference of the section is another one than before.</summary>
    /// <param name="place">Which one.</param>
    /// <param name="old">What it was.</param>
    public void Note(int place, object? old)
    {
        if (place >= _section!.ObjectCount)
        {
            return;
        }

        if (_oldCount == _olds.Length)
        {
            Array.Resize(ref _olds, _oldCount * 2);
        }

        _places.EnsureCapacity(_oldCount + 1);
        _places[_oldCount] = place;
        _olds[_oldCount++] = old;
    }

    /// <summary>All of the present section is given, and so many references.</summary>
    public void Finish(int objects)
    {
        StateSection section = _section!;
        if (IsNew)
        {
            section.Length = _at;
            section.CutObjects(objects, Math.Max(objects, section.ObjectCount));
            _delta.Tell(_delta.BeginSection(_same), StateDelta.Changes.Goes);
            _same = 0;
            _finished++;
            _section = null;
            return;
        }

        int length = section.Length;
        if (_at != length || objects != section.ObjectCount || _oldCount > 0)
        {
            Tell();
        }

        if (_told >= 0)
        {
            FinishTold(section, length, objects);
        }

        Finished();
    }

    /// <summary>All is visited.</summary>
    public void End()
    {
        DropUntil(_state.Count);
        _delta.End();
    }

    /// <summary>What was visited so far is taken back: the state is as it was.</summary>
    /// <param name="objects">References of the present section that may have been visited.</param>
    public void Cancel(int objects)
    {
        if (_section is { } section)
        {
            if (IsNew)
            {
                section.CutObjects(0, Math.Max(objects, section.ObjectCount));
                _state.Remove(_finished);
            }
            else
            {
                section.CutObjects(section.ObjectCount, Math.Max(objects, section.ObjectCount));
                if (_oldCount > 0)
                {
                    Tell();
                }

                if (_told >= 0)
                {
                    _at = section.Length;
                    FinishTold(section, section.Length, section.ObjectCount);
                }
            }
        }

        _delta.End();
        _delta.Apply(_state);
        _delta.Forget();
        _section = null;
    }

    private void Tell()
    {
        if (_told < 0)
        {
            _told = _delta.BeginSection(_same);
            _same = -1;
        }
    }

    private void Finished()
    {
        _same++;
        _finished++;
        _section = null;
    }

    private void FinishTold(StateSection section, int length, int objects)
    {
        var changes = StateDelta.Changes.None;
        _delta.EndRuns();
        if (_at != length)
        {
            changes |= StateDelta.Changes.Length;
            _delta.Put(length);
            if (length > _at)
            {
                _delta.BeginRuns();
                _delta.AddNew(_at / sizeof(uint), (uint*)(section.Bytes + _at), (length - _at) / sizeof(uint));
                _delta.EndRuns();
            }

            section.Length = _at;
        }

        if (objects != section.ObjectCount || _oldCount > 0)
        {
            changes |= StateDelta.Changes.Objects;
            TellObjects(section, objects);
        }

        _delta.Tell(_told, changes);
    }

    private void TellObjects(StateSection section, int objects)
    {
        int before = section.ObjectCount;
        int more = Math.Max(0, before - objects);
        _delta.Put(before);
        _delta.Put(_oldCount + more);
        int next = 0;
        for (int i = 0; i < _oldCount; i++)
        {
            _delta.Put(_places[i] - next);
            _delta.Keep(_olds[i]);
            next = _places[i] + 1;
        }

        for (int i = before - more; i < before; i++)
        {
            _delta.Put(i - next);
            _delta.Keep(section.Objects[i]);
            next = i + 1;
        }

        Array.Clear(_olds, 0, _oldCount);
        section.CutObjects(objects, Math.Max(objects, before));
    }

    /// <summary>Sections up to one are there no more.</summary>
    private void DropUntil(int end)
    {
        for (int i = end - _finished; i > 0; i--)
        {
            _delta.AddSection(_same, _state[_finished]);
            _same = 0;
            _state.Remove(_finished);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Compare(uint* now, uint* old, int count)
    {
        int place = _at / sizeof(uint);
        int i = 0;
        for (; i + Block <= count; i += Block)
        {
            if (StateBlock.Differ(now + i, old + i))
            {
                Tell();
                _delta.Add(place + i, now + i, old + i);
                StateBlock.CopyBlock(now + i, old + i);
            }
        }

        if (i < count)
        {
            CompareRest(now + i, old + i, count - i, place + i);
        }
    }

    private void CompareRest(uint* now, uint* old, int count, int place)
    {
        uint* from = stackalloc uint[Block];
        uint* to = stackalloc uint[Block];
        for (int k = 0; k < Block; k++)
        {
            from[k] = k < count ? now[k] : 0;
            to[k] = k < count ? old[k] : 0;
        }

        if (StateBlock.Differ(from, to))
        {
            Tell();
            _delta.Add(place, from, to);
            for (int k = 0; k < count; k++)
            {
                old[k] = now[k];
            }
        }
    }
}
