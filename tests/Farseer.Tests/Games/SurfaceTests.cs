using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Games;

/// <summary>Belts, rolling, one-way platforms, materials. In metres, y up.</summary>
public sealed class SurfaceTests
{
    private const float Step = 1f / 60;

    [Fact]
    public void SurfaceSpeed_CarriesABoxAlong_AtTheRateOfFriction()
    {
        PhysicsSimulator simulator = Simulator();
        Geom belt = Floor(simulator, 0.5f);
        belt.SurfaceSpeed = 2;
        Geom box = Box(simulator, 0, 0.5f, 0.5f);
        Run(simulator, 12);

        // μ·g = 5 m/s² for 0.2 s, then 2 m/s; a substep more or less.
        Assert.Equal(1, box.Body.LinearVelocity.X, 0.03f);
        Run(simulator, 60);
        Assert.Equal(2, box.Body.LinearVelocity.X, 1e-4f);
        Assert.Equal(0, box.Body.AngularVelocity, 1e-3f);
        belt.SurfaceSpeed = -1;
        Run(simulator, 120);
        Assert.Equal(-1, box.Body.LinearVelocity.X, 1e-4f);
        belt.SurfaceSpeed = 0;
        Run(simulator, 60);
        Assert.Equal(0, box.Body.LinearVelocity.X, 1e-4f);
    }

    [Fact]
    public void SurfaceSpeed_GoesRoundTheOutline_AndDrivesItsBodyBack()
    {
        PhysicsSimulator simulator = Simulator();
        simulator.Gravity = Vector2.Zero;
        Geom belt = Box(simulator, 0, 0, 0.5f, 4, 1, 1);
        belt.SurfaceSpeed = 1;
        Geom above = Box(simulator, 0, 1, 0.5f);
        Geom below = Box(simulator, 0, -1, 0.5f);
        for (int i = 0; i < 30; i++)
        {
            above.Body.ApplyForce(new Vector2(0, -10));
            below.Body.ApplyForce(new Vector2(0, 10));
            simulator.Update(Step);
        }

        Assert.InRange(above.Body.LinearVelocity.X, 0.3f, 1.1f);
        Assert.InRange(below.Body.LinearVelocity.X, -1.1f, -0.3f);
        Assert.Equal(0, above.Body.LinearVelocity.X + below.Body.LinearVelocity.X + belt.Body.LinearVelocity.X, 1e-3f);
    }

    [Fact]
    public void RollingResistance_SlowsABall_AndHoldsItOnASlope()
    {
        PhysicsSimulator simulator = Simulator();
        Floor(simulator, 1);
        Geom ball = Ball(simulator, 0, 0.5f, 1);
        ball.RollingResistance = 0.1f;
        ball.Body.LinearVelocity = new Vector2(3, 0);
        ball.Body.AngularVelocity = -6;
        Run(simulator, 60);

        // The load at the arm c·r stops a disc of ½mr² that rolls: a = c·g / (1 + ½) = 0.667 m/s².
        Assert.Equal(3 - 0.6667f, ball.Body.LinearVelocity.X, 0.02f);
        Run(simulator, 300);
        Assert.Equal(0, ball.Body.LinearVelocity.X, 1e-4f);

        // Slopes of the tangents 0.08 and 0.12.
        Assert.Equal(0, Slide(0.08f), 1e-3f);
        Assert.InRange(Slide(0.12f), 0.1f, 1);

        static float Slide(float tangent)
        {
            PhysicsSimulator slope = Simulator();
            slope.Gravity = new Vector2(10 * tangent, -10);
            Floor(slope, 1);
            Geom rests = Ball(slope, 0, 0.5f, 1);
            rests.RollingResistance = 0.1f;
            Run(slope, 120);
            return rests.Body.LinearVelocity.X;
        }
    }

    [Fact]
    public void SurfacesOfTheirOwn_KeepMomentumAndBits_AtAnyNumberOfWorkers()
    {
        Assert.Equal(Heap(1), Heap(4));

        static double[] Heap(int workers)
        {
            using PhysicsSimulator simulator = Simulator();
            simulator.WorkerCount = workers;
            Floor(simulator, 0.5f).SurfaceSpeed = 1;
            var bodies = new List<Body>();
            for (int i = 0; i < 60; i++)
            {
                Geom geom = i % 2 == 0 ? Box(simulator, (i % 6) - 3, 1 + (i / 6), 0.5f) : Ball(simulator, (i % 6) - 3, 1 + (i / 6), 0.5f);
                geom.RollingResistance = i % 3 == 0 ? 0.05f : 0;
                bodies.Add(geom.Body);
            }

            Run(simulator, 120);
            return bodies.SelectMany(b => new[] { b.PositionX, b.PositionY, b.TotalRotation }).ToArray();
        }
    }

    [Fact]
    public void MixingRules_TakeTheCoefficientsTogether()
    {
        foreach ((FrictionType rule, float mixed) in new[]
        {
            (FrictionType.Average, 0.5f), (FrictionType.Minimum, 0.1f), (FrictionType.Maximum, 0.9f), (FrictionType.GeometricMean, 0.3f),
            (FrictionType.Product, 0.09f),
        })
        {
            Assert.Equal(mixed, SlidingFriction(s => s.FrictionType = rule), 2e-3f);
        }

        foreach ((RestitutionType rule, float mixed) in new[]
        {
            (RestitutionType.Average, 0.5f), (RestitutionType.Minimum, 0.2f), (RestitutionType.Maximum, 0.8f),
            (RestitutionType.Product, 0.16f),
        })
        {
            Assert.Equal(mixed, Bounce(s => s.RestitutionType = rule), 2e-3f);
        }
    }

    [Fact]
    public void MixMaterials_SaysWhatAPairIs()
    {
        float friction = SlidingFriction(s => s.MixMaterials = (Geom _, Geom _, ref SurfaceMaterial m) =>
        {
            Assert.Equal(0.5f, m.Friction);
            m.Friction = 0.25f;
        });
        Assert.Equal(0.25f, friction, 2e-3f);
        float bounce = Bounce(s => s.MixMaterials = (Geom older, Geom newer, ref SurfaceMaterial m) =>
        {
            Assert.True(older < newer);
            m.Restitution = 0.75f;
        });
        Assert.Equal(0.75f, bounce, 2e-3f);
        PhysicsSimulator simulator = Simulator();
        Floor(simulator, 0.5f);
        Box(simulator, 0, 0.5f, 0.5f);
        simulator.MixMaterials = (Geom _, Geom _, ref SurfaceMaterial _) => throw new TimeoutException();
        Assert.Throws<TimeoutException>(() => Run(simulator, 2));
        Assert.Throws<ArgumentOutOfRangeException>("Friction", () => new SurfaceMaterial { Friction = -1 });
    }

    [Fact]
    public void SegmentMaterials_HoldOnTheirSegments()
    {
        PhysicsSimulator simulator = Simulator();
        var ground = new Body { IsStatic = true };
        var points = new Vertices { new Vector2(30, 0), new Vector2(10, 0), new Vector2(0, 0), new Vector2(-30, 0) };
        Geom chain = GeomFactory.Instance.CreateChainGeom(simulator, ground, points, false);
        chain.FrictionCoefficient = 0.5f;
        chain.SetSegmentMaterial(1, new SurfaceMaterial { Friction = 0 });
        chain.SetSegmentMaterial(0, new SurfaceMaterial { Friction = 0.5f, Speed = 3 });
        Geom box = Box(simulator, -6, 0.5f, 0.5f);
        box.Body.LinearVelocity = new Vector2(8, 0);
        simulator.FrictionType = FrictionType.Minimum;
        while (box.Body.PositionX < 0.6f)
        {
            simulator.Update(Step);
        }

        // On ice nothing slows it, before it was 5 m/s².
        float enters = box.Body.LinearVelocity.X;
        Assert.InRange(enters, 1, 5);
        while (box.Body.PositionX < 9.2f)
        {
            simulator.Update(Step);
            Assert.Equal(enters, box.Body.LinearVelocity.X, 1e-3f);
        }

        Run(simulator, 120);
        Assert.Equal(3, box.Body.LinearVelocity.X, 1e-3f);
        Assert.Equal(3, chain.SegmentCount);
        Assert.Equal(0.5f, chain.GetSegmentMaterial(2).Friction);
        Assert.Throws<ArgumentOutOfRangeException>("segment", () => chain.SetSegmentMaterial(3, default));
    }

    [Theory]
    [InlineData(5, true)]
    [InlineData(200, true)]
    [InlineData(5, false)]
    public void OneWayPlatform_HoldsFromAbove_AndLetsThroughFromBelow(float speed, bool rises)
    {
        PhysicsSimulator simulator = Simulator();
        simulator.Gravity = Vector2.Zero;
        Geom platform = Box(simulator, 0, 0, 0.5f, 6, 0.4f);
        platform.Body.IsStatic = true;
        platform.OneWayDirection = new Vector2(0, 1);
        Geom box = Box(simulator, 0, rises ? -2 : 2, 0);
        box.Body.LinearVelocity = new Vector2(0, rises ? speed : -speed);
        Run(simulator, 60);
        if (rises)
        {
            Assert.Equal(-2 + speed, box.Body.PositionY, 1e-2 * speed);
            Assert.Equal(speed, box.Body.LinearVelocity.Y, 1e-3f);
        }
        else
        {
            Assert.Equal(0.7, box.Body.PositionY, 0.06);
        }
    }

    [Fact]
    public void OneWayPlatform_LetsAJumpThroughAndCatchesIt()
    {
        PhysicsSimulator simulator = Simulator();
        Geom platform = Box(simulator, 0, 0, 0.5f, 6, 0.2f);
        platform.Body.IsStatic = true;
        platform.OneWayDirection = new Vector2(0, 1);
        Geom box = Box(simulator, 0, -1.5f, 0.5f);

        // As high as 1.6 + 1.5: over it by 0.6.
        box.Body.LinearVelocity = new Vector2(0, 7.9f);
        Run(simulator, 200);
        Assert.Equal(0.6, box.Body.PositionY, 0.06);
        Assert.Equal(0, box.Body.LinearVelocity.Y, 1e-2f);

        // One that comes only half way up falls down again.
        Geom low = Box(simulator, 2, -1.5f, 0.5f);
        low.Body.LinearVelocity = new Vector2(0, 5.5f);
        Run(simulator, 200);
        Assert.True(low.Body.PositionY < -5);
    }

    [Fact]
    public void OneWayPlatform_LetsThroughFromTheSide()
    {
        PhysicsSimulator simulator = Simulator();
        simulator.Gravity = Vector2.Zero;
        Geom platform = Box(simulator, 0, 0, 0.5f, 2, 0.4f);
        platform.Body.IsStatic = true;
        platform.OneWayDirection = new Vector2(0, 1);
        Geom box = Box(simulator, -4, 0.1f, 0);
        box.Body.LinearVelocity = new Vector2(6, 0);
        Run(simulator, 120);
        Assert.Equal(8, box.Body.PositionX, 0.01);
    }

    private static PhysicsSimulator Simulator() => new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = 0.01f };

    private static Geom Floor(PhysicsSimulator simulator, float friction)
    {
        Geom floor = Box(simulator, 0, -1, friction, 400, 2);
        floor.Body.IsStatic = true;
        return floor;
    }

    private static Geom Box(PhysicsSimulator simulator, float x, float y, float friction, float width = 1, float height = 1, float mass = 1)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, mass);
        return Finish(body, GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height), x, y, friction);
    }

    private static Geom Ball(PhysicsSimulator simulator, float x, float y, float friction)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, 1);
        return Finish(body, GeomFactory.Instance.CreateCircleGeom(simulator, body, 0.5f, 16), x, y, friction);
    }

    private static Geom Finish(Body body, Geom geom, float x, float y, float friction)
    {
        body.Position = new Vector2(x, y);
        Sandbox.WithoutDrag(body);
        geom.FrictionCoefficient = friction;
        return geom;
    }

    private static void Run(PhysicsSimulator simulator, int steps) => Sandbox.Run(simulator, steps, Step);

    /// <summary>What 0.1 and 0.9 come to, by how a box slows down.</summary>
    private static float SlidingFriction(Action<PhysicsSimulator> set)
    {
        PhysicsSimulator simulator = Simulator();
        simulator.AllowedPenetration = 0;
        set(simulator);
        Floor(simulator, 0.1f);
        Geom box = Box(simulator, 0, 0.5f, 0.9f);
        Run(simulator, 30);
        box.Body.LinearVelocity = new Vector2(20, 0);
        Run(simulator, 60);
        return (20 - box.Body.LinearVelocity.X) / 10;
    }

    /// <summary>What 0.2 and 0.8 come to, by how a ball comes back.</summary>
    private static float Bounce(Action<PhysicsSimulator> set)
    {
        PhysicsSimulator simulator = Simulator();
        simulator.Gravity = Vector2.Zero;
        set(simulator);
        Floor(simulator, 0).RestitutionCoefficient = 0.2f;
        Geom ball = Ball(simulator, 0, 2, 0);
        ball.RestitutionCoefficient = 0.8f;
        ball.Body.LinearVelocity = new Vector2(0, -5);
        Run(simulator, 60);
        return ball.Body.LinearVelocity.Y / 5;
    }
}
