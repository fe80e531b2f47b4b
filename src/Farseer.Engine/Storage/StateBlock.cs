using System;
using System.Numerics;
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

    /// <summary>Copies sixteen words.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void CopyBlock(uint* from, uint* to)
    {
#if NET8_0_OR_GREATER
        Vector256<uint> low = Vector256.Load(from);
        Vector256<uint> high = Vector256.Load(from + 8);
        low.Store(to);
        high.Store(to + 8);
#else
        Buffer.MemoryCopy(from, to, 16 * sizeof(uint), 16 * sizeof(uint));
#endif
    }

    /// <summary>
    /// What words lack of others; the number is a multiple of sixteen. To lack of the same others by that much gives the words back.
    /// </summary>
    public static void Subtract(uint* others, uint* words, uint* to, int count)
    {
        for (int i = 0; i < count; i += Vector<uint>.Count)
        {
            var known = Unsafe.ReadUnaligned<Vector<uint>>(words + i);
            Unsafe.WriteUnaligned(to + i, Unsafe.ReadUnaligned<Vector<uint>>(others + i) - known);
        }
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
        byte* end = LastOfLines(start, start + bytes);
        while (end > start && end[-1] == 0)
        {
            end--;
        }

        return (int)((end - start + size - 1) / size);
    }

    /// <summary>Goes back from the end over what is zero, many bytes at once: columns may have room for far more than there is.</summary>
    private static byte* LastOfLines(byte* start, byte* end)
    {
#if NET8_0_OR_GREATER
        const int Line = 128;
        for (; end - start >= Line; end -= Line)
        {
            Vector256<byte> near = Vector256.Load(end - 32) | Vector256.Load(end - 64);
            Vector256<byte> far = Vector256.Load(end - 96) | Vector256.Load(end - 128);
            if ((near | far) != Vector256<byte>.Zero)
            {
                break;
            }
        }
#endif
        for (; end - start >= sizeof(ulong) && Unsafe.ReadUnaligned<ulong>(end - sizeof(ulong)) == 0; end -= sizeof(ulong))
        {
        }

        return end;
    }

    /// <summary>
    /// Copies memory. The copy that the system has goes past the caches where there is much to copy, and what was written is read at once.
    /// </summary>
    public static void Copy(byte* from, byte* to, long bytes)
    {
#if NET8_0_OR_GREATER
        const int Line = 64;
        for (; bytes >= Line; bytes -= Line, from += Line, to += Line)
        {
            Vector256<byte> low = Vector256.Load(from);
            Vector256<byte> high = Vector256.Load(from + (Line / 2));
            low.Store(to);
            high.Store(to + (Line / 2));
        }
#endif
        Buffer.MemoryCopy(from, to, bytes, bytes);
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
