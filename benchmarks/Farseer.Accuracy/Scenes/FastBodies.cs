using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>Bodies that cross a thin wall within a step or sweep through it by turning.</summary>
internal static class FastBodies
{
    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S20_tunnel", "speed, m/s", new(1, 1e6), ["10", "100", "1000", "10000"], ["tunnelled_frac", "free_travel_frac"], Tunnel),
        new(
            "S20b_tunnel_bullet",
            "speed, m/s",
            new(1, 1e6),
            ["10", "100", "1000", "10000"],
            ["tunnelled_frac", "momentum_rel_error_max"],
            Bullet),
        new("S21_spinner", "rad/s", new(0, 1000), ["20", "60"], ["tunnelled_frac", "ke_gain_max_frac", "max_penetration_mm"], Spinner),
    ];

    private static void Tunnel(Trial trial)
    {
        const int Starts = 20;
        int through = 0;
        for (int run = 0; run < 2 * Starts; run++)
        {
            Fly(trial, isCircle: run < Starts, run % Starts, ref through);
        }

        trial.Record("tunnelled_frac", through / (2.0 * Starts));
        trial.World(
            rig =>
            {
                Actor ball = rig.AddCircle(-5, 0, 0.1);
                ball.Velocity = new Vec(trial.Parameter, 0);
                rig.RunSteps(6);
                trial.Record("free_travel_frac", ball.Displacement.X / (trial.Parameter * rig.Time));
            },
            gravity: 0);
    }

    private static void Fly(Trial trial, bool isCircle, int start, ref int through)
    {
        bool crossed = false;
        trial.World(
            rig =>
            {
                double travel = trial.Parameter * rig.Dt;
                double x = -5 - (travel * start / 20);
                rig.Friction = 0;
                rig.AddStaticBox(0, 0, 0.02, 10);
                Actor shot = isCircle ? rig.AddCircle(x, 0, 0.1) : rig.AddBox(x, 0, 0.2, 0.2);
                shot.Velocity = new Vec(trial.Parameter, 0);
                rig.RunSteps((int)Math.Ceiling((10 + travel) / travel) + 60);
                crossed = shot.Position.X >= 0.05;
            },
            gravity: 0);
        if (crossed)
        {
            through++;
        }
    }

    /// <summary>A ball against a wall that moves: the pair keeps its momentum, and the ball stays on its side of the wall.</summary>
    private static void Bullet(Trial trial)
    {
        const int Starts = 20;
        int through = 0;
        double worst = 0;
        for (int j = 0; j < Starts; j++)
        {
            trial.World(
                rig =>
                {
                    double travel = trial.Parameter * rig.Dt;
                    rig.Friction = 0;
                    Actor wall = rig.AddBox(0, 0, 0.02, 2, density: 1000);
                    Actor shot = rig.AddCircle(-5 - (travel * j / Starts), 0, 0.1);
                    shot.Body.IsBullet = true;
                    shot.Velocity = new Vec(trial.Parameter, 0);
                    double momentum = shot.Mass * shot.Velocity.X;
                    rig.RunSteps((int)Math.Ceiling((8 + travel) / travel) + 2);
                    double now = (shot.Mass * shot.Velocity.X) + (wall.Mass * wall.Velocity.X);
                    worst = Math.Max(worst, Math.Abs((now / momentum) - 1));
                    through += shot.Position.X > wall.Position.X ? 1 : 0;
                },
                gravity: 0);
        }

        trial.Record("tunnelled_frac", through / (double)Starts);
        trial.Record("momentum_rel_error_max", worst);
    }

    private static void Spinner(Trial trial)
    {
        const int Starts = 8;
        int through = 0;
        double gain = 0;
        double depth = 0;
        for (int j = 0; j < Starts; j++)
        {
            double angle = j * Math.PI / 8;
            trial.World(
                rig =>
                {
                    rig.Friction = 0;
                    rig.AddStaticBox(0.1, 0, 0.2, 10);
                    Actor rod = rig.AddBox(-1.3, 0, 0.1, 2, angle);
                    rod.Velocity = new Vec(5, 0);
                    rod.Spin = trial.Parameter;
                    double startEnergy = rod.KineticEnergy;
                    rig.Run(2, () =>
                    {
                        gain = Math.Max(gain, (rod.KineticEnergy / startEnergy) - 1);
                        depth = Math.Max(depth, Metrics.Penetration(rig.Actors));
                    });

                    // Beyond the middle of the wall: it can only leave on the far side.
                    through += rod.Position.X > 0.1 ? 1 : 0;
                },
                gravity: 0);
        }

        trial.Record("tunnelled_frac", through / (double)Starts);
        trial.Record("ke_gain_max_frac", gain);
        trial.Record("max_penetration_mm", 1000 * depth);
    }
}
