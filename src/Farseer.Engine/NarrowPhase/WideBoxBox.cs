using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary><see cref="BoxBox"/> on lanes: the same formulas in the same order, every branch a selection, so the same bits.</summary>
internal static unsafe class WideBoxBox
{
    /// <summary>Writes the manifolds of all lanes as if each were a pair of boxes.</summary>
    /// <returns>Lanes (a bit each) that are near, but not face against face: what is written there does not count.</returns>
    public static int Collide(PairLanes* pairs)
    {
        int corners = 0;
        for (int lane = 0; lane < WideLanes.BundleLanes; lane += Wide.Count)
        {
            corners |= WideLanes.Bits(Collide(pairs, lane)) << lane;
        }

        return corners;
    }

    /// <summary>The separating axis: which box is the reference, which of its axes, and how the other lies towards it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void FindAxis(PairLanes* pairs, int lane, out Reference reference)
    {
        SideLanes* a = &pairs->A;
        SideLanes* b = &pairs->B;
        Wide aCos = Wide.Load(a->Cos + lane);
        Wide aSin = Wide.Load(a->Sin + lane);
        Wide bCos = Wide.Load(b->Cos + lane);
        Wide bSin = Wide.Load(b->Sin + lane);
        Wide bX = Wide.Load(b->X + lane) + Wide.Load(pairs->OffsetX + lane);
        Wide bY = Wide.Load(b->Y + lane) + Wide.Load(pairs->OffsetY + lane);
        Wide offX = bX - Wide.Load(a->X + lane);
        Wide offY = bY - Wide.Load(a->Y + lane);
        Wide cos = (aCos * bCos) + (aSin * bSin);
        Wide turn = (aCos * bSin) - (aSin * bCos);
        Wide c = Wide.Abs(cos);
        Wide s = Wide.Abs(turn);
        Wide aHalfX = Wide.Load(a->HalfX + lane);
        Wide aHalfY = Wide.Load(a->HalfY + lane);
        Wide bHalfX = Wide.Load(b->HalfX + lane);
        Wide bHalfY = Wide.Load(b->HalfY + lane);

        // Centre of B in A's frame, and of A in B's frame with the sign turned.
        Wide ax = (aCos * offX) + (aSin * offY);
        Wide ay = (aCos * offY) - (aSin * offX);
        Wide bx = (bCos * offX) + (bSin * offY);
        Wide by = (bCos * offY) - (bSin * offX);
        Wide sepAx = Wide.Abs(ax) - aHalfX - ((c * bHalfX) + (s * bHalfY));
        Wide sepAy = Wide.Abs(ay) - aHalfY - ((s * bHalfX) + (c * bHalfY));
        Wide sepBx = Wide.Abs(bx) - bHalfX - ((c * aHalfX) + (s * aHalfY));
        Wide sepBy = Wide.Abs(by) - bHalfY - ((s * aHalfX) + (c * aHalfY));
        WideMask axisAx = sepAx > sepAy;
        WideMask axisBx = sepBx > sepBy;
        Wide sepA = Wide.Select(axisAx, sepAx, sepAy);
        Wide sepB = Wide.Select(axisBx, sepBx, sepBy);
        Wide margin = Wide.Load(pairs->Margin + lane);
        reference.Near = ~((sepA > margin) | (sepB > margin));
        Wide.Max(sepA, sepB).Store(pairs->Gap + lane);
        Wide.Select(sepA > sepB, Wide.Zero - Wide.One, Wide.One).Store(pairs->GapOwner + lane);
        Wide scale = Wide.Min(Wide.Load(a->Extent + lane), Wide.Load(b->Extent + lane));
        WideMask flipped = sepB > sepA + (Wide.Splat(ConvexConvex.ReferenceBias) * scale);

        reference.Flipped = flipped;
        reference.AxisX = (flipped & axisBx) | (~flipped & axisAx);
        reference.X = Wide.Select(flipped, Wide.Zero - bx, ax);
        reference.Y = Wide.Select(flipped, Wide.Zero - by, ay);
        reference.Cos = cos;
        reference.Sin = Wide.Select(flipped, Wide.Zero - turn, turn);
    }

    [MethodImpl(KernelMethod.Optimized)]
    private static WideMask Collide(PairLanes* pairs, int lane)
    {
        FindAxis(pairs, lane, out Reference reference);
        WideMask flipped = reference.Flipped;
        WideMask axisX = reference.AxisX;
        WideMask near = reference.Near;
        Wide margin = Wide.Load(pairs->Margin + lane);
        Wide aHalfX = Wide.Load(pairs->A.HalfX + lane);
        Wide aHalfY = Wide.Load(pairs->A.HalfY + lane);
        Wide bHalfX = Wide.Load(pairs->B.HalfX + lane);
        Wide bHalfY = Wide.Load(pairs->B.HalfY + lane);
        Wide otherX = Wide.Select(flipped, aHalfX, bHalfX);
        Wide otherY = Wide.Select(flipped, aHalfY, bHalfY);
        Wide halfDepth = Wide.Select(flipped, Wide.Select(axisX, bHalfX, bHalfY), Wide.Select(axisX, aHalfX, aHalfY));
        Wide halfLength = Wide.Select(flipped, Wide.Select(axisX, bHalfY, bHalfX), Wide.Select(axisX, aHalfY, aHalfX));

        // From here on the other box is seen from the reference face: y out of it, x along it.
        Wide chosen = Wide.Select(axisX, reference.X, reference.Y);
        WideMask negative = chosen < Wide.Zero;
        Wide sign = Wide.Select(negative, Wide.Zero - Wide.One, Wide.One);
        Wide out0 = chosen * sign;
        Wide along0 = Wide.Select(axisX, reference.Y, Wide.Zero - reference.X) * sign;

        // The face normal in the other box's frame; its larger component names the face that looks back.
        Wide mx = Wide.Select(axisX, reference.Cos, reference.Sin) * sign;
        Wide my = Wide.Select(axisX, Wide.Zero - reference.Sin, reference.Cos) * sign;
        WideMask faceX = Wide.Abs(mx) > Wide.Abs(my);
        Wide main = Wide.Select(faceX, mx, my);
        Wide cross = Wide.Select(faceX, my, mx);
        Wide facing = Wide.Abs(main);
        WideMask away = main < Wide.Zero;

        // The incident normal is -facing·n + lean·t; its face runs along -facing·t - lean·n.
        Wide lean = Wide.Select(faceX ^ away, cross, Wide.Zero - cross);
        Wide depth = Wide.Select(faceX, otherX, otherY);
        Wide length = Wide.Select(faceX, otherY, otherX);
        Wide middleX = along0 + (lean * depth);
        Wide middleY = out0 - (facing * depth) - halfDepth;
        Wide highX = middleX + (facing * length);
        Wide highY = middleY + (lean * length);
        Wide lowX = middleX - (facing * length);
        Wide lowY = middleY - (lean * length);
        Wide slope = lean / facing;

        WideMask highNearer = highY < lowY;
        Wide nearX = Wide.Select(highNearer, highX, lowX);
        Wide nearY = Wide.Select(highNearer, highY, lowY);
        Wide end = Wide.Zero - halfLength;
        WideMask lowInside = lowX > end;
        WideMask highInside = highX < halfLength;
        Wide lo = Wide.Select(lowInside, lowX, end);
        Wide hi = Wide.Select(highInside, highX, halfLength);
        Wide far = Wide.Select(highNearer, lowX, highX) - nearX;
        Wide rise = Wide.Abs(highY - lowY);
        Wide gap = Wide.Select(nearX < Wide.Zero, end, halfLength) - nearX;
        WideMask aside = (nearY > Wide.Zero) & (Wide.Abs(nearX) > halfLength) & (((gap * far) - (nearY * rise)) <= Wide.Zero);
        WideMask corner = near & ((hi < lo) | aside);
        Wide yLo = Wide.Select(lowInside, lowY, lowY - ((lowX + halfLength) * slope));
        Wide yHi = Wide.Select(highInside, highY, highY + ((halfLength - highX) * slope));
        WideMask keepLo = near & (yLo <= margin);
        WideMask keepHi = near & (yHi <= margin);
        (Wide.Keep(keepLo, Wide.One) + Wide.Keep(keepHi, Wide.One)).Store(pairs->Count + lane);
        WideMask highFirst = (flipped & keepHi) | ~(flipped | keepLo);

        Frame frame;
        frame.HalfDepth = halfDepth;
        FindFrame(pairs, lane, reference, sign, out frame.NormalX, out frame.NormalY, out frame.X, out frame.Y);

        // Of boxes only: what else is in these lanes is done by others.
        WideMask boxes = ~corner & WideLanes.Has(
            Wide.Load((float*)pairs->A.Flags + lane) & Wide.Load((float*)pairs->B.Flags + lane), (int)SideFlags.Box);
        Wide referenceOwner = Wide.Keep(boxes, Wide.Select(flipped, Wide.One, Wide.Zero - Wide.One));
        Wide lowOwner = Wide.Select(lowInside, Wide.Zero - referenceOwner, referenceOwner);
        Wide highOwner = Wide.Select(highInside, Wide.Zero - referenceOwner, referenceOwner);
        referenceOwner.Store(pairs->NormalOwner + lane);
        Wide.Select(highFirst, highOwner, lowOwner).Store(pairs->Point0.Owner + lane);
        Wide.Select(highFirst, lowOwner, highOwner).Store(pairs->Point1.Owner + lane);
        WritePoint(&pairs->Point0, lane, frame, Wide.Select(highFirst, hi, lo), Wide.Select(highFirst, yHi, yLo));
        WritePoint(&pairs->Point1, lane, frame, Wide.Select(highFirst, lo, hi), Wide.Select(highFirst, yLo, yHi));

        // The reference edge is 1 or 3 (x), 2 or 0 (y); the one that looks back likewise. Numbers modulo 4, in two masks each.
        WideMask edge1 = ~(axisX ^ negative);
        WideMask incident1 = faceX ^ away;
        Wide idLo = Id(axisX, edge1, ~faceX, incident1 ^ faceX, flipped);
        Wide idHi = Id(~axisX, edge1 ^ axisX, faceX, incident1, flipped);
        Wide.Select(highFirst, idHi, idLo).Store((float*)pairs->Point0.Id + lane);
        Wide.Select(highFirst, idLo, idHi).Store((float*)pairs->Point1.Id + lane);
        return corner;
    }

    /// <summary>Normal and centre of the reference box in world axes; the manifold's normal leads from A to B.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void FindFrame(
        PairLanes* pairs, int lane, in Reference reference, Wide sign, out Wide normalX, out Wide normalY, out Wide x, out Wide y)
    {
        WideMask flipped = reference.Flipped;
        Wide cos = Wide.Select(flipped, Wide.Load(pairs->B.Cos + lane), Wide.Load(pairs->A.Cos + lane));
        Wide sin = Wide.Select(flipped, Wide.Load(pairs->B.Sin + lane), Wide.Load(pairs->A.Sin + lane));
        normalX = Wide.Select(reference.AxisX, cos, Wide.Zero - sin) * sign;
        normalY = Wide.Select(reference.AxisX, sin, cos) * sign;
        Wide.Select(flipped, Wide.Zero - normalX, normalX).Store(pairs->NormalX + lane);
        Wide.Select(flipped, Wide.Zero - normalY, normalY).Store(pairs->NormalY + lane);
        x = Wide.Select(flipped, Wide.Load(pairs->B.X + lane) + Wide.Load(pairs->OffsetX + lane), Wide.Load(pairs->A.X + lane));
        y = Wide.Select(flipped, Wide.Load(pairs->B.Y + lane) + Wide.Load(pairs->OffsetY + lane), Wide.Load(pairs->A.Y + lane));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void WritePoint(PointLanes* point, int lane, in Frame frame, Wide along, Wide separation)
    {
        Wide height = frame.HalfDepth + (Wide.Splat(0.5f) * separation);
        separation.Store(point->Separation + lane);
        ((frame.X + (frame.NormalX * height)) - (frame.NormalY * along)).Store(point->X + lane);
        ((frame.Y + (frame.NormalY * height)) + (frame.NormalX * along)).Store(point->Y + lane);
    }

    // EdgeContact.Id, (a << 16) | (b << 1) | 1 for the vertices a of A and b of B, from the bits of the vertices.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide Id(WideMask own0, WideMask own1, WideMask other0, WideMask other1, WideMask flipped)
    {
        WideMask a0 = (flipped & other0) | (~flipped & own0);
        WideMask a1 = (flipped & other1) | (~flipped & own1);
        WideMask b0 = (flipped & own0) | (~flipped & other0);
        WideMask b1 = (flipped & own1) | (~flipped & other1);
        return Wide.Keep(a0, Wide.FromBits(1 << 16)) | Wide.Keep(a1, Wide.FromBits(2 << 16))
            | Wide.Keep(b0, Wide.FromBits(1 << 1)) | Wide.Keep(b1, Wide.FromBits(2 << 1)) | Wide.FromBits(1);
    }

    /// <summary>The reference box's choice of axis, and the other box in its frame.</summary>
    private struct Reference
    {
        public WideMask Near;
        public WideMask Flipped;
        public WideMask AxisX;
        public Wide X;
        public Wide Y;
        public Wide Cos;
        public Wide Sin;
    }

    private struct Frame
    {
        public Wide NormalX;
        public Wide NormalY;
        public Wide X;
        public Wide Y;
        public Wide HalfDepth;
    }
}
