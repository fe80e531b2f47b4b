using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Shapes;
using Farseer.Engine.Springs;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Simulation;

public class SleepTests
{
    [Fact]
    public void Pyramid_ThatRests_FallsAsleepAsAWhole_AndStaysWhereItIs()
    {
        var scene = new SleepScene();
        List<Handle> boxes = scene.Pyramid(6);
        int asleep = 0;
        for (int i = 0; i < 600 && asleep == 0; i++)
        {
            scene.Step();
            asleep = scene.World.Sleep.AsleepCount;
        }

        Assert.Equal(boxes.Count, asleep);
        Assert.All(boxes, b => Assert.Equal(Vector2.Zero, scene.World.Bodies.State[b.Index].LinearVelocity));
        ulong hash = scene.World.Bodies.MotionHash();
        int contacts = scene.World.Reader.Count;
        Assert.True(contacts >= boxes.Count);
        scene.Step(300);
        Assert.Equal(hash, scene.World.Bodies.MotionHash());
        Assert.Equal(contacts, scene.World.Reader.Count);
    }

    [Fact]
    public void Pyramid_ThatSleeps_EndsWithinTwoHundredthsOfAMillimetreOfOneThatDoesNot()
    {
        var sleeping = new SleepScene();
        var waking = new SleepScene(allowSleep: false);
        sleeping.Pyramid(10);
        waking.Pyramid(10);
        double most = 0;
        for (int i = 0; i < 600; i++)
        {
            sleeping.Step();
            waking.Step();
            for (int body = 1; body < waking.World.Bodies.Ids.End; body++)
            {
                BodyPose a = sleeping.World.Bodies.Pose[body];
                BodyPose b = waking.World.Bodies.Pose[body];
                most = Math.Max(most, Math.Sqrt(((a.X - b.X) * (a.X - b.X)) + ((a.Y - b.Y) * (a.Y - b.Y))));
            }
        }

        // The waking one still trembles: pyramids of 5 to 10 end 2.6e-6 to 1.4e-5 off, depending on roundings alone.
        Assert.Equal(55, sleeping.World.Sleep.AsleepCount);
        Assert.InRange(most, 0, 2e-5);
    }

    [Fact]
    public void Pyramid_HitByABox_WakesAndSettlesAgain()
    {
        var scene = new SleepScene();
        scene.Pyramid(6);
        scene.Settle();
        Handle ball = scene.Box(-9, 2.5f, 0.5f, 0.5f);
        scene.SetVelocity(ball, 15, 3);
        scene.Step(30);
        Assert.Equal(0, scene.World.Sleep.AsleepCount);
        Assert.True(scene.World.Reader.LargestPenetration() < 0.1);
        scene.Settle(3000);
    }

    [Fact]
    public void Stack_WokenWithoutACause_DoesNotMove()
    {
        // The impulses come back with the rows: without them the stack would sink before it is carried again.
        var scene = new SleepScene();
        List<Handle> boxes = scene.Pyramid(8);
        scene.Settle();
        double[] before = boxes.Select(b => scene.World.Bodies.Pose[b.Index].Y).ToArray();
        scene.World.Sleep.WakeUp(boxes[0]);
        Assert.Equal(0, scene.World.Sleep.AsleepCount);
        scene.Step();
        double most = boxes.Select((b, i) => Math.Abs(scene.World.Bodies.Pose[b.Index].Y - before[i])).Max();

        // A body that falls for a step moves 2.8 mm.
        Assert.InRange(most, 0, 2e-6);
        scene.Step(60);
        most = boxes.Select((b, i) => Math.Abs(scene.World.Bodies.Pose[b.Index].Y - before[i])).Max();
        Assert.InRange(most, 0, 2e-4);
    }

    public static TheoryData<string> Causes() => new TheoryData<string>
    {
        "WakeUp", "Velocity", "Position", "Angle", "Mass", "Gravity", "Off", "GroundMoved", "GroundRemoved", "GroundDisabled",
        "ColliderAdded",
        "ColliderRemoved", "Filter", "Joint", "JointChanged", "Spring", "Kinematic", "Belt", "NeverSleeps", "Force",
    };

    [Theory]
    [MemberData(nameof(Causes))]
    public void Stack_ThatSleeps_IsWokenBy(string cause)
    {
        var scene = new SleepScene();
        Handle lift = scene.Box(0, 0.25f, 4, 0.5f, BodyFlags.Kinematic);
        Handle low = scene.Box(0, 1, 1, 1);
        Handle high = scene.Box(0, 2, 1, 1);
        Handle aside = scene.Box(20, 0.5f, 1, 1);
        Handle hinge = scene.Hinge(low, high, 0, 1.5f);
        scene.Settle();
        switch (cause)
        {
            case "WakeUp":
                scene.World.Sleep.WakeUp(high);
                break;
            case "Velocity":
                scene.SetVelocity(high, 0, 1);
                break;
            case "Position":
                scene.World.SetPosition(high, 0.1, 2.2);
                break;
            case "Angle":
                scene.World.SetAngle(high, 0.1);
                break;
            case "Mass":
                scene.World.SetMass(high, 2, 1);
                break;
            case "Gravity":
                scene.World.Settings.Gravity = new Vector2(1, -10);
                break;
            case "Off":
                scene.World.Settings.AllowSleep = false;
                break;
            case "GroundMoved":
                scene.World.SetPosition(lift, 0, 0.2);
                break;
            case "GroundRemoved":
                scene.World.DestroyBody(lift);
                break;
            case "GroundDisabled":
                scene.World.SetFlags(lift, BodyFlags.None, BodyFlags.Enabled);
                break;
            case "ColliderAdded":
                scene.Cover(high, 0.2f, 2);
                break;
            case "ColliderRemoved":
                scene.World.DestroyCollider(scene.World.Shapes.ColliderIds.HandleOf(scene.World.Colliders.First(high.Index)));
                break;
            case "Filter":
                scene.World.Pairs.Refilter(scene.World.Shapes.ColliderIds.HandleOf(scene.World.Colliders.First(low.Index)));
                break;
            case "Joint":
                scene.Hinge(high, scene.Bare(0, 3, 1, 1), 0, 2.5f);
                break;
            case "JointChanged":
                scene.World.DestroyJoint(hinge);
                break;
            case "Spring":
                scene.Springs.Add(new SpringDef
                {
                    Kind = SpringKind.Linear,
                    BodyA = high.Index,
                    BodyB = scene.Bare(0, 5, 1, 1).Index,
                    Stiffness = 1,
                    Rest = 1,
                });
                break;
            case "Kinematic":
                scene.SetVelocity(lift, 0, 1);
                break;
            case "Belt":
                scene.SetVelocity(lift, 0.1f, 0);
                break;
            case "NeverSleeps":
                scene.World.SetFlags(low, BodyFlags.NeverSleeps, BodyFlags.None);
                break;
            case "Force":
                scene.Forces = () => scene.World.Sleep.WakeUp(high);
                break;
        }

        scene.Step();
        Assert.True(scene.World.Sleep.IsAwake(low), "the lower one sleeps");
        Assert.True(scene.World.Sleep.IsAwake(high), "the upper one sleeps");
        bool all = cause is "Gravity" or "Off";
        Assert.Equal(all, scene.World.Sleep.IsAwake(aside));
        if (cause == "NeverSleeps")
        {
            scene.Step(600);
            Assert.True(scene.World.Sleep.IsAwake(high));
        }
    }

    [Fact]
    public void Box_OnABeltThatRuns_DoesNotFallAsleep()
    {
        // Without friction the box stands still on it.
        var scene = new SleepScene();
        Handle belt = scene.Box(0, 0.25f, 50, 0.5f, BodyFlags.Kinematic);
        Handle box = scene.Box(0, 1, 1, 1);
        scene.World.Collider(scene.World.Shapes.ColliderIds.HandleOf(scene.World.Colliders.First(belt.Index))).Friction = -0.6f;
        scene.SetVelocity(belt, 0.1f, 0);
        scene.Step(400);
        Assert.True(scene.World.Sleep.IsAwake(box));
    }

    [Fact]
    public void HangingBody_WithAJointOrASpring_FallsAsleepWithWhatHoldsIt()
    {
        var scene = new SleepScene();
        Handle upper = scene.Bare(0, 5, 1, 1);
        Handle lower = scene.Bare(0, 4, 1, 1);
        scene.Hinge(scene.Ground, upper, 0, 6);
        scene.Hinge(upper, lower, 0, 4.5f);
        Handle sprung = scene.Bare(8, 4, 1, 1);
        scene.Springs.Add(new SpringDef
        {
            Kind = SpringKind.Linear, BodyA = sprung.Index, AnchorB = new Vector2(8, 6), Stiffness = 100, Damping = 20, Rest = 1.9,
        });
        scene.Settle(3000);
        scene.SetVelocity(lower, 0, 0);
        scene.Step();
        Assert.False(scene.World.Sleep.IsAwake(lower));
        scene.SetVelocity(lower, 1, 0);
        scene.Step();
        Assert.True(scene.World.Sleep.IsAwake(upper) && scene.World.Sleep.IsAwake(lower));
        Assert.False(scene.World.Sleep.IsAwake(sprung));
    }

    [Fact]
    public void Body_InFlight_NeverSleeps()
    {
        // Thrown up: at the top it stands still for a moment. Large and small ones, which for a tolerance relative to size alone are
        // different.
        foreach (float scale in new[] { 1e-6f, 1e-3f, 1, 1e3f, 1e6f })
        {
            foreach (float size in new[] { 1e-3f, 1, 1e3f })
            {
                foreach (float gravity in new[] { 0.1f, 10, 1000 })
                {
                    var scene = new SleepScene(scale, gravity: gravity);
                    Handle single = scene.Box(0, 1e6f, size, size);
                    Handle left = scene.Box(1e5f, 1e6f, size, size);
                    Handle right = scene.Box(1e5f + size, 1e6f, size, size);
                    foreach (Handle body in new[] { single, left, right })
                    {
                        scene.SetVelocity(body, 0, 0.7f * gravity);
                    }

                    scene.Step(180);
                    Assert.True(scene.World.Sleep.AsleepCount == 0, $"scale {scale}, size {size}, gravity {gravity}");
                }
            }
        }
    }

    [Theory]
    [InlineData(1e-6f)]
    [InlineData(1f)]
    [InlineData(1e6f)]
    public void Body_ThatDriftsWithoutGravity_NeverSleeps(float scale)
    {
        var scene = new SleepScene(scale, gravity: 0);
        Handle large = scene.Box(0, 5e4f, 1e4f, 1e4f);
        Handle spinning = scene.Box(5e5f, 5e4f, 1e4f, 1e4f);
        Handle standing = scene.Box(9e5f, 5e4f, 1, 1);
        scene.SetVelocity(large, 1e-3f, 0);
        scene.World.Bodies.State[spinning.Index].AngularVelocity = 1e-7f;
        scene.Step(300);
        Assert.True(scene.World.Sleep.IsAwake(large));
        Assert.True(scene.World.Sleep.IsAwake(spinning));
        Assert.False(scene.World.Sleep.IsAwake(standing));
    }

    [Fact]
    public void Body_SlowedByDragAlone_SleepsWhenItHasStopped()
    {
        var scene = new SleepScene(gravity: 0);
        Handle body = scene.Box(0, 5, 1, 1);
        scene.World.Bodies.Drag[body.Index] = new BodyDrag { Linear = 2 };
        scene.SetVelocity(body, 1, 0);
        scene.Settle();

        // v/k with v = 1 and k = 2; stopped within the share of the size that counts as rest.
        Assert.Equal(0.5, scene.World.Bodies.Pose[body.Index].X, 4);
    }

    [Fact]
    public void ScaledScene_SleepsInTheSameSteps_WithScaledBits()
    {
        const float Scale = 1 << 20;
        var small = new SleepScene();
        var large = new SleepScene(Scale);
        small.Pyramid(4);
        large.Pyramid(4);
        for (int i = 0; i < 500; i++)
        {
            small.Step();
            large.Step();
            Assert.Equal(small.World.Sleep.AsleepCount, large.World.Sleep.AsleepCount);
        }

        Assert.Equal(10, small.World.Sleep.AsleepCount);
        for (int body = 1; body < small.World.Bodies.Ids.End; body++)
        {
            Assert.Equal(small.World.Bodies.Pose[body].Y * Scale, large.World.Bodies.Pose[body].Y);
            Assert.Equal(small.World.Bodies.Pose[body].Angle, large.World.Bodies.Pose[body].Angle);
        }
    }

    [Fact]
    public void Scene_InWhichNothingRests_HasTheSameBitsWithSleepAllowed()
    {
        var with = new SleepScene();
        var without = new SleepScene(allowSleep: false);
        foreach (SleepScene scene in new[] { with, without })
        {
            scene.Pyramid(5);
            Handle spinner = scene.Box(0, 8, 12, 0.5f, BodyFlags.Kinematic);
            scene.World.Bodies.State[spinner.Index].AngularVelocity = 2;
            scene.World.SetFlags(scene.Box(3, 0.5f, 1, 1), BodyFlags.NeverSleeps, BodyFlags.None);
            for (int i = 0; i < 5; i++)
            {
                scene.Box(i - 2, 12, 0.9f, 0.9f, BodyFlags.NeverSleeps);
            }
        }

        for (int i = 0; i < 60; i++)
        {
            with.Step();
            without.Step();
            Assert.Equal(without.World.Bodies.MotionHash(), with.World.Bodies.MotionHash());
        }

        Assert.Equal(0, with.World.Sleep.AsleepCount);
    }

    [Fact]
    public void Listeners_OfAPairThatSleeps_HearNothing_UntilItWakes()
    {
        var scene = new SleepScene { Listen = ColliderFlags.WantsContact | ColliderFlags.WantsSeparation };
        Handle box = scene.Box(0, 0.5f, 1, 1);
        Handle top = scene.Box(0, 1.5f, 1, 1);
        scene.Settle();
        scene.Events.Clear();
        scene.Step(20);
        Assert.Empty(scene.Events);
        scene.World.Sleep.WakeUp(top);
        scene.Step();
        Assert.Equal(new[] { "touch 0 1", "touch 1 2" }, scene.Events);
        scene.Settle();
        scene.Events.Clear();

        // Woken and taken away in one: what touched when it fell asleep parts now.
        scene.World.SetPosition(top, 30, 20);
        scene.Step();
        Assert.Contains("part 1 2", scene.Events);
        scene.Events.Clear();
        scene.World.DestroyBody(box);
        Assert.Equal(new[] { "part 0 1" }, scene.Events);
    }

    [Fact]
    public void Collider_RemovedAsleep_PartsFromWhatItTouched()
    {
        var scene = new SleepScene { Listen = ColliderFlags.WantsContact | ColliderFlags.WantsSeparation };
        Handle box = scene.Box(0, 0.5f, 1, 1);
        scene.Box(0, 1.5f, 1, 1);
        scene.Settle();
        scene.Events.Clear();
        scene.World.DestroyBody(box);
        Assert.Equal(new[] { "part 0 1", "part 1 2" }, scene.Events);
        scene.Step();
        Assert.DoesNotContain(scene.Events.Skip(2), e => e.StartsWith("part", StringComparison.Ordinal));
    }

    [Fact]
    public void Sensor_BesideASleeper_WakesNothing()
    {
        var scene = new SleepScene();
        Handle box = scene.Box(0, 0.5f, 1, 1);
        scene.Settle();
        Handle ghost = scene.Bare(-3, 0.5f, 1, 1, BodyFlags.IgnoreGravity);
        scene.Cover(ghost, 1, 1, ColliderFlags.None);
        scene.SetVelocity(ghost, 2, 0);
        scene.Step(120);
        Assert.False(scene.World.Sleep.IsAwake(box));
        Assert.True(scene.World.Bodies.Pose[ghost.Index].X > 0.9);
    }

    [Fact]
    public void Bodies_MadeAsleep_SleepUntilHit()
    {
        var scene = new SleepScene();
        var boxes = new List<Handle>();
        for (int i = 0; i < 5; i++)
        {
            boxes.Add(scene.Box(0, 0.5f + i, 1, 1, BodyFlags.Asleep));
        }

        Handle hanging = scene.Box(5, 8, 1, 1, BodyFlags.Asleep);
        scene.Step(100);
        Assert.All(boxes, b => Assert.False(scene.World.Sleep.IsAwake(b)));
        Assert.Equal(6, scene.World.Sleep.AsleepCount);
        Assert.Equal(8, scene.World.Bodies.Pose[hanging.Index].Y);
        scene.SetVelocity(scene.Box(-3, 2.5f, 0.3f, 0.3f), 20, 2);
        scene.Step(20);
        Assert.All(boxes, b => Assert.True(scene.World.Sleep.IsAwake(b)));
        Assert.False(scene.World.Sleep.IsAwake(hanging));
    }

    [Fact]
    public void Body_PutToSleepBesideAnAwakeOne_WakesAgain()
    {
        var scene = new SleepScene();
        Handle low = scene.Box(0, 0.5f, 1, 1);
        Handle high = scene.Box(0, 1.5f, 1, 1);
        Handle alone = scene.Box(9, 0.5f, 1, 1);
        scene.Step(3);
        scene.World.Sleep.PutToSleep(low);
        scene.World.Sleep.PutToSleep(alone);
        Assert.False(scene.World.Sleep.IsAwake(low));
        scene.Step();
        Assert.True(scene.World.Sleep.IsAwake(low) && scene.World.Sleep.IsAwake(high));
        Assert.False(scene.World.Sleep.IsAwake(alone));
        scene.World.Sleep.PutToSleep(low);
        scene.World.Sleep.PutToSleep(high);
        scene.Step();
        Assert.Equal(3, scene.World.Sleep.AsleepCount);
    }

    [Fact]
    public void Step_OfASleepingWorld_AllocatesNothing_NorDoFallingAsleepAndWaking()
    {
        var scene = new SleepScene();
        List<Handle> boxes = scene.Pyramid(5);
        for (int i = 0; i < 3; i++)
        {
            scene.Settle();
            scene.World.Sleep.WakeUp(boxes[0]);
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 400; i++)
        {
            scene.World.Step(SleepScene.Dt);
        }

        scene.World.Sleep.WakeUp(boxes[0]);
        for (int i = 0; i < 400; i++)
        {
            scene.World.Step(SleepScene.Dt);
        }

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        Assert.Equal(boxes.Count, scene.World.Sleep.AsleepCount);
    }
}
