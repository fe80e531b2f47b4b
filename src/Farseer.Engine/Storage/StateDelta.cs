using System;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <summary>How one state becomes another: words and references that differ, section by section, and sections that come or go.</summary>
/// <remarks>
/// Of bytes, of which the first four tell how many there are. A section that differs has: how many the same lie before it;
/// <see cref="Changes"/>; if it comes, its number and, among the references, its owner. Then runs of blocks of sixteen words: how many
/// blocks, how many words from the end of the run before, folded, and of each block how many bytes the differences of each four words
/// take, see <see cref="WordPacker"/>, and those bytes. Zero blocks end the runs. If it has another length then: that, and if it is longer,
/// runs of what it has more. If references differ: how many it has, how many of them differ, and of each how many the same lie before it.
/// Numbers are of seven bits a byte.
/// </remarks>
internal sealed unsafe class StateDelta
{
    /// <summary>Words that are compared at once: a cache line.</summary>
    public const int Block = 16;

    private const int BlockBytes = Block * sizeof(uint);

    /// <summary>Bytes that tell of how many bytes the differences of a block are.</summary>
    private const int Codes = Block / WordPacker.Words;

    /// <summary>Most bytes of a number.</summary>
    private const int MostOfNumber = 5;

    /// <summary>Most bytes that a block takes: the head of a run, the sizes, and the differences.</summary>
    private const int MostOfBlock = 1 + MostOfNumber + Codes + BlockBytes + WordPacker.MostBytes;

    private const int MostOfRun = byte.MaxValue;

    private readonly WordPacker _packer = new WordPacker();
    private readonly Column<byte> _bytes = new Column<byte>(1 << 10);
    private object?[] _objects = new object?[16];
    private int _at;

    // Where the number of blocks of the present run is, −1: there is none; and which word comes behind it.
    private int _run;
    private int _runEnd;

    [Flags]
    public enum Changes : byte
    {
        None = 0,

        /// <summary>The section comes.</summary>
        Comes = 1,

        /// <summary>It goes.</summary>
        Goes = 2,

        /// <summary>It has another length.</summary>
        Length = 4,

        /// <summary>It has other references.</summary>
        Objects = 8,
    }

    public int ObjectCount { get; private set; }

    public int WordCount => (_at + sizeof(uint) - 1) / sizeof(uint);

    public ReadOnlySpan<uint> Words => new ReadOnlySpan<uint>(_bytes.Pointer, WordCount);

    public ReadOnlySpan<object?> Objects => new ReadOnlySpan<object?>(_objects, 0, ObjectCount);

    /// <summary>Nothing differs so far.</summary>
    public void Begin()
    {
        Forget();
        _at = sizeof(int);
        _run = -1;
    }

    /// <summary>Nothing more differs.</summary>
    public void End()
    {
        *(int*)_bytes.Pointer = _at;
    }

    /// <summary>A section differs.</summary>
    /// <param name="skipped">How many that do not lie between it and the one before.</param>
    /// <returns>Where its changes are told, by <see cref="Tell"/>.</returns>
    public int BeginSection(int skipped)
    {
        Put(skipped);
        _bytes.EnsureCapacity(_at + 1);
        _bytes[_at] = 0;
        BeginRuns();
        return _at++;
    }

    public void Tell(int at, Changes changes) => _bytes[at] = (byte)changes;

    public void BeginRuns()
    {
        _run = -1;
        _runEnd = 0;
    }

    public void EndRuns() => Put(0);

    /// <summary>A block of which some word differs.</summary>
    /// <param name="place">Its first word.</param>
    /// <param name="from">What they are.</param>
    /// <param name="to">What they become.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(int place, uint* from, uint* to)
    {
        if (_at > _bytes.Capacity - MostOfBlock)
        {
            _bytes.EnsureCapacity(_at + MostOfBlock);
        }

        byte* start = _bytes.Pointer;
        if (_run >= 0 && place == _runEnd && start[_run] < MostOfRun)
        {
            start[_run]++;
        }
        else
        {
            _run = _at;
            start[_at++] = 1;
            Put((int)StateBlock.Fold((uint)(place - _runEnd)));
            start = _bytes.Pointer;
        }

        _runEnd = place + Block;
        byte* codes = start + _at;
        byte* at = codes + Codes;
        at = _packer.PackBlock(from, to, codes, at);
        _at = (int)(at - start);
    }

    /// <summary>Words that were zero, or are no more.</summary>
    /// <param name="place">The first of them.</param>
    /// <param name="words">What they become.</param>
    /// <param name="count">How many.</param>
    public void AddNew(int place, uint* words, int count)
    {
        uint* zero = stackalloc uint[Block];
        uint* block = stackalloc uint[Block];
        new Span<uint>(zero, Block).Clear();
        for (int i = 0; i < count; i += Block)
        {
            int length = Math.Min(Block, count - i);
            new Span<uint>(block, Block).Clear();
            new ReadOnlySpan<uint>(words + i, length).CopyTo(new Span<uint>(block, Block));
            if (StateBlock.Differ(zero, block))
            {
                Add(place + i, zero, block);
            }
        }
    }

    /// <summary>A number, seven bits a byte.</summary>
    public void Put(int number)
    {
        _bytes.EnsureCapacity(_at + MostOfNumber);
        uint rest = (uint)number;
        for (; rest >= 0x80; rest >>= 7)
        {
            _bytes[_at++] = (byte)(rest | 0x80);
        }

        _bytes[_at++] = (byte)rest;
    }

    public void Keep(object? item)
    {
        if (ObjectCount == _objects.Length)
        {
            Array.Resize(ref _objects, _objects.Length * 2);
        }

        _objects[ObjectCount++] = item;
    }

    /// <summary>A whole section, which comes.</summary>
    public void AddSection(int skipped, StateSection section)
    {
        int at = BeginSection(skipped);
        Put(section.Number);
        Keep(section.Owner);
        EndRuns();
        Put(section.Length);
        if (section.Length > 0)
        {
            BeginRuns();
            AddNew(0, (uint*)section.Bytes, section.Length / sizeof(uint));
            EndRuns();
        }

        Put(section.ObjectCount);
        Put(section.ObjectCount);
        for (int i = 0; i < section.ObjectCount; i++)
        {
            Put(0);
            Keep(section.Objects[i]);
        }

        Tell(at, Changes.Comes | Changes.Length | Changes.Objects);
    }

    /// <summary>Makes room for one that is read back.</summary>
    public void Prepare(int words, int objects, out Span<uint> wordSpan, out Span<object?> objectSpan)
    {
        Forget();
        _bytes.EnsureCapacity(checked((words * sizeof(uint)) + MostOfBlock));
        if (objects > _objects.Length)
        {
            Array.Resize(ref _objects, Math.Max(objects, _objects.Length * 2));
        }

        _at = words * sizeof(uint);
        ObjectCount = objects;
        wordSpan = new Span<uint>(_bytes.Pointer, words);
        objectSpan = new Span<object?>(_objects, 0, objects);
    }

    /// <summary>Makes a state the other one.</summary>
    public void Apply(StateSections state)
    {
        byte* at = _bytes.Pointer;
        byte* end = at + *(int*)at;
        at += sizeof(int);
        int section = 0;
        int objects = 0;

        while (at < end)
        {
            section += Number(ref at);
            var changes = (Changes)(*at++);
            if ((changes & Changes.Goes) != 0)
            {
                state.Remove(section);
                continue;
            }

            StateSection changed;
            if ((changes & Changes.Comes) != 0)
            {
                int number = Number(ref at);
                changed = state.Insert(section, _objects[objects++], number);
            }
            else
            {
                changed = state.Own(section);
            }

            section++;
            at = ApplyRuns(at, (uint*)changed.Bytes);
            if ((changes & Changes.Length) != 0)
            {
                int before = changed.Length;
                changed.Resize(Number(ref at));
                if (changed.Length > before)
                {
                    at = ApplyRuns(at, (uint*)changed.Bytes);
                }
            }

            if ((changes & Changes.Objects) != 0)
            {
                ApplyObjects(changed, ref at, ref objects);
            }
        }
    }

    /// <summary>Holds no reference any more.</summary>
    public void Forget()
    {
        Array.Clear(_objects, 0, ObjectCount);
        ObjectCount = 0;
    }

    private static int Number(ref byte* at)
    {
        uint number = 0;
        int shift = 0;
        for (; (*at & 0x80) != 0; shift += 7)
        {
            number |= (uint)(*at++ & 0x7F) << shift;
        }

        return (int)(number | ((uint)*at++ << shift));
    }

    private void ApplyObjects(StateSection section, ref byte* at, ref int objects)
    {
        int count = Number(ref at);
        section.EnsureObjects(count);
        section.CutObjects(count, section.ObjectCount);
        int changed = Number(ref at);
        for (int place = 0; changed > 0; changed--, place++)
        {
            place += Number(ref at);
            section.Objects[place] = _objects[objects++];
        }
    }

    private byte* ApplyRuns(byte* at, uint* words)
    {
        for (int blocks = *at++; blocks > 0; blocks = *at++)
        {
            words += (int)StateBlock.Unfold((uint)Number(ref at));
            for (; blocks > 0; blocks--, words += Block)
            {
                byte* codes = at;
                at += Codes;
                for (int i = 0; i < Codes; i++)
                {
                    // What does not differ may lie behind the end of the section.
                    if (codes[i] != 0)
                    {
                        at = _packer.Unpack(at, codes[i], words + (i * WordPacker.Words));
                    }
                }
            }
        }

        return at;
    }
}
