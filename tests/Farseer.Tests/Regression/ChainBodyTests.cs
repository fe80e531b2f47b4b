using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Chains on bodies that move. What is in front of a link was told by the other piece's centre, which for a wide floor lies anywhere: links
/// that looked away from the floor were pushed out of it through its far side, and links that lay on it fell in.
/// </summary>
public class ChainBodyTests
{
    private const int Seeds = 300;
    private const float Gravity = 10;

    /// <summary>
    /// Of energies as heights, m: what a fall in a step is off, as for polygons. Between links a body may also lose the rest of a step in
    /// which the sweep stops it, and so not fall by a step's way at up to 12 m/s.
    /// </summary>
    private static double Spare(string floor, float dt) => 0.02 + (40 * dt * dt) + (floor == "chain" ? 12 * dt : 0);

    [Theory]
    [InlineData("closed", "box", 1 / 60f)]
    [InlineData("closed", "polygon", 1 / 60f)]
    [InlineData("closed", "chain", 1 / 60f)]
    [InlineData("open", "box", 1 / 60f)]
    [InlineData("open", "polygon", 1 / 60f)]
    [InlineData("open", "chain", 1 / 60f)]
    [InlineData("closed", "box", 1 / 30f)]
    [InlineData("closed", "chain", 1 / 30f)]
    [InlineData("open", "box", 1 / 30f)]
    [InlineData("closed", "box", 0.1f)]
    [InlineData("open", "box", 0.1f)]
    public void Chain_ThrownOnAFloor_GainsNoEnergyAndStaysAbove(string kind, string floor, float dt)
    {
        var bad = new List<string>();
        for (int seed = 0; seed < Seeds; seed++)
        {
            Outcome outcome = Throw(seed, kind, floor, dt, bodies: 1);
            if (outcome.IsBad(Spare(floor, dt)))
            {
                bad.Add($"{seed}: {outcome}");
            }
        }

        Assert.True(bad.Count == 0, $"{bad.Count} of {Seeds}: {string.Join("; ", bad.Take(8))}");
    }

    [Theory]
    [InlineData("closed")]
    [InlineData("open")]
    [InlineData("mixed")]
    public void Chains_InAHeap_GainNoEnergyAndStayAbove(string kind)
    {
        const float Dt = 1 / 60f;
        var bad = new List<string>();
        for (int seed = 0; seed < Seeds / 6; seed++)
        {
            Outcome outcome = Throw(seed, kind, "box", Dt, bodies: 6);
            if (outcome.IsBad(Spare("chain", Dt)))
            {
                bad.Add($"{seed}: {outcome}");
            }
        }

        Assert.True(bad.Count == 0, $"{bad.Count} of {Seeds / 6}: {string.Join("; ", bad.Take(8))}");
    }

    private static Outcome Throw(int seed, string kind, string floor, float dt, int bodies)
    {
        const double Seconds = 4;
        var random = new Random((seed * 7919) + 13);
        var simulator = new PhysicsSimulator(new Vector2(0, -Gravity));
        Outcome outcome = default;
        simulator.BodyQuarantined += (_, _) => outcome.Quarantined = true;
        float restitution = Within(random, 0, 0.8f);
        float friction = Within(random, 0, 0.8f);
        var geoms = new List<Geom> { Floor(simulator, floor) };
        for (int i = 0; i < bodies; i++)
        {
            Geom geom = Body(simulator, random, kind);
            geom.Body.Position = new Vector2(
                Within(random, -3, 3) * (bodies > 1 ? 0.5f : 3), 1.5f + Within(random, 0, bodies > 1 ? 0.4f : 2.5f) + (i * 3.1f));
            geom.Body.Rotation = Within(random, 0, 6.28f);
            geom.Body.LinearVelocity = new Vector2(Within(random, -5, 5), Within(random, -5, 0));
            geom.Body.AngularVelocity = Within(random, -5, 5);
            geoms.Add(geom);
        }

        foreach (Geom geom in geoms)
        {
            geom.RestitutionCoefficient = restitution;
            geom.FrictionCoefficient = friction;
        }

        List<Body> moving = geoms.Skip(1).Select(geom => geom.Body).ToList();
        simulator.Update(1e-6f);
        double least = Energies.AsHeight(moving, Gravity);
        for (int step = 0; step < Seconds / dt; step++)
        {
            simulator.Update(dt);
            double height = Energies.AsHeight(moving, Gravity);
            least = Math.Min(least, height);
            outcome.Rise = height - least <= outcome.Rise ? outcome.Rise : height - least;
            foreach (Geom geom in geoms.Skip(1))
            {
                outcome.Depth = Math.Max(outcome.Depth, -geom.WorldVertices.Min(vertex => vertex.Y));
            }
        }

        return outcome;
    }

    private static Geom Floor(PhysicsSimulator simulator, string kind)
    {
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        body.IsStatic = true;
        body.Position = new Vector2(0, -5);
        switch (kind)
        {
            case "box":
                return GeomFactory.Instance.CreateRectangleGeom(simulator, body, 80, 10);
            case "polygon":
                // Its centroid, which becomes the origin, is that of a rectangle of 80 by 10 with a triangle of 5 by 10 at either end.
                return GeomFactory.Instance.CreatePolygonGeom(
                    simulator, body, Sandbox.Outline(-40, -5, 40, -5, 45, 0, 40, 5, -40, 5, -45, 0), 0);
            default:
                var points = new Vertices();
                for (int i = 20; i >= -20; i--)
                {
                    points.Add(new Vector2(2 * i, 5));
                }

                points.Add(new Vector2(-40, -5));
                points.Add(new Vector2(40, -5));
                return GeomFactory.Instance.CreateChainGeom(simulator, body, points, true);
        }
    }

    private static Geom Body(PhysicsSimulator simulator, Random random, string kind)
    {
        int count = random.Next(3, 9);
        double start = random.NextDouble() * 6.28;
        var ring = new Vertices();
        for (int i = 0; i < count; i++)
        {
            double angle = start + (2 * Math.PI * (i + (0.5 * (random.NextDouble() - 0.5))) / count);
            ring.Add(Within(random, 0.7f, 1.3f) * new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle)));
        }

        Body body = BodyFactory.Instance.CreateCircleBody(simulator, 1, Within(random, 0.5f, 3));
        Sandbox.WithoutDrag(body);
        string chosen = kind == "mixed" ? new[] { "closed", "open", "polygon", "box", "circle" }[random.Next(5)] : kind;
        return chosen switch
        {
            "closed" => GeomFactory.Instance.CreateChainGeom(simulator, body, ring, true),
            "open" => GeomFactory.Instance.CreateChainGeom(simulator, body, ring, false),
            "polygon" => GeomFactory.Instance.CreatePolygonGeom(simulator, body, ring, 0),
            "box" => GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1.2f, 0.8f),
            _ => GeomFactory.Instance.CreateCircleGeom(simulator, body, 0.6f, 16),
        };
    }

    private static float Within(Random random, float least, float most) => least + ((most - least) * (float)random.NextDouble());

    private struct Outcome
    {
        public bool Quarantined;
        public double Rise;
        public double Depth;

        // Half of what a body of 1 m may sink in before a sweep stops it, and the depth of rest.
        public readonly bool IsBad(double spare) => Quarantined || !(Rise <= spare) || !(Depth <= 0.35);

        public override readonly string ToString() =>
            $"{(Quarantined ? "quarantined, " : string.Empty)}rise {Rise:G3} m, depth {Depth:G3} m";
    }
}
