using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.NarrowPhase;

/// <summary>
/// The hulls of one side of a bundle's pairs, corner by corner. A hull with fewer corners than another repeats its last one: it is
/// never chosen, because the first of equals is.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct HullLanes
{
    public const int Lanes = WideLanes.BundleLanes;

    /// <summary>The lanes of a column as it lies in memory: see <see cref="PairLanes.LineLanes"/>.</summary>
    public const int LineLanes = PairLanes.LineLanes;

    /// <summary>Hulls with more corners are left to the code for one pair.</summary>
    public const int MostCorners = Piece.MostLaneCorners;

    /// <summary>
    /// Corner i of all lanes stands at i·<see cref="LineLanes"/>, likewise the outward normal of the edge that starts there.
    /// </summary>
    public fixed float VertexX[MostCorners * LineLanes];
    public fixed float VertexY[MostCorners * LineLanes];
    public fixed float NormalX[MostCorners * LineLanes];
    public fixed float NormalY[MostCorners * LineLanes];

    /// <summary>Where the hull's corners begin in the pools, and the number of its last one.</summary>
    public fixed int Start[LineLanes];
    public fixed int Last[LineLanes];

    /// <summary>The body's rotation.</summary>
    public fixed float Cos[LineLanes];
    public fixed float Sin[LineLanes];

    private const int CornerBits = 3;

    /// <summary>Start and number of corners, of 1 to <see cref="MostCorners"/>, in one number.</summary>
    public static int Pack(int start, int count) => (start << CornerBits) | ((count - 1) & (MostCorners - 1));

    /// <summary>The hulls of the lanes from one on.</summary>
    public static HullLanes* At(HullLanes* hulls, int lane) => (HullLanes*)((float*)hulls + lane);

    /// <summary>
    /// Names the hulls of some lanes. The others repeat the first point of the pool; a lane without a piece is named -1, and something must
    /// stand there.
    /// </summary>
    /// <param name="hulls">The lanes to name.</param>
    /// <param name="lanes">Those that have a hull, a bit each.</param>
    /// <param name="pieces">The piece of each lane.</param>
    /// <param name="packed">By piece, what <see cref="Pack"/> told.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Name(HullLanes* hulls, int lanes, int* pieces, int* packed)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            Vector256<int> all = WideLanes.Mask(lanes).AsVector256() & Vector256.Create(
                packed[pieces[0]], packed[pieces[1]], packed[pieces[2]], packed[pieces[3]],
                packed[pieces[4]], packed[pieces[5]], packed[pieces[6]], packed[pieces[7]]);
            (all >>> CornerBits).Store(hulls->Start);
            (all & Vector256.Create(MostCorners - 1)).Store(hulls->Last);
            return;
        }
#endif
        for (int lane = 0; lane < Lanes; lane++)
        {
            int one = packed[pieces[lane]] & -((lanes >> lane) & 1);
            hulls->Start[lane] = one >> CornerBits;
            hulls->Last[lane] = one & (MostCorners - 1);
        }
    }

    /// <summary>Reads the corners of all lanes from the pools.</summary>
    /// <param name="hulls">The lanes, named.</param>
    /// <param name="most">The number of the last corner to read; no lane has more.</param>
    /// <param name="vertices">Pool of corners.</param>
    /// <param name="normals">Pool of edge normals.</param>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Gather(HullLanes* hulls, int most, Vector2* vertices, Vector2* normals)
    {
        int corner = ShapeStore.ReadAtOnce;
        if (AreEqual(hulls, most))
        {
            Spread(hulls, vertices + hulls->Start[0], normals + hulls->Start[0], most);
            return;
        }

#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            Vector256<int> last = Vector256.Load(hulls->Last);
            WidePoints.GatherFour(vertices, hulls->Start, last, hulls->VertexX, hulls->VertexY);
            WidePoints.GatherFour(normals, hulls->Start, last, hulls->NormalX, hulls->NormalY);
        }
        else
#endif
        {
            WidePoints.TurnFour(vertices, hulls->Start, hulls->VertexX, hulls->VertexY);
            WidePoints.TurnFour(normals, hulls->Start, hulls->NormalX, hulls->NormalY);
            for (int lane = 0; lane < Lanes; lane += Wide.Count)
            {
                Vector<int> last = Read(hulls->Last + lane);
                WidePoints.RepeatLast(last, hulls->VertexX + lane);
                WidePoints.RepeatLast(last, hulls->VertexY + lane);
                WidePoints.RepeatLast(last, hulls->NormalX + lane);
                WidePoints.RepeatLast(last, hulls->NormalY + lane);
            }
        }

        int* index = stackalloc int[Lanes];
        for (; corner <= most; corner++)
        {
            Place(hulls, corner, index);
            for (int lane = 0; lane < Lanes; lane += Wide.Count)
            {
                int at = (corner * LineLanes) + lane;
                WidePoints.Gather(vertices, index + lane, out Wide x, out Wide y);
                x.Store(hulls->VertexX + at);
                y.Store(hulls->VertexY + at);
                WidePoints.Gather(normals, index + lane, out x, out y);
                x.Store(hulls->NormalX + at);
                y.Store(hulls->NormalY + at);
            }
        }
    }

    /// <summary>All lanes have one hull, of as many corners as are to be read.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AreEqual(HullLanes* hulls, int most)
    {
        var start = new Vector<int>(hulls->Start[0]);
        var last = new Vector<int>(most);
        for (int lane = 0; lane < Lanes; lane += Wide.Count)
        {
            if (!Vector.EqualsAll(Read(hulls->Start + lane), start) || !Vector.EqualsAll(Read(hulls->Last + lane), last))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Equal pieces share their corners: those of a heap of one kind are read once for all lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Spread(HullLanes* hulls, Vector2* vertices, Vector2* normals, int last)
    {
        for (int i = 0; i <= last; i++)
        {
            var x = new Wide(vertices[i].X);
            var y = new Wide(vertices[i].Y);
            var normalX = new Wide(normals[i].X);
            var normalY = new Wide(normals[i].Y);
            for (int lane = 0; lane < Lanes; lane += Wide.Count)
            {
                int at = (i * LineLanes) + lane;
                x.Store(hulls->VertexX + at);
                y.Store(hulls->VertexY + at);
                normalX.Store(hulls->NormalX + at);
                normalY.Store(hulls->NormalY + at);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Place(HullLanes* hulls, int corner, int* index)
    {
        for (int lane = 0; lane < Lanes; lane += Wide.Count)
        {
            Unsafe.WriteUnaligned(index + lane, Read(hulls->Start + lane) + Vector.Min(Read(hulls->Last + lane), new Vector<int>(corner)));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<int> Read(int* source) => Unsafe.ReadUnaligned<Vector<int>>(source);
}

/// <summary>The best separating axis of each lane among the edges of one side, as <see cref="AxisQuery"/>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct AxisLanes
{
    private const int LineLanes = PairLanes.LineLanes;

    /// <summary>Numbers of an edge and of the other hull's vertex nearest to it, held as floats.</summary>
    public fixed float Edge[LineLanes];
    public fixed float Support[LineLanes];
    public fixed float Separation[LineLanes];
}

/// <summary>A corner or an edge of each lane's hull: its place in the pools, and its part of the name of a point.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct FeatureLanes
{
    private const int LineLanes = PairLanes.LineLanes;

    public fixed int Place[LineLanes];
    public fixed int Name[LineLanes];
}

/// <summary>What the kernels of hulls hold of the pairs of a bundle besides <see cref="PairLanes"/>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct HullPairLanes
{
    private const int LineLanes = PairLanes.LineLanes;

    public HullLanes A;
    public HullLanes B;
    public AxisLanes FromA;
    public AxisLanes FromB;

    /// <summary>All bits set in the lanes that a kernel is to write.</summary>
    public fixed int Active[LineLanes];

    /// <summary>All bits set in the lanes whose reference edge is one of B's.</summary>
    public fixed int Flipped[LineLanes];

    /// <summary>The ends of the reference edge, and of the other hull the support vertex and its neighbours.</summary>
    public FeatureLanes Edge;
    public FeatureLanes End;
    public FeatureLanes Before;
    public FeatureLanes Support;
    public FeatureLanes After;
}
