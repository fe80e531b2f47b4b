using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Accuracy.Surveys;

/// <summary>
/// What swings or whirls on a rope keeps its energy while the rope is taut; where it goes slack and snaps, it can only lose. So does what
/// swings at the end of a slider.
/// </summary>
internal sealed class RopeSwingSurvey : Survey
{
    private const double Limit = 1e-3;

    private const double Gravity = 10;
    private const double Seconds = 30;

    /// <summary>Up to the horizontal the rope stays taut; at the horizontal itself it is so with no force.</summary>
    private const double Taut = 1.5;

    public override string Name => "K12";

    public override string What =>
        "swings on a rope or at the end of a slider: energy gained in 30 s, or lost where it stays taut, of the energy at the lowest "
            + "place; at most 1e-3";

    public override int Draws => 200;

    public override IEnumerable<Variation> Grid()
    {
        foreach (float length in (float[])[0.3f, 1, 3])
        {
            foreach (float angle in (float[])[0.3f, 1, 1.4f, MathF.PI / 2, 1.8f, 2.5f])
            {
                yield return Swing(new Setup("pendulum", length, angle, 1, 1, 0, 5, Yard.UsualDt));
                yield return Swing(new Setup("slider", length, angle, 1, 1, 0, 5, Yard.UsualDt));
            }
        }

        foreach (int iterations in (int[])[1, 2, 10, 20])
        {
            yield return Swing(new Setup("pendulum", 3, MathF.PI / 2, 1, 1, 0, iterations, Yard.UsualDt));
            yield return Swing(new Setup("whirl", 3, 1, 1, 1, 0, iterations, Yard.UsualDt));
        }
    }

    public override Variation Draw(Dice dice) => Swing(new Setup(
        dice.Of("pendulum", "slider", "whirl"), dice.Wide(0.3, 10), dice.Between(0.1, 3), dice.Wide(0.1, 10), dice.Wide(0.1, 10),
        dice.Of(0, 0, dice.Between(0, 0.3)), dice.Whole(2, 20), dice.Of(Yard.UsualDt, Yard.UsualDt, 1 / 30f, 1 / 120f)));

    private static Variation Swing(Setup s) => new(
        FormattableString.Invariant($"{s.What} of {s.Mass} kg on {s.Length} m, ")
            + (s.What == "whirl"
                ? FormattableString.Invariant($"about {s.Other} kg at {s.Angle} of the root of g·length, ")
                : FormattableString.Invariant($"from {s.Angle}, "))
            + FormattableString.Invariant($"held {s.Offset} of the length off its centre, iterations {s.Iterations}, 1/{1 / s.Dt:F0} s"),
        Limit,
        () => s.What == "whirl" ? Whirl(s) : Pendulum(s));

    private static double Pendulum(Setup s)
    {
        using var yard = new Yard(Yard.UsualDepth, iterations: s.Iterations, dt: s.Dt);
        Body post = yard.Anchor(Vector2.Zero);
        float arm = s.Offset * s.Length;
        var down = new Vector2(MathF.Sin(s.Angle), -MathF.Cos(s.Angle));
        Body bob = yard.Loose((s.Length + arm) * down, s.Mass, s.Mass * 0.1f * s.Length * s.Length);
        yard.Simulator.Add(s.What == "slider"
            ? new SliderJoint(post, Vector2.Zero, bob, -arm * down, 0, s.Length) { Slop = 0 }
            : new RopeJoint(post, Vector2.Zero, bob, -arm * down, s.Length));
        double start = bob.PositionY;
        double scale = s.Mass * Gravity * (s.Length + arm + start);
        return Play(yard, s, () => Yard.Energy(bob) + (s.Mass * Gravity * (bob.PositionY - start)), scale, s.Angle < Taut && s.Offset == 0);
    }

    private static double Whirl(Setup s)
    {
        using var yard = new Yard(Yard.UsualDepth, gravity: 0, iterations: s.Iterations, dt: s.Dt);
        float arm = s.Offset * s.Length;
        Body a = yard.Loose(Vector2.Zero, s.Mass, s.Mass * 0.1f * s.Length * s.Length);
        Body b = yard.Loose(new Vector2(s.Length + arm, 0), s.Other, s.Other * 0.1f * s.Length * s.Length);
        yard.Simulator.Add(new RopeJoint(a, Vector2.Zero, b, new Vector2(-arm, 0), s.Length));
        b.LinearVelocity = new Vector2(0, s.Angle * MathF.Sqrt((float)Gravity * s.Length));
        double start = Yard.Energy(b);
        return Play(yard, s, () => Yard.Energy(a) + Yard.Energy(b) - start, start, s.Offset == 0);
    }

    private static double Play(Yard yard, Setup s, Func<double> gained, double scale, bool keeps)
    {
        double worst = 0;
        yard.Steps((int)(Seconds / s.Dt), after: () =>
        {
            double gain = gained();
            worst = Math.Max(worst, keeps ? Math.Abs(gain) : gain);
        });
        return yard.Figure(worst / scale);
    }

    private sealed record Setup(
        string What, float Length, float Angle, float Mass, float Other, float Offset, int Iterations, float Dt);
}
