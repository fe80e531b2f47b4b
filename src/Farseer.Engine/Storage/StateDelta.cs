using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Storage;

/// <summary>
/// How one state becomes another: blocks in which words differ, and references that differ. Sections are compared from their
/// starts, so a record more or less in one of them does not shift all that follows.
/// </summary>
/// <remarks>
/// Of words: whether the places of the sections are told, and if so, how many there are, each, and the end; then the number of
/// references and where each is; then the number of bytes that follow. These are blocks of up to sixteen words: how many words further than
/// the one before it begins, seven bits a byte; for each four of its words how many bytes their differences take, see
/// <see cref="WordPacker"/>; and those bytes. Numbers that change change little: the upper bytes of most differences are zero.
/// </remarks>
internal sealed unsafe class StateDelta
{
    /// <summary>Words that are compared at once: a cache line.</summary>
    private const int Block = 16;

    /// <summary>Bytes that tell of how many bytes the differences of a block are.</summary>
    private const int Codes = Block / WordPacker.Words;

    /// <summary>Most bytes that a block takes: its place, the sizes, and the differences.</summary>
    private const int MostOfBlock = 5 + Codes + (Block * sizeof(uint));

    /// <summary>Words behind the last difference that are read or written with it.</summary>
    private const int Behind = WordPacker.Words;

    private readonly WordPacker _packer = new WordPacker();

    private readonly Column<uint> _words = new Column<uint>(1 << 10);
    private readonly Column<byte> _bytes = new Column<byte>(1 << 10);
    private object?[] _objects = new object?[16];

    // Where the last block begins, and where the next byte goes to.
    private int _block;
    private byte* _at;

    // The last section of which the words are found; −2: none.
    private int _found;
    private int _byteCount;
    private StateStream? _watched;

    public int WordCount { get; private set; }

    public int ObjectCount { get; private set; }

    public ReadOnlySpan<uint> Words => new ReadOnlySpan<uint>(_words.Pointer, WordCount);

    public ReadOnlySpan<object?> Objects => new ReadOnlySpan<object?>(_objects, 0, ObjectCount);

    /// <summary>Whether it can be applied in place: both states have their sections at the same places.</summary>
    public bool KeepsShape => _words[0] == 0;

    /// <summary>Finds how <paramref name="from"/> becomes <paramref name="to"/>.</summary>
    public void Find(StateStream from, StateStream to)
    {
        Begin();
        FindWords(from, to, to.SectionCount - 1);
        End(from, to);
    }

    /// <summary>
    /// From now on it finds, section by section while it is written, how a state becomes <paramref name="to"/>; <see cref="Finish"/> comes
    /// behind.
    /// </summary>
    public void Watch(StateStream from, StateStream to)
    {
        _watched = to;
        from.Watcher = this;
    }

    /// <summary>The state is written anew.</summary>
    public void Begin()
    {
        Forget();
        WordCount = 0;
        _found = -2;
        _block = 0;
        _byteCount = 0;
    }

    /// <summary>Sections up to one are written.</summary>
    public void Ended(StateStream from, int section) => FindWords(from, _watched!, section);

    /// <summary>The state is written that was watched.</summary>
    public void Finish(StateStream from)
    {
        from.Watcher = null;
        StateStream to = _watched!;
        _watched = null;
        FindWords(from, to, to.SectionCount - 1);
        End(from, to);
    }

    /// <summary>What was watched will not be finished.</summary>
    public void Leave(StateStream from)
    {
        from.Watcher = null;
        _watched = null;
        Forget();
    }

    /// <summary>Makes room for one that is read back.</summary>
    public void Prepare(int words, int objects, out Span<uint> wordSpan, out Span<object?> objectSpan)
    {
        Forget();
        _words.EnsureCapacity(words + Behind);
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

        byte* place = (byte*)(_words.Pointer + at + 1);
        ApplyBlocks(place, place + _words[at], to.Words);
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
        for (int i = -1; i < to.SectionCount; i++)
        {
            if (from.IsHeld(i, to))
            {
                continue;
            }

            Range(from, i, out StatePlace source, out StatePlace sourceEnd);
            Range(to, i, out StatePlace target, out StatePlace targetEnd);
            ReadOnlySpan<object?> news = to.Objects.AsSpan(target.ObjectAt, targetEnd.ObjectAt - target.ObjectAt);
            int common = Math.Min(sourceEnd.ObjectAt - source.ObjectAt, news.Length);
            ReadOnlySpan<object?> olds = from.Objects.AsSpan(source.ObjectAt, common);
            for (int k = 0; k < news.Length; k++)
            {
                if (!ReferenceEquals(k < olds.Length ? olds[k] : null, news[k]))
                {
                    Put((uint)(target.ObjectAt + k));
                    Keep(news[k]);
                }
            }
        }
    }

    /// <summary>Behind the words come the rest, which is found first.</summary>
    private void End(StateStream from, StateStream to)
    {
        FindShape(from, to);
        int count = WordCount;
        Put(0);
        FindObjects(from, to);
        _words[count] = (uint)ObjectCount;
        Put((uint)_byteCount);
        int words = (_byteCount + sizeof(uint) - 1) / sizeof(uint);
        _words.EnsureCapacity(WordCount + words + Behind);
        Unsafe.CopyBlockUnaligned(_words.Pointer + WordCount, _bytes.Pointer, (uint)_byteCount);
        WordCount += words;
    }

    /// <summary>Finds the words of all sections up to one.</summary>
    private void FindWords(StateStream from, StateStream to, int last)
    {
        for (int i = Math.Max(_found + 1, -1); i <= last && i < to.SectionCount; i++)
        {
            if (!from.IsHeld(i, to))
            {
                FindSection(from, to, i);
            }
        }

        _found = Math.Max(_found, last);
    }

    private void FindSection(StateStream from, StateStream to, int section)
    {
        Range(from, section, out StatePlace source, out StatePlace sourceEnd);
        Range(to, section, out StatePlace target, out StatePlace targetEnd);
        uint* old = from.Words + (source.At / sizeof(uint));
        int first = target.At / sizeof(uint);
        int count = (targetEnd.At - target.At) / sizeof(uint);
        int common = Math.Min((sourceEnd.At - source.At) / sizeof(uint), count);

        // The section ends with a block of its own.
        long most = ((count / Block) + 2L) * MostOfBlock;
        _bytes.EnsureCapacity(checked((int)(_byteCount + Behind + most)));
        _at = _bytes.Pointer + _byteCount;
        uint* now = to.Words + first;
        int i = 0;
        for (; i + Block <= common; i += Block)
        {
            if (StateBlock.Differ(old + i, now + i))
            {
                Enter(first + i, old + i, now + i);
            }
        }

        // What there was not before was zero.
        uint* before = stackalloc uint[Block];
        uint* after = stackalloc uint[Block];
        for (; i < count; i += Block)
        {
            for (int k = 0; k < Block; k++)
            {
                before[k] = i + k < common ? old[i + k] : 0;
                after[k] = i + k < count ? now[i + k] : 0;
            }

            if (StateBlock.Differ(before, after))
            {
                Enter(first + i, before, after);
            }
        }

        _byteCount = (int)(_at - _bytes.Pointer);
    }

    /// <summary>A block of the state that differs; there is room.</summary>
    private void Enter(int place, uint* old, uint* now)
    {
        byte* at = _at;
        uint gap = (uint)(place - _block);
        _block = place;
        for (; gap >= 0x80; gap >>= 7)
        {
            *at++ = (byte)(gap | 0x80);
        }

        *at++ = (byte)gap;
        byte* codes = at;
        at += Codes;
        at = _packer.Pack(old, now, at, out codes[0]);
        at = _packer.Pack(old + WordPacker.Words, now + WordPacker.Words, at, out codes[1]);
        at = _packer.Pack(old + (2 * WordPacker.Words), now + (2 * WordPacker.Words), at, out codes[2]);
        _at = _packer.Pack(old + (3 * WordPacker.Words), now + (3 * WordPacker.Words), at, out codes[3]);
    }

    private void ApplyBlocks(byte* at, byte* end, uint* words)
    {
        while (at < end)
        {
            uint gap = 0;
            int shift = 0;
            for (; (*at & 0x80) != 0; shift += 7)
            {
                gap |= (uint)(*at++ & 0x7F) << shift;
            }

            words += gap | ((uint)*at++ << shift);
            byte* codes = at;
            at += Codes;
            for (int i = 0; i < Codes; i++)
            {
                // What does not differ may lie behind the end of the state.
                if (codes[i] != 0)
                {
                    at = _packer.Unpack(at, codes[i], words + (i * WordPacker.Words));
                }
            }
        }
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
