using System;
using System.Collections.Generic;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>Numbers beyond what the engine can hold, and things that are gone or missing: refused by name, or without effect.</summary>
public sealed class BadInputTests
{
    [Theory]
    [InlineData(1e-45f)]
    [InlineData(1e-30f)]
    [InlineData(1e19f)]
    [InlineData(float.MaxValue)]
    public void Size_BeyondTheEngine_IsRefusedByName(float size)
    {
        b2World world = Bench.World();
        b2Body body = Bench.Dynamic(world, 0, 0);
        Assert.Throws<ArgumentOutOfRangeException>("radius", () => body.CreateShape(new b2CircleDef { radius = size }));
        Assert.Throws<ArgumentOutOfRangeException>("hx", () => new b2PolygonDef().SetAsBox(size, 1));
        Assert.Throws<ArgumentOutOfRangeException>("hy", () => new b2PolygonDef().SetAsOrientedBox(1, size));
        Assert.Null(body.GetShapeList()!.GetNext());
    }

    [Theory]
    [InlineData(1e-45f)]
    [InlineData(1e-40f)]
    public void Mass_WithoutAnInverse_IsRefusedByName(float value)
    {
        b2World world = Bench.World();
        b2Body body = Bench.Dynamic(world, 0, 0);
        Assert.Throws<ArgumentOutOfRangeException>("mass", () => body.SetMass(new b2MassData { mass = value, I = 1 }));
        Assert.Throws<ArgumentOutOfRangeException>("I", () => body.SetMass(new b2MassData { mass = 1, I = value }));
        Assert.Throws<ArgumentOutOfRangeException>(
            "mass", () => world.CreateBody(new b2BodyDef { massData = new b2MassData { mass = value } }));
        Assert.Equal(1, body.GetMass());
        Assert.Equal(2, world.GetBodyCount());
    }

    /// <summary>A mass that is no float, too large or too small, or an inertia that is none.</summary>
    [Theory]
    [InlineData(1, 3e38f)]
    [InlineData(1e18f, 10)]
    [InlineData(1e-18f, 1e-5f)]
    [InlineData(1e-10f, 1)]
    public void SetMassFromShapes_OfAMassBeyondFloats_IsRefused_AndChangesNothing(float radius, float density)
    {
        b2World world = Bench.World();
        b2Body body = world.CreateBody(new b2BodyDef { massData = new b2MassData { mass = 2, I = 3 } });
        body.CreateShape(new b2CircleDef { radius = radius, density = density });
        Assert.Contains("density", Assert.Throws<InvalidOperationException>(body.SetMassFromShapes).Message, StringComparison.Ordinal);
        Assert.Equal((2, 3), (body.GetMass(), body.GetInertia()));
    }

    [Theory]
    [InlineData(1e19f)]
    [InlineData(-float.MaxValue)]
    public void AngleAndSpin_BeyondTheEngine_AreRefusedByName(float value)
    {
        b2World world = Bench.World();
        b2Body body = Bench.Dynamic(world, 0, 0);
        Assert.Throws<ArgumentOutOfRangeException>("angle", () => body.SetXForm(new b2Vec2(1, 1), value));
        Assert.Throws<ArgumentOutOfRangeException>("omega", () => body.SetAngularVelocity(value));
        Assert.Throws<ArgumentOutOfRangeException>("angle", () => world.CreateBody(new b2BodyDef { angle = value }));
        Assert.Equal((0, 0, 0), (body.GetPosition().x, body.GetAngle(), body.GetAngularVelocity()));
    }

    [Fact]
    public void Body_WhoseSpeedLeavesTheEngine_IsFrozen_AndTheBoundaryListenerHearsOfIt()
    {
        b2World world = Bench.World();
        Boundary boundary = new();
        world.SetBoundaryListener(boundary);
        b2Body body = Bench.Dynamic(world, 1, 2);
        b2Body other = Bench.Dynamic(world, 5, 2);
        body.ApplyForce(new b2Vec2(0, 9e18f), body.GetWorldCenter());
        body.ApplyImpulse(new b2Vec2(9e18f, 0), body.GetWorldCenter());
        body.ApplyImpulse(new b2Vec2(9e18f, 0), body.GetWorldCenter());
        Bench.Step(world, 3);
        Assert.True(body.IsFrozen());
        Assert.Same(body, Assert.Single(boundary.Heard));
        Assert.Equal((1, 2, 0), (body.GetPosition().x, body.GetPosition().y, body.GetLinearVelocity().x));
        Assert.True(other.GetLinearVelocity().y < 0);
    }

    [Fact]
    public void DestroyedBodyAndJoint_AskedForAnything_ChangeNothing()
    {
        b2World world = Bench.World();
        b2Body dead = Bench.Dynamic(world, 0, 5);
        b2RevoluteJointDef def = new();
        def.Initialize(world.GetGroundBody(), dead, dead.GetPosition());
        var joint = (b2RevoluteJoint)world.CreateJoint(def);
        Bench.Step(world, 3);
        world.DestroyBody(dead);
        Bench.Dynamic(world, 0, 20);
        ulong before = world.MotionHash();
        dead.ApplyForce(new b2Vec2(1000, 0), new b2Vec2(0, 0));
        dead.ApplyTorque(10);
        dead.ApplyImpulse(new b2Vec2(5, 5), dead.GetWorldCenter());
        dead.SetLinearVelocity(new b2Vec2(50, 0));
        dead.SetAngularVelocity(5);
        dead.WakeUp();
        joint.SetMotorSpeed(5);
        joint.EnableMotor(true);
        joint.SetLimits(-1, 1);
        Assert.Equal(before, world.MotionHash());
    }

    [Fact]
    public void MissingCornersAndUnknownQuirks_AreRefusedByName()
    {
        b2World world = Bench.World();
        Assert.Throws<ArgumentNullException>("aabb", () => world.Query(new b2AABB { lowerBound = null! }, new b2Shape[1], 1));
        Assert.Throws<ArgumentNullException>("aabb", () => world.Query(new b2AABB { upperBound = null! }, new List<b2Shape>(), 1));
        Assert.Throws<ArgumentOutOfRangeException>("Quirks", () => world.Quirks = (Box2DFlash202Quirks)(1 << 30));
        Assert.Equal(Box2DFlash202Quirks.None, world.Quirks);
    }

    [Theory]
    [InlineData(false, true)]
    [InlineData(true, false)]
    public void TwoJoints_OfWhichOneForbidsCollision_ConnectTheirBodies(bool first, bool second)
    {
        b2World world = Bench.World(0);
        b2Body a = Bench.Dynamic(world, 0, 0);
        b2Body b = Bench.Dynamic(world, 0.8f, 0);
        foreach (bool collide in new[] { first, second })
        {
            b2DistanceJointDef def = new() { collideConnected = collide };
            def.Initialize(a, b, a.GetPosition(), b.GetPosition());
            world.CreateJoint(def);
        }

        Assert.True(a.IsConnected(b));
        Assert.True(b.IsConnected(a));
        Bench.Step(world, 1);
        Assert.Equal(0, world.GetContactCount());
    }

    private sealed class Boundary : b2BoundaryListener
    {
        public List<b2Body> Heard { get; } = [];

        public override void Violation(b2Body body) => Heard.Add(body);
    }
}
