using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Bodies that joints make one, and that touch each other besides: their contacts have nothing to do, and nothing to divide by.
/// </summary>
public class JointedGroupTests
{
    private const float Side = 0.8f;

    [Theory]
    [InlineData(3, 10f)]
    [InlineData(3, 25f)]
    [InlineData(6, 10f)]
    [InlineData(6, 25f)]
    public void WeldedColumnWhoseBricksTouch_HitByABall_GainsNoEnergy(int rows, float speed)
    {
        PhysicsSimulator simulator = new(new Vector2(0f, -10f)) { AllowedPenetration = 0.001f };
        Body floor = Box(simulator, new Vector2(0f, -0.5f), 400f, 1f);
        floor.IsStatic = true;
        Body? below = null;
        for (int row = 0; row < rows; row++)
        {
            Body brick = Box(simulator, new Vector2(0f, Side * (row + 0.5f)), Side, Side);
            if (below is not null)
            {
                simulator.Add(new WeldJoint(below, brick, 0.5f * (below.Position + brick.Position)));
            }

            below = brick;
        }

        Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, 3f);
        ball.Position = new Vector2(-4f, Math.Min(3f, (rows * Side) - 0.4f));
        ball.LinearVelocity = new Vector2(speed, 2f);
        GeomFactory.Instance.CreateCircleGeom(simulator, ball, 0.5f, 24);
        simulator.Update(1f / 60f);
        double start = Energy(simulator);
        for (int step = 0; step < 300; step++)
        {
            simulator.Update(1f / 60f);

            // Contacts that rest a millimetre deep may give back what lifts them out of it; all is far below a percent.
            Assert.True(Energy(simulator) < 1.01 * start, $"{Energy(simulator)} J of {start} J after {step} updates");
        }
    }

    private static Body Box(PhysicsSimulator simulator, Vector2 position, float width, float height)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, width * height);
        body.Position = position;
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height).FrictionCoefficient = 0.6f;
        return body;
    }

    private static double Energy(PhysicsSimulator simulator)
    {
        double sum = 0;
        foreach (Body body in simulator.BodyList)
        {
            if (!body.IsStatic)
            {
                sum += 0.5 * ((body.Mass * (double)body.LinearVelocity.LengthSquared())
                    + (body.MomentOfInertia * (double)body.AngularVelocity * body.AngularVelocity));
                sum += 10.0 * body.Mass * body.PositionY;
            }
        }

        return sum;
    }
}
