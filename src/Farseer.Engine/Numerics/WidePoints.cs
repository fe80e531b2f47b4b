using System.Numerics;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Numerics;

/// <summary>Brings points of a pool, one for each lane, into two lane vectors.</summary>
internal static unsafe class WidePoints
{
    /// <param name="pool">Where the points lie.</param>
    /// <param name="index">The place of each lane's point.</param>
    /// <param name="x">Their x.</param>
    /// <param name="y">Their y.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Gather(Vector2* pool, int* index, out Wide x, out Wide y)
    {
#if NET8_0_OR_GREATER
        if (Avx.IsSupported)
        {
            Vector256<float> low = Vector256.Create(Pair(pool, index[0], index[1]), Pair(pool, index[4], index[5]));
            Vector256<float> high = Vector256.Create(Pair(pool, index[2], index[3]), Pair(pool, index[6], index[7]));
            x = Avx.Shuffle(low, high, 0x88);
            y = Avx.Shuffle(low, high, 0xDD);
            return;
        }
#endif
        GatherByElement(pool, index, out x, out y);
    }

#if NET8_0_OR_GREATER
    // A point is eight bytes: two of them fill a vector of 128 bits in two loads.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<float> Pair(Vector2* pool, int first, int second) =>
        Sse2.LoadHigh(Sse2.LoadScalarVector128((double*)(pool + first)), (double*)(pool + second)).AsSingle();
#endif

    private static void GatherByElement(Vector2* pool, int* index, out Wide x, out Wide y)
    {
        float* t = stackalloc float[2 * WideLanes.BundleLanes];
        for (int i = 0; i < Wide.Count; i++)
        {
            t[i] = pool[index[i]].X;
            t[i + WideLanes.BundleLanes] = pool[index[i]].Y;
        }

        x = Wide.Load(t);
        y = Wide.Load(t + WideLanes.BundleLanes);
    }
}
