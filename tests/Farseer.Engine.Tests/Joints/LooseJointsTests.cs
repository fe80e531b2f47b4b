using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Joints;

/// <summary>Joints that are iterated give side by side the bits that they give one by one.</summary>
public class LooseJointsTests
{
    private static readonly JointKind[] Kinds =
    [
        JointKind.Revolute,
        JointKind.Pin,
        JointKind.Distance,
        JointKind.Target,
        JointKind.Motor,
        JointKind.Angle,
        JointKind.Gear,
        JointKind.AngleLimit,
        JointKind.Rope,
        JointKind.Slider,
        JointKind.Pulley,
    ];

    [Fact]
    public void RandomLooseJoints_SideBySideOrOneByOne_GiveTheSameBits()
    {
        int sideBySide = 0;
        for (int seed = 0; seed < 90; seed++)
        {
            sideBySide += Compare(seed, floor: false);
        }

        // Or the two ways would be one.
        Assert.True(sideBySide > 1000, $"{sideBySide}");
    }

    [Fact]
    public void RandomLooseJointsOnAFloor_SideBySideOrOneByOne_GiveTheSameBits()
    {
        int sideBySide = 0;
        for (int seed = 0; seed < 48; seed++)
        {
            sideBySide += Compare(seed, floor: true);
        }

        Assert.True(sideBySide > 500, $"{sideBySide}");
    }

    /// <returns>Joints that went side by side in the last step.</returns>
    private static int Compare(int seed, bool floor)
    {
        using World lanes = Build(seed, onLanes: true, floor, out List<Handle> bodies, out List<Handle> joints);
        using World single = Build(seed, onLanes: false, floor, out _, out _);
        TreeLanesTests.Compare(lanes, single, seed, bodies, joints);
        return lanes.JointsSideBySide;
    }

    /// <summary>
    /// Chains, trees and nets of random kinds, hung on the world, on what moves along or on nothing; some have a rigid hinge among them.
    /// </summary>
    private static World Build(int seed, bool onLanes, bool floor, out List<Handle> bodies, out List<Handle> joints)
    {
        var random = new Random(seed);
        var world = new World { TreesOnLanes = onLanes };
        world.Settings.Gravity = new Vector2(0, -10);
        bodies = new List<Handle>();
        joints = new List<Handle>();
        Handle carriage = world.CreateBody(new BodyDef { Mass = 1, Inertia = 1, Flags = BodyFlags.Enabled | BodyFlags.Kinematic });
        world.Bodies.State[carriage.Index].LinearVelocity = new Vector2(0.5f, 0);
        world.Bodies.State[carriage.Index].AngularVelocity = 0.3f;
        int groups = 1 + random.Next(9);
        int shape = 0;
        for (int group = 0; group < groups; group++)
        {
            shape = random.Next(3) == 0 ? random.Next() : shape;
            AddGroup(world, new Random(shape), random, group == 2 ? carriage : World.WorldFrame, 20.0 * group, bodies, joints);
        }

        if (floor)
        {
            TreeLanesTests.AddShapes(world, bodies, random);
        }

        return world;
    }

    private static void AddGroup(
        World world, Random shape, Random random, Handle ground, double x, List<Handle> bodies, List<Handle> joints)
    {
        int count = 1 + shape.Next(8);
        bool chain = shape.Next(2) == 0;
        bool sole = shape.Next(2) == 0;
        JointKind kind = Kinds[shape.Next(Kinds.Length)];
        JointFlags flags = JointFlags.Enabled;
        flags |= shape.Next(2) == 0 ? JointFlags.Limit : JointFlags.None;
        flags |= shape.Next(3) == 0 ? JointFlags.Motor : JointFlags.None;
        bool soft = shape.Next(4) > 0;
        var own = new Handle[count];
        for (int i = 0; i < count; i++)
        {
            float mass = (float)Math.Pow(10, 2 * random.NextDouble());
            float inertia = random.Next(20) == 0 ? float.PositiveInfinity : mass / 6;
            own[i] = world.CreateBody(new BodyDef { X = x + i, Y = 0, Mass = mass, Inertia = inertia, Flags = BodyFlags.Enabled });
            world.Bodies.State[own[i].Index].LinearVelocity = new Vector2((float)random.NextDouble(), (float)random.NextDouble());
            world.Bodies.State[own[i].Index].AngularVelocity = (float)(10 * (random.NextDouble() - 0.5));
            bodies.Add(own[i]);
            for (int to = 0; to < i; to++)
            {
                if (to == (chain ? i - 1 : i / 2) || (!chain && shape.Next(4) == 0))
                {
                    bool first = shape.Next(2) == 0;
                    JointKind own1 = sole ? kind : Kinds[shape.Next(Kinds.Length)];
                    joints.Add(Join(world, own1, first ? own[to] : own[i], first ? own[i] : own[to], flags, soft, random));
                }
            }
        }

        for (int hung = shape.Next(3); hung > 0; hung--)
        {
            Handle at = own[shape.Next(count)];
            bool first = shape.Next(2) == 0;
            JointKind held = sole ? kind : Kinds[shape.Next(Kinds.Length)];
            joints.Add(Join(world, held, first ? ground : at, first ? at : ground, flags, soft, random));
        }

        if (shape.Next(12) == 0 && count > 1)
        {
            joints.Add(Join(world, JointKind.Revolute, own[0], own[1], JointFlags.Enabled, false, random));
        }
    }

    private static Handle Join(World world, JointKind kind, Handle a, Handle b, JointFlags flags, bool soft, Random random)
    {
        JointSettings settings = default;
        double xa = a.Index == World.WorldFrame.Index ? 0 : world.Bodies.Pose[a.Index].X;
        double xb = b.Index == World.WorldFrame.Index ? 0 : world.Bodies.Pose[b.Index].X;
        if (kind != JointKind.Motor)
        {
            settings.AnchorAX = 0.5 * (xb - xa);
            settings.AnchorBX = -0.5 * (xb - xa);
            settings.AnchorBY = random.Next(3) == 0 ? 0 : 0.5;
        }

        settings.BiasFactor = 0.2;
        bool bounded = !soft || random.Next(3) == 0;
        settings.MaxImpulse = bounded ? Math.Pow(10, 2 * random.NextDouble()) : double.PositiveInfinity;
        settings.Softness = soft ? 0.2 * random.NextDouble() : 0;
        settings.Breakpoint = random.Next(4) == 0 ? 1e6 : double.PositiveInfinity;
        settings.BreakForce = double.PositiveInfinity;
        settings.Lower = 0.3 * random.NextDouble();
        settings.Upper = 0.5 + random.NextDouble();
        settings.Slop = random.Next(2) == 0 ? 0 : 0.01;
        settings.Target = kind == JointKind.Pin && random.Next(2) == 0 ? 0 : kind == JointKind.Pulley ? 8 : 0.5;
        settings.AxisX = random.NextDouble();
        settings.AxisY = random.NextDouble();
        settings.Ratio = kind == JointKind.Target && random.Next(2) == 0 ? 0 : 0.5 + random.NextDouble();
        settings.GroundAX = xa;
        settings.GroundBX = xb;
        settings.GroundAY = 4;
        settings.GroundBY = 4;
        settings.MotorSpeed = random.Next(2) == 0 ? 0 : 4 * (random.NextDouble() - 0.5);
        settings.MotorLimit = Math.Pow(10, (4 * random.NextDouble()) - 1);
        settings.TorqueLimit = Math.Pow(10, (4 * random.NextDouble()) - 1);
        settings.Frequency = 1 + (10 * random.NextDouble());
        settings.DampingRatio = random.NextDouble();
        flags |= kind == JointKind.Distance ? JointFlags.Spring : JointFlags.None;
        return world.CreateJoint(kind, a, b, settings, flags);
    }
}
