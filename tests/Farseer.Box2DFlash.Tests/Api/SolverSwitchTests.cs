using System;
using System.Collections.Generic;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>What a world does without the impulses of the last step, and without correcting positions.</summary>
public sealed class SolverSwitchTests
{
    [Fact]
    public void Overlap_WithoutPositionCorrection_Stays()
    {
        float with = SunkenBox(true).GetPosition().y;
        float without = SunkenBox(false).GetPosition().y;

        // Half a slop is where boxes lie; without correction nothing moves but by rounding.
        Assert.InRange(with, 0.49f, 0.5f);
        Assert.InRange(without, 0.4f - 1e-5f, 0.4f + 1e-5f);
    }

    [Fact]
    public void FallingBox_WithoutPositionCorrection_IsStopped()
    {
        b2World world = World(true, false);
        Bench.Static(world, 0, -0.5f, 10, 0.5f);
        b2Body box = Bench.Dynamic(world, 0, 3);
        Bench.Step(world, 120);

        Assert.InRange(box.GetPosition().y, 0.49f, 0.501f);
        Assert.InRange(box.GetLinearVelocity().Length(), 0, 1e-4f);
    }

    [Theory]
    [InlineData("tree")]
    [InlineData("ring")]
    public void Joints_WithoutPositionCorrection_DriftApart(string form)
    {
        float with = Drift(true, form);
        float without = Drift(false, form);

        Assert.InRange(with, 0, 1e-3f);
        Assert.InRange(without, 3e-3f, 0.5f);
    }

    [Fact]
    public void Limit_WithoutPositionCorrection_StillStops()
    {
        b2World world = World(true, false);
        b2Body rod = Bench.Dynamic(world, 1, 0, 1, 0.1f);
        b2RevoluteJointDef def = new() { enableLimit = true, lowerAngle = -0.5f, upperAngle = 0.5f };
        def.Initialize(world.GetGroundBody(), rod, new b2Vec2());
        b2RevoluteJoint joint = (b2RevoluteJoint)world.CreateJoint(def)!;
        Bench.Step(world, 240);

        Assert.InRange(joint.GetJointAngle(), -0.6f, -0.49f);
    }

    [Fact]
    public void Stack_WithoutWarmStarting_SinksDeeper()
    {
        float with = StackHeight(true);
        float without = StackHeight(false);

        // Ten boxes of 1 m, two iterations: with the impulses of the last step they stand to a slop.
        Assert.InRange(with, 9.45f, 9.5f);
        Assert.InRange(without, 5, 9.2f);
    }

    [Fact]
    public void Ring_WithoutWarmStarting_HoldsItsJoints()
    {
        // Loops are iterated; from nothing in each step they still come close.
        Assert.InRange(Drift(true, "ring", false), 0, 0.05f);
    }

    [Fact]
    public void Switches_OnAgain_AreAsIfNeverTouched()
    {
        ulong untouched = Hash(null);
        ulong on = Hash(true);
        ulong off = Hash(false);

        Assert.Equal(untouched, on);
        Assert.NotEqual(untouched, off);
    }

    private static ulong Hash(bool? flag)
    {
        b2World world = World(true, true);
        Build(world, "ring", out _);
        Bench.Static(world, 0, -6.5f, 10, 0.5f);
        for (int i = 0; i < 4; i++)
        {
            Bench.Dynamic(world, -4, -5.4f + i);
        }

        if (flag is bool value)
        {
            world.SetWarmStarting(false);
            world.SetPositionCorrection(false);
            world.SetWarmStarting(value);
            world.SetPositionCorrection(value);
        }

        Bench.Step(world, 60);
        return world.MotionHash();
    }

    private static b2World World(bool warm, bool correct)
    {
        b2World world = Bench.World(-10, 100, false);
        world.SetWarmStarting(warm);
        world.SetPositionCorrection(correct);
        return world;
    }

    private static b2Body SunkenBox(bool correct)
    {
        b2World world = World(true, correct);
        Bench.Static(world, 0, -0.5f, 10, 0.5f);
        b2Body box = Bench.Dynamic(world, 0, 0.4f);
        Bench.Step(world, 60);
        return box;
    }

    private static float StackHeight(bool warm)
    {
        b2World world = World(warm, true);
        Bench.Static(world, 0, -0.5f, 10, 0.5f);
        b2Body top = Bench.Dynamic(world, 0, 0.5f);
        for (int i = 1; i < 10; i++)
        {
            top = Bench.Dynamic(world, 0, 0.5f + i);
        }

        Bench.Step(world, 120, 2);
        return top.GetPosition().y;
    }

    /// <summary>The largest distance of two anchors that belong together, after two seconds of swinging.</summary>
    private static float Drift(bool correct, string form, bool warm = true)
    {
        b2World world = World(warm, correct);
        Build(world, form, out List<b2RevoluteJoint> joints);
        Bench.Step(world, 120);
        float largest = 0;
        foreach (b2RevoluteJoint joint in joints)
        {
            b2Vec2 a = joint.GetAnchor1();
            b2Vec2 b = joint.GetAnchor2();
            largest = MathF.Max(largest, MathF.Sqrt(((a.x - b.x) * (a.x - b.x)) + ((a.y - b.y) * (a.y - b.y))));
        }

        return largest;
    }

    /// <summary>A rod on a hinge, or four rods in a ring that hangs from one corner.</summary>
    private static void Build(b2World world, string form, out List<b2RevoluteJoint> joints)
    {
        joints = [];
        if (form == "tree")
        {
            b2Body rod = Bench.Dynamic(world, 1, 0, 1, 0.1f);
            joints.Add(Hinge(world, world.GetGroundBody(), rod, 0, 0));
            return;
        }

        b2Body top = Bench.Dynamic(world, 1, 0, 1, 0.1f);
        b2Body right = Bench.Dynamic(world, 2, -1, 0.1f, 1);
        b2Body bottom = Bench.Dynamic(world, 1, -2, 1, 0.1f);
        b2Body left = Bench.Dynamic(world, 0, -1, 0.1f, 1);
        joints.Add(Hinge(world, world.GetGroundBody(), top, 0, 0));
        joints.Add(Hinge(world, top, right, 2, 0));
        joints.Add(Hinge(world, right, bottom, 2, -2));
        joints.Add(Hinge(world, bottom, left, 0, -2));
        joints.Add(Hinge(world, left, top, 0, 0));
    }

    private static b2RevoluteJoint Hinge(b2World world, b2Body a, b2Body b, float x, float y)
    {
        b2RevoluteJointDef def = new();
        def.Initialize(a, b, new b2Vec2(x, y));
        return (b2RevoluteJoint)world.CreateJoint(def)!;
    }
}
