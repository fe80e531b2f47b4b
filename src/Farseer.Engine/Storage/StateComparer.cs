using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <summary>A field that is another one in another state.</summary>
internal struct StateMismatch
{
    public StateNote Note;

    /// <summary>The record of a column; −1: it is none.</summary>
    public int Record;
    public string Field;
    public string One;
    public string Other;
    public string OneBits;
    public string OtherBits;
}

/// <summary>Finds and names what differs in two states that were traced.</summary>
internal sealed unsafe class StateComparer
{
    private const string Absent = "none";

    private readonly StateStream _one;
    private readonly StateStream _other;
    private readonly Func<object?, object?, bool> _areSame;
    private readonly Func<object?, string> _label;
    private readonly int _most;
    private readonly List<StateMismatch> _found = new List<StateMismatch>();

    /// <param name="one">A state.</param>
    /// <param name="other">Another one, maybe of another simulation.</param>
    /// <param name="areSame">Whether two references stand for the same.</param>
    /// <param name="label">What a reference is called.</param>
    /// <param name="most">The search ends when it has found so many.</param>
    public StateComparer(StateStream one, StateStream other, Func<object?, object?, bool> areSame, Func<object?, string> label, int most)
    {
        _one = one;
        _other = other;
        _areSame = areSame;
        _label = label;
        _most = most;
    }

    /// <returns>What differs, in the order of the state.</returns>
    public List<StateMismatch> Find()
    {
        IReadOnlyList<StateNote> ones = _one.Trace!.Notes;
        IReadOnlyList<StateNote> others = _other.Trace!.Notes;
        int count = Math.Min(ones.Count, others.Count);
        int i = 0;
        for (; i < count && _found.Count < _most; i++)
        {
            StateNote note = ones[i];
            if (note.Part != others[i].Part || note.Name != others[i].Name || note.Item != others[i].Item)
            {
                break;
            }

            int before = _found.Count;
            if (note.IsCount && i + 1 < count)
            {
                Compare(i + 1);
            }

            if (_found.Count == before)
            {
                Compare(i);
            }

            i += note.IsCount && i + 1 < count ? 1 : 0;
        }

        if (_found.Count < _most && i < Math.Max(ones.Count, others.Count) && (i < count || _found.Count == 0))
        {
            Add(i < ones.Count ? ones[i] : others[i], -1, i < ones.Count ? "" : others[i].Name, Head(ones, i), Head(others, i), "", "");
        }

        return _found;
    }

    private static string Head(IReadOnlyList<StateNote> notes, int i) =>
        i >= notes.Count ? "nothing more" : notes[i].Part + (notes[i].Item < 0 ? "" : " " + Text(notes[i].Item)) + "." + notes[i].Name;

    private static string Text(object value) => value switch
    {
        float number => number.ToString("G9", CultureInfo.InvariantCulture),
        double number => number.ToString("G17", CultureInfo.InvariantCulture),
        IFormattable other => other.ToString(null, CultureInfo.InvariantCulture),
        _ => value.ToString() ?? "",
    };

    private static string Bits(object value) => value switch
    {
        float number => unchecked((uint)Numerics.FloatBits.ToInt(number)).ToString("x8", CultureInfo.InvariantCulture),
        double number => BitConverter.DoubleToInt64Bits(number).ToString("x16", CultureInfo.InvariantCulture),
        bool flag => flag ? "01" : "00",
        byte or sbyte => Convert.ToInt32(value, CultureInfo.InvariantCulture).ToString("x2", CultureInfo.InvariantCulture),
        short or ushort or char => Convert.ToInt32(value, CultureInfo.InvariantCulture).ToString("x4", CultureInfo.InvariantCulture),
        int number => number.ToString("x8", CultureInfo.InvariantCulture),
        uint number => number.ToString("x8", CultureInfo.InvariantCulture),
        long number => number.ToString("x16", CultureInfo.InvariantCulture),
        ulong number => number.ToString("x16", CultureInfo.InvariantCulture),
        Enum flag => Bits(Convert.ChangeType(flag, Enum.GetUnderlyingType(flag.GetType()), CultureInfo.InvariantCulture)),
        _ => "",
    };

    private static string Hex(byte* at, int bytes)
    {
        var text = new System.Text.StringBuilder(bytes * 2);
        for (int i = 0; i < bytes; i++)
        {
            text.Append(at[i].ToString("x2", CultureInfo.InvariantCulture));
        }

        return text.ToString();
    }

    private static (int At, int ObjectAt) End(StateStream s, int note) => note + 1 < s.Trace!.Notes.Count
        ? (s.Trace.Notes[note + 1].At, s.Trace.Notes[note + 1].ObjectAt) : (s.Length, s.ObjectCount);

    private void Compare(int i)
    {
        StateNote one = _one.Trace!.Notes[i];
        StateNote other = _other.Trace!.Notes[i];
        (int end, int objectEnd) = End(_one, i);
        (int otherEnd, int otherObjectEnd) = End(_other, i);
        CompareReferences(one, other.ObjectAt, objectEnd - one.ObjectAt, otherObjectEnd - other.ObjectAt);
        if (one.Kind is null || _one.IsLocal(one.At))
        {
            return;
        }

        // What aligns the next section lies behind the records, and is zero.
        int size = one.Kind.Size;
        int records = (end - one.At) / size;
        int otherRecords = (otherEnd - other.At) / size;
        byte* mine = (byte*)_one.Words + one.At;
        byte* its = (byte*)_other.Words + other.At;
        int common = Math.Min(records, otherRecords);
        for (int k = 0; k < common && _found.Count < _most; k++)
        {
            if (!new ReadOnlySpan<byte>(mine + (k * size), size).SequenceEqual(new ReadOnlySpan<byte>(its + (k * size), size)))
            {
                CompareRecord(one, one.IsColumn ? k : -1, mine + (k * size), its + (k * size));
            }
        }
    }

    private void CompareReferences(in StateNote note, int otherAt, int count, int otherCount)
    {
        for (int k = 0; k < Math.Max(count, otherCount) && _found.Count < _most; k++)
        {
            object? mine = k < count ? _one.Objects[note.ObjectAt + k] : null;
            object? its = k < otherCount ? _other.Objects[otherAt + k] : null;
            if (!ReferenceEquals(mine, its) && !_areSame(mine, its))
            {
                Add(note, Math.Max(count, otherCount) > 1 ? k : -1, note.Name, _label(mine), _label(its), "", "");
            }
        }
    }

    private void CompareRecord(in StateNote note, int record, byte* mine, byte* its)
    {
        int before = _found.Count;
        CompareValues(note, record, note.Name, "", note.Kind!.Box(mine), note.Kind.Box(its));
        if (_found.Count == before)
        {
            // Of fields that have no names: those of buffers within a record.
            int word = 0;
            while (word + sizeof(uint) < note.Kind.Size && *(uint*)(mine + word) == *(uint*)(its + word))
            {
                word += sizeof(uint);
            }

            int bytes = Math.Min(sizeof(uint), note.Kind.Size - word);
            string field = note.Name + " byte " + Text(word);
            Add(note, record, field, Hex(mine + word, bytes), Hex(its + word, bytes), Hex(mine + word, bytes), Hex(its + word, bytes));
        }
    }

    [UnconditionalSuppressMessage(
        "Trimming", "IL2075", Justification = "Fields that were cut off have no names: they are told by their bytes.")]
    private void CompareValues(in StateNote note, int record, string name, string path, object mine, object its)
    {
        Type type = mine.GetType();
        if (type.IsPrimitive || type.IsEnum)
        {
            string bits = Bits(mine);
            string otherBits = Bits(its);
            if (bits != otherBits)
            {
                Add(note, record, name + (record < 0 ? "" : "[" + Text(record) + "]") + path, Text(mine), Text(its), bits, otherBits);
            }

            return;
        }

        foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
        {
            if (_found.Count < _most
                && !field.FieldType.IsPointer
                && !field.IsDefined(typeof(CompilerGeneratedAttribute), false) | IsProperty(field))
            {
                CompareValues(note, record, name, path + "." + NameOf(field), field.GetValue(mine)!, field.GetValue(its)!);
            }
        }
    }

    private static bool IsProperty(FieldInfo field) => field.Name[0] == '<';

    private static string NameOf(FieldInfo field) =>
        IsProperty(field) ? field.Name.Substring(1, field.Name.IndexOf('>') - 1) : field.Name.TrimStart('_');

    private void Add(in StateNote note, int record, string field, string one, string other, string bits, string otherBits) =>
        _found.Add(new StateMismatch
        {
            Note = note,
            Record = record,
            Field = field.Length == 0 ? Absent : field,
            One = one,
            Other = other,
            OneBits = bits,
            OtherBits = otherBits,
        });
}
