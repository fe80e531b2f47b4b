using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Boxes on each other that begin in each other. What soft contacts take back of an overlap leaves at a rate that grows with the dial: ten
/// boxes overlapping by a quarter rose 0.54 m above their height at 40 iterations, while at 5 they did not.
/// </summary>
public class OverlappingStackTests
{
    private static readonly double[] Shares = { 0.005, 0.02, 0.05, 0.1, 0.25, 0.4 };

    [Theory]
    [InlineData(1, 1 / 60f)]
    [InlineData(2, 1 / 60f)]
    [InlineData(5, 1 / 60f)]
    [InlineData(10, 1 / 60f)]
    [InlineData(20, 1 / 60f)]
    [InlineData(40, 1 / 60f)]
    [InlineData(5, 1 / 30f)]
    [InlineData(5, 1 / 240f)]
    public void OverlappingStack_ComingApart_RisesNoHigherThanItIs(int iterations, float dt)
    {
        var bad = new List<string>();
        foreach (int count in new[] { 3, 4, 6, 10, 15 })
        {
            foreach (double share in Shares)
            {
                double above = Above(count, share, iterations, dt);
                if (!(above <= 1e-3))
                {
                    bad.Add($"{count} by {share}: {above:G3} m");
                }
            }
        }

        Assert.True(bad.Count == 0, string.Join("; ", bad));
    }

    // Stacks of more than 16 levels carry their pushes on, and go a little too far with them: without speed, so that they sink back.
    [Theory]
    [InlineData(2, 1 / 60f)]
    [InlineData(5, 1 / 60f)]
    [InlineData(20, 1 / 60f)]
    [InlineData(5, 1 / 240f)]
    public void HighOverlappingStack_ComingApart_RisesHardlyHigherThanItIs(int iterations, float dt)
    {
        foreach (int count in new[] { 20, 30 })
        {
            foreach (double share in Shares)
            {
                double above = Above(count, share, iterations, dt);
                Assert.True(above <= 0.01 * count, $"{count} by {share}: {above:G3} m");
            }
        }
    }

    /// <summary>How far a box gets above its place, m.</summary>
    private static double Above(int count, double share, int iterations, float dt)
    {
        const double Seconds = 3;
        var simulator = new PhysicsSimulator(new Vector2(0, -10)) { Iterations = iterations, AllowedPenetration = 0 };
        Body ground = BodyFactory.Instance.CreateRectangleBody(simulator, 40, 10, 1);
        ground.IsStatic = true;
        ground.Position = new Vector2(0, -5);
        var geoms = new List<Geom> { GeomFactory.Instance.CreateRectangleGeom(simulator, ground, 40, 10) };
        for (int i = 0; i < count; i++)
        {
            geoms.Add(Sandbox.Box(simulator, new Vector2(0, (float)(0.5 + (i * (1 - share)))), 1, 1));
        }

        foreach (Geom geom in geoms)
        {
            geom.FrictionCoefficient = 0.5f;
            geom.RestitutionCoefficient = 0;
        }

        List<Body> boxes = geoms.Skip(1).Select(geom => geom.Body).ToList();
        double above = 0;
        for (int step = 0; step < Seconds / dt; step++)
        {
            simulator.Update(dt);
            for (int i = 0; i < count; i++)
            {
                above = Math.Max(above, boxes[i].Position.Y - (i + 0.5));
            }
        }

        return above;
    }
}
