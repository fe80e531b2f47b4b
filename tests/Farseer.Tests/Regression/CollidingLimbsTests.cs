using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Ragdolls whose own limbs collide. What their contacts gave against a blow was repeated in the next substeps, of which a sweep took back
/// a part only: energy rose by up to three metres of height in single steps.
/// </summary>
public class CollidingLimbsTests
{
    private const float Gravity = 10;

    public enum Steps
    {
        Even,
        Random,
        WithPauses,
    }

    // Largest rise in a step before: 0.57, 0.46, 0.58, 2.77, 0.18, 0.92 and 0.16 m, of falls of 2.5 to 9.5 m.
    [Theory]
    [InlineData(18, Steps.Even, 5)]
    [InlineData(23, Steps.Even, 5)]
    [InlineData(23, Steps.Random, 5)]
    [InlineData(23, Steps.WithPauses, 5)]
    [InlineData(3, Steps.WithPauses, 5)]
    [InlineData(29, Steps.Random, 20)]
    [InlineData(22, Steps.Random, 20)]
    public void Ragdoll_ThatFallsOnAFloor_GainsNoEnergy(int seed, Steps steps, int iterations)
    {
        using PhysicsSimulator simulator = With(iterations);
        Geom floor = Sandbox.Box(simulator, new Vector2(0, -0.5f), 60, 1);
        floor.Body.IsStatic = true;
        floor.FrictionCoefficient = 0.6f;
        floor.RestitutionCoefficient = 0;

        // Overlaps that pauses leave are pushed apart. Of 180 such runs the worst has 0.026 m.
        Assert.InRange(LargestRise(simulator, seed, steps, 10), 0, 0.05);
    }

    // Before: 0.002, 0.004, 0.014 and 0.09 m.
    [Theory]
    [InlineData(9, Steps.Even, 5)]
    [InlineData(27, Steps.Random, 5)]
    [InlineData(0, Steps.Even, 20)]
    [InlineData(28, Steps.Random, 20)]
    public void Ragdoll_ThatFalls_GainsNoEnergy(int seed, Steps steps, int iterations)
    {
        using PhysicsSimulator simulator = With(iterations);

        // 0.0003 m is the most of 180 such runs.
        Assert.InRange(LargestRise(simulator, seed, steps, 1.2), 0, 0.0006);
    }

    private static PhysicsSimulator With(int iterations) =>
        new PhysicsSimulator(new Vector2(0, -Gravity)) { Iterations = iterations, AllowedPenetration = 0 };

    private static double LargestRise(PhysicsSimulator simulator, int seed, Steps steps, double duration)
    {
        var puppet = new Puppet(simulator, new Vector2(0, 0.5f + (seed % 10)));
        var random = new Random(seed);
        foreach (Geom geom in puppet.Geoms)
        {
            geom.Body.LinearVelocity = new Vector2((float)(random.NextDouble() - 0.5) * 2, 0);
        }

        float spin = (float)(random.NextDouble() - 0.5) * 0.4f;
        puppet.Geoms.ForEach(geom => geom.Body.AngularVelocity = spin);
        double before = double.PositiveInfinity;
        double rise = 0;
        for (double time = 0; time < duration;)
        {
            double dt = steps switch
            {
                Steps.Random => 1 / (30 + (210 * random.NextDouble())),
                Steps.WithPauses => random.NextDouble() < 0.05 ? 0.1 : 1 / 60.0,
                _ => 1 / 60.0,
            };
            simulator.Update((float)dt);
            time += dt;
            double height = Energies.AsHeight(puppet.Geoms.Select(geom => geom.Body), Gravity);
            rise = Math.Max(rise, height - before);
            before = height;
        }

        return rise;
    }
}
