using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Joints together with contacts and limits: what touches a tree meets the mass of all of it.</summary>
public class JointTreeTests
{
    private const int Planks = 16;

    /// <summary>Links between posts of 100 units; the ratio of the load to a plank.</summary>
    [Theory]
    [InlineData(10f)]
    [InlineData(64f)]
    [InlineData(200f)]
    [InlineData(1000f)]
    public void Bridge_CarriesALoad_AtAnyRatio(float ratio)
    {
        var bridge = new Bridge(ratio, 1);
        Sandbox.Run(bridge.Simulator, 600, 1 / 60f);
        float error = 0;
        float depth = 0;
        for (int i = 0; i < 120; i++)
        {
            Sandbox.Run(bridge.Simulator, 1, 1 / 60f);
            error = Math.Max(error, bridge.Joints.Max(joint => Math.Abs(joint.JointError)));
            depth = Math.Max(
                depth,
                bridge.Simulator.ArbiterList.SelectMany(pair => pair.ContactList).Select(c => -c.Separation).DefaultIfEmpty(0).Max());
        }

        // Of planks of 10: joints to 1/100,000, the load sinks by 1/50 at most, half of it the depth at which contacts rest.
        Assert.InRange(error, 0, 1e-4f);
        Assert.InRange(depth, 0, 0.2f);
        Assert.InRange(bridge.Load.Position.Y, -20, 60);
    }

    [Theory]
    [InlineData(30f)]
    [InlineData(1000f)]
    public void Bridge_ScaledByAPowerOfTwo_GoesTheSameWayBitForBit(float ratio)
    {
        var bridge = new Bridge(ratio, 1);
        var scaled = new Bridge(ratio, 1024);
        for (int i = 0; i < 12; i++)
        {
            Assert.Equal(bridge.State(), scaled.State());
            Sandbox.Run(bridge.Simulator, 10);
            Sandbox.Run(scaled.Simulator, 10);
        }

        Assert.True(bridge.Simulator.ArbiterList.Count > 0, "The load was to land.");
    }

    [Theory]
    [InlineData(30f)]
    [InlineData(1000f)]
    public void Bridge_UnderALoad_AllocatesNothingOnceWarm(float ratio)
    {
        var bridge = new Bridge(ratio, 1);
        Sandbox.Run(bridge.Simulator, 200);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Sandbox.Run(bridge.Simulator, 100);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    /// <summary>
    /// Links in a star, all at their lower limits, set in motion at random: the velocities are those nearest by mass that meet the joints
    /// and open no limit downwards, found here by trying every set of limits.
    /// </summary>
    [Fact]
    public void Limits_OfASmallTree_AreTheSolutionOfTheComplementarityProblem()
    {
        for (int seed = 0; seed < 40; seed++)
        {
            var random = new Random(seed);
            PhysicsSimulator simulator = Sandbox.Falling(0);
            const int Count = 5;
            var bodies = new Body[Count];
            for (int i = 0; i < Count; i++)
            {
                bodies[i] = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, (float)Math.Pow(10, random.NextDouble()));
                bodies[i].Position = new Vector2(10 * i, (float)(3 * random.NextDouble()));
                bodies[i].LinearVelocity = new Vector2((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f);
                bodies[i].AngularVelocity = (float)random.NextDouble() - 0.5f;
                Sandbox.WithoutDrag(bodies[i]);
            }

            var anchors = new Vector2[Count];
            var parents = new int[Count];
            for (int i = 1; i < Count; i++)
            {
                parents[i] = random.Next(i);
                anchors[i] = bodies[i].Position + new Vector2(-5, (float)random.NextDouble());
                RevoluteJoint joint = JointFactory.Instance.CreateRevoluteJoint(simulator, bodies[parents[i]], bodies[i], anchors[i]);
                joint.AreLimitsEnabled = true;
                joint.LowerLimit = 0;
                joint.UpperLimit = 3;
            }

            double[] expected = ComplementaritySolution(bodies, parents, anchors);

            // So short a step that nothing turns meanwhile.
            Sandbox.Run(simulator, 1, 1e-5f);
            for (int i = 0; i < Count; i++)
            {
                Assert.Equal(expected[3 * i], bodies[i].LinearVelocity.X, 1e-3);
                Assert.Equal(expected[(3 * i) + 1], bodies[i].LinearVelocity.Y, 1e-3);
                Assert.Equal(expected[(3 * i) + 2], bodies[i].AngularVelocity, 1e-3);
            }
        }
    }

    /// <summary>A trunk with four limbs of two links, all with limits, dropped.</summary>
    [Theory]
    [InlineData(30f)]
    [InlineData(200f)]
    public void Ragdoll_ComesToRest_WithinItsLimits(float height)
    {
        PhysicsSimulator simulator = Sandbox.WithFloor(out _);
        Geom trunk = Part(simulator, new Vector2(0, -60 - height), 20, 40, 4);
        var joints = new List<(RevoluteJoint Joint, Body A, Body B)>();
        for (int side = -1; side <= 1; side += 2)
        {
            for (int end = -1; end <= 1; end += 2)
            {
                var at = new Vector2(side * 12, -60 - height + (end * 18));
                Geom upper = Part(simulator, at + new Vector2(side * 8, 0), 16, 6, 1);
                Geom lower = Part(simulator, at + new Vector2(side * 24, 0), 16, 6, 1);
                joints.Add((Limited(simulator, trunk.Body, upper.Body, at), trunk.Body, upper.Body));
                joints.Add((Limited(simulator, upper.Body, lower.Body, at + new Vector2(side * 16, 0)), upper.Body, lower.Body));
            }
        }

        float over = 0;
        float error = 0;
        for (int i = 0; i < 1200; i++)
        {
            Sandbox.Run(simulator, 1);
            over = Math.Max(over, joints.Max(j => Math.Abs(j.B.TotalRotation - j.A.TotalRotation) - 0.8f));
            error = Math.Max(error, joints.Max(j => Math.Abs(j.Joint.JointError)));
        }

        // 0.2 degrees, and a thousandth of a limb's width.
        Assert.InRange(over, float.NegativeInfinity, 0.0035f);
        Assert.InRange(error, 0, 0.006f);
        Assert.All(simulator.BodyList.Where(body => !body.IsStatic), body => Assert.InRange(body.LinearVelocity.Length(), 0, 0.01f));
    }

    private static Geom Part(PhysicsSimulator simulator, Vector2 place, float width, float height, float mass)
    {
        Geom geom = Sandbox.Box(simulator, place, width, height, mass);
        geom.CollisionGroup = 1;

        // Limbs that hang free would swing for ever.
        geom.Body.LinearDragCoefficient = 2 * mass;
        return geom;
    }

    private static RevoluteJoint Limited(PhysicsSimulator simulator, Body a, Body b, Vector2 anchor)
    {
        RevoluteJoint joint = JointFactory.Instance.CreateRevoluteJoint(simulator, a, b, anchor);
        joint.AreLimitsEnabled = true;
        joint.LowerLimit = -0.8f;
        joint.UpperLimit = 0.8f;
        return joint;
    }

    private static double[] ComplementaritySolution(Body[] bodies, int[] parents, Vector2[] anchors)
    {
        int limits = bodies.Length - 1;
        double[] best = [];
        double least = double.NegativeInfinity;
        for (int set = 0; set < 1 << limits; set++)
        {
            double[] v = Velocities(bodies, parents, anchors, set, out double worst);
            if (worst > least)
            {
                least = worst;
                best = v;
            }
        }

        Assert.True(least > -1e-9, "One set of limits meets all conditions.");
        return best;
    }

    /// <summary>Velocities with the limits of a set held; the least of their multipliers and of the others' opening speeds.</summary>
    private static double[] Velocities(Body[] bodies, int[] parents, Vector2[] anchors, int set, out double worst)
    {
        int size = 3 * bodies.Length;
        var rows = new List<double[]>();
        var held = new List<int>();
        for (int i = 1; i < bodies.Length; i++)
        {
            Vector2 b = anchors[i] - bodies[i].Position;
            Vector2 a = anchors[i] - bodies[parents[i]].Position;
            rows.Add(Row(size, parents[i], i, 1, 0, a, b));
            rows.Add(Row(size, parents[i], i, 0, 1, a, b));
        }

        for (int i = 1; i < bodies.Length; i++)
        {
            if ((set & (1 << (i - 1))) != 0)
            {
                held.Add(rows.Count);
                rows.Add(Turn(size, parents[i], i));
            }
        }

        var velocity = new double[size];
        var inverse = new double[size];
        for (int i = 0; i < bodies.Length; i++)
        {
            velocity[3 * i] = bodies[i].LinearVelocity.X;
            velocity[(3 * i) + 1] = bodies[i].LinearVelocity.Y;
            velocity[(3 * i) + 2] = bodies[i].AngularVelocity;
            inverse[3 * i] = 1.0 / bodies[i].Mass;
            inverse[(3 * i) + 1] = 1.0 / bodies[i].Mass;
            inverse[(3 * i) + 2] = 1.0 / bodies[i].MomentOfInertia;
        }

        double[] multipliers = Solve(rows, inverse, velocity);
        for (int r = 0; r < rows.Count; r++)
        {
            for (int k = 0; k < size; k++)
            {
                velocity[k] += inverse[k] * rows[r][k] * multipliers[r];
            }
        }

        worst = held.Count == 0 ? double.PositiveInfinity : held.Min(r => multipliers[r]);
        for (int i = 1; i < bodies.Length; i++)
        {
            if ((set & (1 << (i - 1))) == 0)
            {
                worst = Math.Min(worst, velocity[(3 * i) + 2] - velocity[(3 * parents[i]) + 2]);
            }
        }

        return velocity;
    }

    private static double[] Row(int size, int a, int b, double x, double y, Vector2 armA, Vector2 armB)
    {
        var row = new double[size];
        row[3 * b] = x;
        row[(3 * b) + 1] = y;
        row[(3 * b) + 2] = (armB.X * y) - (armB.Y * x);
        row[3 * a] = -x;
        row[(3 * a) + 1] = -y;
        row[(3 * a) + 2] = (armA.Y * x) - (armA.X * y);
        return row;
    }

    private static double[] Turn(int size, int a, int b)
    {
        var row = new double[size];
        row[(3 * b) + 2] = 1;
        row[(3 * a) + 2] = -1;
        return row;
    }

    /// <summary>J M⁻¹ Jᵀ λ = -J v, by elimination.</summary>
    private static double[] Solve(List<double[]> rows, double[] inverse, double[] velocity)
    {
        int n = rows.Count;
        var m = new double[n, n + 1];
        for (int i = 0; i < n; i++)
        {
            for (int k = 0; k < n; k++)
            {
                m[i, k] = rows[i].Zip(rows[k], (x, y) => x * y).Zip(inverse, (x, y) => x * y).Sum();
            }

            m[i, n] = -rows[i].Zip(velocity, (x, y) => x * y).Sum();
        }

        for (int i = 0; i < n; i++)
        {
            for (int row = 0; row < n; row++)
            {
                double factor = row == i ? 0 : m[row, i] / m[i, i];
                for (int k = i; factor != 0 && k <= n; k++)
                {
                    m[row, k] -= factor * m[i, k];
                }
            }
        }

        return Enumerable.Range(0, n).Select(i => m[i, n] / m[i, i]).ToArray();
    }

    /// <summary>Planks of 10 on hinges between two fixed points 0.95 of their length apart, and a box that lands in the middle.</summary>
    private sealed class Bridge
    {
        public Bridge(float ratio, float scale)
        {
            Simulator = Sandbox.Falling(100 * scale);
            Simulator.AllowedPenetration *= scale;
            Simulator.BiasFactor = 0.8f;
            float length = 10 * scale;
            float sine = MathF.Sqrt(1 - (0.95f * 0.95f));
            Vector2 end = Vector2.Zero;
            Body before = new Body { IsStatic = true };
            for (int i = 0; i <= Planks; i++)
            {
                if (i == Planks)
                {
                    Body post = new Body { IsStatic = true, Position = end };
                    Joints.Add(JointFactory.Instance.CreateRevoluteJoint(Simulator, before, post, end));
                    break;
                }

                var along = new Vector2(0.95f * length, (i < Planks / 2 ? sine : -sine) * length);
                Geom plank = Sandbox.Box(Simulator, end + (along / 2), length, 2 * scale, 1);
                plank.Body.Rotation = MathF.Atan2(along.Y, along.X);
                plank.CollisionGroup = 1;
                plank.FrictionCoefficient = 0.6f;
                Joints.Add(JointFactory.Instance.CreateRevoluteJoint(Simulator, before, plank.Body, end));
                before = plank.Body;
                end += along;
            }

            Geom load =
                Sandbox.Box(Simulator, new Vector2(end.X / 2, (Planks / 2 * sine * length) - (18 * scale)), 20 * scale, 20 * scale, ratio);
            load.FrictionCoefficient = 0.6f;
            Load = load.Body;
            Scale = scale;
        }

        public PhysicsSimulator Simulator { get; }

        public List<RevoluteJoint> Joints { get; } = [];

        public Body Load { get; }

        private float Scale { get; }

        public float[] State() => Simulator.BodyList.SelectMany(body => new[]
        {
            body.Position.X / Scale, body.Position.Y / Scale, body.Rotation, body.LinearVelocity.X / Scale, body.LinearVelocity.Y / Scale,
            body.AngularVelocity,
        }).ToArray();
    }
}
