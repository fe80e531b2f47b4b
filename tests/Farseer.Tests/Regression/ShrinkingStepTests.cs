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
/// Jointed bodies bounce in a room, with usual steps and far shorter ones by turns. What an impact in a usual step leaves of a joint's
/// error was closed in the short one as motion of its own: 50 mm in 13 µs gave 130 m/s.
/// </summary>
public class ShrinkingStepTests
{
    [Fact]
    public void Joints_InAStepFarShorterThanTheLast_MakeNoEnergy()
    {
        for (int seed = 0; seed < 100; seed++)
        {
            var random = new Random(seed);
            using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { Iterations = random.Next(1, 4) };
            AddRoom(simulator);
            float restitution = (float)random.NextDouble();
            AddLimbs(simulator, random, restitution);
            float dt = 1 / (20f + (60 * (float)random.NextDouble()));
            double most = 0;
            for (int i = 0; i < 120; i++)
            {
                simulator.Update(dt);
                double before = Energy(simulator);
                most = Math.Max(most, before);
                float shorter = (float)Math.Pow(10, -6 + (2 * random.NextDouble()));
                simulator.Update(shorter);

                // The limit of all worlds in which nothing drives; gravity gives a third of it in the longest of these steps.
                double after = Energy(simulator);
                Assert.True(after <= before + (1e-3 * most), $"Seed {seed}, {i}: {before} J became {after} J in {shorter} s.");
            }
        }
    }

    /// <summary>
    /// What a usual step leaves of an overlap, of a violated limit or of a joint's gap goes by time, at the pace of the longest step of
    /// late: of these worlds 128 gained more than a thousandth in a far shorter step, up to 23,500 times what they had.
    /// </summary>
    [Fact]
    public void RandomJointedWorlds_InStepsFarShorterThanTheLast_MakeNoEnergy()
    {
        const int Worlds = 400;
        int gained = 0;
        for (int seed = 0; seed < Worlds; seed++)
        {
            double rise = LargestRise(seed);
            Assert.True(rise <= 1e-2, $"Seed {seed} gained {rise} of its energy in one short step.");
            gained += rise > 1e-3 ? 1 : 0;
        }

        // An impact that falls into a short step is as true as its joints are, and a spring swings on.
        Assert.True(gained <= Worlds / 50, $"{gained} of {Worlds} worlds gained more than a thousandth.");
    }

    private static double LargestRise(int seed)
    {
        using var room = new JointedRoom(seed);
        var random = new Random(seed + 1);
        float dt = 1 / (20f + (60 * (float)random.NextDouble()));
        double most = room.Energy;
        double rise = 0;
        for (int i = 0; i < 120; i++)
        {
            room.Simulator.Update(random.Next(4) == 0 ? dt * (0.5f + (2 * (float)random.NextDouble())) : dt);
            double before = room.Energy;
            most = Math.Max(most, before);
            for (int shorter = random.Next(1, 4); shorter > 0; shorter--)
            {
                room.Simulator.Update((float)Math.Pow(10, -5 + (2 * random.NextDouble())));
                double after = room.Energy;
                Assert.False(double.IsNaN(after), $"Seed {seed}, {i}");
                rise = Math.Max(rise, (after - before) / most);
                before = after;
            }
        }

        return rise;
    }

    private static void AddRoom(PhysicsSimulator simulator)
    {
        foreach (Vector2 place in new[] { new Vector2(0, -3), new Vector2(0, 9), new Vector2(-6, 3), new Vector2(6, 3) })
        {
            Geom wall = Sandbox.Box(simulator, place, place.X == 0 ? 14 : 2, place.X == 0 ? 2 : 14);
            wall.Body.IsStatic = true;
            wall.RestitutionCoefficient = 0.5f;
        }
    }

    private static void AddLimbs(PhysicsSimulator simulator, Random random, float restitution)
    {
        Body? before = null;
        int count = random.Next(2, 6);
        for (int i = 0; i < count; i++)
        {
            var place = new Vector2(-4 + (2 * i), 3);
            float width = 0.4f + (float)random.NextDouble();
            float height = 0.2f + (0.4f * (float)random.NextDouble());
            Geom limb = Sandbox.Box(simulator, place, width, height, 0.05f + (float)random.NextDouble());
            limb.RestitutionCoefficient = restitution;
            limb.Body.LinearVelocity = new Vector2((20 * (float)random.NextDouble()) - 10, (20 * (float)random.NextDouble()) - 10);
            if (before != null)
            {
                RevoluteJoint hinge = JointFactory.Instance.CreateRevoluteJoint(simulator, before, limb.Body, place - Vector2.UnitX);
                hinge.CollideConnected = false;
            }

            before = random.Next(4) == 0 ? null : limb.Body;
        }
    }

    private static double Energy(PhysicsSimulator simulator)
    {
        double sum = 0;
        foreach (Body body in simulator.BodyList)
        {
            if (!body.IsStatic)
            {
                sum += 0.5 * body.Mass * body.LinearVelocity.LengthSquared();
                sum += 0.5 * body.MomentOfInertia * (double)body.AngularVelocity * body.AngularVelocity;
            }
        }

        return sum;
    }
}
