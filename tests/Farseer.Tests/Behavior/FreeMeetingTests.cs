using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Bodies that fly free until they meet: what happens then follows from where and how they meet, see decision 027.</summary>
public class FreeMeetingTests
{
    private const float Dt = 1 / 60f;

    /// <summary>
    /// Two boxes that tumble meet at corners and sides that only their ways tell. The reference takes 64 steps where this takes one.
    /// </summary>
    [Theory]
    [InlineData(0.2f)]
    [InlineData(0.7f)]
    public void FreeBoxes_ThatMeetOnce_PartAsInMuchFinerSteps(float restitution)
    {
        const int Pairs = 250;
        const int Finer = 64;
        int met = 0;
        var off = new List<string>();
        for (int seed = 0; seed < Pairs; seed++)
        {
            double fine = EnergyAfterMeeting(seed, restitution, Dt / Finer, 24 * Finer, out int fineChanges);
            double coarse = EnergyAfterMeeting(seed, restitution, Dt, 24, out int changes);

            // One impact, and no other soon after it, which might be of another corner.
            if (fineChanges != 1 || changes > 2)
            {
                continue;
            }

            met++;
            if (Math.Abs(coarse - fine) > 0.01)
            {
                off.Add($"{seed}: {coarse:F4} of {fine:F4}");
            }
        }

        Assert.True(met > Pairs / 5, $"{met} pairs met once");

        // Corner on corner the finer steps do not tell either; from the poses of the step's start it was every fourth pair.
        Assert.True(off.Count * 50 <= met, $"{off.Count} of {met} pairs: {string.Join("; ", off)}");
    }

    /// <summary>Without friction an impact on what cannot move takes nothing at a restitution of 1, wherever and how often.</summary>
    [Theory]
    [InlineData("box")]
    [InlineData("rod")]
    [InlineData("triangle")]
    [InlineData("capsule")]
    public void Body_ThatStrikesBothSidesOfACorner_GainsNoEnergy(string shape)
    {
        const float Gravity = 10;
        var random = new Random(5);
        double worst = 0;
        for (int i = 0; i < 2000; i++)
        {
            using var simulator = new PhysicsSimulator(new Vector2(0, -Gravity));
            Wall(simulator, new Vector2(0, -0.5f), new Vector2(20, 1));
            Wall(simulator, new Vector2(-0.5f, 5), new Vector2(1, 12));
            Body body = Solid(simulator, shape, out float reach);
            body.Position = new Vector2(reach + Between(random, 0, 0.15f), reach + Between(random, 0, 0.15f));
            body.Rotation = Between(random, 0, 6.28f);
            body.LinearVelocity = new Vector2(-Between(random, 0, 10), -Between(random, 0, 10));
            body.AngularVelocity = Between(random, -20, 20);
            double before = Energies.Kinetic(body) + (body.Mass * Gravity * body.PositionY);
            for (int step = 0; step < 8; step++)
            {
                simulator.Update(Dt);
                worst = Math.Max(worst, ((Energies.Kinetic(body) + (body.Mass * Gravity * body.PositionY)) / before) - 1);
            }
        }

        // A meeting is known to a thousandth of the body's extent; contacts that bore a load after they had bounced gave up to 31 %.
        Assert.InRange(worst, 0, 2e-3);
    }

    /// <summary>The energy when all is over, in units of that of the start, and in how many steps a velocity changed.</summary>
    private static double EnergyAfterMeeting(int seed, float restitution, float dt, int steps, out int changes)
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero);
        var random = new Random(seed);
        var bodies = new List<Body>();
        var reaches = new List<float>();
        for (int i = 0; i < 2; i++)
        {
            var size = new Vector2(Between(random, 0.3f, 1.5f), Between(random, 0.3f, 1.5f));
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, size.X, size.Y, size.X * size.Y);
            Bouncing(GeomFactory.Instance.CreateRectangleGeom(simulator, body, size.X, size.Y), restitution);
            body.LinearDragCoefficient = body.RotationalDragCoefficient = 0;
            body.Rotation = Between(random, 0, 6.28f);
            body.AngularVelocity = Between(random, -10, 10);
            bodies.Add(body);
            reaches.Add(size.Length() / 2);
        }

        float reach = reaches[0] + reaches[1];
        bodies[1].Position = new Vector2(reach + Between(random, 0.02f, 0.4f), Between(random, -0.45f, 0.45f) * reach);
        bodies[1].LinearVelocity = new Vector2(-Between(random, 3, 10), 0);
        double before = Energies.Kinetic(bodies[0]) + Energies.Kinetic(bodies[1]);
        changes = 0;
        for (int step = 0; step < steps; step++)
        {
            (Vector2 velocity, float spin) = (bodies[0].LinearVelocity, bodies[0].AngularVelocity);
            simulator.Update(dt);
            changes += velocity != bodies[0].LinearVelocity || spin != bodies[0].AngularVelocity ? 1 : 0;
        }

        return (Energies.Kinetic(bodies[0]) + Energies.Kinetic(bodies[1])) / before;
    }

    private static Body Solid(PhysicsSimulator simulator, string shape, out float reach)
    {
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 0.15f);
        body.LinearDragCoefficient = body.RotationalDragCoefficient = 0;
        reach = shape == "rod" ? 1.01f : 0.76f;
        Bouncing(
            shape switch
            {
                "box" => GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1),
                "rod" => GeomFactory.Instance.CreateRectangleGeom(simulator, body, 2, 0.2f),
                "triangle" => GeomFactory.Instance.CreatePolygonGeom(
                    simulator, body, new Vertices(new Vector2[] { new(-0.6f, -0.35f), new(0.6f, -0.35f), new(0, 0.7f) }), 0.1f),
                _ => GeomFactory.Instance.CreateCapsuleGeom(simulator, body, new Vector2(-0.5f, 0), new Vector2(0.5f, 0), 0.25f),
            },
            1);
        return body;
    }

    private static void Wall(PhysicsSimulator simulator, Vector2 middle, Vector2 size)
    {
        Body wall = BodyFactory.Instance.CreateRectangleBody(simulator, size.X, size.Y, 1);
        wall.IsStatic = true;
        wall.Position = middle;
        Bouncing(GeomFactory.Instance.CreateRectangleGeom(simulator, wall, size.X, size.Y), 1);
    }

    private static void Bouncing(Geom geom, float restitution)
    {
        geom.FrictionCoefficient = 0;
        geom.RestitutionCoefficient = restitution;
    }

    private static float Between(Random random, float least, float most) => least + ((most - least) * (float)random.NextDouble());
}
