using System;
using System.Collections.Generic;

namespace Farseer.Engine.Storage;

/// <summary>A whole state, section by section. What is changed in one that shares sections with another is copied before.</summary>
internal sealed class StateSections
{
    private readonly List<StateSection> _sections = new List<StateSection>();

    // Sections whose memory waits to be used again.
    private readonly Stack<StateSection> _unused;

    /// <param name="unused">Where sections are taken from, and left: states that share sections share it as well.</param>
    public StateSections(Stack<StateSection> unused) => _unused = unused;

    public int Count => _sections.Count;

    /// <summary>See <see cref="StateStream.Round"/>.</summary>
    public long Round { get; set; }

    /// <summary>Bytes of all sections, without references.</summary>
    public int Length
    {
        get
        {
            long bytes = 0;
            foreach (StateSection section in _sections)
            {
                bytes += section.Length;
            }

            return (int)Math.Min(bytes, int.MaxValue);
        }
    }

    /// <summary>Bytes of all sections, references included.</summary>
    public long ByteCount
    {
        get
        {
            long bytes = 0;
            foreach (StateSection section in _sections)
            {
                bytes += section.Length + ((long)section.ObjectCount * IntPtr.Size);
            }

            return bytes;
        }
    }

    public StateSection this[int index] => _sections[index];

    /// <summary>A section that may be changed.</summary>
    public StateSection Own(int index)
    {
        StateSection section = _sections[index];
        if (section.IsShared)
        {
            _sections[index] = section = section.Copied();
        }

        return section;
    }

    /// <summary>Adds an empty section before one.</summary>
    public StateSection Insert(int index, object? owner, int number)
    {
        StateSection section = Take();
        section.Owner = owner;
        section.Number = number;
        _sections.Insert(index, section);
        return section;
    }

    public void Remove(int index)
    {
        StateSection section = _sections[index];
        _sections.RemoveAt(index);
        Drop(section);
    }

    /// <summary>Where the section of an owner is, from a place on; −1: it has none there.</summary>
    public int Find(int from, object? owner, int number)
    {
        for (int i = from; i < _sections.Count; i++)
        {
            if (_sections[i].Is(owner, number))
            {
                return i;
            }
        }

        return -1;
    }

    /// <summary>Whether another state may have the sections as well.</summary>
    public void MarkShared(bool isShared)
    {
        foreach (StateSection section in _sections)
        {
            section.IsShared = isShared;
        }
    }

    /// <summary>Becomes the same as another one, whose sections are marked as shared.</summary>
    public void CopyFrom(StateSections other) => _sections.AddRange(other._sections);

    /// <summary>Becomes another one, which is empty then; what is not a part of that is dropped.</summary>
    public void TakeOver(StateSections other)
    {
        foreach (StateSection section in other._sections)
        {
            section.IsShared = false;
            if (section.Original is not null)
            {
                section.Replace();
            }
        }

        foreach (StateSection section in _sections)
        {
            if (section.IsShared)
            {
                section.IsShared = false;
                Drop(section);
            }
        }

        _sections.Clear();
        _sections.AddRange(other._sections);
        other._sections.Clear();
    }

    /// <summary>Is empty.</summary>
    public void Clear()
    {
        // From behind: the next state takes them in the order in which they were.
        for (int i = _sections.Count - 1; i >= 0; i--)
        {
            Drop(_sections[i]);
        }

        _sections.Clear();
        Round = 0;
    }

    private StateSection Take() => _unused.Count > 0 ? _unused.Pop() : new StateSection();

    private void Drop(StateSection section)
    {
        if (section.Original is not null)
        {
            section.GiveUp();
        }
        else if (!section.IsShared)
        {
            section.Forget();
            _unused.Push(section);
        }
    }
}
