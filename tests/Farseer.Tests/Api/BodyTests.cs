using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>The manual's chapter "Body".</summary>
public class BodyTests
{
    [Fact]
    [ManualRow("F011")]
    public void Body_MadeByHand_HasTheDefaultsAndIsSimulated()
    {
        var body = new Body();
        Assert.Equal(1, body.Mass);
        Assert.Equal(1, body.MomentOfInertia);
        Assert.Equal(Vector2.Zero, body.Position);
        Assert.Equal(0, body.Rotation);
        Assert.Equal(Vector2.Zero, body.LinearVelocity);
        Assert.Equal(0, body.AngularVelocity);
        Assert.False(body.IsStatic);
        Assert.True(body.Enabled);
        Assert.Equal(0.001f, body.LinearDragCoefficient);
        Assert.Equal(0.001f, body.RotationalDragCoefficient);
        Assert.Equal(0.001f, body.QuadraticDragCoefficient);
        Assert.False(body.IsQuadraticDragEnabled);
        Assert.Equal(55, body.MinimumVelocity);
        Assert.False(body.IsAutoIdle);
        PhysicsSimulator simulator = Sandbox.Falling();
        simulator.Add(body);
        Sandbox.Run(simulator, 100);

        // g t²/2; the drag of 0.001 takes away less than a thousandth of it.
        Assert.InRange(body.Position.Y, 49.9f, 50.01f);
    }

    [Fact]
    [ManualRow("F012")]
    public void Mass_Set_DividesForcesAndRefusesNonsense()
    {
        var body = new Body { Mass = 4, LinearDragCoefficient = 0 };
        Assert.Equal(0.25f, body.InverseMass);
        var simulator = new PhysicsSimulator();
        simulator.Add(body);
        body.ApplyForce(new Vector2(8, 0));
        simulator.Update(0.5f);
        Assert.Equal(1, body.LinearVelocity.X, 1e-6f);
        body.Mass = 2;
        body.ApplyForce(new Vector2(8, 0));
        simulator.Update(0.5f);
        Assert.Equal(3, body.LinearVelocity.X, 1e-6f);
        foreach (float bad in new[] { 0, -1, float.NaN, float.PositiveInfinity })
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => body.Mass = bad);
        }

        Assert.Equal(2, body.Mass);
    }

    [Fact]
    [ManualRow("F013")]
    public void MomentOfInertia_Set_DividesTorquesAndRefusesNonsense()
    {
        var body = new Body { MomentOfInertia = 8, RotationalDragCoefficient = 0 };
        Assert.Equal(0.125f, body.InverseMomentOfInertia);
        var simulator = new PhysicsSimulator();
        simulator.Add(body);
        body.ApplyTorque(16);
        simulator.Update(0.5f);
        Assert.Equal(1, body.AngularVelocity, 1e-6f);
        Assert.Throws<ArgumentOutOfRangeException>(() => body.MomentOfInertia = 0);
        Assert.Throws<ArgumentOutOfRangeException>(() => body.MomentOfInertia = float.NaN);
        Assert.Equal(8, body.MomentOfInertia);
    }

    [Fact]
    [ManualRow("F014")]
    public void Position_Set_MovesTheBodyAtOnce_AlsoInASimulator()
    {
        var simulator = new PhysicsSimulator();
        Geom geom = Sandbox.Ball(simulator, new Vector2(3, 4));
        Assert.Equal(new Vector2(3, 4), geom.Body.Position);
        simulator.Update(0.01f);
        geom.Body.Position = new Vector2(-100, 7);
        Assert.Equal(new Vector2(-100, 7), geom.Body.Position);
        Assert.Equal(new Vector2(-100, 7), geom.Position);
        simulator.Update(0.01f);
        Assert.Equal(new Vector2(-100, 7), geom.Body.Position);
        Assert.Throws<ArgumentOutOfRangeException>(() => geom.Body.Position = new Vector2(0, float.NaN));
        Assert.Equal(new Vector2(-100, 7), geom.Body.Position);
    }

    [Fact]
    [ManualRow("F015")]
    public void MomentOfInertia_OfTheManualsFormula_IsThatOfTheRectangle()
    {
        const float Mass = 3;
        const float Width = 40;
        const float Height = 20;
        var body = new Body { Mass = Mass };
        body.MomentOfInertia = Mass * ((Width * Width) + (Height * Height)) / 12;
        Assert.Equal(BodyFactory.Instance.CreateRectangleBody(Width, Height, Mass).MomentOfInertia, body.MomentOfInertia);

        // The same by adding up squares of a fine grid: an independent witness of the formula.
        double sum = 0;
        for (int i = 0; i < 200; i++)
        {
            for (int j = 0; j < 100; j++)
            {
                double x = ((i + 0.5) * 0.2) - 20;
                double y = ((j + 0.5) * 0.2) - 10;
                sum += Mass / 20000.0 * ((x * x) + (y * y));
            }
        }

        // The midpoint rule lacks the inertia of the small squares, 0.2²/6 per unit of mass: 2e-5 of the whole.
        Assert.Equal(sum, body.MomentOfInertia, 5e-5 * sum);
    }

    [Fact]
    [ManualRow("F016")]
    public void Position_IsTheCentre_OfWhatTheFactoriesMakeAndOfTheTurning()
    {
        var body = new Body { Position = new Vector2(100, 50) };
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(body, 40, 20);
        Assert.Equal(new Vector2(100, 50), geom.AABB.GetCenter());
        Assert.Equal(new Vector2(80, 40), geom.AABB.Min);
        body.Rotation = (float)(Math.PI / 2);
        Assert.Equal(100, geom.AABB.GetCenter().X, 1e-4f);
        Assert.Equal(50, geom.AABB.GetCenter().Y, 1e-4f);
        Assert.Equal(20, geom.AABB.Width, 1e-4f);
        Assert.Equal(40, geom.AABB.Height, 1e-4f);
    }

    [Fact]
    [ManualRow("F017")]
    public void ForceTorqueImpulse_AreEachUsedOnce()
    {
        var simulator = new PhysicsSimulator();
        var body = new Body { Mass = 2, MomentOfInertia = 5, LinearDragCoefficient = 0, RotationalDragCoefficient = 0 };
        simulator.Add(body);
        body.ApplyForce(new Vector2(4, 0));
        body.ApplyForce(new Vector2(4, 0));
        body.ApplyTorque(10);
        body.ApplyImpulse(new Vector2(0, 6));
        body.ApplyAngularImpulse(5);
        Assert.Equal(new Vector2(8, 0), body.Force);
        Assert.Equal(10, body.Torque);
        Assert.Equal(Vector2.Zero, body.LinearVelocity);
        Assert.Equal(1, body.AngularVelocity);
        simulator.Update(0.5f);
        Assert.Equal(2, body.LinearVelocity.X, 1e-5f);
        Assert.Equal(3, body.LinearVelocity.Y, 1e-5f);
        Assert.Equal(2, body.AngularVelocity, 1e-5f);
        Assert.Equal(Vector2.Zero, body.Force);
        Assert.Equal(0, body.Torque);
        Vector2 velocity = body.LinearVelocity;
        simulator.Update(0.5f);
        Assert.Equal(velocity, body.LinearVelocity);
        Assert.Equal(2, body.AngularVelocity, 1e-5f);
    }

    [Fact]
    public void LinearVelocity_WrittenInEveryWayAFieldAllows_ReachesTheSimulation()
    {
        var simulator = new PhysicsSimulator();
        var body = new Body
        {
            LinearVelocity = new Vector2(1, 2),
            AngularVelocity = 3,
            Position = new Vector2(10, 20),
            LinearDragCoefficient = 0,
            RotationalDragCoefficient = 0,
        };
        Assert.Equal(new Vector2(1, 2), body.LinearVelocity);
        simulator.Add(body);
        simulator.Update(0.5f);
        Assert.Equal(new Vector2(10.5f, 21), body.Position);
        body.LinearVelocity.X = 5;
        body.LinearVelocity.Y *= 2;
        body.AngularVelocity += 1;
        Double(ref body.LinearVelocity);
        Assert.Equal(new Vector2(10, 8), body.LinearVelocity);
        simulator.Update(0.5f);
        Assert.Equal(new Vector2(15.5f, 25), body.Position);
        Assert.Equal(3.5f, body.TotalRotation, 1e-5f);
        simulator.Remove(body);
        simulator.Update(0.5f);
        body.LinearVelocity.X = 7;
        Assert.Equal(new Vector2(7, 8), body.LinearVelocity);

        static void Double(ref Vector2 velocity) => velocity *= 2;
    }
}
