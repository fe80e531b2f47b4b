using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>
/// Loads of 100 to 5,000 planks, boxes and balls, fall on bridges that are straight and taut, or sag by up to a sixth of their length. The
/// planks turned out of the way within a substep, for their own inertia was all that held them in line: 13 of 100 loads fell through.
/// </summary>
public class LoadedBridgeTests
{
    private const float PlankMass = 5;
    private const float Thickness = 0.25f;

    [Fact]
    public void Load_DroppedOnBridge_IsCarried()
    {
        for (int seed = 0; seed < 100; seed++)
        {
            var random = new Random(seed);
            int planks = random.Next(6, 35);
            double turn = random.Next(2) == 0 ? 0 : 0.04 * random.NextDouble();
            using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { Iterations = random.Next(4) == 0 ? 10 : 5 };
            double span = AddBridge(simulator, planks, turn);
            Body load = AddLoad(simulator, random, planks);
            Sandbox.Run(simulator, 300, 1 / 60f);

            // One that rolls off an end falls beside the bridge. What a bridge carries is at most as deep as half of its length.
            bool beside = Math.Abs(load.Position.X) > 0.5 * span;
            Assert.True(
                beside || load.Position.Y > -0.5 * planks,
                $"Seed {seed}: 1:{load.Mass / PlankMass} on {planks} planks with turns of {turn} is at {load.Position}.");
        }
    }

    /// <returns>The distance of its ends.</returns>
    private static double AddBridge(PhysicsSimulator simulator, int planks, double turn)
    {
        double angle = -0.5 * turn * (planks - 1);
        double span = turn > 0 ? Math.Sin(0.5 * planks * turn) / Math.Sin(0.5 * turn) : planks;
        var end = new Vector2((float)(-0.5 * span), 0);
        Body before = AddAnchor(simulator, end);
        for (int i = 0; i < planks; i++)
        {
            var along = new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle));
            Geom plank = Sandbox.Box(simulator, end + (0.5f * along), 1, Thickness, PlankMass);
            plank.Body.Rotation = (float)angle;
            plank.CollisionGroup = 1;
            plank.FrictionCoefficient = 0.6f;
            JointFactory.Instance.CreateRevoluteJoint(simulator, before, plank.Body, end);
            before = plank.Body;
            end += along;
            angle += turn;
        }

        JointFactory.Instance.CreateRevoluteJoint(simulator, before, AddAnchor(simulator, end), end);
        return span;
    }

    private static Body AddAnchor(PhysicsSimulator simulator, Vector2 position)
    {
        Body anchor = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        anchor.Position = position;
        anchor.IsStatic = true;
        return anchor;
    }

    private static Body AddLoad(PhysicsSimulator simulator, Random random, int planks)
    {
        float mass = PlankMass * (float)Math.Pow(10, 2 + (1.7 * random.NextDouble()));
        float half = 1 + (1.5f * (float)random.NextDouble());
        float height = 0.2f + (5 * (float)random.NextDouble()) + (1.5f * half);
        var position = new Vector2(0.6f * planks * ((float)random.NextDouble() - 0.5f), height);
        Geom load = random.Next(4) == 0
            ? AddBall(simulator, position, half, mass)
            : Sandbox.Box(simulator, position, 2 * half, 2 * half, mass);
        load.Body.Rotation = (2 * (float)random.NextDouble()) - 1;
        load.FrictionCoefficient = 0.6f;
        return load.Body;
    }

    private static Geom AddBall(PhysicsSimulator simulator, Vector2 position, float radius, float mass)
    {
        Body ball = BodyFactory.Instance.CreateCircleBody(simulator, radius, mass);
        ball.Position = position;
        return GeomFactory.Instance.CreateCircleGeom(simulator, ball, radius, 32);
    }
}
