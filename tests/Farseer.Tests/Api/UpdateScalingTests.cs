using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>The interval of updates under load.</summary>
public class UpdateScalingTests
{
    [Fact]
    [ManualRow("F297")]
    public void Scaling_NotEnabled_SimulatesWhatIsGiven()
    {
        PhysicsSimulator simulator = Falling(out Body body);
        Assert.False(simulator.Scaling.Enabled);
        simulator.Update(0.001f, 1);
        Assert.True(body.LinearVelocity.Y > 0);
        Assert.Equal(0.001f, simulator.Scaling.UpdateInterval);
        Assert.Equal(0.01f, simulator.Scaling.MaximumUpdateInterval);
    }

    [Fact]
    [ManualRow("F297")]
    public void Scaling_UnderLoad_GrowsTheIntervalToTheMaximum_AndShrinksItBack()
    {
        PhysicsSimulator simulator = Falling(out _);
        simulator.Scaling = new Scaling(0.002f, 0.01f) { Enabled = true };
        for (int i = 1; i <= 16; i++)
        {
            simulator.Update(0.001f, 0.02f);
            Assert.Equal(0.002f + (0.0005f * i), simulator.Scaling.UpdateInterval, 5);
        }

        simulator.Update(0.001f, 0.02f);
        Assert.Equal(0.01f, simulator.Scaling.UpdateInterval, 5);
        for (int i = 1; i <= 32; i++)
        {
            simulator.Update(0.001f, 0.0005f);
            Assert.Equal(0.01f - (0.00025f * i), simulator.Scaling.UpdateInterval, 5);
        }

        simulator.Update(0.001f, 0.0005f);
        Assert.Equal(0.002f, simulator.Scaling.UpdateInterval, 5);
    }

    [Fact]
    public void Scaling_UnderASteadyLoad_SettlesAtTheRealTime()
    {
        var random = new Random(5);
        for (int i = 0; i < 200; i++)
        {
            float preferred = 0.0005f + (0.01f * (float)random.NextDouble());
            float maximum = preferred * (1 + (40 * (float)random.NextDouble()));
            float real = preferred * 45 * (float)random.NextDouble();
            PhysicsSimulator simulator = Falling(out _);
            simulator.Scaling = new Scaling(preferred, maximum) { Enabled = true };
            for (int step = 0; step < 400; step++)
            {
                simulator.Update(0.001f, real);
            }

            // It goes up by a quarter of the preferred interval where it has just come too low.
            float expected = Math.Min(Math.Max(real, preferred), maximum);
            for (int step = 0; step < 10; step++)
            {
                simulator.Update(0.001f, real);
                Assert.InRange(simulator.Scaling.UpdateInterval, expected - (0.126f * preferred), expected + (0.251f * preferred));
            }
        }
    }

    [Fact]
    [ManualRow("F297")]
    public void Scaling_Enabled_GathersTimeUntilTheIntervalIsFull_AndLosesNone()
    {
        PhysicsSimulator simulator = Falling(out Body body);
        simulator.Scaling = new Scaling(0.01f, 0.01f) { Enabled = true };
        int steps = 0;
        float last = 0;
        for (int i = 0; i < 100; i++)
        {
            simulator.Update(0.00390625f);
            if (body.LinearVelocity.Y != last)
            {
                steps++;
                last = body.LinearVelocity.Y;
            }
        }

        // Three gifts of 1/256 s make an interval: 33 steps and one gift left over.
        Assert.Equal(33, steps);
        Assert.Equal(99 * 0.00390625f * 100, body.LinearVelocity.Y, 2);
    }

    [Fact]
    [ManualRow("F297")]
    public void Scaling_WrongNumbers_AreRefused()
    {
        Assert.Equal("preferredUpdateInterval", Assert.Throws<ArgumentOutOfRangeException>(() => new Scaling(0, 1)).ParamName);
        Assert.Equal("maximumUpdateInterval", Assert.Throws<ArgumentOutOfRangeException>(() => new Scaling(1, float.NaN)).ParamName);
        var scaling = new Scaling(0.01f, 0.1f);
        Assert.Throws<ArgumentOutOfRangeException>(() => scaling.UpdateInterval = -1);
        Assert.Throws<ArgumentOutOfRangeException>(() => scaling.MaximumUpdateInterval = float.PositiveInfinity);
        Assert.Throws<ArgumentOutOfRangeException>(() => scaling.GetUpdateInterval(-1));
        Assert.Equal(0.01f, scaling.UpdateInterval);
        Assert.Throws<ArgumentNullException>(() => new PhysicsSimulator().Scaling = null!);
    }

    private static PhysicsSimulator Falling(out Body body)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        body = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        body.LinearDragCoefficient = 0;
        return simulator;
    }
}
