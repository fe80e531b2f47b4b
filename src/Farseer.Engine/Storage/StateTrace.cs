using System;
using System.Collections.Generic;

namespace Farseer.Engine.Storage;

/// <summary>A field in a state, or the records of a column.</summary>
internal struct StateNote
{
    public int At;
    public int ObjectAt;

    /// <summary>The part of the simulation that it belongs to.</summary>
    public string Part;

    /// <summary>Which one, where a part is there several times; else −1.</summary>
    public int Item;

    /// <summary>The item itself, if it is an object.</summary>
    public object? Who;
    public string Name;

    /// <summary>What lies there; null: references alone.</summary>
    public StateKind? Kind;

    /// <summary>It counts the records of the note behind it.</summary>
    public bool IsCount;

    /// <summary>Several records may follow, which have numbers.</summary>
    public bool IsColumn;
}

/// <summary>
/// The names of all fields of a state, noted by the stream as they are visited: a field that is saved is named without being told of
/// anywhere else.
/// </summary>
internal sealed class StateTrace
{
    private readonly List<StateNote> _notes = new List<StateNote>();
    private string _part = "";
    private int _item = -1;
    private object? _who;

    public IReadOnlyList<StateNote> Notes => _notes;

    public void Begin()
    {
        _notes.Clear();
        Enter("", -1, null);
    }

    /// <summary>What follows belongs to this part.</summary>
    public void Enter(string part, int item, object? who)
    {
        _part = part.TrimStart('_');
        _item = item;
        _who = who;
    }

    public void Note(int at, int objectAt, string name, StateKind? kind, bool isCount = false, bool isColumn = false) =>
        _notes.Add(new StateNote
    {
        At = at,
        ObjectAt = objectAt,
        Part = _part,
        Item = _item,
        Who = _who,
        Name = Plain(name),
        Kind = kind,
        IsCount = isCount,
        IsColumn = isColumn,
    });

    // As it was written where it is visited, but for marks that say nothing.
    private static string Plain(string name)
    {
        name = name.Replace("_extras.", "").Replace("extras.", "").Replace("_loose.", "");
        return name.TrimStart('_');
    }
}
