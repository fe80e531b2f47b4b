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

    [Fact]
    public void WhateverMeetsADisabledBody_OfAnySize_AtAnySpeed_LiesOnIt()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            var random = new Random(seed);
            float width = 20 + (400 * (float)random.NextDouble());
            float height = 10 + (40 * (float)random.NextDouble());
            float size = 3 + (10 * (float)random.NextDouble());
            PhysicsSimulator simulator = Quiet(100 * (float)random.NextDouble());
            Floor(simulator);
            Body box = Box(simulator, width, height, 0, -height / 2);
            box.IsAutoIdle = true;
            Run(simulator, 120);
            Assert.False(box.Enabled);

            // From beside its middle to near its ends; dropped, thrown, pushed or struck, and idle or not.
            float aside = (width - size) * 0.8f * ((float)random.NextDouble() - 0.5f);
            Body body = Box(simulator, size, size, aside, -height - size - 20 - (300 * (float)random.NextDouble()));
            body.IsAutoIdle = random.Next(2) == 0;
            int way = random.Next(4);

            // Any other fast body may get into a moving one for a step, and so does one that is struck less than a step's way before it.
            body.IsBullet = true;
            body.LinearVelocity = new Vector2(0, way == 1 ? 2000 : 0);
            if (way == 2)
            {
                body.ApplyImpulse(new Vector2(0, 1000));
            }

            for (int step = 0; step < 400; step++)
            {
                if (way == 3)
                {
                    body.ApplyForce(new Vector2(0, 100));
                }

                simulator.Update(1 / 60f);
                string what = $"seed {seed}, way {way}, step {step}: at {body.Position} in {width} by {height}";
                Assert.True(body.Position.Y < -height + (0.1f * size), what);
            }
        }
    }

    [Fact]
    public void Stacks_AreDisabledTogether_AndStand()
    {
        for (int seed = 0; seed < 100; seed++)
        {
            var random = new Random(seed);
            PhysicsSimulator simulator = Quiet(5 * (float)random.NextDouble());
            Floor(simulator);
            int count = random.Next(2, 6);
            float size = 10 + (30 * (float)random.NextDouble());
            var boxes = new Body[count];
            for (int i = 0; i < count; i++)
            {
                // One by one, so that their times are over one after the other.
                boxes[i] = Box(simulator, size, size, 0, (-size * (i + 0.5f)) - 0.5f);
                boxes[i].IsAutoIdle = true;
                Run(simulator, random.Next(5, 40));
            }

            bool allDisabled = false;
            for (int step = 0; step < 300 && !allDisabled; step++)
            {
                simulator.Update(1 / 60f);
                int enabled = 0;
                foreach (Body box in boxes)
                {
                    enabled += box.Enabled ? 1 : 0;
                }

                Assert.True(enabled == 0 || enabled == count, $"seed {seed}: {enabled} of {count} are enabled");
                allDisabled = enabled == 0;
            }

            Assert.True(allDisabled, $"seed {seed}: the stack is never disabled");

            // What lands on the top wakes them all: none sinks into one that is not there.
            Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 4, 1);
            GeomFactory.Instance.CreateCircleGeom(simulator, ball, 4, 20);
            ball.Position = new Vector2(0, (-size * count) - 60);
            for (int step = 0; step < 200; step++)
            {
                simulator.Update(1 / 60f);
                float top = boxes[count - 1].Position.Y;
                Assert.True(top < (-size * (count - 0.5f)) + 1, $"seed {seed}, step {step}: the top is at {top}");
            }
        }
    }

    [Fact]
    public void WhatHangsAtAMovingBody_IsNotDisabled()
    {
        for (int seed = 0; seed < 100; seed++)
        {
            var random = new Random(seed);
            PhysicsSimulator simulator = Quiet(10);
            bool bySpring = random.Next(2) == 0;
            Body support = Box(simulator, 10, 10, 0, 0);
            support.IsKinematic = true;
            var chain = new Body[random.Next(1, 6)];
            Body above = support;
            float length = 30 + (40 * (float)random.NextDouble());
            for (int i = 0; i < chain.Length; i++)
            {
                chain[i] = Box(simulator, 10, 10, 0, (i + 1) * length);
                chain[i].IsAutoIdle = true;
                if (bySpring)
                {
                    SpringFactory.Instance.CreateLinearSpring(simulator, above, Vector2.Zero, chain[i], Vector2.Zero, 200, 20);
                }
                else
                {
                    JointFactory.Instance.CreatePinJoint(simulator, above, Vector2.Zero, chain[i], Vector2.Zero);
                }

                above = chain[i];
            }

            for (int step = 0; step < 300; step++)
            {
                simulator.Update(1 / 60f);
                Assert.All(chain, link => Assert.True(link.Enabled, $"seed {seed}, step {step}"));
            }

            // It hangs where it hung: a link that is let go falls by hundreds.
            Assert.InRange(above.Position.Y, chain.Length * length * 0.9f, (chain.Length * length) + (bySpring ? 100 : 1));
        }
    }

    private static PhysicsSimulator Quiet(float activationDistance)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        simulator.InactivityController.Enabled = true;
        simulator.InactivityController.MaxIdleTime = 200;
        simulator.InactivityController.ActivationDistance = activationDistance;
        return simulator;
    }

    private static void Floor(PhysicsSimulator simulator) => Box(simulator, 2000, 20, 0, 10).IsStatic = true;

    private static void Run(PhysicsSimulator simulator, int steps) => Sandbox.Run(simulator, steps, 1 / 60f);

    private static Body Box(PhysicsSimulator simulator, float width, float height, float x, float y)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, 1);
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height);
        body.Position = new Vector2(x, y);
        return body;
    }
}
