using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Motion with a closed form; time is steps × the float step that <c>Update</c> receives.</summary>
public class ClosedFormMotionTests
{
    private const float Dt = 1f / 60f;

    [Theory]
    [InlineData(1f / 15f)]
    [InlineData(1f / 60f)]
    [InlineData(1f / 1000f)]
    public void FreeFlight_AtAnyStepLength_FollowsTheParabola(float dt)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10));
        Body body = Ball(simulator, 1);
        body.LinearVelocity = new Vector2(10, 15);
        int steps = (int)Math.Round(10 / dt);
        Run(simulator, steps, dt);
        double t = steps * (double)dt;
        body.GetPosition(out double x, out double y);

        // Positions are double and the velocity's rounding is carried along: what is left is the rounding of sums.
        Assert.InRange(x - (10 * t), -1e-6, 1e-6);
        Assert.InRange(y - ((15 * t) - (5 * t * t)), -1e-6, 1e-6);
    }

    [Theory]
    [InlineData(0.5)]
    [InlineData(2)]
    [InlineData(50)]
    public void LinearDrag_OfAnyStrength_DecaysExponentially(double rate)
    {
        using var simulator = new PhysicsSimulator();
        Body body = Ball(simulator, 1);
        body.LinearVelocity = new Vector2(10, 0);
        body.LinearDragCoefficient = (float)rate;
        Run(simulator, 30, Dt);
        double t = 30 * (double)Dt;
        body.GetPosition(out double x, out _);

        // The velocity is a float multiplied 30 times: 30 half units of 6e-8.
        Assert.InRange(body.LinearVelocity.X / (10 * Math.Exp(-rate * t)), 1 - 4e-6, 1 + 4e-6);
        Assert.InRange(x / (10 / rate * (1 - Math.Exp(-rate * t))), 1 - 4e-6, 1 + 4e-6);
    }

    [Theory]
    [InlineData(10f)]
    [InlineData(50f)]
    [InlineData(200f)]
    public void Spin_WithoutDrag_KeepsItsRateAndPhase(float omega)
    {
        using var simulator = new PhysicsSimulator();
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 2, 0.2f, 0.4f);
        body.RotationalDragCoefficient = 0;
        body.AngularVelocity = omega;
        Run(simulator, 600, Dt);
        double exact = omega * 600 * (double)Dt;

        // The wrapped angle is a float below 2π: 2.4e-7 of rounding; nothing else may be lost.
        Assert.InRange(Math.IEEERemainder(body.Rotation - exact, 2 * Math.PI), -1e-5, 1e-5);
        Assert.Equal(omega, body.AngularVelocity);
    }

    [Theory]
    [InlineData(0.5f, 1f)]
    [InlineData(1f, 1f)]
    [InlineData(1f, 1000f)]
    public void Impact_OfTwoCircles_KeepsMomentumAndRestitution(float restitution, float ratio)
    {
        using var simulator = new PhysicsSimulator { AllowedPenetration = 0 };
        Body a = Ball(simulator, 1, restitution);
        Body b = Ball(simulator, ratio, restitution);
        a.Position = new Vector2(-2.03f, 0);
        a.LinearVelocity = new Vector2(5, 0);
        Run(simulator, 60, Dt);

        // A few float roundings of numbers about 5: relative 1e-6.
        Assert.InRange(a.LinearVelocity.X + (ratio * b.LinearVelocity.X), 5 * (1 - 1e-6), 5 * (1 + 1e-6));
        Assert.InRange(b.LinearVelocity.X - a.LinearVelocity.X, 5 * (restitution - 1e-6), 5 * (restitution + 1e-6));
    }

    private static Body Ball(PhysicsSimulator simulator, float mass, float restitution = 0)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, mass);
        body.LinearDragCoefficient = 0;
        body.RotationalDragCoefficient = 0;
        Geom geom = GeomFactory.Instance.CreateCircleGeom(simulator, body, 0.5f, 32);
        geom.RestitutionCoefficient = restitution;
        geom.FrictionCoefficient = 0;
        return body;
    }

    private static void Run(PhysicsSimulator simulator, int steps, float dt)
    {
        for (int i = 0; i < steps; i++)
        {
            simulator.Update(dt);
        }
    }
}
