using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Api;

/// <summary>The chapter "Impulses". Bodies have mass 4 and moment of inertia 8, and no drag.</summary>
public class ImpulseTests
{
    [Fact]
    [ManualRow("F267")]
    [ManualRow("F268")]
    public void CollisionResponse_AndManualImpulse_AddUpInOneScene()
    {
        var simulator = new PhysicsSimulator();
        Geom a = Ball(simulator, new Vector2(0, 0), 10);
        Geom b = Ball(simulator, new Vector2(40, 0), 10);
        a.RestitutionCoefficient = 1;
        b.RestitutionCoefficient = 1;
        a.Body.ApplyImpulse(new Vector2(50, 0));
        Run(simulator, 100);

        // Equal masses, central and elastic: the velocity given by hand goes over to the other ball, momentum stays.
        Assert.InRange(a.Body.LinearVelocity.X, -0.5f, 0.5f);
        Assert.InRange(b.Body.LinearVelocity.X, 49.5f, 50.5f);
        Assert.Equal(50, a.Body.LinearVelocity.X + b.Body.LinearVelocity.X, 3);
    }

    [Fact]
    [ManualRow("F268")]
    public void CollisionResponse_OfAnInelasticHit_SharesTheMomentum()
    {
        var simulator = new PhysicsSimulator();
        Geom a = Ball(simulator, new Vector2(0, 0), 10);
        Geom b = Ball(simulator, new Vector2(40, 0), 10);
        a.Body.Mass = 3;
        a.Body.LinearVelocity = new Vector2(40, 0);
        Run(simulator, 200);
        Assert.Equal(30, a.Body.LinearVelocity.X, 1);
        Assert.Equal(30, b.Body.LinearVelocity.X, 1);
        Assert.True(a.Body.Position.X + 19 < b.Body.Position.X);
    }

    [Fact]
    [ManualRow("F269")]
    [ManualRow("F270")]
    public void CollisionResponseEnabled_False_PassesThroughAllButRaisesEvents()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        Geom ghost = Box(simulator, new Vector2(0, -30));
        Geom solid = Box(simulator, new Vector2(100, -30));
        Assert.True(ghost.CollisionResponseEnabled);
        ghost.CollisionResponseEnabled = false;
        int touched = 0;
        int parted = 0;
        int ofFloor = 0;
        ghost.OnCollision += (_, _, _) => ++touched > 0;
        ghost.OnSeparation += (_, _) => parted++;
        floor.OnCollision += (_, b, _) => !ReferenceEquals(b, ghost) || ++ofFloor > 0;
        Run(simulator, 150);
        Assert.Equal(-30 + (50 * 1.5f * 1.5f), ghost.Body.Position.Y, 2);
        Assert.InRange(solid.Body.Position.Y, -10.1f, -9.9f);

        // Inside the floor from y = -10 to y = 30: from 0.632 s to 1.095 s.
        Assert.InRange(touched, 44, 50);
        Assert.Equal(touched, ofFloor);
        Assert.Equal(1, parted);
    }

    [Fact]
    [ManualRow("F271")]
    [ManualRow("F272")]
    public void ApplyForce_ByValueAndByReference_AcceleratesForOneStep()
    {
        PhysicsSimulator simulator = Free(out Body byValue);
        Body byReference = Add(simulator);
        var force = new Vector2(40, -20);
        byValue.ApplyForce(force);
        byReference.ApplyForce(ref force);
        Assert.Equal(new Vector2(40, -20), force);
        Assert.Equal(force, byValue.Force);
        Run(simulator, 1);
        Assert.Equal(Vector2.Zero, byValue.Force);
        Near(new Vector2(0.1f, -0.05f), byValue.LinearVelocity);
        Assert.Equal(byValue.LinearVelocity, byReference.LinearVelocity);
        Assert.Equal(0, byValue.AngularVelocity);
        Run(simulator, 1);
        Near(new Vector2(0.1f, -0.05f), byValue.LinearVelocity);
    }

    [Fact]
    [ManualRow("F273")]
    public void ApplyForceAtLocalPoint_OfATurnedBody_TurnsThePointButNotTheForce()
    {
        PhysicsSimulator simulator = Free(out Body byValue);
        Body byReference = Add(simulator);
        byValue.Rotation = MathF.PI / 2;
        byReference.Rotation = MathF.PI / 2;
        var force = new Vector2(40, 0);
        var point = new Vector2(2, 0);
        byValue.ApplyForceAtLocalPoint(force, point);
        byReference.ApplyForceAtLocalPoint(ref force, ref point);
        Assert.Equal(force, byValue.Force);

        // The point is at (0, 2) in world axes: torque = x·Fy - y·Fx = -80, on an inertia of 8.
        Assert.Equal(-80, byValue.Torque, 3);
        Run(simulator, 1);
        Near(new Vector2(0.1f, 0), byValue.LinearVelocity);
        Assert.Equal(-0.1f, byValue.AngularVelocity, 5);
        Assert.Equal(byValue.AngularVelocity, byReference.AngularVelocity);
    }

    [Fact]
    [ManualRow("F274")]
    public void ApplyForceAtWorldPoint_TurnsByTheLeverArm()
    {
        PhysicsSimulator simulator = Free(out Body byValue);
        Body byReference = Add(simulator);
        byValue.Position = new Vector2(100, 50);
        byReference.Position = new Vector2(100, 50);
        byValue.Rotation = 1;
        byReference.Rotation = 1;
        var force = new Vector2(40, 0);
        var point = new Vector2(100, 48);
        byValue.ApplyForceAtWorldPoint(force, point);
        byReference.ApplyForceAtWorldPoint(ref force, ref point);
        Assert.Equal(80, byValue.Torque, 3);
        Run(simulator, 1);
        Near(new Vector2(0.1f, 0), byValue.LinearVelocity);
        Assert.Equal(0.1f, byValue.AngularVelocity, 5);
        Assert.Equal(byValue.AngularVelocity, byReference.AngularVelocity);
    }

    [Fact]
    [ManualRow("F275")]
    public void ClearForce_DropsWhatWasGathered()
    {
        PhysicsSimulator simulator = Free(out Body body);
        body.ApplyForce(new Vector2(40, 0));
        body.ApplyForce(new Vector2(40, 7));
        Assert.Equal(new Vector2(80, 7), body.Force);
        body.ClearForce();
        Assert.Equal(Vector2.Zero, body.Force);
        Run(simulator, 2);
        Assert.Equal(Vector2.Zero, body.LinearVelocity);
    }

    [Fact]
    [ManualRow("F276")]
    public void ApplyImpulse_OfAJump_ChangesTheVelocityByJOverM()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        Geom box = Box(simulator, new Vector2(0, -10));
        Run(simulator, 50);
        box.Body.Mass = 4;
        box.Body.ApplyImpulse(new Vector2(0, -200));
        var more = new Vector2(8, 0);
        box.Body.ApplyImpulse(ref more);
        Assert.Equal(0, box.Body.LinearVelocity.X, 3);
        Run(simulator, 1);

        // -200 / 4 and one step of gravity; 8 / 4.
        Assert.Equal(-49, box.Body.LinearVelocity.Y, 1);
        Assert.Equal(2, box.Body.LinearVelocity.X, 3);

        // v² / 2g = 12.5 lengths up, at 0.5 s.
        Run(simulator, 49);
        Assert.Equal(-10 - 12.5f, box.Body.Position.Y, 0);
        Run(simulator, 100);
        Assert.InRange(box.Body.Position.Y, -10.1f, -9.9f);
    }

    [Fact]
    [ManualRow("F277")]
    public void ClearImpulse_DropsWhatWasStored()
    {
        PhysicsSimulator simulator = Free(out Body body);
        body.ApplyImpulse(new Vector2(40, 0));
        body.ClearImpulse();
        Run(simulator, 2);
        Assert.Equal(Vector2.Zero, body.LinearVelocity);
        body.ApplyImpulse(new Vector2(40, 0));
        Run(simulator, 1);
        Near(new Vector2(10, 0), body.LinearVelocity);
    }

    [Fact]
    [ManualRow("F278")]
    public void ApplyAngularImpulse_ChangesTheSpinAtOnce()
    {
        PhysicsSimulator simulator = Free(out Body body);
        body.ApplyAngularImpulse(16);
        Assert.Equal(2, body.AngularVelocity);
        float amount = -4;
        body.ApplyAngularImpulse(ref amount);
        Assert.Equal(1.5f, body.AngularVelocity);
        Run(simulator, 100);
        Assert.Equal(1.5f, body.TotalRotation, 4);
        Assert.Equal(Vector2.Zero, body.LinearVelocity);
    }

    [Fact]
    [ManualRow("F279")]
    public void ApplyTorque_OnAWheel_DrivesIt()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        Geom wheel = Ball(simulator, new Vector2(0, -10), 10);
        floor.FrictionCoefficient = 1;
        wheel.FrictionCoefficient = 1;
        Run(simulator, 20);
        for (int i = 0; i < 100; i++)
        {
            wheel.Body.ApplyTorque(300);
            Assert.Equal(300, wheel.Body.Torque);
            simulator.Update(Step);
        }

        // Rolling without slip: a = T r / (I + m r²) = 300 · 10 / (50 + 100) = 20 length/s².
        Assert.InRange(wheel.Body.LinearVelocity.X, 19.8f, 20.2f);

        // The rim may be ahead by what the torque alone gives in a third of a step (0.6 · 1/3): friction answers each substep, and the
        // wheel rests 0.05 deep.
        Assert.InRange((wheel.Body.AngularVelocity * 10) - wheel.Body.LinearVelocity.X, 0, 0.2f);
    }

    [Fact]
    [ManualRow("F280")]
    public void ClearTorque_DropsWhatWasGathered()
    {
        PhysicsSimulator simulator = Free(out Body body);
        body.ApplyTorque(100);
        body.ApplyForceAtLocalPoint(new Vector2(0, 4), new Vector2(5, 0));
        Assert.Equal(120, body.Torque);
        body.ClearTorque();
        Assert.Equal(0, body.Torque);
        Run(simulator, 2);
        Assert.Equal(0, body.AngularVelocity);
        Assert.Equal(0.01f, body.LinearVelocity.Y, 5);
    }

    private static PhysicsSimulator Free(out Body body)
    {
        var simulator = new PhysicsSimulator();
        body = Add(simulator);
        Run(simulator, 1);
        return simulator;
    }

    private static Body Add(PhysicsSimulator simulator)
    {
        Body body = BodyFactory.Instance.CreateBody(simulator, 4, 8);
        body.LinearDragCoefficient = 0;
        body.RotationalDragCoefficient = 0;
        return body;
    }

    private static void Near(Vector2 expected, Vector2 actual)
    {
        Assert.Equal(expected.X, actual.X, 4);
        Assert.Equal(expected.Y, actual.Y, 4);
    }
}
