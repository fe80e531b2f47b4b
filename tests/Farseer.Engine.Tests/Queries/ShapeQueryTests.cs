using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Queries;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;
using Farseer.Engine.Tests.NarrowPhase;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Engine.Tests.Queries;

public class ShapeQueryTests
{
    [Fact]
    public void FindInBox_OnAnyScene_FindsEveryColliderWhoseBoxOverlaps()
    {
        ForAnyScene(scene =>
        {
            RayInput corner = scene.Ray();
            Box box = Box.FromDouble(corner.X, corner.Y, corner.X + Math.Abs(corner.DirectionX), corner.Y + Math.Abs(corner.DirectionY));
            var found = new IndexList();
            scene.World.Queries.FindInBox(box, QueryFilter.All, found);
            AssertSame(
                scene,
                found,
                collider => Pieces(scene, collider).Any(p => Box.Overlap(box, scene.World.Shapes.TightBox(p, PoseOf(scene, collider)))));
        });
    }

    [Fact]
    public void FindAtPoint_OnAnyScene_FindsEveryColliderThatContainsIt()
    {
        ForAnyScene(scene =>
        {
            RayInput at = scene.Ray();
            var found = new IndexList();
            scene.World.Queries.FindAtPoint(at.X, at.Y, QueryFilter.All, found);
            AssertSame(scene, found, c => PointQuery.Contains(scene.World.Shapes, c.Index, PoseOf(scene, c), at.X, at.Y));
        });
    }

    [Fact]
    public void FindOverlapping_OnAnyScene_FindsWhatIsNoFartherThanTheRadius()
    {
        ForAnyScene(scene =>
        {
            RayInput at = scene.Ray();
            var found = new IndexList();
            double radius = 0.7;
            scene.World.Queries.SetDisc(at.X, at.Y, radius);
            scene.World.Queries.FindOverlapping(QueryFilter.All, found);
            AssertSame(
                scene,
                found,
                c => scene.Distance(c, at.X, at.Y) <= radius,
                tie: c => Math.Abs(scene.Distance(c, at.X, at.Y) - radius) < 1e-6);
        });
    }

    [Fact]
    public void FindOverlapping_OfAnyPiece_AgreesWithTheDistanceOfHulls()
    {
        ForAnyScene(scene =>
        {
            int piece = Pieces(scene, scene.Colliders[0]).First();
            var found = new IndexList();
            scene.World.Queries.SetPiece(piece);
            scene.World.Queries.FindOverlapping(QueryFilter.All, found);
            double Gap(Handle c) => Pieces(scene, c).Min(p => HullGap(scene, piece, p, 0, 0));
            AssertSame(scene, found, c => Gap(c) <= 0, tie: c => Math.Abs(Gap(c)) < 1e-6);
        });
    }

    [Fact]
    public void FindNearest_OnAnyScene_FindsTheLeastDistanceOfAll()
    {
        ForAnyScene(scene =>
        {
            RayInput at = scene.Ray();
            double most = Math.Abs(at.DirectionX);
            Handle[] near =
                scene.Colliders.Where(c => scene.IsSeen(c, QueryFilter.All)).OrderBy(c => scene.Distance(c, at.X, at.Y)).ToArray();
            bool found = scene.World.Queries.FindNearest(at.X, at.Y, most, QueryFilter.All, out NearHit hit);
            Assert.Equal(near.Length > 0 && scene.Distance(near[0], at.X, at.Y) <= most, found);
            if (found)
            {
                double distance = scene.Distance(near[0], at.X, at.Y);
                Assert.Equal(distance, hit.Distance, 9);

                // As far away as is said, but for the scale of a pose's sine and cosine, which are floats.
                double dx = hit.X - at.X;
                double dy = hit.Y - at.Y;
                double tolerance = 4e-7 * (1 + Math.Abs(distance));
                Assert.InRange(Math.Sqrt((dx * dx) + (dy * dy)), Math.Abs(distance) - tolerance, Math.Abs(distance) + tolerance);
            }
        });
    }

    [Fact]
    public void CastShape_OfADisc_MeetsWhereTheDistanceIsItsRadius()
    {
        ForAnyScene(scene =>
        {
            const double Radius = 0.4;
            RayInput way = scene.Ray();
            double length = Math.Sqrt((way.DirectionX * way.DirectionX) + (way.DirectionY * way.DirectionY));
            double expected = scene.Colliders.Where(c => scene.IsSeen(c, QueryFilter.All))
                .Select(c => scene.March(c, way, Radius)).DefaultIfEmpty(double.PositiveInfinity).Min();
            scene.World.Queries.SetDisc(way.X, way.Y, Radius);
            bool found = scene.World.Queries.CastShape(way.DirectionX, way.DirectionY, QueryFilter.All, out RayHit hit);
            double at = found ? hit.Fraction : 1;

            // What is grazed may count or not: then the disc comes to within a hair of touching there all the same.
            double gap = scene.Colliders.Where(c => scene.IsSeen(c, QueryFilter.All))
                .Select(c => scene.Distance(c, way.X + (at * way.DirectionX), way.Y + (at * way.DirectionY)) - Radius)
                .DefaultIfEmpty(1).Min();
            if (found && !hit.StartsInside)
            {
                Assert.InRange(gap, -1e-5, 1e-5);
                Assert.True(hit.Fraction <= expected + (1e-3 / length), $"{hit.Fraction} after {expected}");
                double dx = hit.X - way.X - (at * way.DirectionX);
                double dy = hit.Y - way.Y - (at * way.DirectionY);
                Assert.Equal(Radius, Math.Sqrt((dx * dx) + (dy * dy)), 5);
            }
            else if (found)
            {
                Assert.Equal(0, expected);
            }
            else
            {
                Assert.True(gap > -1e-5 && (double.IsInfinity(expected) || expected > 1 - 1e-3));
            }
        });
    }

    [Fact]
    public void CastShape_OfAnyPiece_TouchesAtTheEndAndNotBefore()
    {
        ForAnyScene(scene =>
        {
            int piece = Pieces(scene, scene.Colliders[0]).First();
            RayInput way = scene.Ray();
            QueryFilter filter = QueryFilter.All;
            filter.IgnoredBody = scene.World.Shapes.Pieces[piece].Body;
            scene.World.Queries.SetPiece(piece);
            bool found = scene.World.Queries.CastShape(way.DirectionX, way.DirectionY, filter, out RayHit hit);
            int[] others = scene.Colliders.Where(c => scene.IsSeen(c, filter)).SelectMany(c => Pieces(scene, c)).ToArray();
            double Least(double t) =>
                others.Select(p => HullGap(scene, piece, p, t * way.DirectionX, t * way.DirectionY)).DefaultIfEmpty(1).Min();
            double end = found ? hit.Fraction : 1;
            if (found && !hit.StartsInside)
            {
                Assert.InRange(Least(end), -1e-5, 1e-5);
            }
            else if (found)
            {
                Assert.True(Least(0) <= 1e-6);
            }

            for (int k = 0; k < 10; k++)
            {
                Assert.True(hit.StartsInside || Least(end * k / 10) > -1e-6);
            }
        });
    }

    /// <summary>Signed distance of two pieces, the first moved, by brute force.</summary>
    private static double HullGap(QueryScene scene, int moved, int other, double dx, double dy)
    {
        ref Piece a = ref scene.World.Shapes.Pieces[moved];
        ref Piece b = ref scene.World.Shapes.Pieces[other];
        BodyPose poseA = scene.World.Bodies.Pose[a.Body];
        poseA.X += dx;
        poseA.Y += dy;
        return ReferenceDistance.Signed(Place(scene, moved, poseA), Place(scene, other, scene.World.Bodies.Pose[b.Body])) - a.Radius
            - b.Radius;
    }

    private static ReferenceDistance.Point[] Place(QueryScene scene, int piece, BodyPose pose)
    {
        Piece p = scene.World.Shapes.Pieces[piece];
        return Enumerable.Range(p.VertexStart, p.VertexCount).Select(i => scene.World.Shapes.Vertices[i])
            .Select(v => new ReferenceDistance.Point(
                pose.X + ((double)pose.Cos * v.X) - ((double)pose.Sin * v.Y), pose.Y + ((double)pose.Sin * v.X) + ((double)pose.Cos * v.Y)))
            .ToArray();
    }

    private static BodyPose PoseOf(QueryScene scene, Handle collider) => scene.World.Bodies.Pose[scene.World.Collider(collider).Body];

    private static IEnumerable<int> Pieces(QueryScene scene, Handle collider)
    {
        for (int piece = scene.World.Shapes.Colliders[collider.Index].FirstPiece; piece >= 0; piece = scene.World.Shapes.NextPiece[piece])
        {
            yield return piece;
        }
    }

    private static void AssertSame(QueryScene scene, IndexList found, Func<Handle, bool> expected, Func<Handle, bool>? tie = null)
    {
        int[] actual = Enumerable.Range(0, found.Count).Select(i => found[i]).ToArray();
        Handle[] colliders = scene.Colliders.Where(c => scene.IsSeen(c, QueryFilter.All) && (tie is null || !tie(c)))
            .OrderBy(c => scene.World.Shapes.Order[c.Index]).ToArray();
        Assert.Equal(colliders.Where(expected).Select(c => c.Index), actual.Where(a => colliders.Any(c => c.Index == a)));
    }

    private static void ForAnyScene(Action<QueryScene> check)
    {
        Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
        {
            var scene = new QueryScene(seed, bodies: 2 + (seed % 40), side: 9);
            for (int i = 0; i < 6; i++)
            {
                check(scene);
                if (i == 2)
                {
                    scene.Disturb();
                }
            }
        }).QuickCheckThrowOnFailure();
    }
}
