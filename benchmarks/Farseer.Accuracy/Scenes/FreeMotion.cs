using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>One body that touches nothing; the references are closed forms.</summary>
internal static class FreeMotion
{
    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S01_free_flight", "seconds of flight", new(0.1, 1000), ["10"], ["pos_error_m", "vel_error_mps"], FreeFlight),
        new("S01b_linear_drag", "damping rate, 1/s", new(0.001, 100), ["0.5", "2"], ["vel_rel_error", "dist_rel_error"], LinearDrag),
        new("S02_spin", "rad/s", new(0.001, 1000), ["10", "50"], ["angle_error_rad", "ke_rel_drift", "omega_rel_error"], Spin),
    ];

    private static void FreeFlight(Trial trial) => trial.World(rig =>
    {
        Actor ball = rig.AddCircle(0, 0, 0.5);
        ball.Velocity = new Vec(10, 15);
        ball.Spin = 3;
        rig.Run(trial.Parameter);
        double t = rig.Time;
        Vec exact = new(10 * t, (15 * t) - (5 * t * t));
        trial.Record("pos_error_m", (ball.Position - exact).Length);
        trial.Record("vel_error_mps", Math.Abs(ball.Velocity.Y - (15 - (10 * t))));
    });

    private static void LinearDrag(Trial trial) => trial.World(
        rig =>
        {
            double c = trial.Parameter;
            Actor ball = rig.AddCircle(0, 0, 0.5);
            ball.Velocity = new Vec(10, 0);
            ball.SetLinearDrag(c * ball.Mass);
            rig.Run(4);
            double decay = Math.Exp(-c * rig.Time);
            double distance = 10 / c * (1 - decay);
            trial.Record("vel_rel_error", Math.Abs(ball.Velocity.X - (10 * decay)) / (10 * decay));
            trial.Record("dist_rel_error", Math.Abs(ball.Position.X - distance) / distance);
        },
        gravity: 0);

    private static void Spin(Trial trial) => trial.World(
        rig =>
        {
            // As the body receives it.
            double omega = (float)trial.Parameter;
            Actor box = rig.AddBox(0, 0, 2, 0.2);
            box.Velocity = new Vec(3, 0);
            box.Spin = omega;
            double startEnergy = box.KineticEnergy;
            double angle = box.Angle;
            double last = angle;
            double expected = omega * rig.Dt;
            rig.Run(60, () =>
            {
                // Unwrapped around the expected increment: a spin of several turns a step is followed too.
                double now = box.Angle;
                angle += expected + Math.IEEERemainder(now - last - expected, 2 * Math.PI);
                last = now;
            });
            trial.Record("angle_error_rad", Math.Abs(angle - (omega * rig.Time)));
            trial.Record("ke_rel_drift", Math.Abs((box.KineticEnergy / startEnergy) - 1));
            trial.Record("omega_rel_error", Math.Abs(box.Spin - omega) / omega);
        },
        gravity: 0);
}
