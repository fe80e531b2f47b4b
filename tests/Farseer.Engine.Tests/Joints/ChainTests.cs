using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Joints;

/// <summary>Chains of hinges that are solved as such move as the passes for all trees move them, but for roundings.</summary>
public partial class ChainTests
{
    private const float Dt = 1f / 60;

    /// <summary>
    /// Corrections stop at 1e-8 of a link, with one more or less where the two differ by a rounding; and chains of up to eight links
    /// whirl. Of a hundred two snap taut: from there on the last digits of its bends decide which way it whips.
    /// </summary>
    [Fact]
    public void RandomChains_SolvedAsSuchOrAsTrees_MoveAlike()
    {
        const int MostSnaps = 12;
        int parted = 0;
        for (int seed = 0; seed < 400; seed++)
        {
            using World chains = Build(seed, asChains: true, out List<Handle> bodies, out List<Handle> joints);
            using World trees = Build(seed, asChains: false, out _, out _);
            bool alike = true;
            for (int step = 0; step < 20 && alike; step++)
            {
                chains.Step(Dt);
                trees.Step(Dt);
                alike = bodies.TrueForAll(body => StandAlike(chains.Bodies.Pose[body.Index], trees.Bodies.Pose[body.Index]))
                    && joints.TrueForAll(joint => PullAlike(chains.JointState(joint), trees.JointState(joint)));
            }

            parted += alike ? 0 : 1;
        }

        Assert.InRange(parted, 0, MostSnaps);
    }

    private static bool StandAlike(in BodyPose a, in BodyPose b) =>
        Math.Abs(a.X - b.X) + Math.Abs(a.Y - b.Y) + Math.Abs(a.Angle - b.Angle) <= 1e-6;

    private static bool PullAlike(in JointState a, in JointState b)
    {
        double force = Math.Abs(b.ForceX) + Math.Abs(b.ForceY) + 1;
        return Math.Abs(a.ForceX - b.ForceX) + Math.Abs(a.ForceY - b.ForceY) <= 1e-3 * force
            && Math.Abs(b.Torque - a.Torque) <= 1e-3 * force && Math.Abs(b.Error - a.Error) <= 1e-6;
    }

    [Fact]
    public void RandomChains_WatchedOrNot_GiveTheSameBits()
    {
        for (int seed = 0; seed < 40; seed++)
        {
            using World watched = Build(seed, asChains: true, out _, out _);
            using World alone = Build(seed, asChains: true, out _, out _);
            watched.Accuracy.ReportEnabled = true;
            for (int step = 0; step < 60; step++)
            {
                watched.Step(Dt);
                alone.Step(Dt);
                Assert.True(watched.Bodies.MotionHash() == alone.Bodies.MotionHash(), $"seed {seed}, step {step}");
            }
        }
    }

    [Fact]
    public void RandomChains_ThatAreDisturbed_HoldTogetherAgain()
    {
        for (int seed = 0; seed < 60; seed++)
        {
            using World world = Build(seed, asChains: true, out List<Handle> bodies, out List<Handle> joints);
            var random = new Random(seed);
            for (int round = 0; round < 3; round++)
            {
                int index = bodies[random.Next(bodies.Count)].Index;
                world.Bodies.Pose[index].X += random.NextDouble() - 0.5;
                world.Bodies.State[index].AngularVelocity += (float)(200 * (random.NextDouble() - 0.5));
                for (int step = 0; step < 90; step++)
                {
                    world.Step(Dt);
                }

                foreach (Handle joint in joints)
                {
                    // Links of a metre that may still whirl at 100 rad/s, a third of a turn in a substep.
                    Assert.InRange(world.JointState(joint).Error, 0, 0.01);
                }
            }
        }
    }

    [Fact]
    public void Rope_ThatHangsStill_StaysAsItIs()
    {
        using var world = new World();
        world.Settings.Gravity = new Vector2(0, -10);
        Handle before = World.WorldFrame;
        var links = new List<Handle>();
        for (int i = 0; i < 20; i++)
        {
            Handle link = world.CreateBody(new BodyDef { X = 0, Y = -0.5 - i, Mass = 1, Inertia = 0.1f, Flags = BodyFlags.Enabled });
            Hinge(world, before, link, before.Index == 0 ? 0 : -0.5, 0.5);
            links.Add(link);
            before = link;
        }

        for (int step = 0; step < 600; step++)
        {
            world.Step(Dt);
        }

        for (int i = 0; i < links.Count; i++)
        {
            Assert.Equal(0, world.Bodies.Pose[links[i].Index].X);
            Assert.Equal(-0.5 - i, world.Bodies.Pose[links[i].Index].Y, 1e-12);
            Assert.Equal(0, world.Bodies.Pose[links[i].Index].Angle);
        }
    }

    /// <summary>Chains of one to eight links, free, at the world or at a body that moves as it wants; rooted at an end or within.</summary>
    private static World Build(int seed, bool asChains, out List<Handle> bodies, out List<Handle> joints)
    {
        var random = new Random(seed);
        var world = new World { TreesAsChains = asChains };
        world.Settings.Gravity = new Vector2(0, -10);
        bodies = new List<Handle>();
        joints = new List<Handle>();
        Handle carriage = world.CreateBody(new BodyDef { Mass = 1, Inertia = 1, Flags = BodyFlags.Enabled | BodyFlags.Kinematic });
        world.Bodies.State[carriage.Index].LinearVelocity = new Vector2(0.5f, 0.1f);
        world.Bodies.State[carriage.Index].AngularVelocity = 0.3f;
        for (int chain = 0; chain < 3; chain++)
        {
            int count = 1 + random.Next(8);
            double x = 20 * chain;
            Handle before = random.Next(3) == 0 ? default : random.Next(2) == 0 ? carriage : World.WorldFrame;
            for (int i = 0; i < count; i++)
            {
                float mass = (float)Math.Pow(10, 2 * random.NextDouble());
                Handle link =
                    world.CreateBody(new BodyDef { X = x + i, Y = 0, Mass = mass, Inertia = mass / 6, Flags = BodyFlags.Enabled });
                world.Bodies.State[link.Index].AngularVelocity = (float)(4 * (random.NextDouble() - 0.5));
                if (i > 0 || before.Index != 0 || before.Generation != 0)
                {
                    double anchor = i > 0 ? 0.5 : x - 0.5;
                    bool first = random.Next(2) == 0;
                    joints.Add(first ? Hinge(world, before, link, anchor, -0.5, 0) : Hinge(world, link, before, -0.5, anchor, 0));
                }

                bodies.Add(link);
                before = link;
            }
        }

        return world;
    }

    private static Handle Hinge(World world, Handle a, Handle b, double anchorA, double anchorB) => Hinge(world, a, b, anchorA, anchorB, 1);

    /// <param name="axis">The anchors are along x (0) or y.</param>
    private static Handle Hinge(World world, Handle a, Handle b, double anchorA, double anchorB, int axis)
    {
        JointSettings settings = default;
        settings.AnchorAX = axis == 0 ? anchorA : 0;
        settings.AnchorAY = axis == 0 ? 0 : anchorA;
        settings.AnchorBX = axis == 0 ? anchorB : 0;
        settings.AnchorBY = axis == 0 ? 0 : anchorB;
        settings.BiasFactor = 0.2;
        settings.MaxImpulse = double.PositiveInfinity;
        settings.Breakpoint = double.PositiveInfinity;
        settings.BreakForce = double.PositiveInfinity;
        return world.CreateJoint(JointKind.Revolute, a, b, settings, JointFlags.Enabled);
    }
}
