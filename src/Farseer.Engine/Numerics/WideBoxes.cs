using System.Numerics;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#else
using System;
using System.Runtime.InteropServices;
#endif

namespace Farseer.Engine.Numerics;

/// <summary>
/// Eight boxes in four arrays, one a bound, tested at once against one box. Comparisons have no rounding, so every lane width gives the
/// same mask.
/// </summary>
internal unsafe struct WideBoxes
{
    /// <summary>Boxes a test looks at; arrays need this many readable elements from any tested index on.</summary>
    public const int Width = 8;

    public float* MinX;
    public float* MinY;
    public float* MaxX;
    public float* MaxY;

    /// <summary>Bit i is set if box <paramref name="index"/> + i shares a point with <paramref name="box"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly uint Overlaps(int index, in SpreadBox box)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            return (uint)WideLanes.Bits(Inside(index, box));
        }
#endif
        uint mask = 0;
        for (int lane = 0; lane < Width; lane += Vector<float>.Count)
        {
            Vector<int> inside = Inside(index + lane, box);
            if (!inside.Equals(Vector<int>.Zero))
            {
                mask |= (uint)WideLanes.Bits(inside) << lane;
            }
        }

        return mask & 0xFF;
    }

    /// <summary>The same of as many as a vector holds.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly Vector<int> Inside(int index, in SpreadBox box) =>
        Vector.LessThanOrEqual(Read(MinX + index), box.MaxX)
        & Vector.GreaterThanOrEqual(Read(MaxX + index), box.MinX)
        & Vector.LessThanOrEqual(Read(MinY + index), box.MaxY)
        & Vector.GreaterThanOrEqual(Read(MaxY + index), box.MinY);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<float> Read(float* from) => Unsafe.ReadUnaligned<Vector<float>>(from);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Set(int index, in Box box)
    {
        MinX[index] = box.MinX;
        MinY[index] = box.MinY;
        MaxX[index] = box.MaxX;
        MaxY[index] = box.MaxY;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Box Get(int index) => new Box(MinX[index], MinY[index], MaxX[index], MaxY[index]);

    /// <summary>The box around the eight from <paramref name="first"/> on; empty ones do not count.</summary>
    public readonly Box Around(int first)
    {
        Box box = Get(first);
        for (int i = first + 1; i < first + Width; i++)
        {
            box.MinX = MinX[i] < box.MinX ? MinX[i] : box.MinX;
            box.MinY = MinY[i] < box.MinY ? MinY[i] : box.MinY;
            box.MaxX = MaxX[i] > box.MaxX ? MaxX[i] : box.MaxX;
            box.MaxY = MaxY[i] > box.MaxY ? MaxY[i] : box.MaxY;
        }

        return box;
    }

    /// <summary>A box that overlaps nothing, not even itself.</summary>
    public readonly void SetEmpty(int index) => Set(index, Box.Empty);

    /// <summary>A mask of the first <paramref name="count"/> lanes, of all if there are more; at least 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint FirstLanes(int count) => count >= Width ? (1u << Width) - 1 : (1u << count) - 1;

    /// <summary>The index of the lowest set bit of a mask that is not zero.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int LowestLane(uint mask)
    {
#if NET8_0_OR_GREATER
        return BitOperations.TrailingZeroCount(mask);
#else
        // Times the bit that is alone a sequence in which each run of five bits stands once has that of the bit's number at its top.
        return Unsafe.Add(ref MemoryMarshal.GetReference(LaneOfRun), (int)(((mask & (0 - mask)) * 0x077CB531u) >> 27));
#endif
    }

#if !NET8_0_OR_GREATER
    private static ReadOnlySpan<byte> LaneOfRun =>
        [0, 1, 28, 2, 29, 14, 24, 3, 30, 22, 20, 15, 25, 17, 4, 8, 31, 27, 13, 23, 21, 19, 16, 7, 26, 12, 18, 6, 11, 5, 10, 9];
#endif
}

/// <summary>One box with every bound in all lanes, made once and tested against many groups of eight.</summary>
internal readonly struct SpreadBox
{
    public readonly Vector<float> MinX;
    public readonly Vector<float> MinY;
    public readonly Vector<float> MaxX;
    public readonly Vector<float> MaxY;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public SpreadBox(in Box box)
    {
        MinX = new Vector<float>(box.MinX);
        MinY = new Vector<float>(box.MinY);
        MaxX = new Vector<float>(box.MaxX);
        MaxY = new Vector<float>(box.MaxY);
    }
}
