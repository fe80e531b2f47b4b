using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>
/// Geoms up to four hundred sizes off their bodies: they answer by turning up to a million times what they answer by moving. With the arms
/// as far turned as others may be such bodies left at up to 10¹³ m/s: of 500 worlds 302 gained energy.
/// </summary>
public class FarSurfaceTests
{
    private const int Worlds = 300;
    private const int Steps = 300;
    private const float Dt = 1 / 60f;
    private const float Gravity = 10;
    private const float Fastest = 5;

    [Fact]
    public void GeomsFarOffTheirBodies_OnAFloor_GainNothing()
    {
        int gained = 0;
        for (int seed = 0; seed < Worlds; seed++)
        {
            using PhysicsSimulator simulator = World(seed, out List<Body> bodies);
            double before = Energies.Whole(bodies, Gravity);
            double moving = bodies.Sum(Energies.Kinetic);
            double above = 0;
            for (int i = 0; i < Steps; i++)
            {
                simulator.Update(Dt);
                above = Math.Max(above, Energies.Whole(bodies, Gravity) - before);

                // No faster than what was thrown and fell all the time.
                double most = (Math.Sqrt(2) * Fastest) + (Gravity * Dt * Steps);
                Assert.All(bodies, b => Assert.True(b.LinearVelocity.Length() <= most, $"{seed}, {i}: {b.LinearVelocity}"));
            }

            Assert.True(above <= 10 * moving, $"{seed} gained {above} J");
            gained += above > 0.1 * moving ? 1 : 0;
        }

        Assert.True(gained <= Worlds / 50, $"{gained} of {Worlds} worlds gained a tenth of their motion.");
    }

    private static PhysicsSimulator World(int seed, out List<Body> bodies)
    {
        var random = new Random(seed);
        float Between(float low, float high) => low + ((high - low) * (float)random.NextDouble());
        var simulator = new PhysicsSimulator(new Vector2(0, -Gravity)) { Iterations = random.Next(1, 6) };
        Geom floor = Sandbox.Box(simulator, new Vector2(0, -50), 1e5f, 100);
        floor.Body.IsStatic = true;
        bodies = new List<Body>();
        int count = random.Next(2, 9);
        for (int i = 0; i < count; i++)
        {
            float size = Between(0.3f, 1.5f);
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, size, size, Between(0.1f, 3));
            Sandbox.WithoutDrag(body);

            // m·r²/I of 9 to 10⁶.
            double ratio = Math.Pow(10, 0.95 + (5.05 * random.NextDouble()));
            float lever = random.Next(4) == 0 ? 0 : size * (float)Math.Sqrt(ratio / 6);
            double angle = 2 * Math.PI * random.NextDouble();
            var off = new Vector2(lever * (float)Math.Cos(angle), lever * (float)Math.Sin(angle));
            body.Position = new Vector2(1.3f * (i % 4), 1 + (1.3f * (i / 4))) - off;
            Geom geom = random.Next(2) == 0
                ? GeomFactory.Instance.CreatePolygonGeom(
                    simulator, body, Vertices.CreateRectangle(Between(0.3f, 1.2f), Between(0.3f, 1.2f)), off, 0, 0)
                : GeomFactory.Instance.CreateCircleGeom(simulator, body, Between(0.2f, 0.7f), 12, off, 0);
            geom.FrictionCoefficient = Between(0, 1);
            geom.RestitutionCoefficient = random.Next(2) * Between(0, 0.8f);
            body.LinearVelocity = new Vector2(Between(-Fastest, Fastest), Between(-Fastest, Fastest));
            bodies.Add(body);
        }

        return simulator;
    }
}
