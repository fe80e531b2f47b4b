using System;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>A reused list of proxy pairs, packed as lower &lt;&lt; 32 | higher.</summary>
[NotState(Why.OfOneStep)]
internal sealed class PairBuffer
{
    /// <summary>Pairs that there is room for: how many a search finds differs from step to step.</summary>
    private const int Least = 64;

    private Column<ulong> _pairs = new Column<ulong>();

    public int Count { get; private set; }

    public ulong this[int index] => _pairs[index];

    public unsafe ulong* Pointer => _pairs.Pointer;

    public void Clear() => Count = 0;

    public unsafe void Add(int a, int b)
    {
        *Reserve(1) = Pack(a, b);
        Count++;
    }

    /// <summary>
    /// Room for <paramref name="most"/> pairs behind those that are there; <see cref="SetEnd"/> tells how far it was filled.
    /// </summary>
    public unsafe ulong* Reserve(int most)
    {
        _pairs.EnsureCapacity(Math.Max(Least, Count + most));
        return _pairs.Pointer + Count;
    }

    /// <summary>Makes room for so many pairs in all.</summary>
    public void Expect(int pairs) => _pairs.EnsureCapacity(pairs);

    public unsafe void SetEnd(ulong* end) => Count = (int)(end - _pairs.Pointer);

    /// <summary>Moves all pairs of another buffer behind those of this one.</summary>
    public unsafe void Take(PairBuffer other)
    {
        ulong* next = Reserve(other.Count);
        for (int i = 0; i < other.Count; i++)
        {
            *next++ = other[i];
        }

        SetEnd(next);
        other.Clear();
    }

    /// <summary>Gives back room for more pairs than so many.</summary>
    public void Trim(int pairs)
    {
        if (_pairs.Capacity > Math.Max(Least, pairs))
        {
            _pairs = new Column<ulong>(Math.Max(Least, pairs));
        }
    }

    /// <summary>How many pairs fit.</summary>
    public int Capacity => _pairs.Capacity;

    public static ulong Pack(int a, int b) => a < b ? ((ulong)(uint)a << 32) | (uint)b : ((ulong)(uint)b << 32) | (uint)a;

    public static int Lower(ulong pair) => (int)(pair >> 32);

    public static int Higher(ulong pair) => (int)(uint)pair;
}
