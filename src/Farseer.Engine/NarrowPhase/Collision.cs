using System.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>The pair table: which routine finds the contact of two kinds of pieces.</summary>
internal static unsafe class Collision
{
    /// <summary>Finds the contact of two pieces: at most two points, none farther apart than the margin.</summary>
    public static void Collide(in PairInput pair, out Manifold manifold)
    {
        if (((pair.A.Flags | pair.B.Flags) & PieceFlags.OneSided) != 0)
        {
            CollideLink(pair, out manifold);
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

    // A circle is behind a link if its centre is.
    private static void CollideLink(in PairInput pair, out Manifold manifold)
    {
        manifold = default;
        if (pair.A.Kind == ShapeKind.Circle)
        {
            if (!IsBehind(pair, pair.B, pair.RotationB.InverseRotate(pair.RotationA.Rotate(pair.A.Center) - pair.Offset)))
            {
                CirclePairs.CircleHull(pair, out manifold);
            }
        }
        else if (pair.B.Kind == ShapeKind.Circle)
        {
            if (!IsBehind(pair, pair.A, pair.RotationA.InverseRotate(pair.RotationB.Rotate(pair.B.Center) + pair.Offset)))
            {
                CirclePairs.HullCircle(pair, out manifold);
            }
        }
        else
        {
            LinkContact.Collide(pair, out manifold);
        }
    }

    private static bool IsBehind(in PairInput pair, in Piece link, Vector2 center) =>
        Vector2.Dot(pair.Normals[link.VertexStart], center - pair.Vertices[link.VertexStart]) < 0;
}
