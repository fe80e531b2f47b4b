using System;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Storage;

/// <summary>Memory of states: where it ends, whether sixteen words at a time differ, and differences as small numbers.</summary>
internal static unsafe class StateBlock
{
    /// <summary>Whether any of sixteen words differs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Differ(uint* one, uint* other)
    {
#if NET8_0_OR_GREATER
        Vector256<uint> low = Vector256.Load(one) ^ Vector256.Load(other);
        Vector256<uint> high = Vector256.Load(one + 8) ^ Vector256.Load(other + 8);
        return (low | high) != Vector256<uint>.Zero;
#else
        ulong* a = (ulong*)one;
        ulong* b = (ulong*)other;
        ulong low = (a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2]) | (a[3] ^ b[3]);
        ulong high = (a[4] ^ b[4]) | (a[5] ^ b[5]) | (a[6] ^ b[6]) | (a[7] ^ b[7]);
        return (low | high) != 0;
#endif
    }

    /// <summary>A difference as a number that is small if the difference is, whatever its sign.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Fold(uint difference) => (difference << 1) ^ (uint)((int)difference >> 31);

    /// <summary>The difference that was folded.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Unfold(uint folded) => (folded >> 1) ^ (0u - (folded & 1));

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
