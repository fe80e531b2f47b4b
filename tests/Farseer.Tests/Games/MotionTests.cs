using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Games;

/// <summary>How bodies may move, what pulls them, and what they are made of.</summary>
public sealed class MotionTests
{
    [Fact]
    public void FixedRotation_KeepsABodyFromTurning_AndGivesItsInertiaBack()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        Geom box = Box(simulator, new Vector2(0, -40), 10, 40);
        box.FrictionCoefficient = 1;
        float inertia = box.Body.MomentOfInertia;
        box.Body.AngularVelocity = 3;
        box.Body.FixedRotation = true;
        Assert.Equal(0, box.Body.AngularVelocity);
        Assert.Equal(0, box.Body.InverseMomentOfInertia);
        Assert.Equal(inertia, box.Body.MomentOfInertia);
        box.Body.LinearVelocity = new Vector2(60, 0);
        box.Body.ApplyTorque(1000);
        Run(simulator, 200);
        Assert.Equal(0, box.Body.TotalRotation);
        Assert.Equal(0, box.Body.LinearVelocity.X, 1e-3f);
        box.Body.MomentOfInertia = 2 * inertia;
        box.Body.FixedRotation = false;
        Assert.Equal(2 * inertia, box.Body.MomentOfInertia);
        Assert.Equal(1 / (2 * inertia), box.Body.InverseMomentOfInertia);
        box.Body.ApplyTorque(10000);
        Run(simulator, 1);
        Assert.NotEqual(0, box.Body.AngularVelocity);
    }

    [Theory]
    [InlineData(MotionLocks.X)]
    [InlineData(MotionLocks.Y)]
    [InlineData(MotionLocks.X | MotionLocks.Y)]
    public void MotionLocks_HoldTheirAxis_AndLeaveTheOtherFree(MotionLocks locks)
    {
        PhysicsSimulator simulator = Falling();
        Body body = Box(simulator, new Vector2(30, 40)).Body;
        body.MotionLocks = locks;
        body.LinearVelocity = new Vector2(50, 0);
        body.AngularVelocity = 2;
        Run(simulator, 100);
        bool x = (locks & MotionLocks.X) != 0;
        bool y = (locks & MotionLocks.Y) != 0;
        Assert.Equal(x ? 30 : 80, body.PositionX, 1e-3);
        Assert.Equal(y ? 40 : 90, body.PositionY, 1e-2);
        Assert.Equal(2, body.TotalRotation, 1e-3f);

        // Put elsewhere, it keeps to where it was put; let go, it falls.
        body.Position = new Vector2(-5, -6);
        body.LinearVelocity = new Vector2(50, 0);
        Run(simulator, 50);
        Assert.Equal(x ? -5 : 20, body.PositionX, 1e-3);
        body.MotionLocks = MotionLocks.None;
        body.LinearVelocity = Vector2.Zero;
        double before = body.PositionY;
        Run(simulator, 100);
        Assert.Equal(50, body.PositionY - before, 0.6);
        Assert.Throws<ArgumentOutOfRangeException>(() => body.MotionLocks = (MotionLocks)64);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(2.5f)]
    [InlineData(-1)]
    public void GravityScale_FallsThatMuch_Exactly(float scale)
    {
        PhysicsSimulator simulator = Falling();
        Body body = Ball(simulator, Vector2.Zero, mass: 7).Body;
        body.GravityScale = scale;
        Run(simulator, 100);
        Assert.Equal(scale * 50, body.PositionY, 1e-3);
        Assert.Equal(scale * 100, body.LinearVelocity.Y, 1e-3f);
        body.GravityScale = 1;
        Run(simulator, 10);
        Assert.Equal((scale * 100) + 10, body.LinearVelocity.Y, 1e-3f);
    }

    [Fact]
    public void GravityScale_RestsWithItsOwnWeight()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        simulator.SumImpulses = true;
        Body body = Box(simulator, new Vector2(0, -10), mass: 2).Body;
        body.GravityScale = 3;
        Run(simulator, 200);
        float sum = simulator.ArbiterList.SelectMany(a => a.ContactList).Sum(c => c.NormalImpulse);
        Assert.Equal(2 * 3 * 100 * Step, sum, 6e-4f);
    }

    [Fact]
    public void ImpulseAtAPoint_PushesAndTurns()
    {
        PhysicsSimulator simulator = Falling(0);
        Body body = Box(simulator, new Vector2(100, 50), mass: 4).Body;
        body.Rotation = MathF.PI / 2;
        simulator.Update(Step);
        body.ApplyImpulseAtWorldPoint(new Vector2(8, 0), new Vector2(100, 45));
        body.ApplyImpulseAtLocalPoint(new Vector2(0, 12), new Vector2(0, 10));
        simulator.Update(Step);
        Assert.Equal(2, body.LinearVelocity.X, 1e-5f);
        Assert.Equal(3, body.LinearVelocity.Y, 1e-5f);

        // (0, -5) × (8, 0) = 40; the local (0, 10) is (-10, 0) in the world: (-10, 0) × (0, 12) = -120.
        Assert.Equal((40f - 120) / body.MomentOfInertia, body.AngularVelocity, 1e-5f);
        body.ApplyImpulseAtWorldPoint(new Vector2(8, 0), Vector2.Zero);
        body.ClearImpulse();
        simulator.Update(Step);
        Assert.Equal(2, body.LinearVelocity.X, 1e-5f);
    }

    [Fact]
    public void MoveTo_BringsAKinematicBodyThere_WithWhatStandsOnIt()
    {
        PhysicsSimulator simulator = Falling();
        Geom lift = Box(simulator, new Vector2(0, 10), 100, 20);
        lift.Body.IsKinematic = true;
        lift.FrictionCoefficient = 1;
        Geom box = Box(simulator, new Vector2(0, -10));
        box.FrictionCoefficient = 1;
        Run(simulator, 10);
        for (int i = 1; i <= 200; i++)
        {
            var place = new Vector2(0.2f * i, 10 - (0.1f * i));
            lift.Body.MoveTo(place, Step);
            simulator.Update(Step);
            Assert.Equal(place.X, lift.Body.PositionX, 1e-4);
            Assert.Equal(place.Y, lift.Body.PositionY, 1e-4);
        }

        Assert.Equal(40, box.Body.PositionX, 0.5);
        Assert.Equal(-30, box.Body.PositionY, 0.1);
        lift.Body.MoveTo(lift.Body.Position, 0.5, Step);
        simulator.Update(Step);
        Assert.Equal(0.5f, lift.Body.TotalRotation, 1e-5f);
        Assert.Throws<InvalidOperationException>(() => box.Body.MoveTo(Vector2.Zero, Step));
    }

    [Fact]
    public void SetDensity_AgreesWithTheBodyFactory()
    {
        foreach (Action<Body> shape in new Action<Body>[]
        {
            b => GeomFactory.Instance.CreateRectangleGeom(b, 3, 4),
            b => GeomFactory.Instance.CreateCircleGeom(b, 2, 16),
            b => GeomFactory.Instance.CreateCapsuleGeom(b, new Vector2(-2, 0), new Vector2(2, 0), 1.5f),
            b => GeomFactory.Instance.CreateRoundedRectangleGeom(b, 3, 4, 0.5f),
            b => GeomFactory.Instance.CreatePolygonGeom(b, Outline(-1, -1, 3, -1, 3, 2, -1, 2), 0),
        })
        {
            var body = new Body();
            shape(body);
            body.SetDensity(2);
            Geom geom = body.Geoms[0];
            Body made = geom.LocalVertices.Count == 16 && geom.AABB.Width < 3.1f ? BodyFactory.Instance.CreateRectangleBody(3, 4, body.Mass)
                : geom.AABB.Width > 6 ? BodyFactory.Instance.CreateCapsuleBody(4, 1.5f, body.Mass)
                : geom.AABB.Height > 4.5f ? BodyFactory.Instance.CreateRoundedRectangleBody(3, 4, 0.5f, body.Mass)
                : geom.LocalVertices.Count == 4 ? BodyFactory.Instance.CreateRectangleBody(4, 3, body.Mass)
                : BodyFactory.Instance.CreateCircleBody(2, body.Mass);
            Assert.Equal(made.MomentOfInertia, body.MomentOfInertia, made.MomentOfInertia * 1e-5f);
            Assert.InRange(body.Mass, 23.9f, 50);
        }

        var capsule = BodyFactory.Instance.CreateCapsuleBody(4, 1.5f, 1);

        // A sum over strips of the same shape, 10⁻³ wide.
        double area = 0;
        double inertia = 0;
        for (double x = -3.4995; x < 3.5; x += 0.001)
        {
            double over = Math.Max(0, Math.Abs(x) - 2);
            double half = Math.Sqrt((1.5 * 1.5) - (over * over));
            area += 2 * half * 0.001;
            inertia += ((2 * half * x * x) + (2 * half * half * half / 3)) * 0.001;
        }

        Assert.Equal(inertia / area, capsule.MomentOfInertia, 1e-3);
        Assert.Throws<InvalidOperationException>(() => new Body().SetDensity(1));
    }

    [Fact]
    public void JointFactory_HasAMethodForEachKindOfJoint()
    {
        List<string> kinds = [.. typeof(Joint).Assembly.GetExportedTypes().Where(t => t.IsSubclassOf(typeof(Joint)) && !t.IsAbstract)
            .Select(t => t.Name)];
        foreach (string kind in kinds)
        {
            System.Reflection.MethodInfo[] makers = [.. typeof(JointFactory).GetMethods().Where(m => m.Name == "Create" + kind)];
            Assert.Contains(makers, m => m.GetParameters()[0].ParameterType == typeof(PhysicsSimulator));
            Assert.Contains(makers, m => m.GetParameters()[0].ParameterType == typeof(Body));
        }

        Assert.Equal(18, kinds.Count);
    }

    [Fact]
    public void ContactsOfABodyAndOfASensor_AreListed()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        Geom box = Box(simulator, new Vector2(0, -10));
        Geom top = Box(simulator, new Vector2(0, -30));
        Geom zone = Box(simulator, new Vector2(0, -20), 200, 200);
        zone.IsSensor = true;
        zone.Body.IsStatic = true;
        Run(simulator, 20);
        var arbiters = new List<Arbiter>();
        Assert.Equal(3, box.Body.GetContacts(arbiters));
        Assert.Contains(arbiters, a => ReferenceEquals(a.GeomA, floor) && a.ContactList[0].NormalImpulse > 0);
        var inside = new List<Geom>();
        Assert.Equal(2, zone.GetTouching(inside));
        Assert.Equal(new[] { box, top }, inside);
        simulator.Remove(top);
        Assert.Equal(1, zone.GetTouching(inside));
        Assert.Equal(0, new Body().GetContacts(arbiters));
    }
}
