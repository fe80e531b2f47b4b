using System.Numerics;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>
/// Contact of any two pieces with at least two vertices. For convex hulls the axis of greatest separation among the edge
/// normals belongs to an edge of their Minkowski difference next to its nearest point, so the nearest features are always
/// that edge and the other hull's support vertex (or an end of the edge): no iterative distance search is needed.
/// </summary>
internal static unsafe class ConvexConvex
{
    /// <summary>
    /// B's axis must be better than A's by this share of the smaller piece's extent. Where faces are almost parallel both
    /// serve equally well, and a normal that jumps between them from step to step would cost the stack its rest.
    /// </summary>
    public const float ReferenceBias = 0.001f;

    /// <summary>
    /// Overlap of a seamed piece, in extents, from which on a contact must come of it even without an outline edge in reach.
    /// </summary>
    private const float SeamlessDepth = 0.04f;

    public static void Collide(in PairInput pair, out Manifold manifold)
    {
        manifold = default;
        var a = new Hull(pair, pair.A);
        var b = new Hull(pair, pair.B);
        Placement bInA;
        bInA.Rotation = pair.RotationB.RelativeTo(pair.RotationA);
        bInA.Offset = pair.RotationA.InverseRotate(pair.Offset);
        float limit = pair.Margin + a.Radius + b.Radius;
        AxisQuery fromA = AxisQuery.Find(a, b, bInA, pair.B.Center);
        if (fromA.Greatest > limit)
        {
            return;
        }

        Placement aInB;
        aInB.Rotation = new Rotation(bInA.Rotation.Cos, -bInA.Rotation.Sin);
        aInB.Offset = pair.RotationB.InverseRotate(-pair.Offset);
        AxisQuery fromB = AxisQuery.Find(b, a, aInB, pair.A.Center);
        if (fromB.Greatest > limit)
        {
            return;
        }

        float scale = pair.A.Extent < pair.B.Extent ? pair.A.Extent : pair.B.Extent;

        // An axis is refused where the neighbour over a seam makes the contact. The axes left over may all lead the long way
        // out, through the whole piece: then the short way serves, though the neighbour goes it as well.
        float admitted = fromA.Separation > fromB.Separation ? fromA.Separation : fromB.Separation;
        float real = fromA.RealSeparation > fromB.RealSeparation ? fromA.RealSeparation : fromB.RealSeparation;
        bool seamed = ((pair.A.Flags | pair.B.Flags) & PieceFlags.Seamed) != 0;
        if (seamed ? admitted < real - (SeamlessDepth * scale) : fromA.Edge < 0 && fromB.Edge < 0)
        {
            TakeReal(ref fromA);
            TakeReal(ref fromB);
        }

        if (fromA.Edge >= 0 && (fromB.Edge < 0 || !(fromB.Separation > fromA.Separation + (ReferenceBias * scale))))
        {
            EdgeContact.Build(a, b, bInA, fromA, pair.Margin, scale, ref manifold, flipped: false);
            ToWorld(ref manifold, pair.RotationA, Vector2.Zero);
        }
        else if (fromB.Edge >= 0)
        {
            EdgeContact.Build(b, a, aInB, fromB, pair.Margin, scale, ref manifold, flipped: true);
            manifold.Normal = -manifold.Normal;
            ToWorld(ref manifold, pair.RotationB, pair.Offset);
        }

        if (manifold.Count == 0 && seamed)
        {
            float depth = -SeamlessDepth * scale;
            if (fromA.Greatest < depth && fromB.Greatest < depth)
            {
                PushOut(pair, fromA, fromB, ref manifold);
            }
        }
    }

    // Deep inside, the overlap need not lie under any outline edge that the seams leave over; still the piece must let go of
    // the intruder, so the support vertex is pushed out of the outline edge that it is least far behind.
    private static void PushOut(in PairInput pair, AxisQuery fromA, AxisQuery fromB, ref Manifold manifold)
    {
        bool flipped = fromB.RealSeparation > fromA.RealSeparation;
        AxisQuery axis = flipped ? fromB : fromA;
        if (axis.RealEdge < 0)
        {
            return;
        }

        Rotation own = flipped ? pair.RotationB : pair.RotationA;
        Rotation others = flipped ? pair.RotationA : pair.RotationB;
        Piece reference = flipped ? pair.B : pair.A;
        Piece other = flipped ? pair.A : pair.B;
        Vector2 normal = own.Rotate(pair.Normals[reference.VertexStart + axis.RealEdge]);
        Vector2 support = others.Rotate(pair.Vertices[other.VertexStart + axis.RealSupport]) + (flipped ? Vector2.Zero : pair.Offset);
        float separation = axis.RealSeparation - reference.Radius - other.Radius;
        manifold.Normal = flipped ? -normal : normal;
        manifold.Count = 1;
        manifold.Point0.Anchor = support - (normal * (other.Radius + (0.5f * separation)));
        manifold.Point0.Separation = separation;
        manifold.Point0.Id = EdgeContact.Id(axis.RealEdge, axis.RealSupport, flipped);
    }

    private static void TakeReal(ref AxisQuery query)
    {
        query.Edge = query.RealEdge;
        query.Support = query.RealSupport;
        query.Separation = query.RealSeparation;
    }

    public static void ToWorld(ref Manifold manifold, Rotation rotation, Vector2 origin)
    {
        manifold.Normal = rotation.Rotate(manifold.Normal);
        manifold.Point0.Anchor = rotation.Rotate(manifold.Point0.Anchor) + origin;
        if (manifold.Count == 2)
        {
            manifold.Point1.Anchor = rotation.Rotate(manifold.Point1.Anchor) + origin;
        }
    }
}
