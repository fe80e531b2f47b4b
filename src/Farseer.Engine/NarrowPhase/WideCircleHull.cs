using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary><see cref="CirclePairs"/> of circles and hulls without seams on lanes, with the same bits.</summary>
internal static unsafe class WideCircleHull
{
    /// <summary>Finds the manifolds of the given lanes and leaves the others alone.</summary>
    /// <param name="pairs">The pairs; the hulls, of whichever side, are named in A of <see cref="PairLanes.Hulls"/>.</param>
    /// <param name="lanes">The lanes to do, a bit each.</param>
    /// <param name="circleFirst">Those whose circle is A.</param>
    /// <param name="vertices">Pool of corners.</param>
    /// <param name="normals">Pool of edge normals.</param>
    public static void Collide(PairLanes* pairs, int lanes, int circleFirst, Vector2* vertices, Vector2* normals)
    {
        HullPairLanes* hulls = &pairs->Hulls;
        int edges = HullSides.Gather(&hulls->A, vertices, normals);
        for (int lane = 0; lane < WideLanes.BundleLanes; lane += Wide.Count)
        {
            Collide(pairs, lane, WideLanes.Mask(lanes >> lane), WideLanes.Mask(circleFirst >> lane), edges, vertices);
        }
    }

    [MethodImpl(KernelMethod.Optimized)]
    private static void Collide(PairLanes* pairs, int lane, WideMask active, WideMask flipped, int edges, Vector2* vertices)
    {
        HullPairLanes* hulls = &pairs->Hulls;
        WidePlacement hull;
        hull.Cos = Wide.Load(hulls->A.Cos + lane);
        hull.Sin = Wide.Load(hulls->A.Sin + lane);
        hull.X = Wide.Keep(flipped, Wide.Load(pairs->OffsetX + lane));
        hull.Y = Wide.Keep(flipped, Wide.Load(pairs->OffsetY + lane));
        FindCenter(pairs, lane, hull, flipped, out Wide x, out Wide y);
        Wide best = FindEdge(hulls, lane, edges, x, y);
        Wide radiusA = HullSides.Radius(&pairs->A, lane);
        Wide radiusB = HullSides.Radius(&pairs->B, lane);
        Wide radius = Wide.Select(flipped, radiusA, radiusB);
        Wide sum = Wide.Select(flipped, radiusB, radiusA) + radius;
        Wide margin = Wide.Load(pairs->Margin + lane);
        WideMask near = active & ~(best - sum > margin);
        WideLanes.Replace(active, Wide.Keep(near, Wide.One), pairs->Count + lane);
        WideLanes.Replace(active, best - sum, pairs->Gap + lane);
        WideLanes.Replace(active, Wide.Select(flipped, Wide.One, Wide.Zero - Wide.One), pairs->GapOwner + lane);
        if (!WideLanes.Any(near))
        {
            return;
        }

        Wide.Keep(active, Wide.FromBits(-1)).Store((float*)hulls->Active + lane);
        FindEnds(hulls, lane);
        WidePoints.Gather(vertices, hulls->Edge.Place + lane, out Wide startX, out Wide startY);
        WidePoints.Gather(vertices, hulls->End.Place + lane, out Wide endX, out Wide endY);
        Wide nx = Wide.Load(hulls->FromB.Edge + lane);
        Wide ny = Wide.Load(hulls->FromB.Support + lane);
        Wide along = ((y - startY) * nx) - ((x - startX) * ny);
        Wide length = ((endY - startY) * nx) - ((endX - startX) * ny);
        WideMask before = along < Wide.Zero;
        WideMask corner = (best >= Wide.Zero) & (before | (along > length));

        // Nearest to a corner: the direction is that from it to the centre.
        Wide armX = x - Wide.Select(before, startX, endX);
        Wide armY = y - Wide.Select(before, startY, endY);
        Wide distance = Wide.Sqrt((armX * armX) + (armY * armY));
        Wide scale = Wide.Select(flipped, Wide.Load(pairs->B.Extent + lane), Wide.Load(pairs->A.Extent + lane));
        WideMask apart = corner & (distance > Wide.Splat(CirclePairs.ShortestArm) * scale);
        nx = Wide.Select(apart, armX / distance, nx);
        ny = Wide.Select(apart, armY / distance, ny);
        Wide separation = Wide.Select(corner, (armX * nx) + (armY * ny), best) - sum;
        near = near & ~(corner & (distance - sum > margin));
        Wide reach = radius + (Wide.Splat(0.5f) * separation);
        hull.Apply(x - (nx * reach), y - (ny * reach), out x, out y);
        Wide worldX = (hull.Cos * nx) - (hull.Sin * ny);
        Wide worldY = (hull.Sin * nx) + (hull.Cos * ny);
        WideLanes.Replace(active, Wide.Keep(near, Wide.One), pairs->Count + lane);
        WideLanes.Replace(active, Wide.Select(flipped, Wide.Zero - worldX, worldX), pairs->NormalX + lane);
        WideLanes.Replace(active, Wide.Select(flipped, Wide.Zero - worldY, worldY), pairs->NormalY + lane);
        WideLanes.Replace(active, x, pairs->Point0.X + lane);
        WideLanes.Replace(active, y, pairs->Point0.Y + lane);
        WideLanes.Replace(active, separation, pairs->Point0.Separation + lane);
        WideLanes.Replace(active, Wide.FromBits((int)CirclePairs.Id), (float*)pairs->Point0.Id + lane);
    }

    /// <summary>The circle's centre in the hull's frame.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void FindCenter(PairLanes* pairs, int lane, in WidePlacement hull, WideMask flipped, out Wide x, out Wide y)
    {
        Wide offX = Wide.Load(pairs->OffsetX + lane);
        Wide offY = Wide.Load(pairs->OffsetY + lane);
        x = Wide.Select(flipped, Wide.Load(pairs->A.X + lane) - offX, Wide.Load(pairs->B.X + lane) + offX);
        y = Wide.Select(flipped, Wide.Load(pairs->A.Y + lane) - offY, Wide.Load(pairs->B.Y + lane) + offY);
        hull.TurnBack(x, y, out x, out y);
    }

    /// <summary>Finds the edge that the centre is farthest out of: its number, and its normal in the place of B's axis.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide FindEdge(HullPairLanes* hulls, int lane, int edges, Wide x, Wide y)
    {
        Wide best = Wide.Zero;
        Wide bestEdge = Wide.Zero;
        Wide normalX = Wide.Zero;
        Wide normalY = Wide.Zero;
        for (int edge = 0; edge < edges; edge++)
        {
            int at = (edge * HullLanes.LineLanes) + lane;
            Wide nx = Wide.Load(hulls->A.NormalX + at);
            Wide ny = Wide.Load(hulls->A.NormalY + at);
            Wide s = (nx * (x - Wide.Load(hulls->A.VertexX + at))) + (ny * (y - Wide.Load(hulls->A.VertexY + at)));
            WideMask better = edge == 0 ? WideLanes.AllSet : s > best;
            best = Wide.Select(better, s, best);
            bestEdge = Wide.Select(better, Wide.Splat(edge), bestEdge);
            normalX = Wide.Select(better, nx, normalX);
            normalY = Wide.Select(better, ny, normalY);
        }

        bestEdge.Store(hulls->FromA.Edge + lane);
        normalX.Store(hulls->FromB.Edge + lane);
        normalY.Store(hulls->FromB.Support + lane);
        return best;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void FindEnds(HullPairLanes* hulls, int first)
    {
        for (int lane = first; lane < first + Wide.Count; lane += Vector<int>.Count)
        {
            Vector<int> active = Unsafe.ReadUnaligned<Vector<int>>(hulls->Active + lane);
            Vector<int> edge = Vector.ConvertToInt32(Unsafe.ReadUnaligned<Vector<float>>(hulls->FromA.Edge + lane)) & active;
            Vector<int> start = Unsafe.ReadUnaligned<Vector<int>>(hulls->A.Start + lane);
            Vector<int> isLast = Vector.Equals(edge, Unsafe.ReadUnaligned<Vector<int>>(hulls->A.Last + lane));
            Unsafe.WriteUnaligned(hulls->Edge.Place + lane, start + edge);
            Unsafe.WriteUnaligned(hulls->End.Place + lane, start + Vector.AndNot(edge + Vector<int>.One, isLast));
        }
    }
}
