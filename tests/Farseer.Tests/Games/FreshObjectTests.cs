using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Views;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Games;

/// <summary>What was added, moved or removed is seen at once.</summary>
public sealed class FreshObjectTests
{
    [Fact]
    public void Queries_SeeWhatWaitsForTheUpdate_InOneOrderWithTheRest()
    {
        PhysicsSimulator simulator = Falling(0);
        Geom old = Box(simulator, new Vector2(100, 0));
        simulator.Update(Step);
        Geom fresh = Box(simulator, new Vector2(50, 0));
        Geom far = Box(simulator, new Vector2(150, 0));
        Assert.True(simulator.RayCast(Vector2.Zero, new Vector2(300, 0), out RayCastHit hit));
        Assert.Same(fresh, hit.Geom);
        Assert.Equal(40, hit.Point.X, 1e-4f);
        var hits = new List<RayCastHit>();
        Assert.Equal(3, simulator.RayCastAll(Vector2.Zero, new Vector2(300, 0), hits));
        Assert.Equal(new[] { fresh, old, far }, hits.Select(h => h.Geom));
        var geoms = new List<Geom>();
        simulator.Query(new AABB(new Vector2(0, -5), new Vector2(200, 5)), geoms);
        Assert.Equal(new[] { old, fresh, far }, geoms);
        Assert.Equal(1, simulator.QueryPoint(new Vector2(50, 0), geoms));
        Assert.Equal(2, simulator.QueryCircle(new Vector2(75, 0), 20, geoms));
        Assert.True(simulator.CircleCast(Vector2.Zero, 5, new Vector2(300, 0), out hit));
        Assert.Same(fresh, hit.Geom);
        Assert.True(simulator.ClosestPoint(new Vector2(48, 30), 100, out ClosestPointHit near));
        Assert.Same(fresh, near.Geom);
        Assert.Same(fresh, simulator.Collide(50, 0));
        Assert.Same(fresh, Assert.Single(simulator.CollideAll(50, 0)));
        Assert.True(simulator.ShapeCast(fresh, new Vector2(300, 0), out hit));
        Assert.Same(old, hit.Geom);
        Assert.True(simulator.ShapeCast(old, new Vector2(-300, 0), out hit));
        Assert.Same(fresh, hit.Geom);
        fresh.Body.Position = new Vector2(85, 0);
        Assert.Equal(1, simulator.QueryGeom(fresh, geoms));
        Assert.Same(old, geoms[0]);
        Assert.Equal(1, simulator.QueryGeom(old, geoms));
        Assert.Same(fresh, geoms[0]);
        Assert.Equal(0, simulator.QueryPoint(new Vector2(50, 0), geoms));
    }

    [Fact]
    public void Queries_DoNotSeeWhatWasRemoved_AndSeeNewOutlinesAndBodies()
    {
        PhysicsSimulator simulator = Falling(0);
        Geom box = Box(simulator, new Vector2(100, 0));
        Geom other = Box(simulator, new Vector2(200, 0));
        simulator.Update(Step);
        Assert.True(simulator.RayCast(Vector2.Zero, new Vector2(300, 0), out RayCastHit hit));
        Assert.Same(box, hit.Geom);
        simulator.Remove(box);
        Assert.True(simulator.RayCast(Vector2.Zero, new Vector2(300, 0), out hit));
        Assert.Same(other, hit.Geom);
        Assert.Null(simulator.Collide(100, 0));
        simulator.Add(box);
        Assert.True(simulator.RayCast(Vector2.Zero, new Vector2(300, 0), out hit));
        Assert.Same(box, hit.Geom);
        box.SetVertices(Outline(-40, -10, 40, -10, 40, 10, -40, 10));
        Assert.True(simulator.RayCast(Vector2.Zero, new Vector2(300, 0), out hit));
        Assert.Equal(60, hit.Point.X, 1e-4f);
        var carrier = new Body { Position = new Vector2(-100, 0) };
        other.SetBody(carrier);
        Assert.True(simulator.RayCast(Vector2.Zero, new Vector2(-300, 0), out hit));
        Assert.Same(other, hit.Geom);
        Assert.Equal(-90, hit.Point.X, 1e-4f);
    }

    [Fact]
    public void Queries_ChangeNoBitOfTheRun()
    {
        Assert.Equal(Run(asks: false), Run(asks: true));

        static double[] Run(bool asks)
        {
            PhysicsSimulator simulator = WithFloor(out _);
            var bodies = new List<Body>();
            var geoms = new List<Geom>();
            for (int i = 0; i < 30; i++)
            {
                Geom geom = Box(simulator, new Vector2((i % 3) - 1, -20 - (22 * i)));
                geom.FrictionCoefficient = 0.4f;
                bodies.Add(geom.Body);
                if (asks)
                {
                    simulator.QueryPoint(geom.Position, geoms);
                    simulator.RayCast(new Vector2(0, -1000), new Vector2(0, 100), out _);
                }

                if (i % 5 == 4)
                {
                    simulator.Remove(geom);
                    simulator.Add(new Body());
                    Box(simulator, new Vector2(60, -20 - (22 * i)));
                }

                if (i % 4 == 3)
                {
                    simulator.Update(Step);
                }
            }

            Sandbox.Run(simulator, 100);
            return bodies.SelectMany(b => new[] { b.PositionX, b.PositionY, b.TotalRotation }).ToArray();
        }
    }

    [Fact]
    public void UpdateOfZero_TakesInAndOut_AndMovesNothing()
    {
        PhysicsSimulator simulator = Falling();
        Geom box = Box(simulator, Vector2.Zero);
        box.Body.LinearVelocity = new Vector2(3, 0);
        box.Body.ApplyImpulse(new Vector2(5, 0));
        simulator.Update(0);
        Assert.Same(box.Body, Assert.Single(simulator.BodyList));
        Assert.Same(box, Assert.Single(simulator.GeomList));
        Assert.Equal((Vector2.Zero, new Vector2(3, 0)), (box.Body.Position, box.Body.LinearVelocity));
        simulator.Update(Step);
        Assert.Equal(8, box.Body.LinearVelocity.X, 1e-5f);
        simulator.Remove(box);
        simulator.Remove(box.Body);
        simulator.Update(0);
        Assert.Empty(simulator.BodyList);
        Assert.Empty(simulator.GeomList);
    }

    [Fact]
    public void View_DrawsWhatWaits()
    {
        PhysicsSimulator simulator = Falling();
        Geom box = Box(simulator, Vector2.Zero);
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, box.Body, new Vector2(5, 5));
        var draw = new CountingDraw();
        var view = new PhysicsSimulatorView(simulator, draw) { EnableCoordinateAxisView = true };
        view.Draw();
        Assert.Equal(1, draw.Polygons);
        Assert.True(draw.Lines > 2);
        simulator.Update(Step);
        simulator.Remove(box);
        draw.Polygons = 0;
        view.Draw();
        Assert.Equal(0, draw.Polygons);
    }

    [Fact]
    public void BodyGeoms_AreThoseMadeForIt()
    {
        var body = new Body();
        Assert.Empty(body.Geoms);
        Geom one = GeomFactory.Instance.CreateCircleGeom(body, 1, 8);
        Geom two = GeomFactory.Instance.CreateCircleGeom(body, 2, 8);
        Assert.Equal(new[] { one, two }, body.Geoms);
        Assert.Throws<ArgumentOutOfRangeException>(() => body.Geoms[2]);
        one.Dispose();
        Assert.Same(two, Assert.Single(body.Geoms));
    }

    [Fact]
    public void RemoveWithParts_TakesGeomsJointsAndSpringsOut_AndRemoveLeavesThem()
    {
        PhysicsSimulator simulator = Falling();
        Geom box = Box(simulator, Vector2.Zero);
        Geom other = Box(simulator, new Vector2(50, 0));
        PinJoint pin = JointFactory.Instance.CreatePinJoint(simulator, box.Body, Vector2.Zero, other.Body, Vector2.Zero);
        FixedLinearSpring spring =
            SpringFactory.Instance.CreateFixedLinearSpring(simulator, box.Body, Vector2.Zero, new Vector2(0, -50), 1, 1);
        simulator.Update(Step);
        simulator.Remove(box.Body);
        simulator.Update(Step);
        Assert.Equal(2, simulator.GeomList.Count);
        Assert.Single(simulator.JointList);
        simulator.Add(box.Body);
        simulator.Update(Step);
        simulator.RemoveWithParts(box.Body);
        simulator.Update(Step);
        Assert.Same(other, Assert.Single(simulator.GeomList));
        Assert.Same(other.Body, Assert.Single(simulator.BodyList));
        Assert.Empty(simulator.JointList);
        Assert.Empty(simulator.SpringList);
        Assert.False(pin.IsDisposed || spring.IsDisposed || box.IsDisposed);
    }

    [Fact]
    public void Lists_OfASimulator_MeanWhatTheySay()
    {
        PhysicsSimulator simulator = Falling();
        Geom one = Box(simulator, Vector2.Zero);
        Geom two = Box(simulator, new Vector2(50, 0));
        Geom three = Box(simulator, new Vector2(100, 0));
        simulator.Update(0);
        simulator.GeomList.RemoveAt(0);
        Assert.Equal(1, simulator.BodyList.RemoveAll(b => ReferenceEquals(b, two.Body)));
        simulator.Update(0);
        Assert.Equal(new[] { two, three }, simulator.GeomList);
        Assert.Equal(new[] { one.Body, three.Body }, simulator.BodyList);
        Assert.Throws<InvalidOperationException>(() => simulator.GeomList.Insert(0, one));
        Assert.Throws<InvalidOperationException>(() => simulator.GeomList[0] = one);
        Assert.Throws<InvalidOperationException>(() => simulator.GeomList.Reverse());
        simulator.GeomList.AddRange([one]);
        simulator.Update(0);
        Assert.Equal(3, simulator.GeomList.Count);
        simulator.BodyList.Clear();
        simulator.GeomList.Clear();
        Sandbox.Run(simulator, 1);
        Assert.Empty(simulator.BodyList);
        Assert.Empty(simulator.GeomList);
    }

    [Fact]
    public void Lists_OfOnesOwn_ChangeAtOnceAndTell()
    {
        var list = new BodyList();
        int added = 0;
        int removed = 0;
        list.Added += _ => added++;
        list.Removed += _ => removed++;
        list.AddRange([new Body(), new Body(), new Body()]);
        list.Insert(1, new Body());
        list[0] = new Body();
        list.RemoveRange(0, 2);
        list.Clear();
        Assert.Empty(list);
        Assert.Equal((5, 5), (added, removed));
    }

    private sealed class CountingDraw : IDebugDraw
    {
        public int Lines { get; private set; }

        public int Polygons { get; set; }

        public void DrawLine(Vector2 start, Vector2 end, DebugColor color) => Lines++;

        public void DrawPolygon(Vertices vertices, DebugColor line, DebugColor fill) => Polygons++;

        public void DrawCircle(Vector2 center, float radius, DebugColor line, DebugColor fill)
        {
        }

        public void DrawPoint(Vector2 position, float size, DebugColor color)
        {
        }
    }
}
