using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Games;

/// <summary>The loop: steps of one length, and poses between them.</summary>
public sealed class LoopTests
{
    [Fact]
    public void Driver_MakesTheSameSteps_AtAnyFrameRate()
    {
        Assert.Equal(Run(1 / 30.0), Run(1 / 144.0));
        Assert.Equal(Run(1 / 30.0), Run(0.25));

        static (double, double, long) Run(double frame)
        {
            PhysicsSimulator simulator = WithFloor(out _);
            Body box = Box(simulator, new Vector2(0, -100)).Body;
            box.AngularVelocity = 1;
            var driver = new FixedStepDriver(simulator, 1.0 / 64) { MaxSteps = 100 };
            while (driver.StepCount < 128)
            {
                driver.Advance(Math.Min(frame, (128 - driver.StepCount) / 64.0));
            }

            return (box.PositionY, box.AngularVelocity, driver.StepCount);
        }
    }

    [Fact]
    public void Driver_MakesAStepAFrame_WhereBothAreAsLong()
    {
        var driver = new FixedStepDriver(Falling());
        for (int i = 0; i < 10000; i++)
        {
            Assert.Equal(1, driver.Advance(1.0 / 60));
        }
    }

    [Fact]
    public void Driver_DropsTimeBeyondItsCap()
    {
        var driver = new FixedStepDriver(Falling(), 0.125) { MaxSteps = 4 };
        Assert.Equal(4, driver.Advance(1));
        Assert.Equal(0.5, driver.DroppedTime);
        Assert.Equal(0, driver.Alpha);
        Assert.Equal(0, driver.Advance(0.0625));
        Assert.Equal(0.5f, driver.Alpha);
        Assert.Equal(1, driver.Advance(0.0625));
        driver.Advance(0.1);
        driver.Reset();
        Assert.Equal(0, driver.Alpha);
    }

    [Fact]
    public void Driver_WithATimeScale_MakesMoreOrFewerStepsOfTheSameLength()
    {
        var lengths = new HashSet<float>();
        var driver = new FixedStepDriver(Falling(), 0.125) { TimeScale = 0.5 };
        driver.BeforeStep += dt => lengths.Add(dt);
        driver.AfterStep += dt => lengths.Add(-dt);
        int steps = 0;
        for (int i = 0; i < 16; i++)
        {
            steps += driver.Advance(0.125);
        }

        Assert.Equal(8, steps);
        driver.TimeScale = 0;
        Assert.Equal(0, driver.Advance(10));
        Assert.Equal(new HashSet<float> { 0.125f, -0.125f }, lengths);
        Assert.Throws<ArgumentOutOfRangeException>(() => driver.TimeScale = -1);
        Assert.Throws<ArgumentOutOfRangeException>(() => driver.Advance(double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => new FixedStepDriver(driver.Simulator, 0));
    }

    [Fact]
    public void GetPose_IsBetweenTheLastTwoSteps()
    {
        PhysicsSimulator simulator = Falling(0);
        var driver = new FixedStepDriver(simulator, 0.125);
        Body body = Box(simulator, new Vector2(10, 0)).Body;
        body.LinearVelocity = new Vector2(8, 0);
        body.AngularVelocity = 4;
        driver.Advance(0.25);
        Assert.Equal(12, body.PositionX, 1e-6);
        Assert.Equal(11, body.GetPose(0).X, 1e-6);
        Assert.Equal(11.25, body.GetPose(0.25f).X, 1e-6);
        Assert.Equal(0.75, body.GetPose(0.5f).TotalRotation, 1e-6);
        Assert.Equal(body.GetPose(), body.GetPose(1));
        Assert.Throws<ArgumentOutOfRangeException>(() => body.GetPose(1.5f));
    }

    [Fact]
    public void GetPose_DoesNotSmearATeleport()
    {
        PhysicsSimulator simulator = Falling(0);
        var driver = new FixedStepDriver(simulator, 0.125);
        Body body = Box(simulator, new Vector2(10, 0)).Body;
        body.LinearVelocity = new Vector2(8, 0);
        driver.Advance(0.125);
        body.Position = new Vector2(1000, 0);
        Assert.Equal(1000, body.GetPose(0.1f).X);
        driver.Advance(0.125);
        Assert.Equal(1000.5, body.GetPose(0.5f).X, 1e-4);

        // In a handler, within the update.
        bool put = false;
        driver.BeforeStep += _ => put = true;
        simulator.ControllerList.Add(new Putter(() => body.Position = new Vector2(-500, 0)));
        driver.Advance(0.125);
        Assert.True(put);
        Assert.InRange(body.GetPose(0).X, -500, -498);
        body.Rotation = 3;
        Assert.Equal(3, body.GetPose(0.3f).TotalRotation, 1e-6);
    }

    [Fact]
    public void SetPoseAndSetTotalRotation_KeepDoubles()
    {
        var body = new Body();
        body.SetTotalRotation(1e6 + 0.123456789);
        body.GetTotalRotation(out double rotation);
        Assert.Equal(1e6 + 0.123456789, rotation);
        body.SetPose(new Pose(1e9 + 0.25, -3, 7.5));
        Assert.Equal(new Pose(1e9 + 0.25, -3, 7.5), body.GetPose());
        Assert.Throws<ArgumentOutOfRangeException>("x", () => new Pose(double.NaN, 0, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => body.SetTotalRotation(double.PositiveInfinity));
    }

    [Fact]
    public void KeptPoses_ChangeNoBitAndAllocateNothing()
    {
        PhysicsSimulator with = WithFloor(out _);
        PhysicsSimulator without = WithFloor(out _);
        Body one = Box(with, new Vector2(3, -100)).Body;
        Body other = Box(without, new Vector2(3, -100)).Body;
        with.KeepsPoses = true;
        Run(with, 100);
        Run(without, 100);
        Assert.Equal(other.GetPose(), one.GetPose());
        long before = GC.GetAllocatedBytesForCurrentThread();
        Run(with, 10);
        one.GetPose(0.5f);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    private sealed class Putter(Action put) : FarseerGames.FarseerPhysics.Controllers.Controller
    {
        private bool _done;

        public override void Validate()
        {
        }

        public override void Update(float dt)
        {
            if (!_done)
            {
                _done = true;
                put();
            }
        }
    }
}
