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
/// pushed apart with masses of another pose, and bricks left by up to 10¹⁸ m.
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
        Body floor = Brick(simulator, new Vector2(0, -0.5f), 400, 1);
        floor.IsStatic = true;
        var bricks = new Body[rows, Columns];
        var welds = new List<Joint>();
        for (int row = 0; row < rows; row++)
        {
            for (int column = 0; column < Columns; column++)
            {
                bricks[row, column] = Brick(simulator, new Vector2(Side * column, Side * (row + 0.5f)), Side, Side);
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

        Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, 5);
        ball.Position = new Vector2(-4, rows * Side * 0.6f);
        ball.LinearVelocity = new Vector2(speed, 2);
        GeomFactory.Instance.CreateCircleGeom(simulator, ball, 0.5f, 24);
        Sandbox.Run(simulator, 300, 1 / 60f);

        // Five seconds at the speed of the ball, and no more.
        Assert.All(simulator.BodyList, b => Assert.InRange(b.Position.Length(), 0, (5 * speed) + 20));
        Assert.All(simulator.BodyList, b => Assert.InRange(b.LinearVelocity.Length(), 0, speed));
    }

    private static WeldJoint Weld(Body a, Body b) => new WeldJoint(a, b, 0.5f * (a.Position + b.Position));

    private static Body Brick(PhysicsSimulator simulator, Vector2 place, float width, float height)
    {
        Geom geom = Sandbox.Box(simulator, place, width, height, width * height);
        geom.FrictionCoefficient = 0.5f;
        return geom.Body;
    }
}
