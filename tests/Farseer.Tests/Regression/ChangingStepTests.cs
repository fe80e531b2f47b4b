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
/// Another step in each update, from 1/1000 to 1/30 s. Contacts began a longer step with their whole impulses in proportion, and a shorter
/// one closed the sag of the longer at as much higher a speed: a stack of ten leapt by 6 m with random steps and by 20 m with steps of
/// 1/300 and 1/30 s in turn.
/// </summary>
public class ChangingStepTests
{
    private const float Gravity = 10;

    public enum Steps
    {
        Random,
        Jumps,
    }

    public static TheoryData<Steps, int> All => new()
    {
        { Steps.Random, 5 },
        { Steps.Random, 20 },
        { Steps.Jumps, 5 },
        { Steps.Jumps, 20 },
    };

    [Theory]
    [MemberData(nameof(All))]
    public void StackOf10_WithChangingSteps_Stands(Steps steps, int iterations)
    {
        using PhysicsSimulator simulator = World(iterations);
        Floor(simulator);
        List<Body> boxes = [];
        for (int i = 0; i < 10; i++)
        {
            boxes.Add(Box(simulator, 0, i + 0.5f, 1, 1, 1));
        }

        Run(simulator, steps, 0.02);

        // A hundredth of a box; with a constant step a thousandth.
        Assert.All(boxes, box => Assert.InRange(Math.Abs(box.Position.X), 0, 0.01));
        Assert.InRange(boxes[9].Position.Y, 9.49f, 9.51f);
    }

    // At rest in every one of them: 1.4 mm/s with steps of 1/50 and 1/75 s before contacts were as stiff in the shorter as in the longer.
    [Theory]
    [InlineData(0.02, 60)]
    [InlineData(0.02, 50, 75)]
    [InlineData(0.05, 50, 50, 75)]
    [InlineData(0.05, 30, 60)]
    [InlineData(0.05, 60, 120)]
    public void StackOf10_WithStepsThatTakeTurns_IsStill(double most, params int[] frequencies)
    {
        const double Seconds = 10;
        foreach (int iterations in new[] { 5, 10, 20 })
        {
            using PhysicsSimulator simulator = World(iterations);
            Floor(simulator);
            Body top = Box(simulator, 0, 0.5f, 1, 1, 1);
            for (int i = 1; i < 10; i++)
            {
                top = Box(simulator, 0, i + 0.5f, 1, 1, 1);
            }

            double sum = 0;
            int count = 0;
            double time = 0;
            for (int step = 0; time < Seconds; step++)
            {
                float dt = 1f / frequencies[step % frequencies.Length];
                simulator.Update(dt);
                time += dt;
                sum += time > Seconds / 2 ? top.LinearVelocity.LengthSquared() : 0;
                count += time > Seconds / 2 ? 1 : 0;
            }

            Assert.InRange(1000 * Math.Sqrt(sum / count), 0, most);
        }
    }

    [Theory]
    [MemberData(nameof(All))]
    public void BoxUnderAHundredTimesItsWeight_WithChangingSteps_Holds(Steps steps, int iterations)
    {
        using PhysicsSimulator simulator = World(iterations);
        Floor(simulator);
        Box(simulator, 0, 0.5f, 1, 1, 1);
        Body heavy = Box(simulator, 0, 1.5f, 1, 1, 100);
        Run(simulator, steps, 0.05);

        // The sag of the longest step, 3 cm in its worst moments.
        Assert.InRange(heavy.Position.Y, 1.45f, 1.52f);
    }

    [Theory]
    [MemberData(nameof(All))]
    public void BoxOnASlope_WithChangingSteps_StaysWhereItIs(Steps steps, int iterations)
    {
        using PhysicsSimulator simulator = World(iterations);
        const float Angle = 0.45f;
        Body slope = Box(simulator, 0, 0, 60, 1, 1);
        slope.IsStatic = true;
        slope.Rotation = Angle;
        Vector2 start = Vector2.Transform(new Vector2(-3, 1), Matrix3x2.CreateRotation(Angle));
        Body box = Box(simulator, start.X, start.Y, 1, 1, 1);
        box.Rotation = Angle;
        Run(simulator, steps, 0.01);

        // 0.12 mm measured; with only the feed-forward's loads 63 mm.
        Assert.InRange(Vector2.Distance(start, box.Position), 0, 1e-3f);
    }

    [Theory]
    [MemberData(nameof(All))]
    public void FallingBoxes_WithChangingSteps_GainNoEnergy(Steps steps, int iterations)
    {
        using PhysicsSimulator simulator = World(iterations);
        Floor(simulator);
        var random = new Random(7);
        for (int i = 0; i < 30; i++)
        {
            Body box = Box(simulator, (float)random.NextDouble() * 4, 1 + (0.8f * i), 0.5f + (float)random.NextDouble(), 0.5f, 1);
            box.Rotation = (float)random.NextDouble();
        }

        Run(simulator, steps, 0.15);
    }

    [Theory]
    [MemberData(nameof(All))]
    public void LoadedBridge_WithChangingSteps_GainsNoEnergy(Steps steps, int iterations)
    {
        using PhysicsSimulator simulator = World(iterations);
        const int Planks = 20;
        Body? before = null;
        var end = Vector2.Zero;
        for (int i = 0; i < Planks; i++)
        {
            float angle = 0.06f * (i - ((Planks - 1) / 2f));
            var along = new Vector2(MathF.Cos(angle), MathF.Sin(angle));
            Body plank = Box(simulator, end.X + (along.X / 2), end.Y + (along.Y / 2), 1, 0.25f, 1, group: 1);
            plank.Rotation = angle;
            Join(simulator, before, plank, end);
            before = plank;
            end += along;
        }

        Join(simulator, null, before!, end);
        for (int i = -1; i <= 1; i++)
        {
            Box(simulator, (end.X / 2) + (1.5f * i), 0, 1, 1, 3);
        }

        Run(simulator, steps, 0.05);
        foreach (Joint joint in simulator.JointList)
        {
            Assert.InRange(joint.JointError, 0, 1e-3f);
        }
    }

    [Theory]
    [MemberData(nameof(All))]
    public void Net_WithChangingSteps_GainsNoEnergy(Steps steps, int iterations)
    {
        using PhysicsSimulator simulator = World(iterations);
        const int Side = 6;
        var bodies = new Body[Side, Side];
        for (int x = 0; x < Side; x++)
        {
            for (int y = 0; y < Side; y++)
            {
                bodies[x, y] = Box(simulator, x, -y, 0.3f, 0.3f, 1, group: 1);
                if (x > 0)
                {
                    Join(simulator, bodies[x - 1, y], bodies[x, y], new Vector2(x - 0.5f, -y));
                }

                if (y > 0)
                {
                    Join(simulator, bodies[x, y - 1], bodies[x, y], new Vector2(x, 0.5f - y));
                }
            }
        }

        Join(simulator, null, bodies[0, 0], Vector2.Zero);
        Join(simulator, null, bodies[Side - 1, 0], new Vector2(Side - 1, 0));
        bodies[2, 5].LinearVelocity = new Vector2(5, 0);

        // Soft rows of a net sag by the square of the step: half a metre at 1/30 s, and come up again.
        Run(simulator, steps, 0.1);
    }

    /// <summary>Eight seconds.</summary>
    /// <param name="simulator">The world.</param>
    /// <param name="steps">How steps change.</param>
    /// <param name="rise">By how much energy may rise above its least so far, as a height of all bodies.</param>
    private static void Run(PhysicsSimulator simulator, Steps steps, double rise)
    {
        var random = new Random(11);
        double least = double.PositiveInfinity;
        double most = 0;
        int index = 0;
        for (double time = 0; time < 8; index++)
        {
            double dt = steps == Steps.Random
                ? Math.Pow(1000 / 30.0, random.NextDouble()) / 1000
                : (index % 2 == 0 ? 1 / 30.0 : 1 / 300.0) / (random.Next(3) == 0 ? 3 : 1);
            simulator.Update((float)dt);
            time += dt;
            double energy = Energies.Whole(simulator.BodyList, Gravity);
            double weight = Energies.Weight(simulator.BodyList, Gravity);
            least = Math.Min(least, energy);
            most = Math.Max(most, (energy - least) / weight);
        }

        Assert.All(simulator.BodyList, body => Assert.True(body.Enabled));
        Assert.InRange(most, 0, rise);
    }

    private static PhysicsSimulator World(int iterations) =>
        new(new Vector2(0, -Gravity)) { Iterations = iterations, AllowedPenetration = 0 };

    private static void Floor(PhysicsSimulator simulator) => Box(simulator, 0, -0.5f, 400, 1, 1).IsStatic = true;

    private static Body Box(PhysicsSimulator simulator, float x, float y, float width, float height, float mass, int group = 0)
    {
        Geom geom = Sandbox.Box(simulator, new Vector2(x, y), width, height, mass);
        geom.FrictionCoefficient = 0.6f;
        geom.RestitutionCoefficient = 0;
        geom.CollisionGroup = group;
        return geom.Body;
    }

    private static void Join(PhysicsSimulator simulator, Body? a, Body b, Vector2 at)
    {
        if (a is null)
        {
            JointFactory.Instance.CreateFixedRevoluteJoint(simulator, b, at);
        }
        else
        {
            JointFactory.Instance.CreateRevoluteJoint(simulator, a, b, at);
        }
    }
}
