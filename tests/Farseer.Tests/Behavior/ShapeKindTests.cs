using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Circles, capsules, chains and kinematic bodies.</summary>
public class ShapeKindTests
{
    [Theory]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(64)]
    [ManualRow("F046")]
    public void Circle_OfAnyEdges_KeepsThemForQueriesAndRollsAsATrueCircle(int edges)
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Sandbox.Floor(simulator).FrictionCoefficient = 1;
        Geom geom = Sandbox.Ball(simulator, new Vector2(-100, -10), 10, 1, edges);
        geom.FrictionCoefficient = 1;
        geom.Body.LinearVelocity = new Vector2(60, 0);
        geom.Body.AngularVelocity = 6;
        Assert.Equal(edges, geom.LocalVertices.Count);
        for (int i = 0; i < 200; i++)
        {
            simulator.Update(Sandbox.Step);
            Assert.InRange(geom.Body.Position.Y, -10.01f, -9.9f);
        }

        // Rolling without slipping costs nothing: v = w r throughout, where r is shorter by up to the resting depth of 0.05, half a
        // percent.
        Assert.Equal(60, geom.Body.LinearVelocity.X, 0.1f);
        Assert.InRange(geom.Body.AngularVelocity, 5.999f, 6.03f);
        Assert.Equal(20, geom.Body.Position.X, 0.5f);
        Assert.Equal(edges, geom.WorldVertices.Count);
        Assert.Equal(20, geom.AABB.Width, 1e-3f);

        // The query goes by the edges: the middle of an edge is r cos(pi/n) from the centre.
        float apothem = 10 * MathF.Cos(MathF.PI / edges);
        var middle = (geom.LocalVertices[0] + geom.LocalVertices[1]) / 2;
        Assert.Equal(apothem, middle.Length(), 1e-3f);
        Assert.True(geom.Collide(geom.GetWorldPosition(middle * 0.99f)));
        Assert.False(geom.Collide(geom.GetWorldPosition(middle * (1 + (0.01f / apothem)))));
    }

    [Theory]
    [InlineData(0f, 5)]
    [InlineData(MathF.PI / 2, 25)]
    public void Capsule_LyingOrStanding_IsRoundAtItsEnds(float rotation, float height)
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Sandbox.Floor(simulator);
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 50, 10, 1);
        Geom geom = GeomFactory.Instance.CreateCapsuleGeom(simulator, body, new Vector2(-20, 0), new Vector2(20, 0), 5);
        body.Position = new Vector2(0, -height - 1);
        body.Rotation = rotation;
        Sandbox.Run(simulator, 40);
        Assert.Equal(-height, body.Position.Y, 0.1f);
        Assert.Equal(rotation == 0 ? 2 : 1, Assert.Single(simulator.ArbiterList).ContactList.Count);
        Assert.True(geom.Collide(geom.GetWorldPosition(new Vector2(24.9f, 0))));
        Assert.False(geom.Collide(geom.GetWorldPosition(new Vector2(24.9f, 4))));
    }

    [Theory]
    [InlineData(0f, 15)]
    [InlineData(MathF.PI / 2, 25)]
    [InlineData(-MathF.PI / 2, 25)]
    public void RoundedRectangle_LyingOrStanding_RestsOnARadiusMoreThanItsHeight(float rotation, float height)
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Sandbox.Floor(simulator);
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 50, 30, 1);
        Geom geom = GeomFactory.Instance.CreateRoundedRectangleGeom(simulator, body, 40, 20, 5);
        body.Position = new Vector2(0, -height - 1);
        body.Rotation = rotation;
        Sandbox.Run(simulator, 40);

        // The allowed penetration of the simulator is within it.
        Assert.Equal(-height, body.Position.Y, 0.1f);
        Assert.Equal(2, Assert.Single(simulator.ArbiterList).ContactList.Count);

        // 5 from the inner corner at (20, 10), on the diagonal: 3.54 each way.
        Assert.True(geom.Collide(geom.GetWorldPosition(new Vector2(23.3f, 13.3f))));
        Assert.False(geom.Collide(geom.GetWorldPosition(new Vector2(23.8f, 13.8f))));
        Assert.Equal(25, geom.LocalVertices.Max(v => v.X), 1e-4f);
        Assert.Equal(-15, geom.LocalVertices.Min(v => v.Y), 1e-4f);
    }

    [Fact]
    public void Chain_OfManySegments_HasNoSeams()
    {
        var simulator = Sandbox.Falling();
        var ground = new Body { IsStatic = true };
        simulator.Add(ground);
        var points = new Vertices();
        for (int i = 0; i <= 40; i++)
        {
            points.Add(new Vector2(10 * i, 0));
        }

        GeomFactory.Instance.CreateChainGeom(simulator, ground, points, false);
        Geom box = Sandbox.Box(simulator, new Vector2(20, -5), 10, 10);
        box.Body.LinearVelocity = new Vector2(100, 0);
        for (int i = 0; i < 300; i++)
        {
            simulator.Update(Sandbox.Step);
            Assert.InRange(box.Body.Position.Y, -5.02f, -4.9f);
        }

        // Without friction nothing slows it: a caught corner would.
        Assert.Equal(100, box.Body.LinearVelocity.X, 0.01f);
        Assert.InRange(Math.Abs(box.Body.TotalRotation), 0, 1e-3f);
    }

    [Fact]
    public void ChainLoop_InTheInwardOrder_KeepsABallInside_InTheOutwardOneLetsItOut()
    {
        foreach (bool inward in new[] { true, false })
        {
            PhysicsSimulator simulator = Sandbox.Falling();
            var ground = new Body { IsStatic = true };
            simulator.Add(ground);

            // From the x axis to the y axis a loop looks outwards.
            Vertices loop = Sandbox.Outline(-50, -50, 50, -50, 50, 50, -50, 50);
            if (inward)
            {
                loop.Reverse();
            }

            GeomFactory.Instance.CreateChainGeom(simulator, ground, loop, true).RestitutionCoefficient = 1;
            Geom ball = Sandbox.Ball(simulator, Vector2.Zero);
            ball.RestitutionCoefficient = 1;
            ball.Body.LinearVelocity = new Vector2(300, 130);
            bool stayed = true;
            for (int i = 0; i < 500; i++)
            {
                // Its centre has 45 of room, and in one step it may get as far into a wall as it moves in that step.
                simulator.Update(Sandbox.Step);
                float most = 45.1f + (Sandbox.Step * ball.Body.LinearVelocity.Length());
                stayed &= Math.Abs(ball.Body.Position.X) < most && Math.Abs(ball.Body.Position.Y) < most;
            }

            Assert.Equal(inward, stayed);
        }
    }

    [Fact]
    public void Kinematic_HeedsNoForceAndPushesEverything()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Sandbox.Floor(simulator);
        Geom ram = Sandbox.Box(simulator, new Vector2(-50, -11));
        ram.Body.IsKinematic = true;
        ram.Body.LinearVelocity = new Vector2(30, 0);
        Geom heavy = Sandbox.Box(simulator, new Vector2(0, -10), mass: 1000);
        ram.Body.ApplyForce(new Vector2(0, -1e6f));
        ram.Body.ApplyImpulse(new Vector2(0, -1e6f));
        ram.Body.ApplyTorque(1e6f);
        Sandbox.Run(simulator, 200);
        Assert.Equal(10, ram.Body.Position.X, 1e-3f);
        Assert.Equal(-11, ram.Body.Position.Y);
        Assert.Equal(0, ram.Body.TotalRotation);
        Assert.Equal(new Vector2(30, 0), ram.Body.LinearVelocity);
        Assert.InRange(heavy.Body.Position.X, 29.9f, 40);
        Assert.True(heavy.Body.LinearVelocity.X >= 29.9f);

        // Stopped, it stands like a wall; turned back, it is an ordinary body and falls the 1 it is above the floor.
        ram.Body.LinearVelocity = Vector2.Zero;
        Sandbox.Run(simulator, 10);
        Assert.Equal(10, ram.Body.Position.X, 1e-3f);
        ram.Body.IsKinematic = false;
        Sandbox.Run(simulator, 100);
        Assert.Equal(-10, ram.Body.Position.Y, 0.1f);
    }

    [Fact]
    public void Kinematic_Turning_SweepsTheBallAway()
    {
        var simulator = new PhysicsSimulator();
        Geom bat = Sandbox.Box(simulator, Vector2.Zero, 100, 10);
        bat.Body.IsKinematic = true;
        bat.Body.AngularVelocity = MathF.PI / 2;
        Geom ball = Sandbox.Ball(simulator, new Vector2(40, 20));
        Sandbox.Run(simulator, 100);
        Assert.Equal(MathF.PI / 2, bat.Body.TotalRotation, 1e-3f);
        Assert.Equal(Vector2.Zero, bat.Body.Position);

        // Struck 40 from the axis, where the bat moves at 63, it slides out to the tip at 50 at most: there the bat moves at 79,
        // and a frictionless slide from 40 has gained w sqrt(50² - 40²) = 47 outwards; sqrt(79² + 47²) = 92.
        Assert.InRange(ball.Body.LinearVelocity.Length(), 62, 92);
        Assert.True(ball.Body.LinearVelocity.Y > 50);
    }
}
