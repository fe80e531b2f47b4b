using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Storage;

/// <summary>
/// How one state becomes another: words that differ, as exclusive or, and references that differ. Sections are compared from their
/// starts, so a record more or less in one of them does not shift all that follows.
/// </summary>
/// <remarks>
/// Of words: whether the places of the sections are told, and if so, how many there are, each, and the end; then the number of
/// references and where each is; then runs, each after a word that says how many words before it are the same and how many follow.
/// </remarks>
internal sealed unsafe class StateDelta
{
    /// <summary>Most words that the head of a run counts, of either kind.</summary>
    private const uint MostOfRun = ushort.MaxValue;
    private const int SkipShift = 16;

    /// <summary>Words that are compared at once.</summary>
    private const int Block = 8;

    private readonly Column<uint> _words = new Column<uint>(1 << 10);
    private object?[] _objects = new object?[16];

    // Where the head of the last run is, and the word of the state behind that run.
    private int _head;
    private int _runEnd;

    public int WordCount { get; private set; }

    public int ObjectCount { get; private set; }

    public ReadOnlySpan<uint> Words => new ReadOnlySpan<uint>(_words.Pointer, WordCount);

    public ReadOnlySpan<object?> Objects => new ReadOnlySpan<object?>(_objects, 0, ObjectCount);

    /// <summary>Whether it can be applied in place: both states have their sections at the same places.</summary>
    public bool KeepsShape => _words[0] == 0;

    /// <summary>Finds how <paramref name="from"/> becomes <paramref name="to"/>.</summary>
    public void Find(StateStream from, StateStream to)
    {
        WordCount = 0;
        Forget();
        FindShape(from, to);
        int count = WordCount;
        Put(0);
        FindObjects(from, to);
        _words[count] = (uint)ObjectCount;
        _head = -1;
        _runEnd = 0;
        for (int i = -1; i < to.SectionCount; i++)
        {
            FindWords(from, to, i);
        }
    }

    /// <summary>Makes room for one that is read back.</summary>
    public void Prepare(int words, int objects, out Span<uint> wordSpan, out Span<object?> objectSpan)
    {
        Forget();
        _words.EnsureCapacity(words);
        if (objects > _objects.Length)
        {
            Array.Resize(ref _objects, Math.Max(objects, _objects.Length * 2));
        }

        WordCount = words;
        ObjectCount = objects;
        wordSpan = new Span<uint>(_words.Pointer, words);
        objectSpan = new Span<object?>(_objects, 0, objects);
    }

    /// <summary>Makes the other state; both may be the same object if it <see cref="KeepsShape"/>.</summary>
    public void Apply(StateStream from, StateStream to)
    {
        int at = 1;
        if (!KeepsShape)
        {
            int sections = (int)_words[1];
            var places = MemoryMarshal.Cast<uint, StatePlace>(new ReadOnlySpan<uint>(_words.Pointer + 2, (sections + 1) * 2));
            to.Shape(places.Slice(0, sections), places[sections]);
            CopySections(from, to);
            at = 2 + ((sections + 1) * 2);
        }
        else if (!ReferenceEquals(from, to))
        {
            to.CopyFrom(from);
        }

        at++;
        for (int i = 0; i < ObjectCount; i++)
        {
            to.Objects[_words[at++]] = _objects[i];
        }

        uint* word = to.Words;
        while (at < WordCount)
        {
            uint head = _words[at++];
            word += head >> SkipShift;
            for (uint i = head & MostOfRun; i > 0; i--)
            {
                *word++ ^= _words.Pointer[at++];
            }
        }
    }

    /// <summary>Holds no reference any more.</summary>
    public void Forget()
    {
        Array.Clear(_objects, 0, ObjectCount);
        ObjectCount = 0;
    }

    private static void CopySections(StateStream from, StateStream to)
    {
        for (int i = -1; i < to.SectionCount; i++)
        {
            Range(from, i, out StatePlace source, out StatePlace sourceEnd);
            Range(to, i, out StatePlace target, out StatePlace targetEnd);
            int bytes = Math.Min(sourceEnd.At - source.At, targetEnd.At - target.At);
            int objects = Math.Min(sourceEnd.ObjectAt - source.ObjectAt, targetEnd.ObjectAt - target.ObjectAt);
            var place = new Span<byte>((byte*)to.Words + target.At, targetEnd.At - target.At);
            from.Bytes.Slice(source.At, bytes).CopyTo(place);
            place.Slice(bytes).Clear();
            Array.Copy(from.Objects, source.ObjectAt, to.Objects, target.ObjectAt, objects);
            Array.Clear(to.Objects, target.ObjectAt + objects, targetEnd.ObjectAt - target.ObjectAt - objects);
        }
    }

    /// <summary>A section; what comes before the first is one as well, −1. One that is not there is empty.</summary>
    private static void Range(StateStream s, int section, out StatePlace start, out StatePlace end)
    {
        start = section < 0 ? default : s.Place(section);
        end = s.Place(section + 1);
    }

    private void FindShape(StateStream from, StateStream to)
    {
        StatePlace end = to.Place(to.SectionCount);
        StatePlace fromEnd = from.Place(from.SectionCount);
        if (end.At == fromEnd.At && end.ObjectAt == fromEnd.ObjectAt
            && MemoryMarshal.AsBytes(from.Sections).SequenceEqual(MemoryMarshal.AsBytes(to.Sections)))
        {
            Put(0);
            return;
        }

        Put(1);
        Put((uint)to.SectionCount);
        for (int i = 0; i <= to.SectionCount; i++)
        {
            Put((uint)to.Place(i).At);
            Put((uint)to.Place(i).ObjectAt);
        }
    }

    private void FindObjects(StateStream from, StateStream to)
    {
        object?[] olds = from.Objects;
        object?[] news = to.Objects;
        for (int i = -1; i < to.SectionCount; i++)
        {
            Range(from, i, out StatePlace source, out StatePlace sourceEnd);
            Range(to, i, out StatePlace target, out StatePlace targetEnd);
            int common = Math.Min(sourceEnd.ObjectAt - source.ObjectAt, targetEnd.ObjectAt - target.ObjectAt);
            for (int k = 0; k < targetEnd.ObjectAt - target.ObjectAt; k++)
            {
                object? item = news[target.ObjectAt + k];
                if (!ReferenceEquals(k < common ? olds[source.ObjectAt + k] : null, item))
                {
                    Put((uint)(target.ObjectAt + k));
                    Keep(item);
                }
            }
        }
    }

    private void FindWords(StateStream from, StateStream to, int section)
    {
        Range(from, section, out StatePlace source, out StatePlace sourceEnd);
        Range(to, section, out StatePlace target, out StatePlace targetEnd);
        uint* old = from.Words + (source.At / sizeof(uint));
        int first = target.At / sizeof(uint);
        int count = (targetEnd.At - target.At) / sizeof(uint);
        int common = Math.Min((sourceEnd.At - source.At) / sizeof(uint), count);
        uint* now = to.Words + first;

        // Sections have an even number of words. Room for all of them: each word in a run of its own, and the heads that only skip.
        _words.EnsureCapacity(WordCount + (count * 2) + ((first + count - _runEnd) / (int)MostOfRun) + 1);
        int i = 0;
        while (i < common)
        {
            if (i + Block <= common && AreSame((ulong*)(old + i), (ulong*)(now + i)))
            {
                i += Block;
                continue;
            }

            for (int end = Math.Min(i + Block, common); i < end; i++)
            {
                if (old[i] != now[i])
                {
                    Enter(first + i, old[i] ^ now[i]);
                }
            }
        }

        for (; i < count; i++)
        {
            if (now[i] != 0)
            {
                Enter(first + i, now[i]);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AreSame(ulong* one, ulong* other) =>
        ((one[0] ^ other[0]) | (one[1] ^ other[1]) | (one[2] ^ other[2]) | (one[3] ^ other[3])) == 0;

    /// <summary>
    /// A word of the state that differs, and how; there is room. A single word that does not is cheaper within a run than between two.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Enter(int place, uint difference)
    {
        uint* words = _words.Pointer;
        int gap = place - _runEnd;
        _runEnd = place + 1;
        if (gap <= 1 && _head >= 0 && (words[_head] & MostOfRun) + gap + 1 <= MostOfRun)
        {
            words[_head] += (uint)gap + 1;
            if (gap == 1)
            {
                words[WordCount++] = 0;
            }
        }
        else
        {
            BeginRun(gap);
        }

        words[WordCount++] = difference;
    }

    /// <summary>The head of a run of one word, so many words behind the last.</summary>
    private void BeginRun(int gap)
    {
        for (; gap > MostOfRun; gap -= (int)MostOfRun)
        {
            _words[WordCount++] = MostOfRun << SkipShift;
        }

        _head = WordCount;
        _words[WordCount++] = ((uint)gap << SkipShift) | 1;
    }

    private void Put(uint word)
    {
        _words.EnsureCapacity(WordCount + 1);
        _words[WordCount++] = word;
    }

    private void Keep(object? item)
    {
        if (ObjectCount == _objects.Length)
        {
            Array.Resize(ref _objects, _objects.Length * 2);
        }

        _objects[ObjectCount++] = item;
    }
}
