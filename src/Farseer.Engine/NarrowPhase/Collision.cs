using System.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>The pair table: which routine finds the contact of two kinds of pieces.</summary>
internal static unsafe class Collision
{
    /// <summary>Finds the contact of two pieces: at most two points, none farther apart than the margin.</summary>
    public static void Collide(in PairInput pair, out Manifold manifold)
    {
        if ((pair.A.Flags & PieceFlags.OneSided) != 0 && IsBehindA(pair))
        {
            manifold = default;
            return;
        }

        if ((pair.B.Flags & PieceFlags.OneSided) != 0 && IsBehindB(pair))
        {
            manifold = default;
            return;
        }

        if (pair.A.Kind == ShapeKind.Box && pair.B.Kind == ShapeKind.Box)
        {
            BoxBox.Collide(pair, out manifold);
            return;
        }

        bool circleA = pair.A.Kind == ShapeKind.Circle;
        bool circleB = pair.B.Kind == ShapeKind.Circle;
        if (circleA)
        {
            if (circleB)
            {
                CirclePairs.CircleCircle(pair, out manifold);
            }
            else
            {
                CirclePairs.CircleHull(pair, out manifold);
            }
        }
        else if (circleB)
        {
            CirclePairs.HullCircle(pair, out manifold);
        }
        else
        {
            ConvexConvex.Collide(pair, out manifold);
        }
    }

    private static bool IsBehindA(in PairInput pair)
    {
        Vector2 center = pair.RotationA.InverseRotate(pair.RotationB.Rotate(pair.B.Center) + pair.Offset);
        return IsBehind(pair, pair.A.VertexStart, center);
    }

    private static bool IsBehindB(in PairInput pair)
    {
        Vector2 center = pair.RotationB.InverseRotate(pair.RotationA.Rotate(pair.A.Center) - pair.Offset);
        return IsBehind(pair, pair.B.VertexStart, center);
    }

    private static bool IsBehind(in PairInput pair, int segment, Vector2 center) =>
        Vector2.Dot(pair.Normals[segment], center - pair.Vertices[segment]) < 0;
}
