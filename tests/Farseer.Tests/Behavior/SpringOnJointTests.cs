using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Springs at bodies that joints hold: they pull against what the joints leave the body, not against its own mass.</summary>
public class SpringOnJointTests
{
    private const float Length = 40;
    private const float Gravity = 100;

    /// <summary>A rod nailed at its left end and held by a spring at the right one: the spring carries half of its weight, 50.</summary>
    [Theory]
    [InlineData(100, 10, 5)]
    [InlineData(1000, 10, 5)]
    [InlineData(1e4f, 10, 5)]
    [InlineData(1000, 10, 50)]
    public void NailedRod_RestsWhereItsSpringCarriesHalfOfIt(float constant, float damping, int iterations)
    {
        Body rod = Rod(constant, damping, iterations, out PhysicsSimulator simulator);
        Sandbox.Run(simulator, 1500);

        // The turn of the rod lengthens the way of its end by less than 1e-4 of it.
        Assert.Equal(50 / constant, Length * rod.TotalRotation, 2e-4f * 50 / constant);
    }

    [Theory]
    [InlineData(100)]
    [InlineData(1000)]
    [InlineData(1e4f)]
    public void NailedRod_OnASpringWithoutDamping_SwingsOnAndOn(float constant)
    {
        Body rod = Rod(constant, 0, 5, out PhysicsSimulator simulator);
        double rest = 50.0 / constant;
        double early = 0;
        double late = 0;
        int crossings = 0;
        double before = -1;
        const int Updates = 2000;
        for (int i = 0; i < Updates; i++)
        {
            Sandbox.Run(simulator, 1);
            double off = (Length * rod.TotalRotation) - rest;
            early = i < 300 ? Math.Max(early, Math.Abs(off)) : early;
            late = i >= Updates - 300 ? Math.Max(late, Math.Abs(off)) : late;
            crossings += before < 0 && off >= 0 ? 1 : 0;
            before = off;
        }

        // It starts at the spring's rest length. Three substeps to a radian at the stiffest: 1 % of the frequency, 2 % of the amplitude.
        Assert.Equal(rest, early, 0.03 * rest);
        Assert.Equal(early, late, 0.01 * early);
        double inertia = (((Length * Length) + 16) / 12) + (Length * Length / 4);
        double period = 2 * Math.PI / Math.Sqrt(constant * Length * Length / inertia);
        Assert.Equal(Updates * Sandbox.Step / period, crossings, 0.015 * Updates * Sandbox.Step / period);
    }

    private static Body Rod(float constant, float damping, int iterations, out PhysicsSimulator simulator)
    {
        simulator = new PhysicsSimulator(new Vector2(0, Gravity)) { Iterations = iterations };
        Body rod = BodyFactory.Instance.CreateRectangleBody(simulator, Length, 4, 1);
        rod.Position = new Vector2(Length / 2, 0);
        Sandbox.WithoutDrag(rod);
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, rod, Vector2.Zero);
        SpringFactory.Instance.CreateFixedLinearSpring(
            simulator, rod, new Vector2(Length / 2, 0), new Vector2(Length, -30), constant, damping);
        return rod;
    }
}
