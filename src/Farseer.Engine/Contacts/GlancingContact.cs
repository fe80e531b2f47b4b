using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.Contacts;

/// <summary>
/// A body that comes to a piece that cannot move is shown its side, or a corner with a slanting normal, as these are when the step
/// begins, and would be stopped or thrown up by what it passes over. Such a contact is refuted by the piece's own face: if the body
/// stays above that face throughout the step, and moves along it rather than into it, it flies over. And it is hidden where other
/// pieces carry the body past that side: see <see cref="HiddenContact"/>. Asked once for each new row.
/// </summary>
internal static unsafe class GlancingContact
{
    /// <summary>
    /// A face that differs from the contact's normal by less than this (sine) is the contact's own: above rounding, and below the
    /// slant of a corner that a circle's centre has all but reached.
    /// </summary>
    private const float SameNormal = 1e-5f;

    /// <summary>Faces nearer to each other than this (cosine) belong to a bend, not to a corner.</summary>
    private const float Corner = 0.5f;

    /// <summary>Takes the points of the lanes whose contact is refuted.</summary>
    public static void Drop(in ContactUpdateInput input, ContactBundle* row, int lanes, ref TouchBits touch)
    {
        PairLanes* pairs = input.Pairs;
        for (int lane = 0; lanes != 0; lane++, lanes >>= 1)
        {
            bool movesA = (pairs->A.Flags[lane] & (int)SideFlags.Moves) != 0;
            bool movesB = (pairs->B.Flags[lane] & (int)SideFlags.Moves) != 0;
            if ((lanes & 1) != 0 && movesA != movesB && (IsRefuted(input, row, lane, movesA) || IsHidden(input, row, lane, movesA)))
            {
                int bit = 1 << lane;
                touch.Hit &= ~bit;
                touch.Touching &= ~bit;
                touch.Same &= ~bit;
            }
        }
    }

    private static bool IsHidden(in ContactUpdateInput input, ContactBundle* row, int lane, bool movesA)
    {
        // A body that became static within the step is another side's pair until the next.
        if (input.Contacts.Records[row->Contact[lane]].Mover != (movesA ? row->PieceA[lane] : row->PieceB[lane]))
        {
            return false;
        }

        SeamInput seam;
        seam.Shapes = input.Shapes;
        seam.Bodies = input.Bodies;
        seam.Contacts = input.Contacts;
        seam.Ahead = 0;
        ref BodyPose pose = ref input.Bodies.Pose[movesA ? row->BodyA[lane] : row->BodyB[lane]];
        return HiddenContact.Is(seam, row->Contact[lane], PairLanes.Read(input.Pairs, lane), pose);
    }

    private static bool IsRefuted(in ContactUpdateInput input, ContactBundle* row, int lane, bool movesA)
    {
        PairLanes* pairs = input.Pairs;
        SideLanes* own = movesA ? &pairs->A : &pairs->B;
        SideLanes* other = movesA ? &pairs->B : &pairs->A;
        var velocity = new Vector2(own->VelocityX[lane] - other->VelocityX[lane], own->VelocityY[lane] - other->VelocityY[lane]);
        if (velocity == Vector2.Zero)
        {
            return false;
        }

        ref Piece mover = ref input.Shapes.Pieces[movesA ? row->PieceA[lane] : row->PieceB[lane]];
        ref Piece tile = ref input.Shapes.Pieces[movesA ? row->PieceB[lane] : row->PieceA[lane]];
        BodyPose moverPose = input.Bodies.Pose[movesA ? row->BodyA[lane] : row->BodyB[lane]];
        BodyPose tilePose = input.Bodies.Pose[movesA ? row->BodyB[lane] : row->BodyA[lane]];
        var turn = new Rotation(tilePose.Cos, tilePose.Sin);
        Rotation relative = new Rotation(moverPose.Cos, moverPose.Sin).RelativeTo(turn);
        Vector2 offset = turn.InverseRotate(new Vector2((float)(moverPose.X - tilePose.X), (float)(moverPose.Y - tilePose.Y)));
        velocity = turn.InverseRotate(velocity);
        Vector2 push = turn.InverseRotate(new Vector2(pairs->NormalX[lane], pairs->NormalY[lane])) * (movesA ? -1 : 1);
        float rounding = (float)FastPairs.Tolerance(Math.Min(mover.Extent, tile.Extent));
        float swing = Math.Abs(own->AngularVelocity[lane]) * (mover.Reach - mover.Radius);
        bool onFace = IsFace(input.Shapes, tile, push);
        Vector2* normals = input.Shapes.Normals.Pointer + tile.VertexStart;
        Vector2* outline = input.Shapes.OutlineAfter.Pointer + tile.VertexStart;
        Vector2* vertices = input.Shapes.Vertices.Pointer + tile.VertexStart;
        for (int i = 0; i < tile.VertexCount && tile.VertexCount > 1; i++)
        {
            Vector2 face = normals[i];
            float alike = Vector2.Dot(face, push);
            if ((onFace ? alike > Corner : IsSame(face, push)) || (tile.Flags != PieceFlags.None && outline[i] != face))
            {
                continue;
            }

            float into = Math.Max(0, swing - Vector2.Dot(velocity, face));
            float along = Math.Abs(OutlineCone.Cross(face, velocity));
            if (!(along > into) || !(Vector2.Dot(velocity, (face * alike) - push) > 0))
            {
                continue;
            }

            float depth = Vector2.Dot(face, vertices[i] - offset) - Lowest(input.Shapes, mover, relative.InverseRotate(face));
            if (depth + mover.Radius + tile.Radius + (into * input.Dt) <= rounding)
            {
                return true;
            }
        }

        return false;
    }

    private static bool IsFace(ShapeStore shapes, in Piece tile, Vector2 push)
    {
        Vector2* normals = shapes.Normals.Pointer + tile.VertexStart;
        for (int i = 0; i < tile.VertexCount && tile.VertexCount > 1; i++)
        {
            if (IsSame(normals[i], push))
            {
                return true;
            }
        }

        return false;
    }

    private static bool IsSame(Vector2 face, Vector2 push) =>
        Vector2.Dot(face, push) > 0 && Math.Abs(OutlineCone.Cross(face, push)) < SameNormal;

    private static float Lowest(ShapeStore shapes, in Piece piece, Vector2 direction)
    {
        Vector2* v = shapes.Vertices.Pointer + piece.VertexStart;
        float lowest = Vector2.Dot(direction, v[0]);
        for (int i = 1; i < piece.VertexCount; i++)
        {
            lowest = Math.Min(lowest, Vector2.Dot(direction, v[i]));
        }

        return lowest;
    }
}
