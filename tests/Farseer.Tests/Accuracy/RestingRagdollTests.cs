using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>
/// What is left of a ragdoll that lies still. It was 3·10⁻⁸ to 6·10⁻⁸ m/s whatever the iterations: in each step the narrow phase found its
/// corners some last places of a float higher or lower than the solver had left them.
/// </summary>
public class RestingRagdollTests
{
    private const float Dt = 1 / 60f;

    // A tenth of the last place of the speed of a substep's fall, g·h = 0.033 m/s; 10⁻¹¹ and less measured.
    private const double Rest = 3.7e-10;

    [Theory]
    [InlineData(0.5f, 4)]
    [InlineData(1, 5)]
    [InlineData(3, 5)]
    [InlineData(3, 10)]
    [InlineData(5, 5)]
    [InlineData(8, 20)]
    public void Ragdoll_ThatLiesOnAFloor_RestsToTheRoundingOfItsGravity(float height, int iterations)
    {
        using PhysicsSimulator simulator = WithFloor(iterations);
        var puppet = new Puppet(simulator, new Vector2(0, height));
        SetGroup(puppet, 1);
        Assert.InRange(RestingSpeed(simulator, puppet), 0, Rest);
    }

    [Fact]
    public void Ragdolls_ThatLieOnAFloorSideBySide_RestToTheRoundingOfTheirGravity()
    {
        using PhysicsSimulator simulator = WithFloor(5);
        Puppet[] puppets = Enumerable.Range(0, 5).Select(i => new Puppet(simulator, new Vector2((i - 2) * 5, 1 + i))).ToArray();
        foreach (Puppet puppet in puppets)
        {
            SetGroup(puppet, 1);
        }

        Sandbox.Run(simulator, 540, Dt);
        Assert.All(puppets, puppet => Assert.InRange(RestingSpeed(simulator, puppet), 0, Rest));
    }

    [Fact]
    public void Ragdoll_ThatLiesStill_GoesOnWhenGravityTurns()
    {
        using PhysicsSimulator simulator = WithFloor(5);
        var puppet = new Puppet(simulator, new Vector2(0, 1));
        SetGroup(puppet, 1);
        Sandbox.Run(simulator, 600, Dt);
        float before = puppet.Geoms[0].Body.Position.X;

        // A slope of 45 degrees; friction holds up to 31.
        simulator.Gravity = new Vector2(7, -7);
        Sandbox.Run(simulator, 60, Dt);

        // 0.5·(7 - 0.6·7) m in a second if it slides as a whole.
        Assert.InRange(puppet.Geoms[0].Body.Position.X - before, 1, 3);
    }

    private static PhysicsSimulator WithFloor(int iterations)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10)) { Iterations = iterations, AllowedPenetration = 0 };
        Geom floor = Sandbox.Box(simulator, new Vector2(0, -0.5f), 60, 1);
        floor.Body.IsStatic = true;
        floor.FrictionCoefficient = 0.6f;
        floor.RestitutionCoefficient = 0;
        return simulator;
    }

    private static void SetGroup(Puppet puppet, int group)
    {
        foreach (Geom geom in puppet.Geoms)
        {
            geom.CollisionGroup = group;
        }
    }

    /// <summary>The mean over the tenth second from now of the root mean square of all bodies.</summary>
    private static double RestingSpeed(PhysicsSimulator simulator, Puppet puppet)
    {
        Sandbox.Run(simulator, 540, Dt);
        double sum = 0;
        for (int i = 0; i < 60; i++)
        {
            simulator.Update(Dt);
            sum += Math.Sqrt(puppet.Geoms.Average(geom => geom.Body.LinearVelocity.LengthSquared()));
        }

        return sum / 60;
    }
}
