using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Queries;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Engine.Tests.Queries;

public class RayCastTests
{
    [Fact]
    public void CastRay_OnAnyScene_FindsWhatAllCollidersOneByOneGive()
    {
        Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
        {
            var scene = new QueryScene(seed, bodies: 1 + (seed % 60), side: 12, oneSided: true);
            for (int round = 0; round < 6; round++)
            {
                for (int i = 0; i < 20; i++)
                {
                    CompareRay(scene, scene.Ray(), Filter(scene, i));
                }

                scene.Disturb();
                if (round % 2 == 1)
                {
                    scene.World.Step(1f / 60);
                }
            }
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void CastRay_OnAnyCollider_EntersWhereTheDistanceBecomesZero()
    {
        Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), AssertEntersColliders).QuickCheckThrowOnFailure();
    }

    /// <summary>Ways that end within 1e-4 of a corner that goes in: a step of that length along the normal nears its other side.</summary>
    [Theory]
    [InlineData(707201898)]
    [InlineData(836060550)]
    public void CastRay_IntoACornerThatGoesIn_HasTheNormalOfItsSide(int seed) => AssertEntersColliders(seed);

    /// <summary>
    /// A way through a line, whose distance is said too large by 1.4e-8 of it: the march that it is compared with went past.
    /// </summary>
    [Fact]
    public void CastRay_ThroughALineOfRoundedNormal_EntersWhereTheDistanceBecomesZero() => AssertEntersColliders(2132652409);

    [Fact]
    public void CastRayAll_OnAnyScene_GivesEachColliderOnceInOrderOfTheWay()
    {
        Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
        {
            var scene = new QueryScene(seed, bodies: 40, side: 8, oneSided: true);
            for (int i = 0; i < 10; i++)
            {
                RayInput ray = scene.Ray();
                QueryFilter filter = Filter(scene, i);
                var expected = new List<(double Fraction, bool Outside, int Order, int Collider)>();
                foreach (Handle collider in scene.Colliders)
                {
                    if (scene.IsSeen(collider, filter) && scene.World.Queries.CastRay(collider.Index, ray, out RayHit hit))
                    {
                        expected.Add((hit.Fraction, !hit.StartsInside, scene.World.Shapes.Order[collider.Index], collider.Index));
                    }
                }

                expected.Sort();
                int count = scene.World.Queries.CastRayAll(ray, filter);
                int[] actual = Enumerable.Range(0, count).Select(k => scene.World.Queries.Hit(k).Collider).ToArray();
                Assert.Equal(expected.Select(e => e.Collider), actual);
            }
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void CastRay_FarFromTheOrigin_FindsTheSameCollider()
    {
        // 2²³ is a place where a float has steps of 1: only differences are exact there, and the boxes are coarse.
        const double Far = 8388608;
        for (int seed = 0; seed < 20; seed++)
        {
            var near = new QueryScene(seed, bodies: 50, side: 20);
            var far = new QueryScene(seed, bodies: 50, side: 20, centerX: Far);
            for (int i = 0; i < 30; i++)
            {
                RayInput ray = near.Ray();
                far.Ray();
                RayInput moved = ray;
                moved.X += Far;
                bool found = near.World.Queries.CastRay(ray, QueryFilter.All, out RayHit hit);
                Assert.Equal(found, far.World.Queries.CastRay(moved, QueryFilter.All, out RayHit farHit));
                Assert.True(!found || (hit.Collider == farHit.Collider && Math.Abs(hit.Fraction - farHit.Fraction) < 1e-6));
            }
        }
    }

    [Fact]
    public void CastRay_IntoConcaveOutline_NeverHitsASeam()
    {
        var world = new World();
        Handle body = world.CreateBody(new BodyDef { Mass = 1, Inertia = 1, Flags = BodyFlags.Enabled });

        // A comb: many pieces side by side, whose seams stand across rays along its spine.
        var outline = new List<Vector2>();
        for (int tooth = 0; tooth < 8; tooth++)
        {
            outline.Add(new Vector2((2 * tooth) + 1, 3));
            outline.Add(new Vector2(2 * tooth, 3));
        }

        outline = outline.OrderByDescending(v => v.X).SelectMany((v, i) => i % 2 == 0
            ? new[] { new Vector2(v.X, 1), v }
            : new[] { v, new Vector2(v.X, 1) }).ToList();
        outline.Add(new Vector2(0, 0));
        outline.Add(new Vector2(15, 0));
        world.CreateCollider(
            body, ShapeBuilder.Polygon(outline.ToArray()), new ColliderDef { Flags = ColliderFlags.CollisionEnabled, Categories = 1 });
        Assert.True(world.Shapes.Colliders[0].PieceCount > 4);
        var ray = new RayInput { X = -5, Y = 2, DirectionX = 40 };
        Assert.True(world.Queries.CastRay(ray, QueryFilter.All, out RayHit hit));
        Assert.Equal(new Vector2(-1, 0), hit.Normal);
        Assert.Equal(0, hit.X, 12);

        // Between two teeth: the next wall is that of the second tooth, at 2.
        ray.X = 1.5;
        Assert.True(world.Queries.CastRay(ray, QueryFilter.All, out hit));
        Assert.Equal(2, hit.X, 12);

        // Within the spine: inside from the start, whatever pieces it is made of.
        ray = new RayInput { X = 0.5, Y = 0.5, DirectionX = 40 };
        Assert.True(world.Queries.CastRay(ray, QueryFilter.All, out hit));
        Assert.True(hit.StartsInside);
        Assert.Equal(0, hit.Fraction);
    }

    [Fact]
    public void CastRay_OnceWarm_AllocatesNothing()
    {
        var scene = new QueryScene(5, bodies: 200, side: 40);
        var found = new IndexList();
        RayInput[] rays = Enumerable.Range(0, 50).Select(_ => scene.Ray()).ToArray();
        long before = 0;
        for (int round = 0; round < 40; round++)
        {
            if (round == 20)
            {
                before = GC.GetAllocatedBytesForCurrentThread();
            }

            foreach (RayInput ray in rays)
            {
                scene.World.Queries.CastRay(ray, QueryFilter.All, out _);
                scene.World.Queries.CastRayAll(ray, QueryFilter.All);
                scene.World.Queries.FindAtPoint(ray.X, ray.Y, QueryFilter.All, found);
                scene.World.Queries.FindNearest(ray.X, ray.Y, 10, QueryFilter.All, out _);
                scene.World.Queries.SetDisc(ray.X, ray.Y, 0.3);
                scene.World.Queries.FindOverlapping(QueryFilter.All, found);
                scene.World.Queries.CastShape(ray.DirectionX, ray.DirectionY, QueryFilter.All, out _);
            }

            for (int i = 0; i < scene.Handles.Count; i += 3)
            {
                scene.World.SetPosition(scene.Handles[i], rays[i % 50].X, rays[(i + round) % 50].Y);
            }

            scene.World.Queries.Version++;
        }

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Fact]
    public void CastRay_FromAFilter_IsRefused()
    {
        var scene = new QueryScene(1, bodies: 30, side: 4);
        QueryFilter filter = QueryFilter.All;
        filter.Predicate = new Nested(scene.World);
        Assert.Throws<InvalidOperationException>(
            () => scene.World.Queries.CastRay(new RayInput { X = -9, DirectionX = 20 }, filter, out _));

        // The refusal has not left anything behind.
        Assert.True(scene.World.Queries.CastRay(new RayInput { X = -9, DirectionX = 20 }, QueryFilter.All, out _));
    }

    private static QueryFilter Filter(QueryScene scene, int i)
    {
        QueryFilter filter = QueryFilter.All;
        filter.Categories = i % 3 == 0 ? 3u : uint.MaxValue;
        filter.IgnoredBody = i % 5 == 0 ? scene.Handles[i % scene.Handles.Count].Index : 0;
        return filter;
    }

    private static void CompareRay(QueryScene scene, in RayInput ray, in QueryFilter filter)
    {
        RayHit best = default;
        best.Fraction = double.PositiveInfinity;
        int order = 0;
        foreach (Handle collider in scene.Colliders)
        {
            if (!scene.IsSeen(collider, filter) || !scene.World.Queries.CastRay(collider.Index, ray, out RayHit hit))
            {
                continue;
            }

            int age = scene.World.Shapes.Order[collider.Index];
            if (hit.Fraction < best.Fraction
                || (hit.Fraction == best.Fraction && (hit.StartsInside, -age).CompareTo((best.StartsInside, -order)) > 0))
            {
                best = hit;
                order = age;
            }
        }

        bool found = scene.World.Queries.CastRay(ray, filter, out RayHit actual);
        Assert.Equal(best.Fraction <= 1, found);
        if (found)
        {
            Assert.Equal(best, actual);
        }
    }

    private static void AssertEntersColliders(int seed)
    {
        var scene = new QueryScene(seed, bodies: 8, side: 8);
        for (int i = 0; i < 20; i++)
        {
            RayInput ray = scene.Ray();
            foreach (Handle collider in scene.Colliders)
            {
                // A line has no inside and the way may start on it; a march that creeps along a border finds its end late.
                if (Math.Abs(scene.Distance(collider, ray.X, ray.Y)) < 1e-4)
                {
                    continue;
                }

                double expected = scene.March(collider, ray, 0);
                bool found = scene.World.Queries.CastRay(collider.Index, ray, out RayHit hit);
                double length = Math.Sqrt((ray.DirectionX * ray.DirectionX) + (ray.DirectionY * ray.DirectionY));
                double actual = found ? hit.Fraction : double.PositiveInfinity;

                // A way that only grazes a corner may be a hit for one and none for the other.
                bool same = double.IsInfinity(expected) == double.IsInfinity(actual)
                    && (double.IsInfinity(expected) || Math.Abs(expected - actual) * length < 1e-5);
                Assert.True(same || Grazes(scene, collider, ray), $"seed {seed}: {expected} and {actual}");
                if (found && !hit.StartsInside)
                {
                    AssertNormal(scene, collider, ray, hit);
                }
            }
        }
    }

    /// <summary>Whether the way comes within a hair of the collider's border without entering it, or only just.</summary>
    private static bool Grazes(QueryScene scene, Handle collider, in RayInput ray)
    {
        double length = Math.Sqrt((ray.DirectionX * ray.DirectionX) + (ray.DirectionY * ray.DirectionY));
        double side = 1e-5;
        bool[] found = new bool[2];
        double[] at = new double[2];
        for (int i = 0; i < 2; i++)
        {
            RayInput moved = ray;
            double sign = i == 0 ? side : -side;
            moved.X -= sign * ray.DirectionY / length;
            moved.Y += sign * ray.DirectionX / length;
            found[i] = scene.World.Queries.CastRay(collider.Index, moved, out RayHit hit);
            at[i] = hit.Fraction;
        }

        bool ends = Math.Abs(scene.Distance(collider, ray.X + ray.DirectionX, ray.Y + ray.DirectionY)) < side;
        return ends || found[0] != found[1] || (found[0] && Math.Abs(at[0] - at[1]) * length > 1e-4);
    }

    /// <summary>The normal points out of the outline, or against the way on a line, and is that of the surface.</summary>
    private static void AssertNormal(QueryScene scene, Handle collider, in RayInput ray, in RayHit hit)
    {
        Assert.InRange(hit.Normal.Length(), 1 - 1e-6, 1 + 1e-6);
        Assert.True((hit.Normal.X * ray.DirectionX) + (hit.Normal.Y * ray.DirectionY) <= 1e-6 * scene.Side);

        // A step along the normal goes away from the surface by as much, also at a corner that stands out. In one that goes in, the
        // other side may come nearer instead: the step is so short that no way ends as near to one.
        const double Step = 1e-7;
        double away = scene.Distance(collider, hit.X + (Step * hit.Normal.X), hit.Y + (Step * hit.Normal.Y));
        Assert.InRange(away, 0.9 * Step, 1.1 * Step);
    }

    private sealed class Nested : IQueryPredicate
    {
        private readonly World _world;

        public Nested(World world) => _world = world;

        public bool Accept(int collider) => _world.Queries.CastRay(default, QueryFilter.All, out _);
    }
}
