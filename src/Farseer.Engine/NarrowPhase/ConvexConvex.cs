using System.Numerics;
using Farseer.Engine.Numerics;

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

        if (fromA.Edge < 0 && fromB.Edge < 0)
        {
            TakeReal(ref fromA);
            TakeReal(ref fromB);
        }

        float scale = pair.A.Extent < pair.B.Extent ? pair.A.Extent : pair.B.Extent;
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
    }

    private static void TakeReal(ref AxisQuery query)
    {
        query.Edge = query.RealEdge;
        query.Support = query.RealSupport;
        query.Separation = query.RealSeparation;
    }

    private static void ToWorld(ref Manifold manifold, Rotation rotation, Vector2 origin)
    {
        manifold.Normal = rotation.Rotate(manifold.Normal);
        manifold.Point0.Anchor = rotation.Rotate(manifold.Point0.Anchor) + origin;
        if (manifold.Count == 2)
        {
            manifold.Point1.Anchor = rotation.Rotate(manifold.Point1.Anchor) + origin;
        }
    }
}
