using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Joints;

/// <content>Bridges with boxes on them.</content>
public partial class ChainTests
{
    [Fact]
    public void LoadedBridges_SolvedAsChainsOrAsTrees_MoveAlike()
    {
        double largest = 0;
        double moved = 0;
        for (int seed = 0; seed < 40; seed++)
        {
            using World chains = BuildBridge(seed, asChains: true, 3, out List<Handle> bodies, out List<Handle> joints);
            using World trees = BuildBridge(seed, asChains: false, 3, out _, out _);
            double start = chains.Bodies.Pose[bodies[bodies.Count / 2].Index].Y;
            for (int step = 0; step < 24; step++)
            {
                chains.Step(Dt);
                trees.Step(Dt);
                foreach (Handle body in bodies)
                {
                    BodyPose a = chains.Bodies.Pose[body.Index];
                    BodyPose b = trees.Bodies.Pose[body.Index];
                    largest = Math.Max(largest, Math.Abs(a.X - b.X) + Math.Abs(a.Y - b.Y) + Math.Abs(a.Angle - b.Angle));
                }

                foreach (Handle joint in joints)
                {
                    Assert.Equal(trees.JointState(joint).Error, chains.JointState(joint).Error, 2e-6);
                }
            }

            moved = Math.Max(moved, Math.Abs(chains.Bodies.Pose[bodies[bodies.Count / 2].Index].Y - start));
        }

        // Corrections stop at 3e-7 of a link on both ways, at other places, and straight rows of planks answer what is left by far larger
        // bends: with corrections to 1e-10 the two differ by 1e-7. Bridges go down by a good part of a metre meanwhile.
        Assert.InRange(largest, 0, 0.01);
        Assert.InRange(moved, 0.1, 10);
    }

    [Fact]
    public void LoadedBridges_WatchedOrNot_GiveTheSameBits()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            using World watched = BuildBridge(seed, asChains: true, 300, out _, out _);
            using World alone = BuildBridge(seed, asChains: true, 300, out _, out _);
            watched.Accuracy.ReportEnabled = true;
            for (int step = 0; step < 90; step++)
            {
                watched.Step(Dt);
                alone.Step(Dt);
                Assert.True(watched.Bodies.MotionHash() == alone.Bodies.MotionHash(), $"seed {seed}, step {step}");
            }
        }
    }

    [Fact]
    public void LoadedBridges_ThatAreDisturbed_HoldTogetherAgain()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            using World world = BuildBridge(seed, asChains: true, 300, out List<Handle> bodies, out List<Handle> joints);
            var random = new Random(seed);
            for (int round = 0; round < 3; round++)
            {
                for (int step = 0; step < 60; step++)
                {
                    world.Step(Dt);
                }

                foreach (Handle joint in joints)
                {
                    // Links of a metre.
                    Assert.InRange(world.JointState(joint).Error, 0, 1e-3);
                }

                int index = bodies[random.Next(bodies.Count)].Index;
                world.Bodies.Pose[index].X += random.NextDouble() - 0.5;
                world.Bodies.State[index].AngularVelocity += (float)(20 * (random.NextDouble() - 0.5));
            }
        }
    }

    /// <summary>
    /// Planks in the shape of a wide V between two nails, of which one may be a body that moves by itself, or hanging at one nail only; and
    /// boxes dropped on them from little above, of up to
    /// <paramref name="heaviest"/> times a plank's mass.
    /// </summary>
    private static World BuildBridge(int seed, bool asChains, double heaviest, out List<Handle> bodies, out List<Handle> joints)
    {
        var random = new Random(seed);
        var world = new World { TreesAsChains = asChains };
        world.Settings.Gravity = new Vector2(0, -10);
        bodies = new List<Handle>();
        joints = new List<Handle>();
        Handle nail = World.WorldFrame;
        if (random.Next(4) == 0)
        {
            nail = world.CreateBody(new BodyDef { Mass = 1, Inertia = 1, Flags = BodyFlags.Enabled | BodyFlags.Kinematic });
            world.Bodies.State[nail.Index].LinearVelocity = new Vector2(0.1f, 0.05f);
            world.Bodies.State[nail.Index].AngularVelocity = 0.02f;
        }

        int half = 5 + random.Next(8);
        double slope = 0.1 + (0.3 * random.NextDouble());
        double x = 0;
        double y = 0;
        Handle before = nail;
        for (int i = 0; i < 2 * half; i++)
        {
            double angle = i < half ? -slope : slope;
            double dx = Math.Cos(angle);
            double dy = Math.Sin(angle);
            Handle plank = world.CreateBody(new BodyDef
            {
                X = x + (dx / 2),
                Y = y + (dy / 2),
                Angle = angle,
                Mass = 1,
                Inertia = 0.1f,
                Flags = BodyFlags.Enabled,
            });
            world.CreateCollider(plank, ShapeBuilder.Box(1, 0.2f), ColliderOf(1, 2));
            joints.Add(i > 0 ? Hinge(world, before, plank, 0.5, -0.5, 0) : Hinge(world, plank, before, -0.5, 0, 0));
            bodies.Add(plank);
            before = plank;
            x += dx;
            y += dy;
        }

        if (random.Next(5) > 0)
        {
            joints.Add(Hinge(world, World.WorldFrame, before, x, 0.5, 0));
        }

        int boxes = 1 + random.Next(2);
        for (int i = 0; i < boxes; i++)
        {
            float mass = (float)Math.Pow(heaviest, random.NextDouble());
            double at = (x / 2) + ((i - 0.5) * 2.5) + (random.NextDouble() - 0.5);
            double height = Math.Tan(-slope) * Math.Min(at, x - at);
            Handle box =
                world.CreateBody(new BodyDef { X = at, Y = height + 1.2, Mass = mass, Inertia = mass / 6, Flags = BodyFlags.Enabled });
            world.CreateCollider(box, ShapeBuilder.Box(1.5f, 1.5f), ColliderOf(2, 3));
            bodies.Add(box);
        }

        return world;
    }

    private static ColliderDef ColliderOf(uint category, uint with) => new ColliderDef
    {
        Flags = ColliderFlags.CollisionEnabled | ColliderFlags.ResponseEnabled,
        Friction = 0.5f,
        Categories = category,
        CollidesWith = with,
    };
}
