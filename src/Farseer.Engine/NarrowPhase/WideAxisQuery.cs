using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary>
/// <see cref="AxisQuery"/> on lanes, for hulls without seams: every edge is measured, which gives the bits of the search that leaves
/// edges out, because both take the first of equals.
/// </summary>
internal static unsafe class WideAxisQuery
{
    /// <param name="reference">The hulls whose edge normals are tried.</param>
    /// <param name="edges">The most edges that one of them has.</param>
    /// <param name="other">The hulls against which.</param>
    /// <param name="corners">The most corners that one of those has.</param>
    /// <param name="placement">How the others lie in the frames of the references.</param>
    /// <param name="lane">First of the lanes to do.</param>
    /// <param name="found">Where the axes are written.</param>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Find(
        HullLanes* reference, int edges, HullLanes* other, int corners, in WidePlacement placement, int lane, AxisLanes* found)
    {
        const int Row = HullLanes.LineLanes;
        float* cornerX = other->VertexX + lane;
        float* cornerY = other->VertexY + lane;
        Wide best = Wide.Zero;
        Wide bestEdge = Wide.Zero;
        Wide bestX = Wide.Zero;
        Wide bestY = Wide.Zero;
        for (int edge = 0; edge < edges; edge++)
        {
            int at = (edge * Row) + lane;
            Wide nx = Wide.Load(reference->NormalX + at);
            Wide ny = Wide.Load(reference->NormalY + at);
            placement.TurnBack(nx, ny, out Wide dx, out Wide dy);
            Wide low = (dx * Wide.Load(cornerX)) + (dy * Wide.Load(cornerY));
            for (int i = Row; i < corners * Row; i += Row)
            {
                low = Wide.Min((dx * Wide.Load(cornerX + i)) + (dy * Wide.Load(cornerY + i)), low);
            }

            Wide separation = low + (((placement.X - Wide.Load(reference->VertexX + at)) * nx)
                + ((placement.Y - Wide.Load(reference->VertexY + at)) * ny));
            WideMask better = edge == 0 ? WideLanes.AllSet : separation > best;
            best = Wide.Select(better, separation, best);
            bestEdge = Wide.Select(better, Wide.Splat(edge), bestEdge);
            bestX = Wide.Select(better, dx, bestX);
            bestY = Wide.Select(better, dy, bestY);
        }

        best.Store(found->Separation + lane);
        bestEdge.Store(found->Edge + lane);
        Wide support = Wide.Zero;
        Wide lowest = (bestX * Wide.Load(cornerX)) + (bestY * Wide.Load(cornerY));
        for (int i = 1; i < corners; i++)
        {
            Wide height = (bestX * Wide.Load(cornerX + (i * Row))) + (bestY * Wide.Load(cornerY + (i * Row)));
            support = Wide.Select(height < lowest, Wide.Splat(i), support);
            lowest = Wide.Min(height, lowest);
        }

        support.Store(found->Support + lane);
    }
}

/// <summary><see cref="Placement"/> on lanes.</summary>
internal struct WidePlacement
{
    public Wide Cos;
    public Wide Sin;
    public Wide X;
    public Wide Y;

    /// <summary>A direction of this frame in the frame that is placed in it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void TurnBack(Wide x, Wide y, out Wide turnedX, out Wide turnedY)
    {
        turnedX = (Cos * x) + (Sin * y);
        turnedY = (Cos * y) - (Sin * x);
    }

    /// <summary>A point of the placed frame in this one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Apply(Wide x, Wide y, out Wide placedX, out Wide placedY)
    {
        placedX = ((Cos * x) - (Sin * y)) + X;
        placedY = ((Sin * x) + (Cos * y)) + Y;
    }
}
