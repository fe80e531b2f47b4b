using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.Queries;

/// <summary>Questions about a world point and one collider. A point on the border is inside.</summary>
internal static class PointQuery
{
    /// <summary>True if the point lies in or on the collider; lines (segments, chains) contain nothing.</summary>
    public static bool Contains(ShapeStore shapes, int collider, in BodyPose pose, double x, double y)
    {
        ToLocal(pose, x, y, out double localX, out double localY);
        ref ColliderInfo info = ref shapes.Colliders[collider];
        int piece = info.FirstPiece;
        for (int i = 0; i < info.PieceCount; i++, piece = shapes.NextPiece[piece])
        {
            if (Distance.IsInCore(shapes, piece, localX, localY))
            {
                return true;
            }

            double radius = shapes.Pieces[piece].Radius;
            if (radius > 0 && Distance.ToOutline(shapes, piece, localX, localY, seamsToo: true) <= radius)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Distance of the point from the collider's outline, seams between its pieces not counted; negative inside.</summary>
    public static double SignedDistance(ShapeStore shapes, int collider, in BodyPose pose, double x, double y)
    {
        ToLocal(pose, x, y, out double localX, out double localY);
        ref ColliderInfo info = ref shapes.Colliders[collider];
        int piece = info.FirstPiece;
        double nearest = double.PositiveInfinity;
        bool inside = false;
        double radius = 0;
        for (int i = 0; i < info.PieceCount; i++, piece = shapes.NextPiece[piece])
        {
            radius = shapes.Pieces[piece].Radius;
            inside |= Distance.IsInCore(shapes, piece, localX, localY);
            nearest = Math.Min(nearest, Distance.ToOutline(shapes, piece, localX, localY, seamsToo: false));
        }

        return (inside ? -nearest : nearest) - radius;
    }

    /// <summary>The point of the collider's outline that is nearest to a world point, and the signed distance from it.</summary>
    public static NearHit Nearest(ShapeStore shapes, int collider, in BodyPose pose, double x, double y)
    {
        ToLocal(pose, x, y, out double localX, out double localY);
        ref ColliderInfo info = ref shapes.Colliders[collider];
        int piece = info.FirstPiece;
        double square = double.PositiveInfinity;
        bool inside = false;
        OutlinePoint nearest = default;
        for (int i = 0; i < info.PieceCount; i++, piece = shapes.NextPiece[piece])
        {
            inside |= Distance.IsInCore(shapes, piece, localX, localY);
            Distance.Nearest(shapes, piece, localX, localY, ref square, ref nearest);
        }

        double distance = Math.Sqrt(square);
        double radius = shapes.Pieces[info.FirstPiece].Radius;
        double outX = nearest.NormalX;
        double outY = nearest.NormalY;
        if (distance > 0)
        {
            double scale = (inside ? -1 : 1) / distance;
            outX = (localX - nearest.X) * scale;
            outY = (localY - nearest.Y) * scale;
        }

        double pointX = nearest.X + (outX * radius);
        double pointY = nearest.Y + (outY * radius);
        return new NearHit
        {
            Collider = collider,
            Distance = (inside ? -distance : distance) - radius,
            X = pose.X + (pose.Cos * pointX) - (pose.Sin * pointY),
            Y = pose.Y + (pose.Sin * pointX) + (pose.Cos * pointY),
        };
    }

    private static void ToLocal(in BodyPose pose, double x, double y, out double localX, out double localY)
    {
        double dx = x - pose.X;
        double dy = y - pose.Y;

        // The rotor is unit only to float rounding; dividing by its square makes this the exact inverse of the pose.
        double square = ((double)pose.Cos * pose.Cos) + ((double)pose.Sin * pose.Sin);
        localX = ((pose.Cos * dx) + (pose.Sin * dy)) / square;
        localY = ((pose.Cos * dy) - (pose.Sin * dx)) / square;
    }
}
