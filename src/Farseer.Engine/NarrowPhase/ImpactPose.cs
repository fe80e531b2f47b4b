using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>Two pieces as they meet on their ways.</summary>
internal static unsafe class ImpactPose
{
    public static PairInput Pair(ShapeStore shapes, int pieceA, int pieceB, in BodyPath a, in BodyPath b, double time, float margin)
    {
        PairInput pair;
        pair.Vertices = shapes.Vertices.Pointer;
        pair.Normals = shapes.Normals.Pointer;
        pair.OutlineBefore = shapes.OutlineBefore.Pointer;
        pair.OutlineAfter = shapes.OutlineAfter.Pointer;
        pair.PieceA = shapes.Pieces.Pointer + pieceA;
        pair.PieceB = shapes.Pieces.Pointer + pieceB;
        pair.RotationA = StableMath.FromAngle(a.AngleAt(time));
        pair.RotationB = StableMath.FromAngle(b.AngleAt(time));
        pair.Offset = new Vector2((float)(b.XAt(time) - a.XAt(time)), (float)(b.YAt(time) - a.YAt(time)));
        pair.Margin = margin;
        return pair;
    }
}
