using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Worlds without gravity, where no weight tells a load from a blow. Every impulse passed for a blow there, so that no substep began from
/// the impulses of the one before: ten boxes that forces press against a wall sank in by 0.42 of one, twenty ran through each other and the
/// wall.
/// </summary>
public class WeightlessTests
{
    private const float Acceleration = 10;
    private const float Brick = 0.4f;

    /// <summary>
    /// The softness of the contacts of a row of n, without the feed-forward that weight would allow: n(n + 1)·a·h²/(π/2)² for boxes of
    /// which each hands on what presses those behind it, h being the substep. Printed: 19 mm for 20, 75 mm for 40.
    /// </summary>
    [Theory]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(40)]
    public void Row_PressedByForces_SinksByItsSoftnessAlone(int count)
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero) { AllowedPenetration = 0 };
        Sandbox.Box(simulator, new Vector2(count + 0.5f, 0), 1, 20).Body.IsStatic = true;
        List<Body> row = Enumerable.Range(0, count).Select(i => Sandbox.Box(simulator, new Vector2(i + 0.5f, 0), 1, 1).Body).ToList();
        for (int step = 0; step < 240; step++)
        {
            row.ForEach(body => body.ApplyForce(new Vector2(Acceleration, 0)));
            simulator.Update(1 / 60f);
        }

        double substep = 1.0 / 60 / simulator.Iterations;
        double softness = count * (count + 1) * Acceleration * Math.Pow(substep / (Math.PI / 2), 2);
        Assert.InRange(row[0].Position.X - 0.5f, 0, 1.1 * softness);
    }

    /// <summary>
    /// A wall of 2,400 bricks at rest. The more iterations the slower the box leaves it: 25.8, 25.3 and 25.2 m/s with 4, 16 and 64. It was
    /// 27.6, and the bricks before it kept lying in each other whole.
    /// </summary>
    [Fact]
    public void Box_ThroughWallAtRest_LeavesItsSpeedToTheBricks()
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero) { Iterations = 4, AllowedPenetration = 0.005f, AllowSleep = true };
        Body box = Plastic(Sandbox.Box(simulator, new Vector2(20, 0), 8, 8, 512));
        box.LinearVelocity = new Vector2(40, 0);
        for (int i = 0; i < 60 * 40; i++)
        {
            var place = new Vector2(30 + (Brick * (i / 40)), Brick * ((i % 40) - 20));
            Plastic(Sandbox.Box(simulator, place, Brick, Brick, Brick * Brick)).Awake = false;
        }

        Sandbox.Run(simulator, 120, 1 / 60f);

        // Within 4 % of what many iterations give.
        Assert.InRange(box.LinearVelocity.Length(), 24.2f, 26.2f);

        // Half a brick's width; it was a whole one.
        Assert.InRange(simulator.LargestPenetration, 0, 0.5f * Brick);
    }

    private static Body Plastic(Geom geom)
    {
        geom.FrictionCoefficient = 0.6f;
        geom.RestitutionCoefficient = 0;
        return geom.Body;
    }
}
