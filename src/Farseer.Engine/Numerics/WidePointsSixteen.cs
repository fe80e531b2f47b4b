#if NET8_0_OR_GREATER
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Farseer.Engine.Numerics.Sixteen;

using Wide = System.Runtime.Intrinsics.Vector512<float>;

/// <summary>Brings points of a pool into vectors of sixteen lanes: see <see cref="Farseer.Engine.Numerics.WidePoints"/>.</summary>
internal static unsafe class WidePoints
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Gather(Vector2* pool, int* index, out Wide x, out Wide y)
    {
        Wide even = Pairs(pool, index);
        Wide odd = Pairs(pool, index + 2);
        x = Avx512F.Shuffle(even, odd, 0x88);
        y = Avx512F.Shuffle(even, odd, 0xDD);
    }

    /// <summary>The first two of every four.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Pairs(Vector2* pool, int* index)
    {
        Wide r = Pair(pool, index).ToVector256Unsafe().ToVector512Unsafe();
        r = Avx512F.InsertVector128(r, Pair(pool, index + 4), 1);
        r = Avx512F.InsertVector128(r, Pair(pool, index + 8), 2);
        return Avx512F.InsertVector128(r, Pair(pool, index + 12), 3);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<float> Pair(Vector2* pool, int* index) =>
        Sse2.LoadHigh(Sse2.LoadScalarVector128((double*)(pool + index[0])), (double*)(pool + index[1])).AsSingle();
}
#endif
