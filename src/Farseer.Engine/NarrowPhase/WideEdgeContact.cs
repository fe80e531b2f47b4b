using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary>A point of <see cref="WideManifold"/>, as <see cref="ManifoldPoint"/>.</summary>
internal struct WideManifoldPoint
{
    public Wide X;
    public Wide Y;
    public Wide Separation;
    public Wide Name;

    /// <summary>1: a corner of the other hull; -1: of the reference; 0: of both.</summary>
    public Wide Owner;
}

/// <summary><see cref="Manifold"/> on lanes.</summary>
internal struct WideManifold
{
    public Wide NormalX;
    public Wide NormalY;
    public Wide Count;

    /// <summary>1: the normal is that of the reference edge; 0: it leads from corner to corner.</summary>
    public Wide Owned;
    public WideManifoldPoint Point0;
    public WideManifoldPoint Point1;
}

/// <summary>
/// <see cref="EdgeContact"/> on lanes, without seams: the reference edge, in its hull's frame, and the two ends of the other hull's
/// edge that faces it, seen along the reference edge (x) and out of it (y). The near end is the support vertex.
/// </summary>
internal struct WideEdgeContact
{
    /// <summary>First vertex, outward normal and last vertex of the reference edge, and the names of both.</summary>
    public Wide X;
    public Wide Y;
    public Wide NormalX;
    public Wide NormalY;
    public Wide EndX;
    public Wide EndY;
    public Wide Length;
    public Wide EdgeName;
    public Wide EndName;

    public Wide NearX;
    public Wide NearY;
    public Wide FarX;
    public Wide FarY;
    public Wide NearName;
    public Wide FarName;

    /// <summary>The near end is the one that lies farther along the reference edge.</summary>
    public WideMask SupportIsHigh;

    /// <summary>Rounding radius of the reference, and of both together.</summary>
    public Wide Radius;
    public Wide Sum;
    public Wide Margin;
    public Wide Scale;
    public WideMask Flipped;

    /// <summary>Part of a way along the reference edge.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Wide Along(Wide x, Wide y) => (y * NormalX) - (x * NormalY);

    /// <summary>A vertex of the other hull as seen from the reference edge.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void See(in WidePlacement placement, Wide x, Wide y, out Wide along, out Wide height)
    {
        placement.Apply(x, y, out x, out y);
        x = x - X;
        y = y - Y;
        along = Along(x, y);
        height = (x * NormalX) + (y * NormalY);
    }

    /// <summary>Finds the points of the lanes in <paramref name="active"/>; what the others get does not count.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Build(WideMask active, out WideManifold manifold)
    {
        Clip(out manifold);

        // Vertex against vertex: the support vertex is beyond the edge, and the edge's end is nearest to it, not to its side.
        WideMask beyond = active & (NearY > Wide.Zero) & ((NearX < Wide.Zero) | (NearX > Length));
        if (WideLanes.Any(beyond))
        {
            MeetCorner(beyond, ref manifold);
        }
    }

    /// <summary>The points of face against face, or that of a vertex over the edge.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void Clip(out WideManifold manifold)
    {
        Wide highX = Wide.Select(SupportIsHigh, NearX, FarX);
        Wide highY = Wide.Select(SupportIsHigh, NearY, FarY);
        Wide lowX = Wide.Select(SupportIsHigh, FarX, NearX);
        Wide lowY = Wide.Select(SupportIsHigh, FarY, NearY);
        Wide lo = Wide.Max(lowX, Wide.Zero);
        Wide hi = Wide.Min(highX, Length);
        WideMask single = (highX <= lowX) | (hi < lo);
        Wide slope = (highY - lowY) / (highX - lowX);
        Wide gapLo = Wide.Select(lowX > Wide.Zero, lowY, lowY - (lowX * slope)) - Sum;
        Wide gapHi = Wide.Select(highX < Length, highY, highY + ((Length - highX) * slope)) - Sum;
        Wide gapNear = NearY - Sum;
        WideMask keepLo = gapLo <= Margin;
        WideMask keepHi = gapHi <= Margin;
        Wide nameLo = EdgeName | Wide.Select(SupportIsHigh, FarName, NearName);
        Wide nameHi = EndName | Wide.Select(SupportIsHigh, NearName, FarName);
        Wide nameNear = Wide.Select(NearX + NearX < Length, EdgeName, EndName) | NearName;
        WideMask highFirst = (Flipped & keepHi) | ~(Flipped | keepLo);
        manifold.NormalX = NormalX;
        manifold.NormalY = NormalY;
        manifold.Owned = Wide.One;
        Wide minus = Wide.Zero - Wide.One;
        Wide ownerLo = Wide.Select(lowX > Wide.Zero, Wide.One, minus);
        Wide ownerHi = Wide.Select(highX < Length, Wide.One, minus);
        manifold.Count = Wide.Select(
            single, Wide.Keep(gapNear <= Margin, Wide.One), Wide.Keep(keepLo, Wide.One) + Wide.Keep(keepHi, Wide.One));
        manifold.Point0 = Point(
            Wide.Select(single, NearX, Wide.Select(highFirst, hi, lo)),
            Wide.Select(single, gapNear, Wide.Select(highFirst, gapHi, gapLo)),
            Wide.Select(single, nameNear, Wide.Select(highFirst, nameHi, nameLo)),
            Wide.Select(single, Wide.One, Wide.Select(highFirst, ownerHi, ownerLo)));
        manifold.Point1 = Point(
            Wide.Select(highFirst, lo, hi),
            Wide.Select(highFirst, gapLo, gapHi),
            Wide.Select(highFirst, nameLo, nameHi),
            Wide.Select(highFirst, ownerLo, ownerHi));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly WideManifoldPoint Point(Wide along, Wide separation, Wide name, Wide owner)
    {
        Wide height = Radius + (Wide.Splat(0.5f) * separation);
        WideManifoldPoint point;
        point.X = (X - (NormalY * along)) + (NormalX * height);
        point.Y = (Y + (NormalX * along)) + (NormalY * height);
        point.Separation = separation;
        point.Name = name;
        point.Owner = owner;
        return point;
    }

    private readonly void MeetCorner(WideMask beyond, ref WideManifold manifold)
    {
        WideMask first = NearX < Wide.Zero;
        Wide end = Wide.Select(first, Wide.Zero, Length);
        Wide lo = Wide.Max(Wide.Select(SupportIsHigh, FarX, NearX), Wide.Zero);
        Wide hi = Wide.Min(Wide.Select(SupportIsHigh, NearX, FarX), Length);
        Wide along = ((end - NearX) * (FarX - NearX)) - (NearY * (FarY - NearY));
        WideMask corner = beyond & ((along <= Wide.Zero) | (hi < lo));
        WideMask farIsNearer = (along > Wide.Zero) & (Wide.Abs(FarX - end) < Wide.Abs(NearX - end));
        Wide x = Wide.Select(farIsNearer, FarX, NearX) - end;
        Wide y = Wide.Select(farIsNearer, FarY, NearY);
        Wide distance = Wide.Sqrt((x * x) + (y * y));
        Wide armX = (NormalX * y) - (NormalY * x);
        Wide armY = (NormalX * x) + (NormalY * y);
        WideMask apart = distance > Wide.Splat(EdgeContact.ShortestArm) * Scale;
        Wide nx = Wide.Select(apart, armX / distance, NormalX);
        Wide ny = Wide.Select(apart, armY / distance, NormalY);
        Wide separation = ((armX * nx) + (armY * ny)) - Sum;
        Wide height = Radius + (Wide.Splat(0.5f) * separation);
        manifold.Owned = Wide.Keep(~corner, manifold.Owned);
        manifold.Point0.Owner = Wide.Keep(~corner, manifold.Point0.Owner);
        manifold.NormalX = Wide.Select(corner, nx, manifold.NormalX);
        manifold.NormalY = Wide.Select(corner, ny, manifold.NormalY);
        manifold.Count = Wide.Select(corner, Wide.Keep(~(distance - Sum > Margin), Wide.One), manifold.Count);
        manifold.Point0.X = Wide.Select(corner, Wide.Select(first, X, EndX) + (nx * height), manifold.Point0.X);
        manifold.Point0.Y = Wide.Select(corner, Wide.Select(first, Y, EndY) + (ny * height), manifold.Point0.Y);
        manifold.Point0.Separation = Wide.Select(corner, separation, manifold.Point0.Separation);
        manifold.Point0.Name = Wide.Select(
            corner,
            Wide.Select(first, EdgeName, EndName) | Wide.Select(farIsNearer, FarName, NearName),
            manifold.Point0.Name);
    }
}
