using System;
using System.Collections.Generic;
using Farseer.CommandLines;

namespace Farseer.Accuracy.Scenes;

/// <summary>Restitution: bounces, pairs, a corner hit, a row of balls.</summary>
internal static class Impacts
{
    private const int Apexes = 5;

    /// <summary>Bounces lower than this are left out: the sampling of the apex would dominate.</summary>
    private const double LeastApex = 0.15;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S03_bounce", "restitution", new(0.1, 1), ["1", "0.8", "0.5"], ["apex1_rel_error", "apex_max_rel_error"], Bounce),
        new("S04_pair", "restitution + 10·lg of the mass ratio", new(0, 91), ["0", "0.5", "1", "11", "30.5", "31"],
            ["momentum_rel_error", "sep_speed_rel_error", "ke_rel_error"], Pair),
        new(
            "S04b_corner_hit",
            "restitution",
            new(0, 1),
            ["0", "0.5", "1"],
            ["vy_error_mps", "omega_error_radps", "ke_rel_error"],
            CornerHit),
        new("S10_newton_line", "balls at rest", new(1, 1000, WholeNumber: true), ["4"],
            ["velocity_l1_error", "momentum_rel_error", "ke_rel_error"], NewtonLine),
    ];

    /// <summary>Heights of the apexes above the ball's rest on the ground, in order, until enough are seen or 60 s are over.</summary>
    public static List<double> ApexHeights(Rig rig, double restitution, double offset, int wanted)
    {
        rig.Friction = 0;
        rig.Restitution = restitution;
        rig.AddStaticBox(offset, offset - 0.5, 60, 1);
        Actor ball = rig.AddCircle(offset, offset + 10.5, 0.5);
        var heights = new List<double>();
        bool rising = false;
        double highest = 0;
        int steps = rig.StepsIn(60);
        for (int i = 0; i < steps && heights.Count < wanted; i++)
        {
            rig.Step();
            double height = ball.Position.Y - offset - 0.5;
            if (ball.Velocity.Y > 0)
            {
                highest = rising ? Math.Max(highest, height) : height;
                rising = true;
            }
            else if (rising)
            {
                heights.Add(Math.Max(highest, height));
                rising = false;
            }
        }

        return heights;
    }

    public static double ApexError(List<double> heights, double restitution, int k)
    {
        double exact = 10 * Math.Pow(restitution, 2 * k);
        double height = k <= heights.Count ? heights[k - 1] : 0;
        return Math.Abs(height - exact) / exact;
    }

    private static void Bounce(Trial trial) => trial.World(rig =>
    {
        double e = trial.Parameter;
        List<double> heights = ApexHeights(rig, e, 0, Apexes);
        double worst = 0;
        for (int k = 1; k <= Apexes && 10 * Math.Pow(e, 2 * k) >= LeastApex; k++)
        {
            worst = Math.Max(worst, ApexError(heights, e, k));
        }

        trial.Record("apex1_rel_error", ApexError(heights, e, 1));
        trial.Record("apex_max_rel_error", worst);
    });

    private static void Pair(Trial trial) => trial.World(
        rig =>
        {
            double e = trial.Parameter % 10;
            if (e > 1)
            {
                throw new UsageException($"S04_pair: {trial.Parameter} has the restitution {e}; it must lie in 0..1.");
            }

            double ratio = Math.Pow(10, Math.Floor(trial.Parameter / 10));
            rig.Friction = 0;
            rig.Restitution = e;
            Actor a = rig.AddCircle(-2.03, 0, 0.5, mass: 1);
            Actor b = rig.AddCircle(0, 0, 0.5, mass: ratio);
            a.Velocity = new Vec(5, 0);
            rig.Run(1);
            double exactA = 5 * (1 - (e * ratio)) / (1 + ratio);
            double exactB = 5 * (1 + e) / (1 + ratio);
            double exactEnergy = 0.5 * ((exactA * exactA) + (ratio * exactB * exactB));
            trial.Record("momentum_rel_error", Math.Abs(a.Velocity.X + (ratio * b.Velocity.X) - 5) / 5);
            trial.Record("sep_speed_rel_error", Math.Abs(b.Velocity.X - a.Velocity.X - (5 * e)) / 5);
            trial.Record("ke_rel_error", Math.Abs(a.KineticEnergy + b.KineticEnergy - exactEnergy) / 12.5);
        },
        gravity: 0);

    private static void CornerHit(Trial trial) => trial.World(
        rig =>
        {
            double e = trial.Parameter;
            const double Angle = 0.35;
            rig.Friction = 0;
            rig.Restitution = e;
            rig.AddGround();
            Actor box = rig.AddBox(0, 2, 1, 1, Angle);
            box.Velocity = new Vec(0, -5);
            double startEnergy = box.KineticEnergy;
            int limit = rig.StepsIn(5);
            do
            {
                rig.Step();
            }
            while (box.Velocity.Y <= -4.9 && rig.Steps < limit);
            rig.Step();

            // The lowest corner of the turned box is the one at (-1/2, -1/2) of its own frame.
            double r = new Vec(-0.5, -0.5).Turned(Angle).X;
            double impulse = 5 * (1 + e) / ((1 / box.Mass) + (r * r / box.Inertia));
            double vy = -5 + (impulse / box.Mass);
            double omega = r * impulse / box.Inertia;
            double energy = 0.5 * ((box.Mass * vy * vy) + (box.Inertia * omega * omega));
            trial.Record("vy_error_mps", Math.Abs(box.Velocity.Y - vy));
            trial.Record("omega_error_radps", Math.Abs(box.Spin - omega));
            trial.Record("ke_rel_error", Math.Abs(box.KineticEnergy - energy) / startEnergy);
        },
        gravity: 0);

    private static void NewtonLine(Trial trial) => trial.World(
        rig =>
        {
            int n = (int)trial.Parameter;
            rig.Restitution = 1;
            var balls = new List<Actor> { rig.AddCircle(-2.51, 0, 0.5) };
            balls[0].Velocity = new Vec(5, 0);
            for (int i = 0; i < n; i++)
            {
                balls.Add(rig.AddCircle(i, 0, 0.5));
            }

            double startEnergy = balls[0].KineticEnergy;
            rig.Run(1.2);
            double error = 0;
            double momentum = 0;
            double energy = 0;
            for (int i = 0; i < balls.Count; i++)
            {
                Vec ideal = new(i == balls.Count - 1 ? 5 : 0, 0);
                error += (balls[i].Velocity - ideal).Length;
                momentum += balls[i].Velocity.X;
                energy += balls[i].KineticEnergy;
            }

            trial.Record("velocity_l1_error", error / 5);
            trial.Record("momentum_rel_error", Math.Abs(momentum - 5) / 5);
            trial.Record("ke_rel_error", Math.Abs(energy - startEnergy) / startEnergy);
        },
        gravity: 0);
}
