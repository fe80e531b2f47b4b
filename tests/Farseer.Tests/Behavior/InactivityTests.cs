using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>What the inactivity controller disables is there again before something meets it.</summary>
public class InactivityTests
{
    [Fact]
    public void BallThatIsNotAutoIdle_DroppedOnADisabledBox_LiesOnIt()
    {
        var random = new Random(7);
        for (int i = 0; i < 200; i++)
        {
            float size = 10 + (30 * (float)random.NextDouble());
            float radius = 3 + (10 * (float)random.NextDouble());
            var simulator = new PhysicsSimulator(new Vector2(0, 100));
            InactivityController controller = simulator.InactivityController;
            controller.Enabled = true;
            controller.MaxIdleTime = 100 + (400 * (float)random.NextDouble());
            controller.ActivationDistance = 100;
            Body floor = Box(simulator, 400, 20, 0, 10);
            floor.IsStatic = true;
            Body box = Box(simulator, size, size, 0, -size / 2);
            box.IsAutoIdle = true;
            for (int step = 0; step < 120; step++)
            {
                simulator.Update(1 / 60f);
            }

            Assert.False(box.Enabled);
            Assert.True(floor.Enabled);
            Body ball = BodyFactory.Instance.CreateCircleBody(simulator, radius, 1);
            GeomFactory.Instance.CreateCircleGeom(simulator, ball, radius, 20);
            ball.Position = new Vector2(0, -size - radius - 20 - (200 * (float)random.NextDouble()));
            ball.IsAutoIdle = false;
            for (int step = 0; step < 300; step++)
            {
                simulator.Update(1 / 60f);
                Assert.True(step < 200 || box.Enabled, $"{i}: the box under the ball is disabled at {step}");
            }

            // Each of two contacts may sink in by AllowedPenetration.
            Assert.Equal(-size - radius, ball.Position.Y, 0.2f);
            Assert.Equal(2, controller.BodiesEnabled);

            // Without the ball the box may rest again.
            simulator.Remove(ball);
            for (int step = 0; step < 60; step++)
            {
                simulator.Update(1 / 60f);
            }

            Assert.False(box.Enabled);
            Assert.Equal(0, controller.BodiesEnabled);
        }
    }

    [Fact]
    public void SleeperOutOfReach_StaysDisabled_AndStaticBodiesAreNeverDisabled()
    {
        var simulator = new PhysicsSimulator();
        simulator.InactivityController.Enabled = true;
        Body wall = Box(simulator, 10, 10, 0, 0);
        wall.IsStatic = true;
        wall.IsAutoIdle = true;
        Body far = Box(simulator, 10, 10, 500, 0);
        far.IsAutoIdle = true;
        Body always = Box(simulator, 10, 10, 50, 0);
        for (int step = 0; step < 120; step++)
        {
            simulator.Update(1 / 60f);
        }

        Assert.True(wall.Enabled);
        Assert.True(always.Enabled);
        Assert.False(far.Enabled);
        Assert.Equal(1, simulator.InactivityController.BodiesEnabled);
    }

    private static Body Box(PhysicsSimulator simulator, float width, float height, float x, float y)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, 1);
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height);
        body.Position = new Vector2(x, y);
        return body;
    }
}
