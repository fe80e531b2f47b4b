using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// A wall of welded bricks that a ball breaks: what is left of the net becomes trees, with errors and overlaps of the blow. Overlaps were
/// pushed apart with masses of another pose, and bricks left by up to 10¹⁸ m. Surfaces and loops within what still held gathered impulses
/// that moved nothing until a weld broke: 7 of 216 walls gained more than 5 % of their energy, one of 1,080 by 8·10⁷ times.
/// </summary>
public class BreakingWallTests
{
    private const float Side = 0.8f;
    private const int Columns = 6;

    [Theory]
    [InlineData(0.02f, 0f, 60f, 4)]
    [InlineData(0.005f, 0f, 20f, 6)]
    [InlineData(0f, 2000f, 200f, 4)]
    [InlineData(0f, 400f, 200f, 6)]
    public void Bricks_StayInTheWorld(float breakpoint, float breakForce, float speed, int rows)
    {
        PhysicsSimulator simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = 0.001f };
        Build(simulator, rows, Columns, breakpoint, breakForce);
        Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, 5);
        ball.Position = new Vector2(-4, rows * Side * 0.6f);
        ball.LinearVelocity = new Vector2(speed, 2);
        GeomFactory.Instance.CreateCircleGeom(simulator, ball, 0.5f, 24);
        Sandbox.Run(simulator, 300, 1 / 60f);

        // Five seconds at the speed of the ball, and no more.
        Assert.All(simulator.BodyList, b => Assert.InRange(b.Position.Length(), 0, (5 * speed) + 20));
        Assert.All(simulator.BodyList, b => Assert.InRange(b.LinearVelocity.Length(), 0, speed));
    }

    /// <summary>The worst of 1,500 walls: all lost energy only after the first update, at which nothing touches yet.</summary>
    [Theory]
    [InlineData(27)]
    [InlineData(118)]
    [InlineData(130)]
    [InlineData(499)]
    [InlineData(604)]
    [InlineData(681)]
    [InlineData(1413)]
    public void Wall_OfAnySeed_GainsNoEnergy(int seed)
    {
        PhysicsSimulator simulator = Wall(seed);
        simulator.Update(1 / 60f);
        double start = EnergyOf(simulator);
        double most = 0;
        for (int step = 0; step < 120; step++)
        {
            simulator.Update(1 / 60f);
            most = Math.Max(most, EnergyOf(simulator));
        }

        Assert.InRange(most / start, 0, 1.05);
    }

    /// <summary>
    /// A wall by its number: strength, speed, iterations and size in turn; what flies at it, how heavy and how high, by chance.
    /// </summary>
    private static PhysicsSimulator Wall(int seed)
    {
        (float Point, float Force)[] breaks = [(0.02f, 0), (0.005f, 0), (0.0005f, 0), (0, 2000), (0, 400), (0, 100)];
        float[] speeds = [20, 60, 200];
        int[] iterations = [5, 10, 20];
        (int Rows, int Columns)[] sizes = [(4, 6), (6, 6), (6, 3), (5, 4)];
        (int rows, int columns) = sizes[seed / 54 % 4];
        var random = new Random(seed);
        float mass = (float)(5 * Math.Pow(4, (random.NextDouble() * 2) - 1));
        bool isBox = random.Next(2) == 0;
        float height = rows * Side * (0.2f + (0.6f * (float)random.NextDouble()));
        var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = 0.001f, Iterations = iterations[seed / 18 % 3] };
        Build(simulator, rows, columns, breaks[seed % 6].Point, breaks[seed % 6].Force);
        Body missile = isBox ? Brick(simulator, Vector2.Zero, 0.9f, 0.7f).Body : Sandbox.Ball(simulator, Vector2.Zero, 0.5f, mass, 24).Body;
        missile.Mass = mass;
        missile.Position = new Vector2(-6, height);
        missile.Rotation = isBox ? (float)random.NextDouble() : 0;
        missile.LinearVelocity = new Vector2(speeds[seed / 6 % 3], 2);
        return simulator;
    }

    private static void Build(PhysicsSimulator simulator, int rows, int columns, float breakpoint, float breakForce)
    {
        Brick(simulator, new Vector2(0, -0.5f), 4000, 1).Body.IsStatic = true;
        var bricks = new Body[rows, columns];
        var welds = new List<Joint>();
        for (int row = 0; row < rows; row++)
        {
            for (int column = 0; column < columns; column++)
            {
                bricks[row, column] = Brick(simulator, new Vector2(Side * column, Side * (row + 0.5f)), Side, Side).Body;
                if (column > 0)
                {
                    welds.Add(Weld(bricks[row, column - 1], bricks[row, column]));
                }

                if (row > 0)
                {
                    welds.Add(Weld(bricks[row - 1, column], bricks[row, column]));
                }
            }
        }

        foreach (Joint weld in welds)
        {
            if (breakpoint > 0)
            {
                weld.Breakpoint = breakpoint;
            }
            else
            {
                weld.BreakForce = breakForce;
            }

            simulator.Add(weld);
        }
    }

    private static double EnergyOf(PhysicsSimulator simulator)
    {
        double sum = 0;
        foreach (Body body in simulator.BodyList)
        {
            double turning = body.MomentOfInertia * (double)body.AngularVelocity * body.AngularVelocity;
            double moving = body.Mass * (double)body.LinearVelocity.LengthSquared();
            sum += body.IsStatic ? 0 : (0.5 * (moving + turning)) + (10.0 * body.Mass * body.Position.Y);
        }

        return sum;
    }

    private static WeldJoint Weld(Body a, Body b) => new WeldJoint(a, b, 0.5f * (a.Position + b.Position));

    private static Geom Brick(PhysicsSimulator simulator, Vector2 place, float width, float height)
    {
        Geom geom = Sandbox.Box(simulator, place, width, height, width * height);
        geom.FrictionCoefficient = 0.5f;
        return geom;
    }
}
