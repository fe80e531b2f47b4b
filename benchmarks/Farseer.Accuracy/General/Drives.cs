using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Accuracy.General;

/// <summary>
/// Joints that push or pull by a law: along a line or about an axis from rest, against closed forms; and swinging, against
/// their equations of motion solved in steps so small that these do not matter.
/// </summary>
internal static class Drives
{
    private const double Gravity = 10;

    /// <summary>The dial of the swings, at which what is left after a doubling is still far above the rounding of floats.</summary>
    private const double SwingDt = 1.0 / 30;
    private const int SwingIterations = 5;

    /// <summary>Four, as an error of second order falls, less a share for its higher terms.</summary>
    private const double Quartered = 3.6;

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new(
            "G22",
            "way after 1 s: Atwood on a pulley, motors of joints, rope that snaps taut, falls on slack joints; error by each doubling of "
                + "Iterations",
            [
                new("slack_way_rel_error", 1e-5),
                new("pulley_way_rel_error", 1e-5), new("motor_way_rel_error", 1e-5), new("rope_way_rel_error", 1e-5),
                new("pulley_factor_per_doubling", Quartered, AtLeast: true), new("motor_factor_per_doubling", Quartered, AtLeast: true),
                new("rope_factor_per_doubling", Quartered, AtLeast: true),
            ],
            Ways),
    ];

    private enum Drive
    {
        Hinge,
        Slide,
        Wheel,
        Offset,
        Angle,
    }

    private enum Slack
    {
        Pulley,
        Rope,
        Slider,
        Angle,
    }

    private static void Ways(GeneralRun run)
    {
        foreach (double ratio in new[] { 0.5, 1, 2 })
        {
            Pulley(run, ratio, 1, 3);
            Pulley(run, ratio, 3, 1);
        }

        foreach (Drive drive in Enum.GetValues<Drive>())
        {
            Motor(run, drive, 1, 1);
        }

        Rope(run, 1, 1, 2);
        for (int i = 0; i < 15; i++)
        {
            Pulley(run, run.Dice.Scale(0.25, 4), run.Dice.Scale(0.2, 5), run.Dice.Scale(0.2, 5));
            foreach (Drive drive in Enum.GetValues<Drive>())
            {
                Motor(run, drive, run.Dice.Scale(0.1, 10), run.Dice.Scale(0.1, 10));
            }

            foreach (Slack slack in Enum.GetValues<Slack>())
            {
                Fall(run, slack, run.Dice.Scale(0.1, 10), run.Dice.Scale(0.1, 10));
            }

            Rope(run, run.Dice.Scale(0.1, 10), run.Dice.Scale(0.1, 10), run.Dice.Between(1, 5));
            SwingingPulley(run, run.Dice.Scale(0.5, 2), run.Dice.Scale(0.5, 2), run.Dice.Between(0.2, 0.8), run.Dice.Between(0.2, 0.8));
            MotorOnPendulum(run, run.Dice.Between(0.1, 0.9), run.Dice.Between(-1, 0));
            SwingingRope(run, run.Dice.Between(0.5, 1.4));
        }
    }

    private static void Pulley(GeneralRun run, double ratio, double first, double second)
    {
        // Pull of the rope T: first·a = first·g - T, second·b = second·g - ratio·T, a + ratio·b = 0, down is positive.
        double r = (float)ratio;
        double m1 = (float)first;
        double m2 = (float)second;
        double down = Gravity * r * ((r * m1) - m2) / (m2 + (r * r * m1));
        if (Math.Abs(down) < 0.1)
        {
            return;
        }

        string parameters = FormattableString.Invariant($"ratio {ratio:G4}, {first:G4} and {second:G4} kg");
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World(Gravity);
            Actor a = rig.AddLoose(new Vec(-2, -20), m1, 1);
            Actor b = rig.AddLoose(new Vec(2, -20), m2, 1);
            rig.Simulator.Add(new PulleyJoint(
                a.Body, new Vector2(-2, 0), Vector2.Zero, b.Body, new Vector2(2, 0), Vector2.Zero, (float)ratio));
            rig.Run(1);
            double exact = 0.5 * down * rig.Time * rig.Time;
            run.Note("pulley_way_rel_error", Math.Abs((-a.Displacement.Y / exact) - 1), parameters);
        });
    }

    /// <summary>A motor that never reaches its speed, from rest: half of its acceleration times the time squared.</summary>
    private static void Motor(GeneralRun run, Drive drive, double push, double resists)
    {
        string parameters = FormattableString.Invariant($"{drive}: {push:G4} N or N m on {resists:G4} kg or kg m2");
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World(gravity: 0);
            bool turns = drive is Drive.Hinge or Drive.Wheel or Drive.Angle;
            Actor anchor = rig.AddAnchor(0, 0);
            Actor driven = rig.AddLoose(new Vec(0, 0), turns ? 1 : resists, turns ? resists : 1);
            Add(rig, anchor, driven, drive, (float)push);
            rig.Run(1);
            double exact = 0.5 * (float)push / (float)resists * rig.Time * rig.Time;
            double way = turns ? driven.Angle : driven.Displacement.X;
            run.Note("motor_way_rel_error", Math.Abs((way / exact) - 1), parameters);
        });
    }

    private static void Add(Rig rig, Actor anchor, Actor driven, Drive drive, float push)
    {
        const float Fast = 1000;

        // So far that a tenth of it in a step is out of the motor's reach.
        const float Far = 1e5f;
        switch (drive)
        {
            case Drive.Hinge:
                RevoluteJoint hinge = rig.AddHinge(anchor, driven, new Vec(0, 0));
                hinge.IsMotorEnabled = true;
                hinge.MotorSpeed = Fast;
                hinge.MaxMotorTorque = push;
                break;
            case Drive.Slide:
                rig.Simulator.Add(new PrismaticJoint(anchor.Body, driven.Body, Vector2.Zero, Vector2.UnitX)
                {
                    IsMotorEnabled = true,
                    MotorSpeed = Fast,
                    MaxMotorForce = push,
                });
                break;
            case Drive.Wheel:
                rig.Simulator.Add(new WheelJoint(anchor.Body, driven.Body, Vector2.Zero, Vector2.UnitY)
                {
                    Frequency = 0,
                    IsMotorEnabled = true,
                    MotorSpeed = Fast,
                    MaxMotorTorque = push,
                });
                break;
            case Drive.Offset:
                rig.Simulator.Add(new MotorJoint(anchor.Body, driven.Body) { MaxForce = push, Offset = new Vector2(Far, 0) });
                break;
            default:
                rig.Simulator.Add(new MotorJoint(anchor.Body, driven.Body) { MaxTorque = push, TargetAngle = Far });
                break;
        }
    }

    /// <summary>Two bodies fall side by side, and the joint between them has nothing to do.</summary>
    private static void Fall(GeneralRun run, Slack slack, double first, double second)
    {
        string parameters = FormattableString.Invariant($"slack {slack} between {first:G4} and {second:G4} kg");
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World(Gravity);
            Actor a = rig.AddLoose(new Vec(-2, 0), first, 1);
            Actor b = rig.AddLoose(new Vec(2, 0), second, 1);
            rig.Simulator.Add(slack switch
            {
                Slack.Pulley => new PulleyJoint(
                    a.Body, new Vector2(-2, 5), Vector2.Zero, b.Body, new Vector2(2, 5), Vector2.Zero) { TotalLength = 100 },
                Slack.Rope => new RopeJoint(a.Body, Vector2.Zero, b.Body, Vector2.Zero, 5),
                Slack.Slider => new SliderJoint(a.Body, Vector2.Zero, b.Body, Vector2.Zero, 3, 5),
                _ => (Joint)new AngleLimitJoint(a.Body, b.Body, -1, 1),
            });
            rig.Run(1);
            double exact = 0.5 * Gravity * rig.Time * rig.Time;
            run.Note("slack_way_rel_error", Math.Abs((-a.Displacement.Y / exact) - 1), parameters);
        });
    }

    /// <summary>A body flies off and takes another with it, without bouncing back, once the rope between them is taut.</summary>
    private static void Rope(GeneralRun run, double waiting, double flying, double speed)
    {
        const double Slack = 0.5;
        string parameters = FormattableString.Invariant($"{flying:G4} kg at {speed:G4} m/s takes {waiting:G4} kg");
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World(gravity: 0);
            Actor a = rig.AddLoose(new Vec(0, 0), waiting, 1);
            Actor b = rig.AddLoose(new Vec(0.5, 0), flying, 1);
            b.Velocity = new Vec(speed, 0);
            double start = b.Velocity.X;
            rig.Simulator.Add(new RopeJoint(a.Body, Vector2.Zero, b.Body, Vector2.Zero, (float)(0.5 + Slack)));
            rig.Run(1);
            double taut = Slack / start;
            double shared = (float)flying * start / ((float)flying + (float)waiting);
            double exact = Slack + (shared * (rig.Time - taut));
            run.Note("rope_way_rel_error", Math.Abs((b.Displacement.X / exact) - 1), parameters);
        });
    }

    /// <summary>Both weights of an Atwood machine swing.</summary>
    private static void SwingingPulley(GeneralRun run, double first, double second, double swing1, double swing2)
    {
        const double Side = 5;
        double m1 = (float)first;
        double m2 = (float)second;
        double v1 = (float)swing1;
        double v2 = (float)swing2;
        string parameters = FormattableString.Invariant($"swinging, {first:G4} kg at {swing1:G4} m/s, {second:G4} kg at {swing2:G4} m/s");
        NoteFactor(run, "pulley_factor_per_doubling", parameters, rig =>
        {
            Actor a = rig.AddLoose(new Vec(0, -Side), m1, 1);
            Actor b = rig.AddLoose(new Vec(4, -Side), m2, 1);
            a.Velocity = new Vec(v1, 0);
            b.Velocity = new Vec(v2, 0);
            rig.Simulator.Add(new PulleyJoint(a.Body, Vector2.Zero, Vector2.Zero, b.Body, new Vector2(4, 0), Vector2.Zero));

            // About their wheels: x1, y1, x2, y2 and the speeds of these.
            var motion = new Motion([0, -Side, 0, -Side, v1, 0, v2, 0], (s, rates) => RatesOfPulley(s, rates, m1, m2));
            return new Swing(motion, s => (a.Position - new Vec(s[0], s[1])).Length);
        });
    }

    /// <summary>
    /// With the directions n to the weights and the pull T: a = (0, -g) - T·n/m for each, and the lengths' accelerations
    /// a·n + (v² - (v·n)²)/l add up to 0.
    /// </summary>
    private static void RatesOfPulley(double[] s, double[] rates, double m1, double m2)
    {
        var x1 = new Vec(s[0], s[1]);
        var x2 = new Vec(s[2], s[3]);
        var v1 = new Vec(s[4], s[5]);
        var v2 = new Vec(s[6], s[7]);
        Vec n1 = 1 / x1.Length * x1;
        Vec n2 = 1 / x2.Length * x2;
        double free = Stretch(x1, n1, v1) + Stretch(x2, n2, v2);
        double pull = free / ((1 / m1) + (1 / m2));
        Vec a1 = new Vec(0, -Gravity) - (pull / m1 * n1);
        Vec a2 = new Vec(0, -Gravity) - (pull / m2 * n2);
        (rates[0], rates[1], rates[2], rates[3]) = (s[4], s[5], s[6], s[7]);
        (rates[4], rates[5], rates[6], rates[7]) = (a1.X, a1.Y, a2.X, a2.Y);

        static double Stretch(Vec x, Vec n, Vec v)
        {
            double along = Vec.Dot(v, n);
            return (-Gravity * n.Y) + ((Vec.Dot(v, v) - (along * along)) / x.Length);
        }
    }

    /// <summary>A rod of 1 m and 1 kg on a hinge whose motor gives a share of the torque that would hold it level.</summary>
    private static void MotorOnPendulum(GeneralRun run, double share, double angle)
    {
        const double Length = 1;
        double torque = (float)(share * 0.5 * Gravity * Length);
        double start = (float)angle;
        string parameters = FormattableString.Invariant($"motor of {torque:G4} N m on a rod at {angle:G4} rad");
        NoteFactor(run, "motor_factor_per_doubling", parameters, rig =>
        {
            Actor anchor = rig.AddAnchor(0, 0);
            Actor rod = rig.AddLooseBox(new Vec(0, -0.5 * Length).Turned(start), 0, Length, start, 1);
            RevoluteJoint hinge = rig.AddHinge(anchor, rod, new Vec(0, 0));
            hinge.IsMotorEnabled = true;
            hinge.MotorSpeed = 1000;
            hinge.MaxMotorTorque = (float)torque;
            var motion = new Motion([start, 0], (s, rates) =>
            {
                rates[0] = s[1];
                rates[1] = 3 * (torque - (0.5 * Gravity * Length * Math.Sin(s[0]))) / (Length * Length);
            });
            return new Swing(motion, s => Math.Abs(rod.Angle - s[0]));
        });
    }

    private static void SwingingRope(GeneralRun run, double angle)
    {
        const double Length = 1;
        string parameters = FormattableString.Invariant($"rope pendulum from {angle:G4} rad");
        NoteFactor(run, "rope_factor_per_doubling", parameters, rig =>
        {
            Actor anchor = rig.AddAnchor(0, 0);
            Actor bob = rig.AddLoose(new Vec(0, -Length).Turned(angle), 1, 0.1);
            rig.Simulator.Add(new RopeJoint(anchor.Body, Vector2.Zero, bob.Body, Vector2.Zero, (float)Length));
            var motion = new Motion([angle, 0], (s, rates) =>
            {
                rates[0] = s[1];
                rates[1] = -Gravity / Length * Math.Sin(s[0]);
            });
            return new Swing(motion, s => Math.Abs(Math.Atan2(bob.Position.X, -bob.Position.Y) - s[0]));
        });
    }

    /// <summary>
    /// By how much a doubling of the iterations divides the largest error within a second: at one moment it may be 0 by chance.
    /// </summary>
    private static void NoteFactor(GeneralRun run, string figure, string parameters, Func<Rig, Swing> build)
    {
        run.Sample(parameters, () => run.Note(figure, At(SwingIterations) / At(2 * SwingIterations), parameters));

        double At(int iterations)
        {
            using Rig rig = run.World(Gravity, run.Dial with { Iterations = iterations, Dt = SwingDt });
            Swing swing = build(rig);
            double worst = 0;
            rig.Run(1, () =>
            {
                swing.Motion.Go(rig.Dt);
                worst = Math.Max(worst, swing.Error(swing.Motion.State));
            });
            return worst;
        }
    }

    /// <summary>A world whose motion is known.</summary>
    /// <param name="Motion">How it moves.</param>
    /// <param name="Error">How far the world is from a state of that.</param>
    private sealed record Swing(Motion Motion, Func<double[], double> Error);
}
