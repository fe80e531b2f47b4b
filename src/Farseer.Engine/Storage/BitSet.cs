using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <summary>A growable set of small numbers, one bit each. Members are visited in ascending order, whatever order they came in.</summary>
internal sealed unsafe class BitSet
{
    public const int WordBits = 64;

    private readonly Column<ulong> _words = new Column<ulong>(1);
    private int _wordCount;

    /// <summary>The bits, 64 numbers a word.</summary>
    public ulong* Words => _words.Pointer;

    /// <summary>Words from here on are not kept: they hold no members.</summary>
    public int WordCount => _wordCount;

    /// <summary>Members; counted on demand, O(words).</summary>
    public int Count
    {
        get
        {
            int count = 0;
            for (int i = 0; i < _wordCount; i++)
            {
                count += CountBits(_words.Pointer[i]);
            }

            return count;
        }
    }

    public void Set(int index)
    {
        int word = index >> 6;
        if (word >= _wordCount)
        {
            _words.EnsureCapacity(word + 1);
            _wordCount = word + 1;
        }

        _words.Pointer[word] |= 1UL << (index & 63);
    }

    public void Clear(int index)
    {
        int word = index >> 6;
        if (word < _wordCount)
        {
            _words.Pointer[word] &= ~(1UL << (index & 63));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Test(int index)
    {
        int word = index >> 6;
        return word < _wordCount && (_words.Pointer[word] >> (index & 63) & 1) != 0;
    }

    public void ClearAll()
    {
        Unsafe.InitBlock(_words.Pointer, 0, (uint)_wordCount * sizeof(ulong));
        _wordCount = 0;
    }

    /// <summary>
    /// The lowest member that is not below <paramref name="start"/>, or −1:
    /// <c>for (int i = set.Next(0); i >= 0; i = set.Next(i + 1))</c>. Members may be cleared on the way.
    /// </summary>
    public int Next(int start)
    {
        int word = start >> 6;
        if (word >= _wordCount)
        {
            return -1;
        }

        ulong bits = _words.Pointer[word] >> (start & 63) << (start & 63);
        while (bits == 0)
        {
            if (++word >= _wordCount)
            {
                return -1;
            }

            bits = _words.Pointer[word];
        }

        return (word << 6) + LowestBit(bits);
    }

    /// <summary>The lowest bit that is set; there must be one.</summary>
    public static int LowestBit(ulong bits) => CountBits((bits & (0 - bits)) - 1);

    public static int CountBits(ulong bits)
    {
#if NET8_0_OR_GREATER
        return System.Numerics.BitOperations.PopCount(bits);
#else
        bits -= (bits >> 1) & 0x5555555555555555UL;
        bits = (bits & 0x3333333333333333UL) + ((bits >> 2) & 0x3333333333333333UL);
        bits = (bits + (bits >> 4)) & 0x0F0F0F0F0F0F0F0FUL;
        return (int)((bits * 0x0101010101010101UL) >> 56);
#endif
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _wordCount);
        s.Column(_words);
    }
}
