using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Accuracy.Surveys;

/// <summary>Motor joints between free bodies are forces between them: they make no momentum, neither linear nor angular.</summary>
internal sealed class MotorMomentumSurvey : Survey
{
    /// <summary>A velocity is a float: of each body 6e-8 of its momentum are rounding, of each step again.</summary>
    private const double Limit = 1e-6;

    private const int Steps = 120;

    public override string Name => "K9";

    public override string What =>
        "free bodies and motor joints: momentum or angular momentum made in 2 s, "
        + "as a share of what the bodies have one by one; at most 1e-6";

    public override int Draws => 200;

    public override IEnumerable<Variation> Grid()
    {
        foreach (float mass in (float[])[1, 10, 1000])
        {
            foreach (float torque in (float[])[0, 10, float.MaxValue])
            {
                foreach (float force in (float[])[10, 1000, float.MaxValue])
                {
                    yield return Drive(new Setup(2, 1, mass, force, torque, 5, Yard.UsualDt, 0, 1));
                }
            }
        }
    }

    public override Variation Draw(Dice dice) => Drive(new Setup(
        dice.Whole(2, 4), dice.Wide(0.1, 10), dice.Wide(0.1, 1000), dice.Of(dice.Wide(1, 1e4), float.MaxValue),
        dice.Of(0, dice.Wide(1, 1e4), float.MaxValue), dice.Whole(1, 20), dice.Of(Yard.UsualDt, 1 / 30f, 1 / 120f),
        dice.Of(0, dice.Between(0, 5)), (uint)dice.Whole(1, 100000)));

    private static Variation Drive(Setup s) => new(
        FormattableString.Invariant(
            $"{s.Bodies} bodies of {s.First} and {s.Others} kg, {s.Force} N, {s.Torque} N m, iterations {s.Iterations}, ")
            + FormattableString.Invariant($"1/{1 / s.Dt:F0} s, speeds to {s.Speed} m/s, seed {s.Seed}"),
        Limit,
        () => Play(s));

    private static double Play(Setup s)
    {
        using var yard = new Yard(Yard.UsualDepth, gravity: 0, iterations: s.Iterations, dt: s.Dt);
        var dice = new Dice(s.Seed, "motors");
        var bodies = new List<Body>();
        for (int i = 0; i < s.Bodies; i++)
        {
            float mass = i == 0 ? s.First : s.Others;
            Body body = yard.Loose(new Vector2(2 * i, dice.Between(-0.5, 0.5)), mass, mass * dice.Wide(0.02, 2));
            body.LinearVelocity = s.Speed * new Vector2(dice.Between(-1, 1), dice.Between(-1, 1));
            body.AngularVelocity = s.Speed * dice.Between(-1, 1);
            bodies.Add(body);
        }

        for (int i = 1; i < s.Bodies; i++)
        {
            var joint = new MotorJoint(bodies[i - 1], bodies[i]) { MaxForce = s.Force, MaxTorque = s.Torque };
            joint.Offset += new Vector2(dice.Between(-1, 1), dice.Between(-1, 1));
            joint.TargetAngle += dice.Between(-2, 2);
            yard.Simulator.Add(joint);
        }

        var ledger = new MomentumLedger(bodies);
        yard.Steps(Steps, after: ledger.Look);
        return yard.Figure(ledger.Made);
    }

    private sealed record Setup(
        int Bodies, float First, float Others, float Force, float Torque, int Iterations, float Dt, float Speed, uint Seed);
}
