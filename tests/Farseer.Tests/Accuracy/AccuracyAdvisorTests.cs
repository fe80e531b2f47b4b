using System;
using System.Collections.Generic;
using System.Numerics;
using System.Threading;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>The advisor's answer is a setting that really keeps the error, and no cheaper one of its curve does.</summary>
public class AccuracyAdvisorTests
{
    [Fact]
    public void Advise_OnAStack_FindsTheCheapestSettingThatKeepsTheError()
    {
        AccuracyAdvice advice = AccuracyAdvisor.Advise(Stack, 0.5f, 1e-3f);
        Assert.NotNull(advice.Cheapest);
        AccuracyPoint best = advice.Cheapest.Value;
        Assert.True(best.PeakError <= 1e-3);
        foreach (AccuracyPoint point in advice.Curve)
        {
            Assert.True(point.Work >= best.Work || point.PeakError > 1e-3);
        }

        using PhysicsSimulator simulator = Stack();
        simulator.Iterations = best.Iterations;
        simulator.EnableReport = true;
        double peak = 0;
        for (int i = 0; i < 15 * (int)Math.Round(1 / (30 * best.Dt)); i++)
        {
            simulator.Update(best.Dt);
            peak = Math.Max(peak, simulator.Report.ConstraintError);
        }

        Assert.Equal(best.ConstraintError, peak);
    }

    [Theory]
    [InlineData(1f, 1e-3f)]
    [InlineData(2f, 1e-3f)]
    [InlineData(2f, 1e-2f)]
    public void Advise_OnADoublePendulum_NamesASettingWhoseMotionIsWithinTheError(float seconds, float error)
    {
        AccuracyAdvice advice = AccuracyAdvisor.Advise(() => DoublePendulum(5), seconds, error);
        Assert.NotNull(advice.Cheapest);
        Assert.InRange(advice.ReferenceError, 0, error);
        AccuracyPoint best = advice.Cheapest.Value;
        using PhysicsSimulator chosen = DoublePendulum(best.Iterations);
        using PhysicsSimulator exact = DoublePendulum(320);
        double worst = 0;
        int perFrame = (int)Math.Round(1 / (30 * best.Dt));
        for (int frame = 0; frame < (int)(30 * seconds); frame++)
        {
            Sandbox.Run(chosen, perFrame, best.Dt);
            Sandbox.Run(exact, 32, 1f / 960);
            worst = Math.Max(worst, Vector2.Distance(chosen.BodyList[1].Position, exact.BodyList[1].Position));
        }

        // The reference of the advice is itself off by some part of its own error.
        Assert.InRange(worst, 0, error + advice.ReferenceError);
    }

    [Fact]
    public void Advise_OnWhatNobodyCanForesee_NamesNoSetting()
    {
        AccuracyAdvice advice = AccuracyAdvisor.Advise(() => DoublePendulum(5), 20, 1e-3f);
        Assert.True(advice.ReferenceError > 1e-3);
        Assert.Null(advice.Cheapest);
        foreach (AccuracyPoint point in advice.Curve)
        {
            Assert.Equal(Math.Max(point.ConstraintError, point.MotionError), point.PeakError);
        }
    }

    [Fact]
    public void Advise_TellsItsProgress_AndCanBeStopped()
    {
        var shares = new Shares();
        AccuracyAdvisor.Advise(Stack, 0.2f, 1, shares);
        Assert.Equal(1 + (24 * 2), shares.Told.Count);
        Assert.Equal(1, shares.Told[^1], 1e-9);
        for (int i = 1; i < shares.Told.Count; i++)
        {
            Assert.True(shares.Told[i] > shares.Told[i - 1]);
        }

        using var stop = new CancellationTokenSource();
        int updates = 0;
        Assert.Throws<OperationCanceledException>(() => AccuracyAdvisor.Advise(
            Stack,
            (simulator, _, dt) =>
            {
                simulator.Update(dt);
                if (++updates == 100)
                {
                    stop.Cancel();
                }
            },
            10,
            1,
            cancellation: stop.Token));
        Assert.Equal(100, updates);
    }

    [Fact]
    public void Advise_WhatCannotBeKept_NamesNoSetting()
    {
        AccuracyAdvice advice = AccuracyAdvisor.Advise(Stack, 0.1f, 1e-12f);
        Assert.Null(advice.Cheapest);
        Assert.Equal(24, advice.Curve.Count);
    }

    [Fact]
    public void Advise_GivesTheUpdatesToTheCaller()
    {
        int updates = 0;
        AccuracyAdvisor.Advise(
            Stack,
            (simulator, done, dt) =>
            {
                Assert.True(done >= 0);
                updates++;
                simulator.Update(dt);
            },
            0.1f,
            1);
        Assert.True(updates > 24 * 2);
    }

    [Fact]
    public void Advise_WithAMistake_IsRefused()
    {
        Assert.Throws<ArgumentNullException>(() => AccuracyAdvisor.Advise(null!, 1, 1));
        Assert.Throws<ArgumentNullException>(() => AccuracyAdvisor.Advise(Stack, null!, 1, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => AccuracyAdvisor.Advise(Stack, 0, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => AccuracyAdvisor.Advise(Stack, 1, float.NaN));
        Assert.Throws<InvalidOperationException>(() => AccuracyAdvisor.Advise(() => null!, 1, 1));
    }

    private static PhysicsSimulator DoublePendulum(int iterations)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10)) { Iterations = iterations };
        Body before = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        before.IsStatic = true;
        for (int i = 0; i < 2; i++)
        {
            Body rod = BodyFactory.Instance.CreateBody(simulator, 1, 1f / 12);
            rod.Position = new Vector2(i + 0.5f, 0);
            rod.LinearDragCoefficient = 0;
            rod.RotationalDragCoefficient = 0;
            JointFactory.Instance.CreateRevoluteJoint(simulator, before, rod, new Vector2(i, 0));
            before = rod;
        }

        return simulator;
    }

    private sealed class Shares : IProgress<double>
    {
        public List<double> Told { get; } = [];

        public void Report(double value) => Told.Add(value);
    }

    private static PhysicsSimulator Stack()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = 0 };
        Geom ground = Sandbox.Box(simulator, new Vector2(0, -0.5f), 20, 1);
        ground.Body.IsStatic = true;
        for (int i = 0; i < 3; i++)
        {
            Sandbox.Box(simulator, new Vector2(0, i + 0.5f), 1, 1);
        }

        return simulator;
    }
}
