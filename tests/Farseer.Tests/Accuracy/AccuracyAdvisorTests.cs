using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
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
        for (int i = 0; i < (int)Math.Round(0.5f / best.Dt); i++)
        {
            simulator.Update(best.Dt);
            peak = Math.Max(peak, simulator.Report.Error);
        }

        Assert.Equal(best.PeakError, peak);
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
