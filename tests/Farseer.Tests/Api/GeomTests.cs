using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>The manual's chapter "Geometry", and what it says of a geom's box and grid.</summary>
public class GeomTests
{
    [Fact]
    [ManualRow("F033")]
    [ManualRow("F039")]
    public void Geom_OfTheManualsFourVertices_IsTheSquareAroundItsBody()
    {
        Body rectBody = BodyFactory.Instance.CreateRectangleBody(128, 128, 1);
        rectBody.Position = new Vector2(400, 300);
        var vertices = new Vertices();
        vertices.Add(new Vector2(-64, -64));
        vertices.Add(new Vector2(64, -64));
        vertices.Add(new Vector2(64, 64));
        vertices.Add(new Vector2(-64, 64));
        var rectGeom = new Geom(rectBody, vertices, 11);
        Assert.Same(rectBody, rectGeom.Body);
        Assert.Equal(11, rectGeom.CollisionGridCellSize);
        Assert.Equal(4, rectGeom.LocalVertices.Count);
        Assert.Equal(new Vector2(336, 236), rectGeom.AABB.Min);
        Assert.Equal(new Vector2(464, 364), rectGeom.AABB.Max);
        Assert.True(rectGeom.Collide(new Vector2(463, 363)));
        Assert.False(rectGeom.Collide(new Vector2(465, 300)));

        var simulator = new PhysicsSimulator();
        simulator.Add(rectBody);
        simulator.Add(rectGeom);
        Geom ball = Sandbox.Ball(simulator, new Vector2(300, 300), 10);
        ball.Body.LinearVelocity = new Vector2(100, 0);
        Sandbox.Run(simulator, 50);
        Assert.True(rectBody.LinearVelocity.X > 10);
    }

    [Fact]
    [ManualRow("F037")]
    public void Geom_NeedsABodyAndVertices()
    {
        Vertices square = Sandbox.Outline(-1, -1, 1, -1, 1, 1, -1, 1);
        Assert.Equal("body", Assert.Throws<ArgumentNullException>(() => new Geom(null!, square, 0)).ParamName);
        Assert.Equal("vertices", Assert.Throws<ArgumentNullException>(() => new Geom(new Body(), (Vertices)null!, 0)).ParamName);
        foreach (Vertices bad in new[]
        {
            new Vertices(),
            Sandbox.Outline(0, 0, 1, 1),
            Sandbox.Outline(0, 0, 1, 1, 2, 2),
            Sandbox.Outline(0, 0, 2, 2, 2, 0, 0, 2),
            Sandbox.Outline(0, 0, 1, float.NaN, 1, 0),
        })
        {
            Assert.ThrowsAny<ArgumentException>(() => new Geom(new Body(), bad, 0));
        }

        // One made without them can be given them later; until then it cannot be added.
        var simulator = new PhysicsSimulator();
        var geom = new Geom();
        Assert.Throws<ArgumentException>(() => simulator.Add(geom));
        geom.SetBody(new Body());
        Assert.Throws<ArgumentException>(() => simulator.Add(geom));
        geom.SetVertices(square);
        simulator.Add(geom);
        simulator.Update(0.01f);
        Assert.Same(geom, Assert.Single(simulator.GeomList));
        Assert.Same(geom, simulator.Collide(0, 0));
    }

    [Fact]
    [ManualRow("F038")]
    public void Collision_OfTwoGeoms_ExchangesImpulsesAndKeepsTheirSum()
    {
        var simulator = new PhysicsSimulator();
        Geom light = Sandbox.Ball(simulator, new Vector2(-20, 0), 5, 1);
        Geom heavy = Sandbox.Ball(simulator, new Vector2(20, 0), 5, 3);
        light.RestitutionCoefficient = 1;
        heavy.RestitutionCoefficient = 1;
        light.Body.LinearVelocity = new Vector2(40, 0);
        Sandbox.Run(simulator, 150);

        // v1 = (m1 - m2)/(m1 + m2) v and v2 = 2 m1/(m1 + m2) v; single precision leaves about 1e-6 of the speed.
        Assert.Equal(-20, light.Body.LinearVelocity.X, 1e-3f);
        Assert.Equal(20, heavy.Body.LinearVelocity.X, 1e-3f);
        Assert.Equal(0, light.Body.LinearVelocity.Y, 1e-3f);
    }

    [Fact]
    [ManualRow("F238")]
    public void Aabb_FollowsTheBody_HoweverItMoves()
    {
        var simulator = new PhysicsSimulator();
        Geom geom = Sandbox.Box(simulator, Vector2.Zero, 40, 20);
        AssertBox(geom, -20, -10, 20, 10);
        geom.Body.LinearVelocity = new Vector2(100, 0);
        simulator.Update(0.25f);
        AssertBox(geom, 5, -10, 45, 10);
        geom.Body.Position = new Vector2(0, 1000);
        AssertBox(geom, -20, 990, 20, 1010);
        geom.Body.Rotation = MathF.PI / 2;
        AssertBox(geom, -10, 980, 10, 1020);
        geom.Body.LinearVelocity = Vector2.Zero;
        geom.Body.AngularVelocity = MathF.PI;
        simulator.Update(0.25f);
        float half = (20 + 10) / MathF.Sqrt(2);
        AssertBox(geom, -half, 1000 - half, half, 1000 + half);
        simulator.Remove(geom.Body);
        simulator.Update(0.25f);
        geom.Body.Rotation = 0;
        AssertBox(geom, -20, 990, 20, 1010);
    }

    [Fact]
    [ManualRow("F242")]
    public void Grid_OfEveryGeom_KnowsDistanceAndNormal()
    {
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(new Body { Position = new Vector2(7, 7) }, 40, 20, 1);
        var point = new Vector2(18, 0);
        Assert.True(geom.Grid.Intersect(ref point, out Feature feature));
        Assert.Equal(-2, feature.Distance, 1e-4f);
        Assert.Equal(Vector2.UnitX, feature.Normal);
        Assert.True(geom.Intersect(ref point, out Feature same));
        Assert.Equal(feature.Distance, same.Distance);
        var outside = new Vector2(25, 0);
        Assert.False(geom.Intersect(ref outside, out _));
        Assert.Same(geom.Grid, geom.Grid);
        Grid old = geom.Grid;
        geom.CollisionGridCellSize = 5;
        Assert.NotSame(old, geom.Grid);
        Assert.Equal(9 * 5, geom.Grid.Points!.Length);
    }

    [Fact]
    [ManualRow("F242")]
    public void Grid_IsMadeOnlyWhenAskedFor()
    {
        // 2560 x 2560 nodes of 4 bytes and more each: over 26 MB if it were made.
        const long Grid = 2560L * 2560 * 4;
        var simulator = new PhysicsSimulator();
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 128, 128, 1);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, 128, 128, 0.05f);
        Geom other = Sandbox.Ball(simulator, new Vector2(66, 0));
        Sandbox.Run(simulator, 3);
        Assert.True(geom.Collide(Vector2.Zero));
        Assert.True(other.Body.LinearVelocity.Length() >= 0);
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, Grid / 10);
    }

    [Fact]
    public void ObjectInitializer_OfGeomAndSimulator_Works()
    {
        int heard = 0;
        var simulator = new PhysicsSimulator { Gravity = new Vector2(0, 50), Iterations = 8, FrictionType = FrictionType.Minimum };
        var body = new Body { IsStatic = true, Tag = 1 };
        var geom = new Geom(body, Sandbox.Outline(-20, 0, 20, 0, 20, 10, -20, 10), 0)
        {
            RestitutionCoefficient = 0.5f,
            FrictionCoefficient = 0.25f,
            CollisionGroup = 0,
            CollisionCategories = CollisionCategory.Cat1,
            CollidesWith = CollisionCategory.All,
            Tag = "floor",
            OnCollision = (_, _, _) => ++heard > 0,
        };
        simulator.Add(body);
        simulator.Add(geom);
        Sandbox.Ball(simulator, new Vector2(0, -6));
        Sandbox.Run(simulator, 50);
        Assert.True(heard > 0);
        Assert.Equal(0.5f, geom.RestitutionCoefficient);
        Assert.Equal(0.25f, geom.FrictionCoefficient);
        Assert.Equal("floor", geom.Tag);
        Assert.Equal(8, simulator.Iterations);
    }

    private static void AssertBox(Geom geom, float minX, float minY, float maxX, float maxY)
    {
        // Coordinates of up to 1020 are rounded to 6e-5.
        const float Rounding = 2e-4f;
        Assert.Equal(minX, geom.AABB.Min.X, Rounding);
        Assert.Equal(minY, geom.AABB.Min.Y, Rounding);
        Assert.Equal(maxX, geom.AABB.Max.X, Rounding);
        Assert.Equal(maxY, geom.AABB.Max.Y, Rounding);
    }
}
