using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Accuracy.Scenes;

/// <summary>Slides, gears and motors against closed forms.</summary>
internal static class Mechanisms
{
    private const double Gravity = 10;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S25_prismatic_load", "density of the far half", new(0.01, 1e5), ["10", "100"],
            ["perp_error_mm", "angle_error_deg", "axial_drift_mm"], PrismaticLoad),
        new("S25b_prismatic_slide", "slope, degrees", new(0, 90), ["30"], ["dist_rel_error", "perp_error_mm"], PrismaticSlide),
        new("S25c_gear", "ratio", new(0.01, 100), ["2"], ["gear_angle_error_max_deg", "shared_speed_rel_error"], Gear),
        new("S26_motor", "torque limit, Nm", new(1e-3, 1e6), ["1"], ["omega_rel_error", "lift_threshold_rel_error"], Motor),
    ];

    private static void PrismaticLoad(Trial trial) => trial.World(rig =>
    {
        double far = trial.Parameter;
        double mass = 1 + far;
        double centre = 3 * far / mass;
        double inertia = (mass / 6) + (centre * centre) + (far * (3 - centre) * (3 - centre));
        Actor anchor = rig.AddAnchor(0, 0);
        Actor body = rig.AddLoose(new Vec(centre, 0), mass, inertia);
        rig.AddSlide(anchor, body, new Vec(0, 0), new Vec(1, 0));
        double across = 0;
        double angle = 0;
        rig.Run(5, () =>
        {
            Vec at = body.Position + new Vec(-centre, 0).Turned(body.Angle);
            across = Math.Max(across, Math.Abs(at.Y));
            angle = Math.Max(angle, Math.Abs(body.Angle));
        });
        trial.Record("perp_error_mm", 1000 * across);
        trial.Record("angle_error_deg", angle * 180 / Math.PI);
        trial.Record("axial_drift_mm", 1000 * Math.Abs(body.Displacement.X));
    });

    private static void PrismaticSlide(Trial trial) => trial.World(rig =>
    {
        double slope = trial.Parameter * Math.PI / 180;
        Vec axis = new(Math.Cos(slope), -Math.Sin(slope));
        Actor anchor = rig.AddAnchor(0, 0);
        Actor box = rig.AddLooseBox(new Vec(0, 0), 1, 1, 0, 1);
        rig.AddSlide(anchor, box, new Vec(0, 0), axis);
        double across = 0;
        rig.Run(3, () => across = Math.Max(across, Math.Abs(Vec.Cross(axis, box.Position))));
        double exact = 0.5 * Gravity * Math.Sin(slope) * rig.Time * rig.Time;
        trial.Record("dist_rel_error", Math.Abs((box.Position.Length / exact) - 1));
        trial.Record("perp_error_mm", 1000 * across);
    });

    private static void Gear(Trial trial) => trial.World(
        rig =>
        {
            // As the joint receives it.
            double ratio = (float)trial.Parameter;
            Actor anchor = rig.AddAnchor(0, 0);
            Actor a = rig.AddLoose(new Vec(-2, 0), Math.PI, 0.5 * Math.PI);
            Actor b = rig.AddLoose(new Vec(2, 0), 0.25 * Math.PI, 0.125 * 0.25 * Math.PI);
            rig.AddHinge(anchor, a, new Vec(-2, 0));
            rig.AddHinge(anchor, b, new Vec(2, 0));
            rig.AddGear(b, a, ratio);
            b.Spin = 10;
            double worst = 0;
            rig.Run(20, () => worst = Math.Max(worst, Math.Abs(a.Angle + (ratio * b.Angle))));
            double shared = b.Inertia * 10 / (b.Inertia + (a.Inertia * ratio * ratio));
            trial.Record("gear_angle_error_max_deg", worst * 180 / Math.PI);
            trial.Record("shared_speed_rel_error", Math.Abs((b.Spin / shared) - 1));
        },
        gravity: 0);

    private static void Motor(Trial trial)
    {
        trial.World(
            rig =>
            {
                Actor anchor = rig.AddAnchor(0, 0);
                Actor disc = rig.AddLoose(new Vec(0, 0), 0.25 * Math.PI, 0.125 * 0.25 * Math.PI);
                Drive(rig.AddHinge(anchor, disc, new Vec(0, 0)), 1000, trial.Parameter);
                rig.Run(1);
                double exact = trial.Parameter * rig.Time / disc.Inertia;
                trial.Record("omega_rel_error", Math.Abs((disc.Spin / Math.Min(exact, 1000)) - 1));
            },
            gravity: 0);
        double low = 0.9;
        double high = 1.1;
        for (int i = 0; i < 14; i++)
        {
            double middle = (low + high) / 2;
            bool lifts = false;
            trial.World(rig =>
            {
                Actor anchor = rig.AddAnchor(0, 0);
                Actor arm = rig.AddLooseBox(new Vec(1, 0), 2, 0.1, 0, 1);
                Drive(rig.AddHinge(anchor, arm, new Vec(0, 0)), 1, middle * 10);
                rig.Run(0.2);
                lifts = arm.Spin > 0;
            });
            (low, high) = lifts ? (low, middle) : (middle, high);
        }

        trial.Record("lift_threshold_rel_error", Math.Abs(((low + high) / 2) - 1));
    }

    private static void Drive(RevoluteJoint joint, double speed, double torque)
    {
        joint.IsMotorEnabled = true;
        joint.MotorSpeed = (float)speed;
        joint.MaxMotorTorque = (float)torque;
    }
}
