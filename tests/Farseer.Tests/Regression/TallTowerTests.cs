using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Towers of boxes of a metre. What each contact takes back of a depth is little, but it adds up level by level to the speed of the top,
/// and more of it the finer the substeps are: those of an island that came to rest became finer at once.
/// </summary>
public class TallTowerTests
{
    // The fastest body before, m/s, and how far the top flew above the height of the tower: 5.0 and 1.1 m, 12 and 7.2, 4.9 and 1.0, 21.8
    // and 23.7, 5.0 and 0.5, 2.2 and 0.09.
    [Theory]
    [InlineData(40, 0.002f, 5)]
    [InlineData(40, 0.01f, 5)]
    [InlineData(40, 0.02f, 5)]
    [InlineData(40, 0.01f, 10)]
    [InlineData(80, 0.002f, 5)]
    [InlineData(20, 0.01f, 5)]
    public void Tower_BegunInItself_RisesToItsHeightAndNoFurther(int boxes, float overlap, int iterations)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { Iterations = iterations, AllowedPenetration = 0 };
        List<Body> tower = Build(simulator, boxes, overlap);
        (float fastest, float highest) = Watch(simulator, tower, 360);

        // 1.2 m/s at most here. A body that rises by its own speed from the least height that these begin with, 0.16 m below the full one,
        // would need 1.8 m/s.
        Assert.InRange(fastest, 0, 1.8f);
        Assert.InRange(highest - Height(tower), -1, 0.001f);

        // A thousandth of a box each; what they sag by is some fiftieth of that.
        Assert.InRange(Height(tower) - tower[^1].Position.Y, 0, 0.001f * boxes);
        Assert.InRange(tower.Max(body => body.LinearVelocity.Length()), 0, 0.01f);
    }

    // A hop of 1 m/s is one of 5 cm. Two seconds later the tower was at rest and took its finer substeps: the top flew up by 1.1 m, and
    // every two seconds again.
    [Theory]
    [InlineData(1f)]
    [InlineData(-5f)]
    public void Tower_WhoseTopHops_ComesToRest(float speed)
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = 0 };
        List<Body> tower = Build(simulator, 40, 0);
        Sandbox.Run(simulator, 120, 1 / 60f);
        tower[^1].LinearVelocity = new Vector2(0, speed);
        (float fastest, float highest) = Watch(simulator, tower, 360);
        // What hops falls back as fast, but for the rounding.
        Assert.InRange(fastest, 0, 1.00001f * Math.Abs(speed));
        Assert.InRange(highest - Height(tower), -1, 0.05f);
        Assert.InRange(tower.Max(body => body.LinearVelocity.Length()), 0, 0.01f);
    }

    private static List<Body> Build(PhysicsSimulator simulator, int boxes, float overlap)
    {
        Sandbox.Box(simulator, new Vector2(0, -0.5f), 100, 1).Body.IsStatic = true;
        return Enumerable.Range(0, boxes).Select(i => Sandbox.Box(simulator, new Vector2(0, 0.5f + i - ((i + 1) * overlap)), 1, 1).Body)
            .ToList();
    }

    /// <summary>The fastest body and the highest place of the top.</summary>
    private static (float Fastest, float Highest) Watch(PhysicsSimulator simulator, List<Body> tower, int steps)
    {
        float fastest = 0;
        float highest = float.MinValue;
        for (int step = 0; step < steps; step++)
        {
            simulator.Update(1 / 60f);
            fastest = Math.Max(fastest, tower.Max(body => body.LinearVelocity.Length()));
            highest = Math.Max(highest, tower[^1].Position.Y);
        }

        return (fastest, highest);
    }

    private static float Height(List<Body> tower) => tower.Count - 0.5f;
}
