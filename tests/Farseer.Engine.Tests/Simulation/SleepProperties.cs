using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Engine.Tests.Simulation;

/// <summary>Worlds in which bodies are woken, put to sleep, moved, made and removed at random, also from within a step.</summary>
public class SleepProperties
{
    private const ColliderFlags Listen = ColliderFlags.WantsContact | ColliderFlags.WantsSeparation;

    [Fact]
    public void World_DisturbedAtRandom_StaysSound_AndRepeatsItself()
    {
        Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed =>
        {
            (ulong first, int slept) = Run(seed);
            Assert.Equal(first, Run(seed).Hash);
        }).QuickCheckThrowOnFailure();
    }

    /// <summary>Each kept a row that the solver went on with, and a sleeper got a velocity.</summary>
    [Theory]
    [InlineData(64738152)] // Put to sleep beside one that was put to sleep too and is woken again.
    [InlineData(1031853712)] // Falls asleep in the step in which a handler sets the platform under it going.
    public void Body_ThatMayNotSleepWhereItIs_IsWokenBeforeItIsSolved(int seed) => Run(seed);

    [Fact]
    public void World_DisturbedAtRandom_HasBodiesAsleep()
    {
        // The property above would hold of a world that never sleeps.
        Assert.True(Enumerable.Range(0, 10).Sum(seed => Run(seed).Slept) > 500);
    }

    private static (ulong Hash, int Slept) Run(int seed)
    {
        var random = new Random(seed);
        var scene = new SleepScene { Listen = random.Next(2) == 0 ? Listen : ColliderFlags.None };
        scene.World.Settings.TimeToSleep = 0.1f;
        scene.World.Settings.RestShare = 0.01f;
        var bodies = new List<Handle>();
        var joints = new List<Handle>();
        for (int i = 0; i < 25; i++)
        {
            Make(scene, random, bodies);
        }

        bool busy = false;
        scene.Forces = () =>
        {
            if (busy && random.Next(4) == 0)
            {
                Disturb(scene, random, bodies, joints, inStep: true);
            }
        };
        int slept = 0;
        for (int step = 0; step < 160; step++)
        {
            busy = step % 40 > 25;
            if (busy)
            {
                Disturb(scene, random, bodies, joints, inStep: false);
            }

            scene.Step();
            slept += scene.World.Sleep.AsleepCount;
            AssertSound(scene, bodies);
        }

        return (scene.World.Bodies.MotionHash(), slept);
    }

    private static void Make(SleepScene scene, Random random, List<Handle> bodies)
    {
        BodyFlags flags = random.Next(60) switch
        {
            < 4 => BodyFlags.Kinematic,
            < 12 => BodyFlags.Asleep,
            12 => BodyFlags.NeverSleeps,
            _ => BodyFlags.None,
        };
        bodies.Add(scene.Box(2 * random.Next(-6, 7), 0.5f + random.Next(4), 0.9f, 1, flags));
    }

    private static void Disturb(SleepScene scene, Random random, List<Handle> bodies, List<Handle> joints, bool inStep)
    {
        Handle body = bodies[random.Next(bodies.Count)];
        switch (random.Next(inStep ? 5 : 11))
        {
            case 0:
                scene.SetVelocity(body, random.Next(-3, 4), random.Next(4));
                break;
            case 1:
                scene.World.Sleep.WakeUp(body);
                break;
            case 2:
                scene.World.Sleep.PutToSleep(body);
                break;
            case 3:
                scene.World.SetPosition(body, random.Next(-4, 5), 0.5 + random.Next(6));
                break;
            case 4:
                scene.World.SetFlags(
                    body,
                    random.Next(2) == 0 ? BodyFlags.Enabled : BodyFlags.None,
                    random.Next(3) == 0 ? BodyFlags.Enabled : BodyFlags.None);
                break;
            case 5:
                Make(scene, random, bodies);
                break;
            case 6 when bodies.Count > 5:
                scene.World.DestroyBody(body);
                bodies.Remove(body);
                joints.RemoveAll(j => !scene.World.Joints.Ids.IsLive(j));
                break;
            case 7:
                scene.Cover(body, 0.5f, 0.5f, random.Next(2) == 0 ? ColliderFlags.None : ColliderFlags.ResponseEnabled);
                break;
            case 8:
                Handle other = bodies[random.Next(bodies.Count)];
                if (!other.Equals(body))
                {
                    joints.Add(scene.Hinge(
                        body, other, (float)scene.World.Bodies.Pose[body.Index].X, (float)scene.World.Bodies.Pose[body.Index].Y));
                }

                break;
            case 9 when joints.Count > 0:
                scene.World.DestroyJoint(joints[0]);
                joints.RemoveAt(0);
                break;
            case 10:
                scene.World.SetFlags(body, BodyFlags.Static, BodyFlags.None);
                scene.World.SetFlags(body, BodyFlags.None, BodyFlags.Static);
                break;
        }
    }

    private static void AssertSound(SleepScene scene, List<Handle> bodies)
    {
        int asleep = bodies.Count(b => !scene.World.Sleep.IsAwake(b));
        Assert.Equal(asleep, scene.World.Sleep.AsleepCount);
        foreach (Handle body in bodies)
        {
            BodyPose pose = scene.World.Bodies.Pose[body.Index];
            Assert.True(double.IsFinite(pose.X) && double.IsFinite(pose.Y) && double.IsFinite(pose.Angle));
            BodyFlags flags = scene.World.Bodies.Flags[body.Index];
            if ((flags & BodyFlags.Asleep) != 0)
            {
                // A velocity that was set while forces acted is looked at when the next step begins.
                Assert.True((flags & BodyFlags.Handled) != 0 || scene.World.Bodies.State[body.Index].LinearVelocity == Vector2.Zero);
                Assert.Equal(
                    BodyFlags.Enabled, flags & (BodyFlags.Enabled | BodyFlags.Static | BodyFlags.Kinematic | BodyFlags.NeverSleeps));
            }
            else
            {
                Assert.True(scene.World.Bodies.Visited.Test(body.Index));
            }
        }
    }
}
