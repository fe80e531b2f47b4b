using System;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Numerics;
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Storage;

/// <summary>Memory of states: where it ends, and in what sixteen words at a time differ, in few bytes.</summary>
internal static unsafe class StateBlock
{
    /// <summary>A bit for each of sixteen words that differs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Differ(uint* one, uint* other)
    {
#if NET8_0_OR_GREATER
        Vector256<uint> low = Vector256.Load(one) ^ Vector256.Load(other);
        Vector256<uint> high = Vector256.Load(one + 8) ^ Vector256.Load(other + 8);
        if ((low | high) == Vector256<uint>.Zero)
        {
            return 0;
        }

        uint same = Vector256.Equals(low, Vector256<uint>.Zero).ExtractMostSignificantBits()
            | (Vector256.Equals(high, Vector256<uint>.Zero).ExtractMostSignificantBits() << 8);
        return ~same & 0xFFFF;
#else
        ulong* a = (ulong*)one;
        ulong* b = (ulong*)other;
        ulong low = (a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2]) | (a[3] ^ b[3]);
        ulong high = (a[4] ^ b[4]) | (a[5] ^ b[5]) | (a[6] ^ b[6]) | (a[7] ^ b[7]);
        if ((low | high) == 0)
        {
            return 0;
        }

        uint differ = 0;
        for (int i = 0; i < 16; i++)
        {
            differ |= (one[i] != other[i] ? 1u : 0) << i;
        }

        return differ;
#endif
    }

    /// <summary>A difference as a number that is small if the difference is, whatever its sign.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Fold(uint difference) => (difference << 1) ^ (uint)((int)difference >> 31);

    /// <summary>The difference that was folded.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Unfold(uint folded) => (folded >> 1) ^ (0u - (folded & 1));

    /// <summary>How many bytes a number takes, without those above that are zero; at least 1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Bytes(uint number)
    {
#if NET8_0_OR_GREATER
        return (39 - BitOperations.LeadingZeroCount(number | 1)) >> 3;
#else
        return number < 1u << 8 ? 1 : number < 1u << 16 ? 2 : number < 1u << 24 ? 3 : 4;
#endif
    }

    /// <summary>Records of a size up to the last one that is not zero.</summary>
    public static int Used(byte* start, long bytes, int size)
    {
        long end = bytes;
        while (end > 0 && start[end - 1] == 0)
        {
            end -= end >= sizeof(ulong) && *(ulong*)(start + end - sizeof(ulong)) == 0 ? sizeof(ulong) : 1;
        }

        return (int)((end + size - 1) / size);
    }

    /// <summary>Makes it zero, however much it is.</summary>
    public static void Clear(byte* start, long bytes)
    {
        const long Most = 1 << 30;
        for (; bytes > 0; bytes -= Most, start += Most)
        {
            Unsafe.InitBlockUnaligned(start, 0, (uint)Math.Min(bytes, Most));
        }
    }
}
