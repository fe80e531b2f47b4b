using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Accuracy;

/// <summary>
/// Depth of the overlap of two convex polygons: the shortest way that parts them, by the axes of all edges, in double precision.
/// A manifold tells less: between slanted ends its deepest point is the deepest of those that lie across from the other's face.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class PolygonDepth
{
    /// <summary>Most vertices of a piece that are looked at.</summary>
    private const int Most = 64;

    private readonly double[] _a = new double[2 * Most];
    private readonly double[] _b = new double[2 * Most];

    /// <summary>Plain polygons only: the ends of rounded pieces and the seams of composed outlines follow other laws.</summary>
    public static bool Applies(in Piece a, in Piece b) => IsPlain(a) && IsPlain(b);

    /// <summary>0 if an axis parts them.</summary>
    public double Measure(ShapeStore shapes, BodyStore bodies, in Piece a, in Piece b)
    {
        ref BodyPose origin = ref bodies.Pose[a.Body];
        Place(shapes, a, bodies.Pose[a.Body], origin, _a);
        Place(shapes, b, bodies.Pose[b.Body], origin, _b);
        double least = Math.Min(Least(_a, a.VertexCount, _b, b.VertexCount), Least(_b, b.VertexCount, _a, a.VertexCount));
        return Math.Max(0, least);
    }

    private static bool IsPlain(in Piece piece) =>
        piece.Radius == 0 && piece.Flags == PieceFlags.None && piece.VertexCount >= 3 && piece.VertexCount <= Most;

    private static void Place(ShapeStore shapes, in Piece piece, in BodyPose pose, in BodyPose origin, double[] target)
    {
        StableMath.SinCos(pose.Angle, out double sin, out double cos);
        double x = pose.X - origin.X;
        double y = pose.Y - origin.Y;
        for (int i = 0; i < piece.VertexCount; i++)
        {
            ref System.Numerics.Vector2 v = ref shapes.Vertices[piece.VertexStart + i];
            target[2 * i] = x + (cos * v.X) - (sin * v.Y);
            target[(2 * i) + 1] = y + (sin * v.X) + (cos * v.Y);
        }
    }

    /// <summary>Over the edges of the first: how far the second reaches inside.</summary>
    private static double Least(double[] a, int countA, double[] b, int countB)
    {
        double least = double.MaxValue;
        for (int i = 0; i < countA; i++)
        {
            int next = i + 1 < countA ? i + 1 : 0;
            double ex = a[2 * next] - a[2 * i];
            double ey = a[(2 * next) + 1] - a[(2 * i) + 1];
            double length = Math.Sqrt((ex * ex) + (ey * ey));
            if (!(length > 0))
            {
                continue;
            }

            double deepest = double.MinValue;
            for (int k = 0; k < countB; k++)
            {
                double along = ((a[2 * i] - b[2 * k]) * ey) - ((a[(2 * i) + 1] - b[(2 * k) + 1]) * ex);
                deepest = Math.Max(deepest, along / length);
            }

            least = Math.Min(least, deepest);
        }

        return least;
    }
}
