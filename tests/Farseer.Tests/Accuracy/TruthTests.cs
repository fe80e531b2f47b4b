using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Accuracy;
using Farseer.Accuracy.Truth;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>A report is no better than the truth, and a budget that says it was kept was kept.</summary>
public class TruthTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Report_OfRandomScenes_IsNoBetterThanTheTruth(int seed)
    {
        using var output = new System.IO.StringWriter();
        string[] words = ["truthful", "--count", "200", "--seed", seed.ToString(System.Globalization.CultureInfo.InvariantCulture)];
        Assert.True(Cli.Run(words, output, output) == 0, output.ToString());
    }

    [Theory]
    [InlineData(1, 0.2)]
    [InlineData(1, 1)]
    [InlineData(2, 0.2)]
    public void Impact_FlatLandingWithoutLoss_MissingEnergyIsToldToTheLastBit(double width, double height)
    {
        int flagged = 0;
        for (int i = 0; i < 40; i++)
        {
            using Rig rig = StepReportTests.New(gravity: 0);
            rig.Friction = 0;
            rig.Restitution = 1;
            rig.AddGround();
            Actor box = rig.AddBox(0, 1 + (0.003 * i), width, height, 0.001 + (0.01 * i));
            box.Velocity = new Vec(0, -5);
            rig.Simulator.ErrorBudget = ErrorBudget.OfLength(1e-3f, 5);
            double start = box.KineticEnergy;
            double told = 0;
            bool within = true;
            for (int step = 0; step < 30; step++)
            {
                rig.Step();
                told += rig.Simulator.Report.ImpactEnergyError;
                within &= rig.Simulator.Report.IsWithinBudget;
            }

            double changed = box.KineticEnergy - start;

            // Nothing but impacts changes the energy; velocities are floats.
            Assert.Equal(changed, told, 1e-5 * start);

            // A thirtieth of the energy is a sixtieth of the speed, which is 1.4 mm in a step.
            Assert.True(!within || Math.Abs(changed) < start / 30, $"tilt {i}: {changed} J of {start} J, said to be within.");
            flagged += within ? 0 : 1;
        }

        // A blow of 5 m/s is not known to a millimetre, so all are.
        Assert.Equal(40, flagged);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.3)]
    [InlineData(0.5)]
    [InlineData(0.8)]
    [InlineData(1)]
    public void Impact_OfABall_KeepsTheLaw(double restitution)
    {
        for (int i = 0; i < 20; i++)
        {
            using Rig rig = StepReportTests.New();
            rig.Friction = 0;
            rig.Restitution = restitution;
            rig.AddGround();
            Actor ball = rig.AddCircle(0, 1 + (0.05 * i), 0.3);
            rig.Simulator.EnableReport = true;
            for (int step = 0; step < 60; step++)
            {
                double before = ball.KineticEnergy;
                rig.Step();

                // What gravity gives between the impact and the end of a substep.
                Assert.InRange(Math.Abs(rig.Simulator.Report.ImpactEnergyError), 0, 1e-3 * (before + 1));
            }
        }
    }

    [Fact]
    public void Slip_OfAFallingPencil_IsTheWayOfItsTip()
    {
        for (int i = 0; i < 20; i++)
        {
            double angle = 0.05 + (0.01 * i);
            using Rig rig = StepReportTests.New();
            rig.Friction = 5;
            rig.AddGround();
            const double Width = 0.05;
            double x = 0.5 * Math.Sin(angle);
            double y = (0.5 * Math.Cos(angle)) + (Width / 2 * Math.Sin(angle));
            Actor rod = rig.AddBox(-x, y, Width, 1, angle);
            rig.Simulator.EnableReport = true;
            double sum = 0;
            Vec before = Tip(rod, Width);
            for (int step = 0; step < 15; step++)
            {
                rig.Step();
                Vec after = Tip(rod, Width);
                if (rig.Simulator.Report.LargestSlip > 0)
                {
                    // The corner is where a float puts it.
                    Assert.Equal(Math.Abs(after.X - before.X), rig.Simulator.Report.LargestSlip, 3e-7);
                    sum += after.X - before.X;
                    Assert.Equal(Math.Abs(sum), rig.Simulator.Report.LargestCreep, 5e-6);
                }

                before = after;
            }
        }
    }

    [Fact]
    public void Slip_OfWhatRollsOrSlides_IsNone()
    {
        using Rig rolling = StepReportTests.New();
        rolling.AddGround();
        Actor disc = rolling.AddCircle(-5, 0.5, 0.5);
        disc.Velocity = new Vec(3, 0);
        disc.Body.AngularVelocity = -6;
        using Rig sliding = StepReportTests.New();
        sliding.Friction = 0.2;
        sliding.AddGround();
        Actor box = sliding.AddBox(-5, 0.5, 1, 1);
        box.Velocity = new Vec(6, 0);
        rolling.Simulator.EnableReport = true;
        sliding.Simulator.EnableReport = true;
        for (int i = 0; i < 60; i++)
        {
            rolling.Step();
            sliding.Step();

            // A hundredth of a thousandth of the 50 mm that it rolls in an update.
            Assert.InRange(rolling.Simulator.Report.LargestSlip, 0, 5e-7);
            Assert.Equal(0, sliding.Simulator.Report.LargestSlip);
        }
    }

    [Fact]
    public void Budget_OnADoublePendulum_SaysWhichUpdatesMissAndWhere()
    {
        using Rig rig = DoublePendulum(5);
        using Rig exact = DoublePendulum(5);
        rig.Simulator.ErrorBudget = ErrorBudget.OfLength(1e-7f, 5);
        int flagged = 0;
        for (int i = 0; i < 200; i++)
        {
            rig.Step();
            StepReport report = rig.Simulator.Report;
            flagged += report.IsWithinBudget ? 0 : 1;
            if (!report.IsWithinBudget)
            {
                Assert.Equal(ErrorCause.Motion, report.Cause);
                Assert.NotNull(report.WorstBody);
                Assert.Equal(report.Error / 1e-7f, report.BudgetLoad, 1e-6 * report.BudgetLoad);
            }
        }

        Assert.InRange(flagged, 150, 200);
    }

    [Fact]
    public void Budget_OnADoublePendulum_IsKeptIfThereAreIterationsForIt()
    {
        using Rig rig = DoublePendulum(5);
        rig.Simulator.ErrorBudget = ErrorBudget.OfLength(1e-5f, 400);
        int missed = 0;
        for (int i = 0; i < 300; i++)
        {
            rig.Step();
            missed += rig.Simulator.Report.IsWithinBudget ? 0 : 1;
        }

        // It goes by the update before: where the motion turns hard, one after the other is short.
        Assert.InRange(missed, 0, 30);
    }

    [Fact]
    public void Budget_OfAStackAtTheDefaults_IsKeptAsItSays()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10));
        Geom ground = Sandbox.Box(simulator, new Vector2(0, -0.5f), 20, 1);
        ground.Body.IsStatic = true;
        var boxes = new List<Body>();
        for (int i = 0; i < 5; i++)
        {
            boxes.Add(Sandbox.Box(simulator, new Vector2(0, i + 0.5f), 1, 1).Body);
        }

        simulator.ErrorBudget = ErrorBudget.OfLength(1e-4f);
        for (int i = 0; i < 600; i++)
        {
            simulator.Update(1f / 60);
            double low = 4.5 - boxes[4].Position.Y;
            Assert.True(!simulator.Report.IsWithinBudget || low <= 1.01e-4, $"step {i}: {low} m low, said to be within");
        }

        Assert.True(simulator.Report.IsWithinBudget, $"{simulator.Report.Error} m of {simulator.Report.Cause}");
    }

    [Fact]
    public void Report_OfALoop_NamesAJointWhereOneIsWorst()
    {
        using Rig rig = StepReportTests.Build("loop");
        rig.Simulator.EnableReport = true;
        for (int i = 0; i < 60; i++)
        {
            rig.Step();
            StepReport report = rig.Simulator.Report;
            Assert.Equal(report.Cause == ErrorCause.Separation, report.WorstJoint is not null);
            Assert.Equal(Math.Max(report.ConstraintError, report.MotionError), report.Error);
        }
    }

    [Fact]
    public void Report_OfALostBody_IsInfinite()
    {
        using var simulator = new PhysicsSimulator(new Vector2(0, -10));
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        simulator.ErrorBudget = ErrorBudget.OfLength(1);
        simulator.Update(1f / 60);
        Assert.True(simulator.Report.IsWithinBudget);
        body.ApplyForce(new Vector2(3e38f, 0));
        simulator.Update(1f / 60);
        Assert.False(body.Enabled);
        Assert.Equal(double.PositiveInfinity, simulator.Report.Error);
        Assert.Equal(ErrorCause.Lost, simulator.Report.Cause);
        Assert.Same(body, simulator.Report.WorstBody);
        Assert.False(simulator.Report.IsWithinBudget);
    }

    private static Rig DoublePendulum(int iterations)
    {
        var rig = new Rig(new Dial(iterations, Options.DefaultDt), 10);
        Actor first = rig.AddLooseBox(new Vec(0.5, 0), 0.1, 1, Math.PI / 2, 1);
        Actor second = rig.AddLooseBox(new Vec(1.5, 0), 0.1, 1, Math.PI / 2, 1);
        rig.AddHinge(rig.AddAnchor(0, 0), first, new Vec(0, 0));
        rig.AddHinge(first, second, new Vec(1, 0));
        return rig;
    }

    /// <summary>The corner that the rod stands on.</summary>
    private static Vec Tip(Actor rod, double width) =>
        rod.Position + new Vec(rod.Angle > 0 ? -width / 2 : width / 2, -0.5).Turned(rod.Angle);
}
