using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Extremes;

/// <summary>Steps, speeds, distances, stiffness.</summary>
internal static class MotionExtremes
{
    public static IReadOnlyList<Extreme> All { get; } =
    [
        new("long-step", "steps a second of a stack of 5, downwards", "stands for 10 s, sinks by less than 10 % of a box", 10,
            [60, 30, 15, 10, 5, 2, 1], rate => Stands(1 / rate, 10)),
        new("short-step", "steps a second of a stack of 5, upwards", "stands for 1 s, sinks by less than 1 % of a box", 1e4,
            [60, 240, 1e3, 1e4, 1e5], rate => Probe.World(
                rig =>
                {
                    List<Actor> boxes = Probe.Stack(rig, 5);
                    rig.Run(1);
                    return Probe.Stayed(boxes, 0.01);
                },
                dt: 1 / rate)),
        new("changing-step", "ratio of longest to shortest step, another in each step, stack of 5", "stands for 10 s, sinks by less than "
            + "10 % of a box", 10,
            [2, 4, 10, 30, 100, 1000], Changing),
        new("speed", "speed of a shot at a wall of 2 cm, m/s", "none of 40 goes through, free flight is exact", 1e4,
            [10, 100, 1e3, 1e4, 1e5], v => Probe.Figure("S20_tunnel", v, "tunnelled_frac") == 0
                && Math.Abs(Probe.Figure("S20_tunnel", v, "free_travel_frac") - 1) <= 1e-5),
        new("spin", "spin of a free box, rad/s", "angle after a minute within 10⁻⁴ rad, spin kept", 1e3,
            [
                10, 100, 1e3,
            ], w => Probe.Figure("S02_spin", w, "angle_error_rad") <= 1e-4 && Probe.Figure("S02_spin", w, "omega_rel_error") <= 1e-6),
        new("far", "distance of a stack of 10 from the origin, m", "sinks by at most 1.1 times what it does at the origin", 1e7,
            [1e3, 1e4, 1e5, 1e6, 1e7, 2e7], d =>
                Probe.Figure(
                    "S22_far_stack", d, "height_error_pct_of_box") <= 1.1 * Probe.Figure("S15_stack", 10, "height_error_pct_of_box")),
        new("frictionless", "seconds that a box slides without "
            + "friction", "keeps its speed within 10⁻⁶", 600, [1, 10, 60, 600], t => Probe.World(rig =>
        {
            rig.Friction = 0;
            rig.AddStaticBox(0, -0.5, 20000, 1);
            Actor box = rig.AddBox(-5000, 0.5, 1, 1);
            box.Velocity = new Vec(10, 0);
            rig.Run(t);
            return Math.Abs((box.Velocity.X / 10) - 1) <= 1e-6;
        })),
        new(
            "rough",
            "friction of a flat box on a slope at 95 % of what its friction holds",
            "creeps by less than 1 mm in 10 s",
            10,
            [0.1, 1, 10, 100, 1000],
            Rough),
        new(
            "elastic",
            "seconds that a ball bounces with restitution 1",
            "still reaches its height within 1 %",
            3600,
            [60, 600, 3600],
            Bounces),
        new("stiff-spring", "stiffness of a spring at a body of 1 kg, N/m", "swings no farther than it was pulled", 1e12,
            [1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14], Spring),
        new("stiff-pair", "stiffness of a spring between two bodies of 1 kg, N/m", "swings no farther than it was pulled", 1e12,
            [1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14], SpringPair),
    ];

    private static bool Stands(double dt, double seconds) => Probe.World(
        rig =>
        {
            List<Actor> boxes = Probe.Stack(rig, 5);
            rig.Run(seconds);
            return Probe.Stayed(boxes, 0.1);
        },
        dt: dt);

    private static bool Changing(double ratio) => Probe.World(rig =>
    {
        List<Actor> boxes = Probe.Stack(rig, 5);
        double time = 0;
        uint random = 1;
        while (time < 10)
        {
            random = unchecked((1664525u * random) + 1013904223u);
            double share = (random >> 8) / 16777216.0;
            double dt = Options.DefaultDt * Math.Pow(ratio, share - 0.5);
            rig.Step((float)dt);
            time += dt;
        }

        return Probe.Stayed(boxes, 0.1);
    });

    /// <summary>A box of 1 × 0.02: flat enough not to tip over on a slope of 89°.</summary>
    private static bool Rough(double friction) => Probe.World(rig =>
    {
        double slope = Math.Atan(0.95 * friction);
        rig.Friction = friction;
        rig.AddStaticBox(0, 0, 20, 1, slope);
        double half = 0.4 / Math.Max(1, friction) / 2;
        Vec place = new Vec(0, 0.5 + half).Turned(slope);
        Actor box = rig.AddBox(place.X, place.Y, 1, 2 * half, slope);
        rig.Run(10);
        return box.Displacement.Length <= 1e-3;
    });

    private static bool Bounces(double seconds) => Probe.World(rig =>
    {
        rig.Friction = 0;
        rig.Restitution = 1;
        rig.AddGround();
        Actor ball = rig.AddCircle(0, 10.5, 0.5);
        rig.Run(seconds);

        // Height of the next apex by the energy at this moment.
        double height = ball.Position.Y - 0.5 + (Vec.Dot(ball.Velocity, ball.Velocity) / 20);
        return Math.Abs((height / 10) - 1) <= 0.01;
    });

    private static bool Spring(double stiffness) => Probe.World(
        rig =>
        {
            Actor ball = rig.AddCircle(6, 0, 0.25, 1);
            rig.AddFixedSpring(ball, 5, stiffness, 0);
            double most = 0;
            rig.Run(10, () => most = Math.Max(most, Math.Abs(ball.Position.Length - 5)));
            return most <= 1.001;
        },
        gravity: 0);

    private static bool SpringPair(double stiffness) => Probe.World(
        rig =>
        {
            Actor a = rig.AddCircle(-3, 0, 0.25, 1);
            Actor b = rig.AddCircle(3, 0, 0.25, 1);
            rig.AddPairSpring(a, b, 5, stiffness);
            double most = 0;
            rig.Run(10, () => most = Math.Max(most, Math.Abs((a.Position - b.Position).Length - 5)));
            return most <= 1.001;
        },
        gravity: 0);
}
