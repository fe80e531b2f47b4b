using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Accuracy.General;
using Farseer.Accuracy.Surveys;
using Farseer.Tests.Accuracy;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using Xunit;
using Dice = Farseer.Accuracy.Surveys.Dice;

namespace Farseer.Tests.Behavior;

/// <summary>
/// Joints that push or pull by a law of their own, pulleys, motors and ropes: they follow it, and what they do to one body they do to
/// the other. The surveys and scenes are those of the accuracy runner.
/// </summary>
public class DriveTests
{
    private const int Worlds = 200;

    /// <summary>A velocity is a float: of each body 6e-8 of its momentum are rounding, of each step again.</summary>
    private const double Rounding = 1e-6;

    /// <summary>
    /// Way after a second within 1e-5, and the error quartered by each doubling of Iterations, over 130 sets of parameters.
    /// </summary>
    [Theory]
    [InlineData(7)]
    [InlineData(8)]
    public void Drives_FromRest_FollowTheirClosedForms(int seed)
    {
        List<string> misses = Misses.Of(GeneralCatalogue.Find("G22")!, (uint)seed);
        Assert.True(misses.Count == 0, string.Join("\n", misses));
    }

    [Fact]
    public void Slides_OfBodiesThatCannotTurn_HoldThemOnTheirAxes() => AssertHolds(new FixedSlideSurvey(), 70);

    [Fact]
    public void MotorJoints_BetweenFreeBodies_MakeNoMomentum() => AssertHolds(new MotorMomentumSurvey(), 70);

    [Fact]
    public void Pulleys_DrawnToTheirWheels_DoNotGrow() => AssertHolds(new WheelSurvey(), 70);

    [Fact]
    public void Swings_OnRopesAndSliders_KeepTheirEnergy() => AssertHolds(new RopeSwingSurvey(), 70);

    /// <summary>Bodies at the ends of ropes, spinning and thrown apart: ropes between them are all that acts.</summary>
    [Fact]
    public void Ropes_BetweenFreeBodies_MakeNoMomentum()
    {
        var dice = new Dice(3, "ropes");
        for (int i = 0; i < Worlds; i++)
        {
            using var yard =
                new Yard(Yard.UsualDepth, gravity: 0, iterations: dice.Whole(1, 20), dt: dice.Of(Yard.UsualDt, 1 / 30f, 1 / 120f));
            var bodies = new List<Body>();
            int count = dice.Whole(2, 4);
            for (int k = 0; k < count; k++)
            {
                float mass = dice.Wide(0.1, 100);
                Body body = yard.Loose(new Vector2(k, dice.Between(-0.2, 0.2)), mass, mass * dice.Wide(0.02, 2));
                body.LinearVelocity = new Vector2(dice.Between(-2, 2), dice.Between(-2, 2));
                body.AngularVelocity = dice.Between(-4, 4);
                if (k > 0)
                {
                    var end = new Vector2(dice.Between(-0.2, 0.2), dice.Between(-0.2, 0.2));
                    yard.Simulator.Add(new RopeJoint(bodies[k - 1], -end, body, end, dice.Between(1.5, 3)));
                }

                bodies.Add(body);
            }

            var ledger = new MomentumLedger(bodies);
            yard.Steps(240, after: ledger.Look);
            Assert.True(yard.Figure(ledger.Made) <= Rounding, $"world {i}: {ledger.Made}");
        }
    }

    /// <summary>A rope over a wheel pulls through the wheel alone, so each body keeps its angular momentum about it.</summary>
    [Fact]
    public void Pulleys_WithoutGravity_KeepEachBodysAngularMomentumAboutItsWheel()
    {
        var dice = new Dice(4, "pulleys");
        for (int i = 0; i < Worlds; i++)
        {
            using var yard =
                new Yard(Yard.UsualDepth, gravity: 0, iterations: dice.Whole(1, 20), dt: dice.Of(Yard.UsualDt, 1 / 30f, 1 / 120f));
            var ledgers = new List<MomentumLedger>();
            var wheels = new[] { new Vector2(-2, 0), new Vector2(2, 0) };
            var bodies = new List<Body>();
            var ends = new List<Vector2>();
            foreach (Vector2 wheel in wheels)
            {
                float mass = dice.Wide(0.1, 100);
                Body body = yard.Loose(wheel + new Vector2(dice.Between(-1, 1), -dice.Between(1, 3)), mass, mass * dice.Wide(0.02, 2));
                body.LinearVelocity = new Vector2(dice.Between(-2, 2), dice.Between(-2, 2));
                body.AngularVelocity = dice.Between(-4, 4);
                ledgers.Add(MomentumLedger.About(body, wheel.X, wheel.Y));
                bodies.Add(body);
                ends.Add(new Vector2(dice.Between(-0.2, 0.2), dice.Between(-0.2, 0.2)));
            }

            yard.Simulator.Add(new PulleyJoint(bodies[0], wheels[0], ends[0], bodies[1], wheels[1], ends[1], dice.Wide(0.4, 2.5)));
            yard.Steps(240, after: () => ledgers.ForEach(ledger => ledger.Look()));
            Assert.All(ledgers, ledger => Assert.True(yard.Figure(ledger.Made) <= Rounding, $"world {i}: {ledger.Made}"));
        }
    }

    private static void AssertHolds(Survey survey, int draws)
    {
        List<string> misses = Misses.Of([.. survey.Variations(5, draws)]);
        Assert.True(misses.Count == 0, string.Join("\n", misses));
    }
}
