using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Contacts;

/// <summary>Finds the manifolds of the pairs that the kernel of boxes leaves: circles, hulls, and boxes that meet at corners.</summary>
internal static unsafe class OtherManifolds
{
    /// <summary>Finds the manifolds of some lanes.</summary>
    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="row">Names the pairs.</param>
    /// <param name="bits">What the sides are.</param>
    /// <param name="left">The lanes, a bit each.</param>
    public static void Collide(in ContactUpdateInput input, ContactBundle* row, in PairBits bits, int left)
    {
        int hulls = bits.Hulls & left;
        if ((bits.Circles & left) != 0)
        {
            WideCircleCircle.Collide(input.Pairs);
            left &= ~bits.Circles;
        }

        if (hulls != 0)
        {
            NameHulls(input, row, &input.Pairs->Hulls.A, hulls, 0, bits.Tilted);
            NameHulls(input, row, &input.Pairs->Hulls.B, hulls, hulls, bits.Tilted);
            WideConvex.Collide(input.Pairs, hulls, input.Shapes.Vertices.Pointer, input.Shapes.Normals.Pointer);
            left &= ~hulls;
        }

        int circleHulls = bits.CircleHulls & left;
        if (circleHulls != 0)
        {
            NameHulls(input, row, &input.Pairs->Hulls.A, circleHulls, bits.CircleFirst, bits.Tilted);
            WideCircleHull.Collide(
                input.Pairs, circleHulls, bits.CircleFirst, input.Shapes.Vertices.Pointer, input.Shapes.Normals.Pointer);
            left &= ~circleHulls;
        }

        for (int lane = 0; left != 0; lane++, left >>= 1)
        {
            if ((left & 1) != 0)
            {
                CollideLane(input, row, lane);
            }
        }
    }

    /// <summary>Names the hulls of some lanes: those of B where a bit of <paramref name="ofB"/> is set, elsewhere those of A.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    private static void NameHulls(in ContactUpdateInput input, ContactBundle* row, HullLanes* hulls, int lanes, int ofB, int tilted)
    {
        PairLanes* pairs = input.Pairs;
        int* pieces = stackalloc int[ContactBundle.Lanes];
        for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
        {
            WideMask b = WideLanes.Mask(ofB >> lane);
            Wide.Select(b, Wide.Load((float*)row->PieceB + lane), Wide.Load((float*)row->PieceA + lane)).Store((float*)pieces + lane);
            Wide.Select(b, Wide.Load(pairs->B.Cos + lane), Wide.Load(pairs->A.Cos + lane)).Store(hulls->Cos + lane);
            Wide.Select(b, Wide.Load(pairs->B.Sin + lane), Wide.Load(pairs->A.Sin + lane)).Store(hulls->Sin + lane);
        }

        HullSides.Name(hulls, lanes, pieces, input.Hulls);

        // The side of a box has the box's own axis, a hull turns with its body.
        tilted &= lanes;
        for (int lane = 0; tilted != 0; lane++, tilted >>= 1)
        {
            if ((tilted & 1) != 0)
            {
                BodyPose* pose = input.Bodies.Pose.Pointer + (((ofB >> lane) & 1) != 0 ? row->BodyB[lane] : row->BodyA[lane]);
                hulls->Cos[lane] = pose->Cos;
                hulls->Sin[lane] = pose->Sin;
            }
        }
    }

    private static void CollideLane(in ContactUpdateInput input, ContactBundle* row, int lane)
    {
        PairInput pair;
        pair.Vertices = input.Shapes.Vertices.Pointer;
        pair.Normals = input.Shapes.Normals.Pointer;
        pair.OutlineBefore = input.Shapes.OutlineBefore.Pointer;
        pair.OutlineAfter = input.Shapes.OutlineAfter.Pointer;
        pair.PieceA = input.Shapes.Pieces.Pointer + row->PieceA[lane];
        pair.PieceB = input.Shapes.Pieces.Pointer + row->PieceB[lane];
        BodyPose* poseA = input.Bodies.Pose.Pointer + row->BodyA[lane];
        BodyPose* poseB = input.Bodies.Pose.Pointer + row->BodyB[lane];
        pair.RotationA = new Rotation(poseA->Cos, poseA->Sin);
        pair.RotationB = new Rotation(poseB->Cos, poseB->Sin);
        pair.Offset = new Vector2(input.Pairs->OffsetX[lane], input.Pairs->OffsetY[lane]);
        pair.Margin = input.Pairs->Margin[lane];
        Collision.Collide(pair, out Manifold manifold);
        PairLanes.Write(input.Pairs, lane, manifold);
    }
}
