using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Chains of ropes, each of which is a limit alone. Iterated, they were pushed on from what the passes had not settled: eight ropes with
/// twenty links' weight at the end rose by 6 m where they hung, and by 3,800 m with pauses.
/// </summary>
public class RopeChainTests
{
    private const float Gravity = 10;
    private const float Seconds = 12;

    /// <summary>How long the steps are.</summary>
    public enum Pace
    {
        /// <summary>1/60 s.</summary>
        Steady,

        /// <summary>1/240 to 1/30 s.</summary>
        Random,

        /// <summary>1/60 s, and three times a second 1/10 s.</summary>
        WithPauses,
    }

    [Theory]
    [InlineData(Pace.Steady, 20)]
    [InlineData(Pace.Random, 20)]
    [InlineData(Pace.WithPauses, 20)]
    [InlineData(Pace.Steady, 200)]
    [InlineData(Pace.Steady, 1)]
    public void Chain_HungWithALoad_HangsStill(Pace pace, float load)
    {
        var chain = Chain(-Vector2.UnitY, load, (a, b) => new RopeJoint(a, Vector2.Zero, b, Vector2.Zero, 1));

        Assert.InRange(Rise(chain.Simulator, chain.Links, pace), 0, 1e-3);
    }

    /// <summary>Let go sideways: it falls, and whips at the end of its swing.</summary>
    [Theory]
    [InlineData(Pace.Steady, 20)]
    [InlineData(Pace.Random, 20)]
    [InlineData(Pace.WithPauses, 20)]
    [InlineData(Pace.Steady, 200)]
    [InlineData(Pace.Random, 1)]
    public void Chain_SwungWithALoad_GainsNoHeight(Pace pace, float load)
    {
        var chain = Chain(Vector2.UnitX, load, (a, b) => new RopeJoint(a, Vector2.Zero, b, Vector2.Zero, 1));

        // Of a fall of eight: what leapfrog's energy sways by in a whip.
        Assert.InRange(Rise(chain.Simulator, chain.Links, pace), 0, 0.1);
    }

    /// <summary>Anchors up to seven sizes off their bodies: a rope that goes taut turns such a body by far more than it moves it.</summary>
    [Theory]
    [InlineData(Pace.Steady)]
    [InlineData(Pace.Random)]
    [InlineData(Pace.WithPauses)]
    public void ChainWithAnchorsFarOffItsBodies_Fallen_GainsNoHeight(Pace pace)
    {
        for (int seed = 0; seed < 10; seed++)
        {
            var random = new Random(seed);
            Vector2 Anchor() => new Vector2(random.NextSingle() - 0.5f, random.NextSingle() - 0.5f) * 2;
            var chain = Chain(-Vector2.UnitY, 1, (a, b) =>
            {
                Vector2 one = Anchor();
                Vector2 other = Anchor();
                float length = (b.Position + other - a.Position - one).Length();
                return new RopeJoint(a, one, b, other, length + (0.5f * random.NextSingle()));
            });

            Assert.InRange(Rise(chain.Simulator, chain.Links, pace), 0, 0.01);
        }
    }

    /// <summary>
    /// A rope between two bodies that a hinge holds already stays a row of their tree: it may not take the hinge's place.
    /// </summary>
    [Fact]
    public void RopeBesideHinges_LeavesThemExact()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -Gravity));
        var bodies = new Body[4];
        for (int i = 0; i < bodies.Length; i++)
        {
            bodies[i] = Sandbox.Box(simulator, new Vector2(i, 0), 0.2f, 0.2f).Body;
        }

        simulator.Add(new RopeJoint(bodies[0], Vector2.Zero, bodies[3], Vector2.Zero, 2));
        simulator.Add(new FixedRevoluteJoint(bodies[0], Vector2.Zero));
        var hinges = new RevoluteJoint[bodies.Length - 1];
        for (int i = 0; i < hinges.Length; i++)
        {
            hinges[i] = new RevoluteJoint(bodies[i], bodies[i + 1], new Vector2(i + 0.5f, 0));
            simulator.Add(hinges[i]);
        }

        for (int i = 0; i < 300; i++)
        {
            simulator.Update(1 / 60f);
            foreach (RevoluteJoint hinge in hinges)
            {
                // To floats, and what a correction may leave in a whip, 10⁻⁴ of the arms; in a loop they would be open by hundredths.
                Assert.InRange(hinge.JointError, 0, 1e-4f);
            }
        }
    }

    /// <summary>
    /// The last of a chain is put half a length further than its rope reaches: it comes back by displacements, and stops there.
    /// </summary>
    [Fact]
    public void Chain_PulledTooLongByHand_ReturnsWithoutSpeed()
    {
        var simulator = new PhysicsSimulator(Vector2.Zero);
        Body first = Sandbox.Box(simulator, Vector2.Zero, 0.2f, 0.2f, 1000).Body;
        Body last = Sandbox.Box(simulator, Vector2.UnitX, 0.2f, 0.2f, 0.1f).Body;
        Geom inTheWay = Sandbox.Box(simulator, new Vector2(1.2f, 0), 0.1f, 0.1f);
        simulator.Add(new RopeJoint(first, Vector2.Zero, last, Vector2.Zero, 1));
        simulator.Update(1 / 60f);
        last.Position = new Vector2(1.5f, 0);
        for (int i = 0; i < 120; i++)
        {
            simulator.Update(1 / 60f);

            // As a speed the return would be a fifth of 0.5 in a substep of 1/300 s, 30.
            Assert.InRange(inTheWay.Body.LinearVelocity.Length(), 0, 1);
            Assert.InRange(last.LinearVelocity.Length(), 0, 1);
        }
    }

    private static (PhysicsSimulator Simulator, Body[] Links) Chain(Vector2 way, float load, Func<Body, Body, Joint> join)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -Gravity));
        Body before = Sandbox.Box(simulator, Vector2.Zero, 0.2f, 0.2f).Body;
        before.IsStatic = true;
        var links = new Body[8];
        for (int i = 1; i <= links.Length; i++)
        {
            Geom geom = Sandbox.Box(simulator, way * i, 0.2f, 0.2f, i == links.Length ? load : 1);
            geom.CollisionGroup = 1;
            Body link = geom.Body;
            simulator.Add(join(before, link));
            links[i - 1] = link;
            before = link;
        }

        return (simulator, links);
    }

    /// <summary>By how much all of it could be lifted with what it gained at most.</summary>
    private static double Rise(PhysicsSimulator simulator, Body[] links, Pace pace)
    {
        var random = new Random(3);
        double start = Energies.AsHeight(links, Gravity);
        double rise = 0;
        double time = 0;
        for (int i = 0; time < Seconds; i++)
        {
            float dt = pace switch
            {
                Pace.Random => 1 / (30 + (210 * random.NextSingle())),
                Pace.WithPauses when i % 20 == 0 => 0.1f,
                _ => 1 / 60f,
            };
            simulator.Update(dt);
            time += dt;
            double now = Energies.AsHeight(links, Gravity);
            Assert.True(double.IsFinite(now));
            rise = Math.Max(rise, now - start);
        }

        return rise;
    }
}
