using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Rays, boxes, points and shapes asked of a simulator.</summary>
public class QueryTests
{
    private readonly PhysicsSimulator _simulator = new PhysicsSimulator();

    [Fact]
    public void RayCast_ThroughARowOfGeoms_MeetsTheFirst_AndAllInTheirOrder()
    {
        Geom far = Box(30, 0);
        Geom near = Ball(10, 0, 2);
        Box(20, 50);
        _simulator.Update(0.01f);
        Assert.True(_simulator.RayCast(Vector2.Zero, new Vector2(50, 0), out RayCastHit hit));
        Assert.Same(near, hit.Geom);
        Assert.Equal(new Vector2(8, 0), hit.Point);
        Assert.Equal(new Vector2(-1, 0), hit.Normal);
        Assert.Equal(0.16f, hit.Fraction, 1e-6f);
        Assert.False(hit.StartsInside);
        var hits = new List<RayCastHit>();
        Assert.Equal(2, _simulator.RayCastAll(new Vector2(50, 0), Vector2.Zero, hits));
        Assert.Equal(new[] { far, near }, hits.Select(h => h.Geom));
        Assert.False(_simulator.RayCast(Vector2.Zero, new Vector2(7, 0), out hit));
        Assert.Equal(default, hit);
    }

    [Fact]
    public void RayCast_FromInside_MeetsTheGeomAtOnce()
    {
        Geom ball = Ball(10, 0, 2);
        _simulator.Update(0.01f);
        Assert.True(_simulator.RayCast(new Vector2(9, 0), new Vector2(50, 0), out RayCastHit hit));
        Assert.Same(ball, hit.Geom);
        Assert.True(hit.StartsInside);
        Assert.Equal(0, hit.Fraction);
        Assert.Equal(Vector2.Zero, hit.Normal);
        Assert.Equal(new Vector2(9, 0), hit.Point);
        Assert.True(_simulator.RayCast(new Vector2(9, 0), new Vector2(9, 0), out hit));
    }

    [Fact]
    public void RayCast_WithAFilter_PassesOverWhatItLeavesOut()
    {
        Geom sensor = Box(10, 0);
        sensor.IsSensor = true;
        Geom ghost = Box(15, 0);
        ghost.CollisionEnabled = false;
        Geom off = Box(20, 0);
        off.Body.Enabled = false;
        Geom red = Box(25, 0);
        red.CollisionCategories = CollisionCategory.Cat3;
        Geom last = Box(30, 0);
        _simulator.Update(0.01f);
        Assert.Same(red, First());
        Assert.Same(sensor, First(new QueryFilter { IncludeSensors = true }));
        Assert.Same(last, First(new QueryFilter { Categories = CollisionCategory.Cat1 }));
        Assert.Same(last, First(new QueryFilter { IgnoredBody = red.Body }));
        Assert.Same(last, First(new QueryFilter { Accept = g => g != red }));
        Assert.Null(First(new QueryFilter { Accept = _ => false }));

        Geom? First(QueryFilter? filter = null) =>
            _simulator.RayCast(Vector2.Zero, new Vector2(50, 0), out RayCastHit hit, filter) ? hit.Geom : null;
    }

    [Fact]
    public void Filter_ThatThrowsOrAsksAgain_DoesNoHarm()
    {
        Geom geom = Box(10, 0);
        _simulator.Update(0.01f);
        var throws = new QueryFilter { Accept = _ => throw new TimeoutException() };
        Assert.Throws<TimeoutException>(() => _simulator.RayCast(Vector2.Zero, new Vector2(50, 0), out _, throws));
        var nested = new QueryFilter { Accept = _ => _simulator.ClosestPoint(Vector2.Zero, 1, out ClosestPointHit _) };
        Assert.Throws<InvalidOperationException>(() => _simulator.RayCast(Vector2.Zero, new Vector2(50, 0), out _, nested));
        Assert.True(_simulator.RayCast(Vector2.Zero, new Vector2(50, 0), out RayCastHit hit));
        Assert.Same(geom, hit.Geom);
    }

    [Fact]
    public void Queries_FollowWhatMovesComesAndGoes()
    {
        Geom geom = Box(10, 0);
        Assert.True(_simulator.RayCast(Vector2.Zero, new Vector2(50, 0), out _));
        _simulator.Update(0.01f);
        Assert.True(_simulator.RayCast(Vector2.Zero, new Vector2(50, 0), out _));
        geom.Body.Position = new Vector2(10, 30);
        Assert.False(_simulator.RayCast(Vector2.Zero, new Vector2(50, 0), out _));
        geom.Body.Position = new Vector2(100, 0);
        geom.Body.LinearVelocity = new Vector2(-6000, 0);
        _simulator.Update(0.01f);
        Assert.True(_simulator.RayCast(Vector2.Zero, new Vector2(50, 0), out RayCastHit hit));
        Assert.Equal(39, hit.Point.X, 0.1f);
        Geom second = Box(20, 0);
        _simulator.Update(0.01f);
        Assert.True(_simulator.RayCast(Vector2.Zero, new Vector2(50, 0), out hit));
        _simulator.Remove(second);
        _simulator.Remove(geom);
        _simulator.Update(0.01f);
        Assert.False(_simulator.RayCast(new Vector2(-500, 0), new Vector2(500, 0), out _));
    }

    [Fact]
    public void Query_PointCircleAndGeom_FindWhatSharesAPoint()
    {
        Geom box = Box(0, 0);
        Geom ball = Ball(3, 0, 1.5f);
        Geom aside = Box(20, 0);
        _simulator.Update(0.01f);
        var found = new List<Geom> { aside };
        Assert.Equal(2, _simulator.Query(new AABB(new Vector2(0.5f, 0.5f), new Vector2(2, 2)), found));
        Assert.Equal(new[] { box, ball }, found);
        Assert.Equal(1, _simulator.QueryPoint(new Vector2(1, -1), found));
        Assert.Same(box, found[0]);

        // In the corner of the ball's box, but not in the ball.
        Assert.Equal(0, _simulator.QueryPoint(new Vector2(4.4f, 1.4f), found));
        Assert.Equal(2, _simulator.QueryCircle(new Vector2(1.2f, 0), 0.5f, found));
        Assert.Equal(0, _simulator.QueryGeom(box, found));
        ball.Body.Position = new Vector2(2.4f, 0);
        Assert.Equal(1, _simulator.QueryGeom(box, found));
        Assert.Same(ball, found[0]);
    }

    [Fact]
    public void ShapeCast_StopsWhereTheGeomsTouch()
    {
        Geom box = Box(0, 0);
        Geom wall = Box(20, 0.5f);
        _simulator.Update(0.01f);
        Assert.True(_simulator.ShapeCast(box, new Vector2(40, 0), out RayCastHit hit));
        Assert.Same(wall, hit.Geom);

        // Sides of 2: they touch after 18 of 40, along the part of the side that both have.
        Assert.Equal(0.45f, hit.Fraction, 1e-6f);
        Assert.Equal(new Vector2(-1, 0), hit.Normal);
        Assert.Equal(new Vector2(19, 0.25f), hit.Point);
        Assert.False(_simulator.ShapeCast(box, new Vector2(17.9f, 0), out _));
        Assert.True(_simulator.CircleCast(new Vector2(0, 10), 0.5f, new Vector2(0, -20), out hit));
        Assert.Same(box, hit.Geom);
        Assert.Equal(new Vector2(0, 1), hit.Point);
        Assert.Equal(8.5f / 20, hit.Fraction, 1e-6f);
    }

    [Fact]
    public void ShapeCast_OfAGeomThatIsNotInTheSimulator_IsRefused()
    {
        Geom stranger = GeomFactory.Instance.CreateRectangleGeom(new Body(), 2, 2);
        Assert.Throws<ArgumentException>("geometry", () => _simulator.ShapeCast(stranger, Vector2.One, out _));
        Assert.Throws<ArgumentException>("geometry", () => _simulator.QueryGeom(stranger, new List<Geom>()));
        Geom leaving = Box(0, 0);
        _simulator.Update(0.01f);
        _simulator.Remove(leaving);
        Assert.Throws<ArgumentException>("geometry", () => _simulator.ShapeCast(leaving, Vector2.One, out _));
    }

    [Fact]
    public void ClosestPoint_IsOnTheOutline_NegativeInside()
    {
        Geom box = Box(0, 0);
        _simulator.Update(0.01f);
        Assert.True(_simulator.ClosestPoint(new Vector2(4, 0.5f), 3, out ClosestPointHit hit));
        Assert.Same(box, hit.Geom);
        Assert.Equal(3, hit.Distance);
        Assert.Equal(new Vector2(1, 0.5f), hit.Point);
        Assert.False(_simulator.ClosestPoint(new Vector2(4, 0.5f), 2.9f, out hit));
        Assert.Null(hit.Geom);
        Assert.True(_simulator.ClosestPoint(new Vector2(0.75f, 0), 0, out hit));
        Assert.Equal(-0.25f, hit.Distance);
        Assert.Equal(new Vector2(1, 0), hit.Point);
    }

    [Fact]
    public void RayCast_InAHandler_SeesTheGeomsOfTheStep()
    {
        Geom ball = Ball(0, 0, 1);
        Geom wall = Box(2.5f, 0);
        wall.Body.IsStatic = true;
        Geom? seen = null;
        ball.Body.LinearVelocity = new Vector2(100, 0);
        ball.OnCollision += (_, _, _) =>
        {
            _simulator.RayCast(new Vector2(2, 10), new Vector2(2, -10), out RayCastHit hit);
            seen = hit.Geom;
            return true;
        };
        for (int i = 0; i < 3; i++)
        {
            _simulator.Update(0.01f);
        }

        Assert.Same(wall, seen);
    }

    private Geom Box(float x, float y)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(_simulator, 2, 2, 1);
        body.Position = new Vector2(x, y);
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 2, 2);
        geom.CollisionCategories = CollisionCategory.Cat1;
        geom.CollidesWith = CollisionCategory.All;
        return geom;
    }

    private Geom Ball(float x, float y, float radius)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(_simulator, radius, 1);
        body.Position = new Vector2(x, y);
        return GeomFactory.Instance.CreateCircleGeom(_simulator, body, radius, 12);
    }
}
