using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>A body whose state is no longer one of numbers is taken out and reported; the others go on.</summary>
public class QuarantineTests
{
    public static TheoryData<float> NoNumbers() =>
        new TheoryData<float> { float.NaN, float.PositiveInfinity, float.NegativeInfinity, 1e30f };

    [Theory]
    [MemberData(nameof(NoNumbers))]
    public void VelocityThatIsNoNumber_DisablesTheBody_AndReportsStepAndCall(float bad)
    {
        var reports = new List<BodyQuarantinedEventArgs>();
        Bench bench = Watched(reports);
        bench.Box.LinearVelocity.X = bad;
        Vector2 place = bench.Box.Position;
        bench.Step(1);
        BodyQuarantinedEventArgs report = Assert.Single(reports);
        Assert.Same(bench.Box, report.Body);
        Assert.Equal(6, report.Step);
        Assert.Contains("LinearVelocity", report.LastCall, StringComparison.Ordinal);
        Assert.Equal(5, report.LastCallStep);
        Assert.Contains("step 6", report.ToString(), StringComparison.Ordinal);
        Assert.True(bench.Box.IsQuarantined);
        Assert.False(bench.Box.Enabled);
        Assert.Equal(place, bench.Box.Position);
        Assert.Equal(Vector2.Zero, bench.Box.LinearVelocity);
        bench.Step(30);
        bench.AssertSound();
        Assert.Single(reports);
    }

    [Fact]
    public void TheOthers_GoOnAsIfTheBodyHadBeenDisabled()
    {
        var sick = new Bench();
        sick.Box.AngularVelocity = float.NaN;
        var off = new Bench();
        off.Box.Enabled = false;
        for (int i = 0; i < 60; i++)
        {
            sick.Step(1);
            off.Step(1);
            Assert.Equal(off.Ball.Position, sick.Ball.Position);
            Assert.Equal(off.Ball.LinearVelocity, sick.Ball.LinearVelocity);
        }

        Assert.True(sick.Ball.Position.Y > -16, "the ball should have fallen through to the floor");
    }

    [Fact]
    public void Enabling_LetsItGoOn()
    {
        Bench bench = Watched(new List<BodyQuarantinedEventArgs>());
        bench.Ball.LinearVelocity = new Vector2(float.NaN);
        bench.Step(3);
        Vector2 place = bench.Ball.Position;
        bench.Ball.Enabled = true;
        Assert.False(bench.Ball.IsQuarantined);
        bench.Step(10);
        Assert.True(bench.Ball.Position.Y > place.Y);
        bench.Ball.LinearVelocity = new Vector2(float.NaN);
        bench.Step(1);
        Assert.True(bench.Ball.IsQuarantined);
    }

    [Fact]
    public void ForceBeyondAllNumbers_TakesOutItsBodyOnly_WithTheCallThatDidIt()
    {
        var reports = new List<BodyQuarantinedEventArgs>();
        Bench bench = Watched(reports);
        Body above = BodyFactory.Instance.CreateRectangleBody(bench.Simulator, 20, 20, 1);
        above.Position = new Vector2(0, -40);
        GeomFactory.Instance.CreateRectangleGeom(bench.Simulator, above, 20, 20);
        bench.Step(1);
        bench.Box.ApplyForce(new Vector2(0, -3e38f));
        bench.Box.ApplyForce(new Vector2(0, -3e38f));
        bench.Step(1);
        BodyQuarantinedEventArgs report = Assert.Single(reports);
        Assert.Same(bench.Box, report.Body);
        Assert.Equal("ApplyForce", report.LastCall);
        Assert.Equal(6, report.LastCallStep);
        Assert.Equal(7, report.Step);
        bench.Step(50);
        bench.AssertSound();
        Assert.False(above.IsQuarantined);
        Assert.Single(reports);
    }

    [Fact]
    public void ImpulseBeyondAllNumbers_InFreeFlight_LeavesThePlace()
    {
        var reports = new List<BodyQuarantinedEventArgs>();
        Bench bench = Watched(reports);
        bench.Ball.Position = new Vector2(0, -1000);
        bench.Ball.ApplyImpulse(new Vector2(3e38f, 0));
        bench.Step(1);
        Assert.Equal("ApplyImpulse", Assert.Single(reports).LastCall);
        Assert.Equal(new Vector2(0, -1000), bench.Ball.Position);
    }

    [Fact]
    public void WrongNumberFromAHandler_DoesNotSpread()
    {
        var reports = new List<BodyQuarantinedEventArgs>();
        Bench bench = Watched(reports);
        bench.BoxGeom.OnCollision += (geom, _, _) =>
        {
            geom.Body.LinearVelocity = new Vector2(float.NaN, 0);
            return true;
        };
        bench.Ball.Position = new Vector2(0, -34.9f);
        bench.Step(1);
        Assert.Same(bench.Box, Assert.Single(reports).Body);
        Assert.False(bench.Ball.IsQuarantined);
        bench.Step(30);
        bench.AssertSound();
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void StaticBody_LosesItsVelocityOnly(bool fromHandler)
    {
        var reports = new List<BodyQuarantinedEventArgs>();
        Bench bench = Watched(reports);
        Body floor = bench.Simulator.BodyList[0];
        if (fromHandler)
        {
            bench.BoxGeom.OnCollision += (_, _, _) =>
            {
                floor.LinearVelocity = new Vector2(float.NaN);
                return true;
            };
            bench.Step(1);
            bench.BoxGeom.OnCollision = null;
        }
        else
        {
            floor.AngularVelocity = float.NaN;
        }

        bench.Step(1);
        Assert.Same(floor, Assert.Single(reports).Body);
        Assert.False(floor.IsQuarantined);
        bench.Step(40);
        bench.AssertSound();
        Assert.InRange(bench.Box.Position.Y, -20.1f, -19.9f);
    }

    [Fact]
    public void KinematicBody_IsTakenOutToo()
    {
        var reports = new List<BodyQuarantinedEventArgs>();
        Bench bench = Watched(reports);
        bench.Box.IsKinematic = true;
        bench.BoxGeom.OnCollision += (geom, _, _) =>
        {
            geom.Body.AngularVelocity = float.PositiveInfinity;
            return true;
        };
        bench.Ball.Position = new Vector2(0, -34.9f);
        bench.Step(2);
        Assert.Same(bench.Box, Assert.Single(reports).Body);
        bench.AssertSound();
    }

    [Fact]
    public void HandlerThatThrowsOrActs_IsHeardAfterTheStep()
    {
        var bench = new Bench();
        bench.Simulator.BodyQuarantined += (_, e) => e.Body.Dispose();
        bench.Simulator.BodyQuarantined += (_, _) => throw new FormatException("mine");
        bench.Ball.AngularVelocity = float.NaN;
        Assert.Throws<FormatException>(() => bench.Step(1));
        bench.Step(1);
        Assert.DoesNotContain(bench.Ball, bench.Simulator.BodyList);
    }

    private static Bench Watched(List<BodyQuarantinedEventArgs> reports)
    {
        var bench = new Bench();
        bench.Simulator.BodyQuarantined += (sender, e) =>
        {
            Assert.Same(bench.Simulator, sender);
            reports.Add(e);
        };
        return bench;
    }
}
