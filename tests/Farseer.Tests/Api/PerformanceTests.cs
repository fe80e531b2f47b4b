using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Api;

/// <summary>The chapter "Performance": its advice holds and its means work. Counts are compared, not times.</summary>
public class PerformanceTests
{
    [Fact]
    [ManualRow("F281")]
    public void Landscape_InChunksOrAsOneGeom_PairsOnlyWithWhatIsNear_AndCarriesTheSame()
    {
        // Every ball hovers above the hills, its lower edge at y = 60: ten near the tops (y = 50) and ten over the valleys, which
        // the box of the whole landscape would meet too. Its pieces have boxes of their own, so the manual's advice is built in.
        int inChunks = BallsPairedOver(Landscape(50));
        Assert.Equal(10, inChunks);
        Assert.Equal(inChunks, BallsPairedOver(Landscape(1)));
        Assert.Equal(DropIntoValley(Landscape(1)), DropIntoValley(Landscape(50)), 1);
    }

    [Fact]
    [ManualRow("F282")]
    public void Vertices_FewerOfThem_CostLessAndSayLess()
    {
        // Each vertex costs memory for its place, its world place and its part of the convex pieces.
        var body = new Body();
        long before = 0;
        foreach (int count in new[] { 8, 64, 512 })
        {
            Vertices outline = Vertices.CreateEllipse(20, 10, count);
            long start = GC.GetAllocatedBytesForCurrentThread();
            _ = new Geom(body, outline, 1);
            long cost = GC.GetAllocatedBytesForCurrentThread() - start;
            Assert.True(cost > 2 * before, $"{count} vertices cost {cost} bytes, an eighth of them {before}.");
            before = cost;
        }

        Geom few = GeomFactory.Instance.CreateCircleGeom(body, 10, 8);
        Geom many = GeomFactory.Instance.CreateCircleGeom(body, 10, 64);
        Assert.Equal(8, few.LocalVertices.Count);
        Assert.Equal(64, many.LocalVertices.Count);

        // What fewer vertices cost is precision: the octagon's edge lies inside the circle.
        Assert.InRange(many.GetNearestDistance(new Vector2(9.9f, 0.2f)), -0.1f, 0);
        Assert.True(few.GetNearestDistance(new Vector2(9.239f, 3.827f)) > 0);
        Assert.True(many.GetNearestDistance(new Vector2(9.239f, 3.827f)) < 0.001f);
    }

    [Fact]
    [ManualRow("F283")]
    public void GridCellSize_ByDefaultATenthOfTheShorterSide_LargerIsCoarser()
    {
        var body = new Body();
        Geom byDefault = GeomFactory.Instance.CreateRectangleGeom(body, 40, 20);
        Geom coarse = GeomFactory.Instance.CreateRectangleGeom(body, 40, 20, 10);
        Assert.Equal(2, byDefault.CollisionGridCellSize, 5);
        Assert.Equal(10, coarse.CollisionGridCellSize);
        Assert.Equal(21 * 11, byDefault.Grid.Points!.Length);
        Assert.Equal(5 * 3, coarse.Grid.Points!.Length);

        // Stepping up from the default makes the table smaller.
        int before = int.MaxValue;
        foreach (float factor in new[] { 1f, 1.5f, 2f, 3f, 5f })
        {
            byDefault.CollisionGridCellSize = 2 * factor;
            int nodes = byDefault.Grid.Points!.Length;
            Assert.True(nodes < before);
            before = nodes;
        }

        // Small cells are precise; the bilinear distance of a coarse one is off where the nearest side changes within a cell.
        var fine = GeomFactory.Instance.CreateRectangleGeom(body, 40, 20, 0.5f);
        var point = new Vector2(18.2f, 5.1f);
        Assert.True(fine.Intersect(ref point, out Feature exact));
        Assert.True(coarse.Intersect(ref point, out Feature rough));
        Assert.Equal(-1.8f, exact.Distance, 2);
        Assert.True(Math.Abs(rough.Distance + 1.8f) > Math.Abs(exact.Distance + 1.8f));
    }

    [Fact]
    [ManualRow("F284")]
    [ManualRow("F291")]
    public void Enabled_False_TakesABodyOutOfMotionAndCollision_TrueBringsItBack()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        Geom far = Box(simulator, new Vector2(0, -30));
        Run(simulator, 10);
        far.Body.Enabled = false;
        Vector2 place = far.Body.Position;
        Vector2 velocity = far.Body.LinearVelocity;
        Geom other = Box(simulator, new Vector2(0, -50));
        Run(simulator, 100);

        // Nothing moves it, and what falls goes through it down to the floor.
        Assert.Equal(place, far.Body.Position);
        Assert.Equal(velocity, far.Body.LinearVelocity);
        Assert.InRange(other.Body.Position.Y, -10.1f, -9.9f);
        Assert.Single(simulator.ArbiterList);
        Assert.Equal(3, simulator.BodyList.Count);
        other.Dispose();
        far.Body.Enabled = true;
        Run(simulator, 1);
        Assert.True(far.Body.Position.Y > place.Y);
        Run(simulator, 150);
        Assert.InRange(far.Body.Position.Y, -10.1f, -9.9f);
    }

    [Fact]
    [ManualRow("F285")]
    public void IsSensor_StartsASection_WithoutTouchingAnything()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        Geom gate = Box(simulator, new Vector2(50, -10));
        gate.Body.IsStatic = true;
        Assert.False(gate.IsSensor);
        gate.IsSensor = true;
        Assert.True(gate.IsSensor);
        Assert.False(gate.CollisionResponseEnabled);
        Geom player = Ball(simulator, new Vector2(0, -10.01f), 10);
        player.Body.LinearVelocity = new Vector2(50, 0);
        int inside = 0;
        int left = 0;
        gate.OnCollision += (a, b, _) =>
        {
            Assert.Same(gate, a);
            Assert.Same(player, b);
            return ++inside > 0;
        };
        gate.OnSeparation += (_, _) => left++;

        // Reaches the gate at x = 30 after 0.6 s and has left it at x = 70 after 1.4 s.
        Run(simulator, 58);
        Assert.Equal(0, inside);
        Run(simulator, 92);
        Assert.InRange(inside, 77, 83);
        Assert.Equal(1, left);
        Assert.Equal(75, player.Body.Position.X, 1);
        Assert.Equal(50, player.Body.LinearVelocity.X, 2);
    }

    [Theory]
    [InlineData(Farseer201Quirks.None)]
    [InlineData(Farseer201Quirks.SensorMakesBodyStatic)]
    [ManualRow("F285")]
    public void IsSensor_MakesTheBodyStatic_OnlyWithTheQuirk(Farseer201Quirks quirks)
    {
        PhysicsSimulator simulator = Falling();
        simulator.Quirks = quirks;
        Geom gate = Box(simulator, Vector2.Zero);
        gate.IsSensor = true;
        bool isStatic = quirks != Farseer201Quirks.None;
        Assert.Equal(isStatic, gate.Body.IsStatic);
        Run(simulator, 100);
        Assert.Equal(isStatic ? 0 : 50, gate.Position.Y, 1e-3f);
    }

    [Fact]
    [ManualRow("F290")]
    public void ArbiterPool_UsesArbitersAgain_SoThatContactsAllocateNothing()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        var boxes = new List<Geom>();
        for (int i = 0; i < 5; i++)
        {
            boxes.Add(Box(simulator, new Vector2((i * 40) - 80, -10)));
        }

        for (int i = 0; i < 20; i++)
        {
            simulator.Update(Step);
            _ = simulator.ArbiterList;
        }

        Assert.Equal(5, simulator.ArbiterList.Count);
        var known = new HashSet<Arbiter>(simulator.ArbiterList, ReferenceEqualityComparer.Instance);
        long before = GC.GetAllocatedBytesForCurrentThread();
        int seen = 0;
        for (int i = 0; i < 20; i++)
        {
            simulator.Update(Step);
            seen += simulator.ArbiterList.Count;
        }

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        Assert.Equal(100, seen);
        Assert.All(simulator.ArbiterList, arbiter => Assert.Contains(arbiter, known));
    }

    [Fact]
    [ManualRow("F291")]
    public void PooledBody_IsDeactivatedNotDisposed_AndServesAgain()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        var pool = new Pool<Body>();
        Geom bullet = Ball(simulator, new Vector2(0, -20), 10);
        Run(simulator, 5);
        for (int shot = 0; shot < 3; shot++)
        {
            bullet.Body.Enabled = false;
            pool.Insert(bullet.Body);
            Run(simulator, 20);
            Assert.Empty(simulator.ArbiterList);
            Body again = pool.Fetch();
            Assert.Same(bullet.Body, again);
            Assert.False(again.IsDisposed);
            again.ResetDynamics();
            again.Position = new Vector2(shot * 30, -15);
            again.Enabled = true;
            Run(simulator, 100);
            Assert.Single(simulator.ArbiterList);
            Assert.InRange(again.Position.Y, -10.1f, -9.9f);
        }
    }

    [Fact]
    [ManualRow("F292")]
    public void PassingByReference_GivesTheSameAsByValue_AndLeavesTheArgumentAlone()
    {
        Body byValue = Turned();
        Body byReference = Turned();
        var amount = new Vector2(3, -4);
        var point = new Vector2(2, 5);
        byValue.ApplyForce(amount);
        byReference.ApplyForce(ref amount);
        byValue.ApplyForceAtLocalPoint(amount, point);
        byReference.ApplyForceAtLocalPoint(ref amount, ref point);
        byValue.ApplyForceAtWorldPoint(amount, point);
        byReference.ApplyForceAtWorldPoint(ref amount, ref point);
        Assert.Equal(byValue.Force, byReference.Force);
        Assert.Equal(byValue.Torque, byReference.Torque);
        byReference.GetWorldPosition(ref point, out Vector2 world);
        Assert.Equal(byValue.GetWorldPosition(point), world);
        byReference.GetBodyMatrix(out Matrix4x4 matrix);
        Assert.Equal(byValue.GetBodyMatrix(), matrix);
        Assert.Equal(new Vector2(3, -4), amount);
        Assert.Equal(new Vector2(2, 5), point);
    }

    [Fact]
    [ManualRow("F293")]
    public void ApplyForce_ByReferenceInALoop_AddsUpOver100Calls()
    {
        var simulator = new PhysicsSimulator();
        Body body = BodyFactory.Instance.CreateBody(simulator, 2, 1);
        body.LinearDragCoefficient = 0;
        simulator.Update(Step);
        var force = new Vector2(1, -0.5f);
        for (int i = 0; i < 100; i++)
        {
            body.ApplyForce(ref force);
        }

        Assert.Equal(new Vector2(100, -50), body.Force);
        simulator.Update(Step);
        Assert.Equal(0.5f, body.LinearVelocity.X, 5);
        Assert.Equal(-0.25f, body.LinearVelocity.Y, 5);
    }

    [Fact]
    [ManualRow("F298")]
    public void CircleCircle_IsExact_WhateverTheNumberOfEdges()
    {
        foreach (int edges in new[] { 3, 4, 32 })
        {
            var simulator = new PhysicsSimulator { AllowedPenetration = 0 };
            Geom a = Ball(simulator, new Vector2(0, 0), 10);
            Body other = BodyFactory.Instance.CreateCircleBody(simulator, 10, 1);
            other.Position = new Vector2(12, 15);
            Geom b = GeomFactory.Instance.CreateCircleGeom(simulator, other, 10, edges);
            Contact contact = default!;
            a.OnCollision += (_, _, contacts) =>
            {
                contact = Assert.Single(contacts);
                return true;
            };
            simulator.Update(Step);

            // The true circles: 20 - |(12, 15)| deep, along the line of centres.
            float distance = new Vector2(12, 15).Length();
            Assert.Equal(distance - 20, contact.Separation, 3);
            Assert.Equal(12 / distance, contact.Normal.X, 4);
            Assert.Equal(15 / distance, contact.Normal.Y, 4);
            Assert.Equal(edges, b.LocalVertices.Count);
            Run(simulator, 100);
            Assert.Equal(20, Vector2.Distance(a.Position, b.Position), 1);
        }
    }

    /// <summary>Hills of 100 in height over 1000 in width: a bottom at each even hundred, a top at each odd one.</summary>
    private static PhysicsSimulator Landscape(int chunks)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        Body ground = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        ground.IsStatic = true;
        float width = 1000f / chunks;
        int points = 500 / chunks;
        for (int c = 0; c < chunks; c++)
        {
            var outline = new Vertices { new Vector2(c * width, 200), new Vector2((c + 1) * width, 200) };
            for (int i = points; i >= 0; i--)
            {
                float x = (c * width) + (width * i / points);
                outline.Add(new Vector2(x, 100 + (50 * MathF.Cos(x * MathF.PI / 100))));
            }

            simulator.Add(new Geom(ground, outline, 0));
        }

        return simulator;
    }

    private static int BallsPairedOver(PhysicsSimulator simulator)
    {
        var paired = new HashSet<Geom>();
        simulator.BroadPhaseCollider.OnBroadPhaseCollision += (_, ball) => paired.Add(ball) || true;
        for (int i = 0; i < 20; i++)
        {
            Ball(simulator, new Vector2(25 + (i * 50), 50), 10);
        }

        simulator.Update(Step);
        return paired.Count;
    }

    private static float DropIntoValley(PhysicsSimulator simulator)
    {
        // There is no friction: it swings about the bottom for two seconds, until the corners of the outline have stopped it.
        Geom ball = Ball(simulator, new Vector2(400, 100), 10);
        Run(simulator, 400);
        Assert.InRange(ball.Body.LinearVelocity.Length(), 0, 0.01f);
        Assert.Equal(400, ball.Body.Position.X, 1);
        return ball.Body.Position.Y;
    }

    private static Body Turned() => new Body { Position = new Vector2(7, 8), Rotation = 0.7f };
}
