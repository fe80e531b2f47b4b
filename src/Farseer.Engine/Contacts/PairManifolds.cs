using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Contacts;

/// <summary>Finds the manifolds of the pairs of a bundle, each by the kernel that its pieces need.</summary>
internal static unsafe class PairManifolds
{
    /// <summary>Keeps points as far apart as the blows of this step may throw the bodies of each pair.</summary>
    public static void Widen(in ContactUpdateInput input, ContactBundle* row)
    {
        if (input.Throws == null)
        {
            return;
        }

        for (int lane = 0; lane < PairLanes.Lanes; lane++)
        {
            if (row->Contact[lane] >= 0)
            {
                input.Pairs->Margin[lane] += input.Throws[row->BodyA[lane]] + input.Throws[row->BodyB[lane]];
            }
        }
    }

    /// <summary>Finds the manifolds of all lanes.</summary>
    public static void Collide(in ContactUpdateInput input, ContactBundle* row, in PairBits bits)
    {
        int left = bits.Exists;
        if ((bits.Boxes & left) != 0)
        {
            int corners = WideBoxBox.Collide(input.Pairs);
            left &= ~bits.Boxes | corners;
        }

        CollideOthers(input, row, bits, left);
    }

    /// <summary>Finds the manifolds of the lanes that the kernel of boxes has left.</summary>
    public static void CollideOthers(in ContactUpdateInput input, ContactBundle* row, in PairBits bits, int left)
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

    /// <summary>
    /// Whether a pair with points, whose arms <see cref="PairStage.Touch"/> has found, overlaps or will within <paramref name="time"/>.
    /// </summary>
    public static bool WillTouch(in ContactUpdateInput input, int lane, float reach, float time)
    {
        PairLanes* pairs = input.Pairs;
        Vector2 n = new Vector2(pairs->NormalX[lane], pairs->NormalY[lane]);
        Vector2 pull = Vector2.Zero;
        pull += (pairs->B.Flags[lane] & (int)SideFlags.Pulled) != 0 ? input.Settings.Gravity : Vector2.Zero;
        pull -= (pairs->A.Flags[lane] & (int)SideFlags.Pulled) != 0 ? input.Settings.Gravity : Vector2.Zero;
        float speed = ((pairs->B.VelocityX[lane] - pairs->A.VelocityX[lane]) * n.X)
            + ((pairs->B.VelocityY[lane] - pairs->A.VelocityY[lane]) * n.Y)
            + (System.Math.Min(0, (pull.X * n.X) + (pull.Y * n.Y)) * time);
        return WillTouch(pairs, &pairs->Point0, lane, speed, reach, time)
            || (pairs->Count[lane] > 1 && WillTouch(pairs, &pairs->Point1, lane, speed, reach, time));
    }

    private static bool WillTouch(PairLanes* pairs, PointLanes* point, int lane, float speed, float reach, float time)
    {
        float closing = speed + (pairs->B.AngularVelocity[lane] * point->TangentArmB[lane])
            - (pairs->A.AngularVelocity[lane] * point->TangentArmA[lane]);
        return point->Separation[lane] <= reach || point->Separation[lane] + (closing * time) <= 0;
    }

    /// <summary>Names the hulls of some lanes: those of B where a bit of <paramref name="ofB"/> is set, elsewhere those of A.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    private static void NameHulls(in ContactUpdateInput input, ContactBundle* row, HullLanes* hulls, int lanes, int ofB, int tilted)
    {
        PairLanes* pairs = input.Pairs;
        int* pieces = stackalloc int[PairLanes.Lanes];
        for (int lane = 0; lane < PairLanes.Lanes; lane += Wide.Count)
        {
            WideMask b = WideLanes.Mask(ofB >> lane);
            Wide.Select(b, Wide.Load((float*)row->PieceB + lane), Wide.Load((float*)row->PieceA + lane)).Store((float*)pieces + lane);
            Wide.Select(b, Wide.Load(pairs->B.Cos + lane), Wide.Load(pairs->A.Cos + lane)).Store(hulls->Cos + lane);
            Wide.Select(b, Wide.Load(pairs->B.Sin + lane), Wide.Load(pairs->A.Sin + lane)).Store(hulls->Sin + lane);
        }

        HullLanes.Name(hulls, lanes, pieces, input.Hulls);

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
