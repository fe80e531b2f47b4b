using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.Accuracy;

/// <summary>Looks at a pair at the present poses, not at those of the step's narrow phase.</summary>
internal static unsafe class ContactProbe
{
    /// <summary>Points are found up to this share of the smaller piece apart.</summary>
    private const float Margin = 0.02f;

    public static void Collide(BodyStore bodies, ShapeStore shapes, in ContactRecord record, out Manifold manifold)
    {
        ref BodyPose a = ref bodies.Pose[record.BodyA];
        ref BodyPose b = ref bodies.Pose[record.BodyB];
        PairInput pair;
        pair.Vertices = shapes.Vertices.Pointer;
        pair.Normals = shapes.Normals.Pointer;
        pair.OutlineBefore = shapes.OutlineBefore.Pointer;
        pair.OutlineAfter = shapes.OutlineAfter.Pointer;
        pair.PieceA = shapes.Pieces.Pointer + record.PieceA;
        pair.PieceB = shapes.Pieces.Pointer + record.PieceB;
        pair.RotationA = new Rotation(a.Cos, a.Sin);
        pair.RotationB = new Rotation(b.Cos, b.Sin);
        pair.Offset = new Vector2((float)(b.X - a.X), (float)(b.Y - a.Y));
        pair.Margin = Margin * Math.Min(pair.PieceA->Extent, pair.PieceB->Extent);
        Collision.Collide(pair, out manifold);
    }
}
