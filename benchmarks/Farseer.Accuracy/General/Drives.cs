using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Accuracy.General;

/// <summary>Pulleys, motors and ropes that start from rest, against closed forms.</summary>
internal static class Drives
{
    private const double Gravity = 10;

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G22", "way after 1 s: Atwood on a pulley, motor on a wheel, rope that snaps taut",
            [new("pulley_way_rel_error", 1e-5), new("motor_way_rel_error", 1e-5), new("rope_way_rel_error", 1e-5)], Ways),
    ];

    private static void Ways(GeneralRun run)
    {
        foreach (double ratio in new[] { 0.5, 1, 2 })
        {
            Pulley(run, ratio, 1, 3);
            Pulley(run, ratio, 3, 1);
        }

        Motor(run, 1, 1);
        Rope(run, 1, 1, 2);
        for (int i = 0; i < 15; i++)
        {
            Pulley(run, run.Dice.Scale(0.25, 4), run.Dice.Scale(0.2, 5), run.Dice.Scale(0.2, 5));
            Motor(run, run.Dice.Scale(0.1, 10), run.Dice.Scale(0.1, 10));
            Rope(run, run.Dice.Scale(0.1, 10), run.Dice.Scale(0.1, 10), run.Dice.Between(1, 5));
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

    private static void Motor(GeneralRun run, double torque, double inertia)
    {
        string parameters = FormattableString.Invariant($"{torque:G4} N m on {inertia:G4} kg m2");
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World(gravity: 0);
            Actor anchor = rig.AddAnchor(0, 0);
            Actor wheel = rig.AddLoose(new Vec(0, 0), 1, inertia);
            RevoluteJoint joint = rig.AddHinge(anchor, wheel, new Vec(0, 0));
            joint.IsMotorEnabled = true;
            joint.MotorSpeed = 1000;
            joint.MaxMotorTorque = (float)torque;
            rig.Run(1);
            double exact = 0.5 * (float)torque / (float)inertia * rig.Time * rig.Time;
            run.Note("motor_way_rel_error", Math.Abs((wheel.Angle / exact) - 1), parameters);
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
}
