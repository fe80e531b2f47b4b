using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>Limits under load: against contacts that will not let them be reached, and against the pull of a whirl.</summary>
public class SqueezedLimitTests
{
    /// <summary>Neither can win, and neither may gain energy.</summary>
    [Theory]
    [InlineData(28f, 30f, 10f)]
    [InlineData(28f, 30f, 0f)]
    [InlineData(0f, 35f, 10f)]
    [InlineData(0f, 35f, 0f)]
    [InlineData(60f, 80f, 10f)]
    public void Slider_TooShortForTheBoxWithin_ComesToABalance(float least, float most, float gravity)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, gravity));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 1000, 20, 1);
        floor.Position = new Vector2(0, 20);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 1000, 20);
        var boxes = new Body[3];
        for (int i = 0; i < boxes.Length; i++)
        {
            boxes[i] = BodyFactory.Instance.CreateRectangleBody(simulator, 20, 20, 1);
            boxes[i].Position = new Vector2(21 * (i - 1), 0);
            GeomFactory.Instance.CreateRectangleGeom(simulator, boxes[i], 20, 20);
        }

        JointFactory.Instance.CreateSliderJoint(simulator, boxes[0], Vector2.Zero, boxes[2], Vector2.Zero, least, most);
        float early = Fastest(simulator, boxes, 600);
        Fastest(simulator, boxes, 600);
        float late = Fastest(simulator, boxes, 600);

        // The widest overrun is 18; it goes by a fifth in a substep of 1/300 s, and nothing may be faster than that.
        Assert.InRange(early, 0, 18 * 0.2f * 300);

        // On the floor they rest; without gravity the one within slips out, and all go on as they left.
        Assert.InRange(late, 0, gravity > 0 ? 1e-2f : early);
    }

    /// <summary>The force of a limit turns with the pair; nothing outside acts on it.</summary>
    [Theory]
    [InlineData(100, 5)]
    [InlineData(100, 1)]
    [InlineData(1000, 5)]
    [InlineData(10000, 5)]
    public void Pair_WhirlingAtTheEndOfItsSlider_KeepsItsAngularMomentumAndGainsNoEnergy(float speed, int iterations)
    {
        var simulator = new PhysicsSimulator(Vector2.Zero) { Iterations = iterations };
        var boxes = new Body[2];
        for (int i = 0; i < boxes.Length; i++)
        {
            boxes[i] = BodyFactory.Instance.CreateRectangleBody(simulator, 20, 20, 1);
            boxes[i].Position = new Vector2((30 * i) - 15, 0);
            boxes[i].LinearVelocity = new Vector2(0, speed * ((2 * i) - 1));
            boxes[i].LinearDragCoefficient = 0;
            boxes[i].RotationalDragCoefficient = 0;
        }

        JointFactory.Instance.CreateSliderJoint(simulator, boxes[0], Vector2.Zero, boxes[1], Vector2.Zero, 0, 30);
        double momentum = 30.0 * speed;
        double energy = (double)speed * speed;
        for (int i = 0; i < 1000; i++)
        {
            simulator.Update(1 / 60f);
            double now = 0;
            double held = 0;
            foreach (Body box in boxes)
            {
                now += (box.Position.X * (double)box.LinearVelocity.Y) - (box.Position.Y * (double)box.LinearVelocity.X);
                held += 0.5 * box.LinearVelocity.LengthSquared();
            }

            // Floats: 5000 substeps of 6e-8 each, all one way, are 3e-4.
            Assert.Equal(momentum, now, 3e-4 * momentum);
            Assert.InRange(held, 0, energy * (1 + 3e-4));
        }
    }

    private static float Fastest(PhysicsSimulator simulator, Body[] boxes, int updates)
    {
        float fastest = 0;
        for (int i = 0; i < updates; i++)
        {
            simulator.Update(1 / 60f);
            foreach (Body box in boxes)
            {
                fastest = MathF.Max(fastest, box.LinearVelocity.Length());
            }
        }

        return fastest;
    }
}
