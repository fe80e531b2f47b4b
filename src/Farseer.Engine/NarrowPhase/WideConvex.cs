using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary>
/// <see cref="ConvexConvex"/> on lanes, for hulls without seams (polygons, boxes, capsules, segments, rounded or not): the same
/// formulas in the same order, every branch a selection, so the same bits.
/// </summary>
internal static unsafe class WideConvex
{
    /// <summary>Finds the manifolds of the given lanes, whose hulls are named, and leaves the others alone.</summary>
    /// <param name="pairs">The pairs; both sides of <see cref="PairLanes.Hulls"/> are named.</param>
    /// <param name="lanes">The lanes to do, a bit each.</param>
    /// <param name="vertices">Pool of corners.</param>
    /// <param name="normals">Pool of edge normals.</param>
    public static void Collide(PairLanes* pairs, int lanes, Vector2* vertices, Vector2* normals)
    {
        HullPairLanes* hulls = &pairs->Hulls;
        int cornersA = HullSides.Gather(&hulls->A, vertices, normals);
        int cornersB = HullSides.Gather(&hulls->B, vertices, normals);
        int near = 0;
        for (int lane = 0; lane < WideLanes.BundleLanes; lane += Wide.Count)
        {
            near |= FindAxes(pairs, WideLanes.Mask(lanes >> lane), cornersA, cornersB, lane);
        }

        if (near == 0)
        {
            return;
        }

        FindFeatures(hulls);
        for (int lane = 0; lane < WideLanes.BundleLanes; lane += Wide.Count)
        {
            Build(pairs, lane, vertices, normals);
        }
    }

    /// <summary>How B lies in A's frame.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WidePlacement PlaceB(PairLanes* pairs, int lane)
    {
        Wide aCos = Wide.Load(pairs->Hulls.A.Cos + lane);
        Wide aSin = Wide.Load(pairs->Hulls.A.Sin + lane);
        Wide bCos = Wide.Load(pairs->Hulls.B.Cos + lane);
        Wide bSin = Wide.Load(pairs->Hulls.B.Sin + lane);
        Wide x = Wide.Load(pairs->OffsetX + lane);
        Wide y = Wide.Load(pairs->OffsetY + lane);
        WidePlacement placement;
        placement.Cos = (aCos * bCos) + (aSin * bSin);
        placement.Sin = (aCos * bSin) - (aSin * bCos);
        placement.X = (aCos * x) + (aSin * y);
        placement.Y = (aCos * y) - (aSin * x);
        return placement;
    }

    /// <summary>How A lies in B's frame, when the turn between them is known.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WidePlacement PlaceA(PairLanes* pairs, int lane, in WidePlacement turn)
    {
        Wide bCos = Wide.Load(pairs->Hulls.B.Cos + lane);
        Wide bSin = Wide.Load(pairs->Hulls.B.Sin + lane);
        Wide x = Wide.Zero - Wide.Load(pairs->OffsetX + lane);
        Wide y = Wide.Zero - Wide.Load(pairs->OffsetY + lane);
        WidePlacement placement;
        placement.Cos = turn.Cos;
        placement.Sin = Wide.Zero - turn.Sin;
        placement.X = (bCos * x) + (bSin * y);
        placement.Y = (bCos * y) - (bSin * x);
        return placement;
    }

    /// <summary>
    /// Finds the best axis of each side, notes which lanes no axis separates by more than the margin, and whose reference is B.
    /// </summary>
    /// <returns>0 if there are none.</returns>
    private static int FindAxes(PairLanes* pairs, WideMask named, int cornersA, int cornersB, int lane)
    {
        HullPairLanes* hulls = &pairs->Hulls;
        WidePlacement placement = PlaceB(pairs, lane);
        Wide radiusA = HullSides.Radius(&pairs->A, lane);
        Wide radiusB = HullSides.Radius(&pairs->B, lane);
        Wide limit = (Wide.Load(pairs->Margin + lane) + radiusA) + radiusB;
        WideLanes.Replace(named, Wide.Zero, pairs->Count + lane);
        WideAxisQuery.Find(&hulls->A, cornersA, &hulls->B, cornersB, placement, lane, &hulls->FromA);
        Wide fromA = Wide.Load(hulls->FromA.Separation + lane);
        WideMask near = named & ~(fromA > limit);
        if (!WideLanes.Any(near))
        {
            NoteGap(pairs, lane, named, fromA - radiusA - radiusB, Wide.Zero - Wide.One);
            Wide.Zero.Store((float*)hulls->Active + lane);
            Wide.Zero.Store((float*)hulls->Flipped + lane);
            return 0;
        }

        placement = PlaceA(pairs, lane, placement);
        WideAxisQuery.Find(&hulls->B, cornersB, &hulls->A, cornersA, placement, lane, &hulls->FromB);
        Wide fromB = Wide.Load(hulls->FromB.Separation + lane);
        Wide scale = Wide.Min(Wide.Load(pairs->A.Extent + lane), Wide.Load(pairs->B.Extent + lane));
        NoteGap(
            pairs, lane, named, Wide.Max(fromA, fromB) - radiusA - radiusB, Wide.Select(fromA > fromB, Wide.Zero - Wide.One, Wide.One));
        WideMask flipped = fromB > fromA + (Wide.Splat(ConvexConvex.ReferenceBias) * scale);
        near = near & ~(fromB > limit);
        Wide set = Wide.FromBits(-1);
        Wide.Keep(near, set).Store((float*)hulls->Active + lane);
        Wide.Keep(flipped, set).Store((float*)hulls->Flipped + lane);
        return WideLanes.Bits(near);
    }

    /// <summary>Notes what separates the hulls of the named lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void NoteGap(PairLanes* pairs, int lane, WideMask named, Wide gap, Wide owner)
    {
        WideLanes.Replace(named, gap, pairs->Gap + lane);
        WideLanes.Replace(named, owner, pairs->GapOwner + lane);
    }

    /// <summary>Looks up where the features lie that the contact can be made of.</summary>
    private static void FindFeatures(HullPairLanes* hulls)
    {
        for (int lane = 0; lane < WideLanes.BundleLanes; lane += Vector<int>.Count)
        {
            Vector<int> turned = Load(hulls->Flipped + lane);
            Vector<int> counts = Load(hulls->Active + lane);
            Vector<int> startA = Load(hulls->A.Start + lane);
            Vector<int> startB = Load(hulls->B.Start + lane);
            Vector<int> lastA = Load(hulls->A.Last + lane);
            Vector<int> lastB = Load(hulls->B.Last + lane);
            Vector<int> edge = Pick(turned, hulls->FromB.Edge + lane, hulls->FromA.Edge + lane) & counts;
            Vector<int> support = Pick(turned, hulls->FromB.Support + lane, hulls->FromA.Support + lane) & counts;
            Vector<int> start = Vector.ConditionalSelect(turned, startB, startA);
            Vector<int> last = Vector.ConditionalSelect(turned, lastB, lastA);
            Set(&hulls->Edge, lane, start, edge, turned);
            Set(&hulls->End, lane, start, Vector.AndNot(edge + Vector<int>.One, Vector.Equals(edge, last)), turned);
            start = Vector.ConditionalSelect(turned, startA, startB);
            last = Vector.ConditionalSelect(turned, lastA, lastB);
            Vector<int> first = Vector.Equals(support, Vector<int>.Zero);
            Set(&hulls->Before, lane, start, Vector.ConditionalSelect(first, last, support - Vector<int>.One), ~turned);
            Set(&hulls->Support, lane, start, support, ~turned);
            Set(&hulls->After, lane, start, Vector.AndNot(support + Vector<int>.One, Vector.Equals(support, last)), ~turned);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<int> Load(int* source) => Unsafe.ReadUnaligned<Vector<int>>(source);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<int> Pick(Vector<int> turned, float* fromB, float* fromA) =>
        Vector.ConvertToInt32(
            Vector.ConditionalSelect(turned, Unsafe.ReadUnaligned<Vector<float>>(fromB), Unsafe.ReadUnaligned<Vector<float>>(fromA)));

    // A name is EdgeContact.Id, of which each feature gives its half: that of B's the lower.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Set(FeatureLanes* feature, int lane, Vector<int> start, Vector<int> number, Vector<int> ofB)
    {
#if NET8_0_OR_GREATER
        Vector<int> name = Vector.ConditionalSelect(ofB, number << 1, number << 16);
#else
        Vector<int> name = number * Vector.ConditionalSelect(ofB, new Vector<int>(1 << 1), new Vector<int>(1 << 16));
#endif
        Unsafe.WriteUnaligned(feature->Place + lane, start + number);
        Unsafe.WriteUnaligned(feature->Name + lane, name | Vector<int>.One);
    }

    [MethodImpl(KernelMethod.Optimized)]
    private static void Build(PairLanes* pairs, int lane, Vector2* vertices, Vector2* normals)
    {
        HullPairLanes* hulls = &pairs->Hulls;
        WideMask flipped = WideLanes.Has(Wide.Load((float*)hulls->Flipped + lane), -1);
        WidePlacement placement = PlaceB(pairs, lane);
        WidePlacement placeA = PlaceA(pairs, lane, placement);
        placement.Sin = Wide.Select(flipped, placeA.Sin, placement.Sin);
        placement.X = Wide.Select(flipped, placeA.X, placement.X);
        placement.Y = Wide.Select(flipped, placeA.Y, placement.Y);

        FeaturePoints points;
        FeaturePoints.Turn(&points, hulls, lane, vertices, normals);
        WideEdgeContact contact = default;
        FeaturePoints.Read(&points.Edge, vertices, hulls->Edge.Place + lane, out contact.X, out contact.Y);
        FeaturePoints.Read(&points.EdgeNormal, normals, hulls->Edge.Place + lane, out contact.NormalX, out contact.NormalY);
        FeaturePoints.Read(&points.End, vertices, hulls->End.Place + lane, out contact.EndX, out contact.EndY);
        contact.Length = contact.Along(contact.EndX - contact.X, contact.EndY - contact.Y);

        // Of the two edges at the support vertex the one that faces the reference edge more.
        placement.TurnBack(contact.NormalX, contact.NormalY, out Wide mx, out Wide my);
        FeaturePoints.Read(&points.BeforeNormal, normals, hulls->Before.Place + lane, out Wide x, out Wide y);
        Wide facing = (x * mx) + (y * my);
        FeaturePoints.Read(&points.SupportNormal, normals, hulls->Support.Place + lane, out x, out y);
        WideMask before = facing < (x * mx) + (y * my);
        contact.SupportIsHigh = ~before;
        FeaturePoints.Read(&points.Support, vertices, hulls->Support.Place + lane, out x, out y);
        contact.See(placement, x, y, out contact.NearX, out contact.NearY);
        FeaturePoints.Read(&points.Before, vertices, hulls->Before.Place + lane, out mx, out my);
        FeaturePoints.Read(&points.After, vertices, hulls->After.Place + lane, out x, out y);
        contact.See(placement, Wide.Select(before, mx, x), Wide.Select(before, my, y), out contact.FarX, out contact.FarY);
        contact.NearName = Wide.Load((float*)hulls->Support.Name + lane);
        contact.FarName = Wide.Select(before, Wide.Load((float*)hulls->Before.Name + lane), Wide.Load((float*)hulls->After.Name + lane));
        contact.EdgeName = Wide.Load((float*)hulls->Edge.Name + lane);
        contact.EndName = Wide.Load((float*)hulls->End.Name + lane);

        Wide radiusA = HullSides.Radius(&pairs->A, lane);
        Wide radiusB = HullSides.Radius(&pairs->B, lane);
        contact.Radius = Wide.Select(flipped, radiusB, radiusA);
        contact.Sum = contact.Radius + Wide.Select(flipped, radiusA, radiusB);
        contact.Margin = Wide.Load(pairs->Margin + lane);
        contact.Scale = Wide.Min(Wide.Load(pairs->A.Extent + lane), Wide.Load(pairs->B.Extent + lane));
        contact.Flipped = flipped;
        WideMask active = WideLanes.Has(Wide.Load((float*)hulls->Active + lane), -1);
        contact.Build(active, out WideManifold manifold);
        Write(pairs, lane, active, flipped, manifold);
    }

    /// <summary>
    /// Turns the manifold from the reference hull's frame to world axes about A's centre, its normal leading from A to B.
    /// </summary>
    private static void Write(PairLanes* pairs, int lane, WideMask active, WideMask flipped, in WideManifold manifold)
    {
        WidePlacement frame;
        frame.Cos = Wide.Select(flipped, Wide.Load(pairs->Hulls.B.Cos + lane), Wide.Load(pairs->Hulls.A.Cos + lane));
        frame.Sin = Wide.Select(flipped, Wide.Load(pairs->Hulls.B.Sin + lane), Wide.Load(pairs->Hulls.A.Sin + lane));
        frame.X = Wide.Keep(flipped, Wide.Load(pairs->OffsetX + lane));
        frame.Y = Wide.Keep(flipped, Wide.Load(pairs->OffsetY + lane));
        Wide nx = (frame.Cos * manifold.NormalX) - (frame.Sin * manifold.NormalY);
        Wide ny = (frame.Sin * manifold.NormalX) + (frame.Cos * manifold.NormalY);
        WideLanes.Replace(active, Wide.Select(flipped, Wide.Zero - nx, nx), pairs->NormalX + lane);
        WideLanes.Replace(active, Wide.Select(flipped, Wide.Zero - ny, ny), pairs->NormalY + lane);
        WideLanes.Replace(active, manifold.Count, pairs->Count + lane);
        Wide other = Wide.Select(flipped, Wide.Zero - Wide.One, Wide.One);
        WideLanes.Replace(active, Wide.Zero - (other * manifold.Owned), pairs->NormalOwner + lane);
        Write(&pairs->Point0, lane, active, frame, other, manifold.Point0);
        Write(&pairs->Point1, lane, active, frame, other, manifold.Point1);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Write(PointLanes* point, int lane, WideMask active, in WidePlacement frame, Wide other, in WideManifoldPoint source)
    {
        frame.Apply(source.X, source.Y, out Wide x, out Wide y);
        WideLanes.Replace(active, x, point->X + lane);
        WideLanes.Replace(active, y, point->Y + lane);
        WideLanes.Replace(active, source.Separation, point->Separation + lane);
        WideLanes.Replace(active, source.Name, (float*)point->Id + lane);
        WideLanes.Replace(active, other * source.Owner, point->Owner + lane);
    }
}
