using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Accuracy.Surveys;

/// <summary>
/// A pulley whose light side is drawn up to its wheel stops the heavy side there: the rope does not grow, and nothing is set going.
/// </summary>
internal sealed class WheelSurvey : Survey
{
    private const double Limit = 0.02;

    /// <summary>
    /// What starts aside is drawn into a whirl about its wheel, down to a radius of two of its ways in a substep: there a rope is long by a
    /// good part of that radius.
    /// </summary>
    private const double LimitOfWhirls = 0.05;

    /// <summary>
    /// The light side flies on past its wheel before a rope that is taut again is seen, by its way in a substep or two, up to 8 cm here:
    /// of growth that is gone again a quarter of a second later a tenth counts.
    /// </summary>
    private const double ShareOfPassing = 0.1;
    private const float Passing = 0.25f;

    private const double Gravity = 10;
    private const float Seconds = 10;

    public override string Name => "K10";

    public override string What =>
        "pulleys drawn to their wheels, 10 s: lasting growth / length of the rope, "
        + "or energy gained / weight · length; at most 0.02, or 0.05";

    public override int Draws => 200;

    public override IEnumerable<Variation> Grid()
    {
        foreach (int iterations in (int[])[5, 20])
        {
            foreach (float times in (float[])[2, 5, 10, 50, 100, 1000])
            {
                foreach (float offset in (float[])[0, 0.05f, 0.2f])
                {
                    yield return Draw(new Setup(times, true, offset, 0, 1, 2, iterations, Yard.UsualDt));
                }
            }
        }
    }

    public override Variation Draw(Dice dice) => Draw(new Setup(
        dice.Wide(1.5, 1000), dice.Of(true, false), dice.Of(0, dice.Between(0, 0.3)), dice.Of(0, dice.Between(0, 1)), dice.Wide(0.4, 2.5),
        dice.Wide(1, 5), dice.Whole(5, 20), dice.Of(Yard.UsualDt, Yard.UsualDt, 1 / 120f)));

    private static Variation Draw(Setup s) => new(
        FormattableString.Invariant($"{s.Times} times as heavy, {(s.SecondIsHeavy ? "second" : "first")} side down, offset {s.Offset}, ")
            + FormattableString.Invariant(
                $"{s.Aside} m aside, ratio {s.Ratio}, sides of {s.Side} m, iterations {s.Iterations}, 1/{1 / s.Dt:F0} s"),
        s.Aside > 0 ? LimitOfWhirls : Limit,
        () => Play(s));

    private static double Play(Setup s)
    {
        using var yard = new Yard(Yard.UsualDepth, iterations: s.Iterations, dt: s.Dt);

        // In terms of the pull that the other side gives it, the heavy side weighs so many times as much.
        float heavy = s.Times * (s.SecondIsHeavy ? s.Ratio : 1 / s.Ratio);
        float first = s.SecondIsHeavy ? 1 : heavy;
        float second = s.SecondIsHeavy ? heavy : 1;
        var wheel1 = new Vector2(0, s.Side);
        var wheel2 = new Vector2(4, s.Side);
        Body a = Hung(yard, new Vector2(s.Aside * s.Side, 0), first);
        Body b = Hung(yard, new Vector2(4, 0), second);
        var anchor = new Vector2(s.Offset, s.Offset);
        var pulley = new PulleyJoint(a, wheel1, anchor, b, wheel2, anchor, s.Ratio);
        yard.Simulator.Add(pulley);
        double length = pulley.TotalLength;
        double scale = Gravity * length * (first + (second / s.Ratio));
        double start = Yard.Energy(a) + Yard.Energy(b);
        double worst = 0;
        double least = double.PositiveInfinity;
        int passing = (int)(Passing / s.Dt);
        int step = 0;
        yard.Steps((int)(Seconds / s.Dt), after: () =>
        {
            double growth = (pulley.Length1 + ((double)s.Ratio * pulley.Length2) - length) / length;
            double energy = Yard.Energy(a) + Yard.Energy(b) + (Gravity * ((first * a.PositionY) + (second * b.PositionY)));
            worst = Math.Max(worst, Math.Max(ShareOfPassing * growth, (energy - start) / scale));
            least = Math.Min(least, growth);
            if (++step % passing == 0)
            {
                worst = Math.Max(worst, least);
                least = double.PositiveInfinity;
            }
        });
        return yard.Figure(worst);
    }

    private static Body Hung(Yard yard, Vector2 place, float mass) => yard.Loose(place, mass, mass * 0.32f / 12);

    private sealed record Setup(
        float Times, bool SecondIsHeavy, float Offset, float Aside, float Ratio, float Side, int Iterations, float Dt);
}
