using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading.Tasks;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// Linkages of hinges and slides, some or all of them with limits. Which joint closes a loop must not matter: the limit of one that did
/// gave way like a spring, and swung the linkage the faster the longer it went on. Nor must it matter that a contact opens a limit.
/// </summary>
public class LimitedLinkageTests
{
    private const float Gravity = 10;
    private const int Seeds = 300;

    /// <summary>Of the ropes across pendulums.</summary>
    private const float Reach = 2.6f;

    /// <summary>Of the energy that a linkage has: what a coarse step makes of pendulums that whirl at 30 m/s.</summary>
    private const double LargestGain = 0.03;

    /// <summary>
    /// One in twenty is past a limit by more than 1 mm at some time: a linkage whose limits strike several at once has one round for each
    /// in a substep. With a limit that closed the loop it was one in five.
    /// </summary>
    private const int MostPast = Seeds / 15;

    /// <summary>
    /// Of so many falls three gain more than that, at most 0.07 of their energy: a box caught between links that their joints leave next to
    /// no way. With limits that closed loops one gained twice its energy; where a limit that a box opened was held at its other end in the
    /// same solution, one gained 600 times its energy.
    /// </summary>
    private const int Falls = 2000;
    private const int MostGains = 6;
    private const double MostGain = 0.2;

    /// <summary>What of a linkage has limits.</summary>
    public enum Limits
    {
        SomeJoints,
        AllJoints,
    }

    [Theory]
    [InlineData(Limits.SomeJoints)]
    [InlineData(Limits.AllJoints)]
    public void Linkage_OfJointsWithLimitsAndWithout_StaysWithinThemAndGainsNoEnergy(Limits limits)
    {
        int past = 0;
        for (int seed = 0; seed < Seeds; seed++)
        {
            using var linkage = new Linkage(seed, limits);
            double energy = linkage.Energy;
            double scale = Math.Max(Math.Abs(energy), linkage.Weight);
            float overrun = 0;
            for (int i = 0; i < 120; i++)
            {
                linkage.Simulator.Update(1 / 60f);
                double before = energy;
                energy = linkage.Energy;
                overrun = Math.Max(overrun, linkage.Overrun);
                Assert.True(energy - before <= LargestGain * scale, $"linkage {seed}, step {i}: {before} to {energy} J");
            }

            past += overrun > 1e-3 ? 1 : 0;
        }

        Assert.InRange(past, 0, MostPast);
    }

    /// <summary>Equal trees may be solved side by side, where nothing asks for limits across them.</summary>
    [Fact]
    public void LimitsAcross_EqualPendulums_HoldEach()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -Gravity));
        var ends = new List<(Body Top, Body Bottom)>();
        for (int i = 0; i < 8; i++)
        {
            var links = new Body[4];
            var start = new Vector2(0, 10 * i);
            for (int k = 0; k < links.Length; k++)
            {
                // A stair: its ends are 2.1 m apart, and 3 m once the pendulum has fallen.
                Vector2 end = start + (k % 2 == 0 ? Vector2.UnitX : -Vector2.UnitY);
                links[k] = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 0.1f, 1);
                links[k].Position = 0.5f * (start + end);
                links[k].Rotation = k % 2 == 0 ? 0 : -MathF.PI / 2;
                simulator.Add(k == 0 ? new FixedRevoluteJoint(links[0], start) : new RevoluteJoint(links[k - 1], links[k], start));
                start = end;
            }

            simulator.Add(new RopeJoint(links[0], Vector2.Zero, links[3], Vector2.Zero, Reach));
            ends.Add((links[0], links[3]));
        }

        float most = 0;
        for (int step = 0; step < 300; step++)
        {
            simulator.Update(1 / 60f);
            foreach ((Body top, Body bottom) in ends)
            {
                most = Math.Max(most, Vector2.Distance(top.Position, bottom.Position));
            }
        }

        // Taut at some time, and past its length by no more than its bend in a substep.
        Assert.InRange(most, Reach - 0.01f, Reach + 1e-3f);
    }

    [Fact]
    public void Linkage_ThatBoxesFallOn_GainsNoEnergy()
    {
        var gains = new double[Falls];
        Parallel.For(0, Falls, seed =>
        {
            using var linkage = new LinkageUnderBoxes(seed);
            gains[seed] = Energies.LargestGain(linkage.Simulator, () => linkage.Energy, linkage.Weight, 180);
        });
        Assert.InRange(gains.Max(), 0, MostGain);
        Assert.InRange(gains.Count(g => g > LargestGain), 0, MostGains);
    }

    private sealed class Linkage : IDisposable
    {
        private readonly Random _random;
        private readonly List<Body> _bodies = new List<Body>();
        private readonly List<Func<float>> _overruns = new List<Func<float>>();

        public Linkage(int seed, Limits limits)
        {
            _random = new Random(seed);
            Simulator = new PhysicsSimulator(new Vector2(0, -Gravity)) { Iterations = _random.Next(1, 6) };
            int count = _random.Next(3, 7);
            for (int i = 0; i < count; i++)
            {
                Body body = BodyFactory.Instance.CreateRectangleBody(
                    Simulator, Between(0.2f, 1.4f), Between(0.2f, 0.8f), Between(0.05f, 2));
                body.Position = new Vector2(2 * MathF.Cos(i * MathF.Tau / count), 2 * MathF.Sin(i * MathF.Tau / count));
                body.LinearVelocity = new Vector2(Between(-3, 3), Between(-3, 3));
                Sandbox.WithoutDrag(body);
                _bodies.Add(body);
            }

            bool all = limits == Limits.AllJoints;
            int free = all ? -1 : _random.Next(count);
            for (int i = 0; i < count; i++)
            {
                Tie(_bodies[i], _bodies[(i + 1) % count], i != free && (all || _random.Next(3) > 0));
            }

            if (_random.Next(2) == 0)
            {
                Simulator.Add(new FixedRevoluteJoint(_bodies[0], _bodies[0].Position + new Vector2(Between(-1, 1), Between(-1, 1))));
            }
        }

        public PhysicsSimulator Simulator { get; }

        public double Energy => Energies.Whole(_bodies, Gravity);

        public double Weight => Energies.Weight(_bodies, Gravity);

        public float Overrun
        {
            get
            {
                float most = 0;
                foreach (Func<float> overrun in _overruns)
                {
                    most = Math.Max(most, overrun());
                }

                return most;
            }
        }

        public void Dispose() => Simulator.Dispose();

        private void Tie(Body a, Body b, bool limited)
        {
            Vector2 anchor = 0.5f * (a.Position + b.Position);
            if (_random.Next(2) == 0)
            {
                var hinge = new RevoluteJoint(a, b, anchor)
                {
                    AreLimitsEnabled = limited, LowerLimit = Between(-0.5f, 0), UpperLimit = Between(0, 0.5f),
                };
                Simulator.Add(hinge);
                Note(limited, () => hinge.JointAngle, hinge.LowerLimit, hinge.UpperLimit);
            }
            else
            {
                float angle = Between(0, MathF.Tau);
                var slide = new PrismaticJoint(a, b, anchor, new Vector2(MathF.Cos(angle), MathF.Sin(angle)))
                {
                    AreLimitsEnabled = limited, LowerLimit = 0, UpperLimit = Between(0, 0.2f),
                };
                Simulator.Add(slide);
                Note(limited, () => slide.Travel, slide.LowerLimit, slide.UpperLimit);
            }
        }

        private void Note(bool limited, Func<float> at, float lower, float upper)
        {
            if (limited)
            {
                _overruns.Add(() => Math.Max(lower - at(), at() - upper));
            }
        }

        private float Between(float low, float high) => low + ((high - low) * (float)_random.NextDouble());
    }
}
