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
    /// <summary>From a column to the next one: a cache line.</summary>
    private const int LineLanes = Prefetch.LineBytes / sizeof(float);

    /// <param name="pool">Where the points lie.</param>
    /// <param name="index">The place of each lane's point.</param>
    /// <param name="x">Their x.</param>
    /// <param name="y">Their y.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Gather(Vector2* pool, int* index, out Wide x, out Wide y)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            Vector256<float> low = Vector256.Create(Pair(pool, index[0], index[1]), Pair(pool, index[4], index[5]));
            Vector256<float> high = Vector256.Create(Pair(pool, index[2], index[3]), Pair(pool, index[6], index[7]));
            x = Avx.Shuffle(low, high, 0x88).AsVector();
            y = Avx.Shuffle(low, high, 0xDD).AsVector();
            return;
        }
#endif
        GatherByElement(pool, index, out x, out y);
    }

#if NET8_0_OR_GREATER
    /// <summary>
    /// Brings four points in a row of each lane into lane vectors. Where a lane's last one is before a point, that repeats the one before
    /// it; what lies behind it in the pool is read all the same.
    /// </summary>
    /// <param name="pool">Where the points lie.</param>
    /// <param name="start">The place of each lane's first point.</param>
    /// <param name="last">How many more each lane has.</param>
    /// <param name="x">Their x, the points <see cref="LineLanes"/> floats apart.</param>
    /// <param name="y">Their y, likewise.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void GatherFour(Vector2* pool, int* start, Vector256<int> last, float* x, float* y)
    {
        float* p0 = (float*)(pool + start[0]);
        float* p1 = (float*)(pool + start[1]);
        float* p2 = (float*)(pool + start[2]);
        float* p3 = (float*)(pool + start[3]);
        float* p4 = (float*)(pool + start[4]);
        float* p5 = (float*)(pool + start[5]);
        float* p6 = (float*)(pool + start[6]);
        float* p7 = (float*)(pool + start[7]);
        Wide beforeX = Wide.Zero;
        Wide beforeY = Wide.Zero;
        for (int i = 0; i < 4; i += 2)
        {
            Vector256<float> r0 = Vector256.Create(Vector128.Load(p0 + (2 * i)), Vector128.Load(p4 + (2 * i)));
            Vector256<float> r1 = Vector256.Create(Vector128.Load(p1 + (2 * i)), Vector128.Load(p5 + (2 * i)));
            Vector256<float> r2 = Vector256.Create(Vector128.Load(p2 + (2 * i)), Vector128.Load(p6 + (2 * i)));
            Vector256<float> r3 = Vector256.Create(Vector128.Load(p3 + (2 * i)), Vector128.Load(p7 + (2 * i)));
            WideLanes.Transpose(ref r0, ref r1, ref r2, ref r3);
            WideMask has = Vector256.GreaterThanOrEqual(last, Vector256.Create(i)).AsVector();
            beforeX = Wide.Select(has, r0.AsVector(), beforeX);
            beforeY = Wide.Select(has, r1.AsVector(), beforeY);
            beforeX.Store(x + (i * LineLanes));
            beforeY.Store(y + (i * LineLanes));
            has = Vector256.GreaterThan(last, Vector256.Create(i)).AsVector();
            beforeX = Wide.Select(has, r2.AsVector(), beforeX);
            beforeY = Wide.Select(has, r3.AsVector(), beforeY);
            beforeX.Store(x + ((i + 1) * LineLanes));
            beforeY.Store(y + ((i + 1) * LineLanes));
        }
    }

    // A point is eight bytes: two of them fill a vector of 128 bits in two loads.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<float> Pair(Vector2* pool, int first, int second) =>
        Sse2.LoadHigh(Sse2.LoadScalarVector128((double*)(pool + first)), (double*)(pool + second)).AsSingle();
#endif

    /// <summary>
    /// Brings four points in a row of each lane of a bundle into columns, whatever lies behind the last one of a lane: see
    /// <see cref="RepeatLast"/>.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void TurnFour(Vector2* pool, int* start, float* x, float* y)
    {
        for (int i = 0; i < WideLanes.BundleLanes; i += MatrixTurn.Records)
        {
            var p0 = (float*)(pool + start[i]);
            var p1 = (float*)(pool + start[i + 1]);
            var p2 = (float*)(pool + start[i + 2]);
            var p3 = (float*)(pool + start[i + 3]);
            MatrixTurn.ToPairs(p0, p1, p2, p3, x + i, y + i, LineLanes);
            MatrixTurn.ToPairs(
                p0 + 4, p1 + 4, p2 + 4, p3 + 4, x + i + (2 * LineLanes), y + i + (2 * LineLanes), LineLanes);
        }
    }

    /// <summary>Where a lane's last point is before one of the four, that repeats the one before it.</summary>
    /// <param name="last">How many more points than one each lane has.</param>
    /// <param name="column">One coordinate of the first points.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void RepeatLast(Vector<int> last, float* column)
    {
        Wide before = Wide.Load(column);
        for (int i = 1; i < 4; i++)
        {
            column += LineLanes;
            before = Wide.Select(Vector.GreaterThanOrEqual(last, new Vector<int>(i)), Wide.Load(column), before);
            before.Store(column);
        }
    }

    private static void GatherByElement(Vector2* pool, int* index, out Wide x, out Wide y)
    {
        FourColumns turned;
        MatrixTurn.ToTwoColumns(pool, index, Wide.Count, (float*)&turned.A, (float*)&turned.B);
        x = turned.A;
        y = turned.B;
    }
}
