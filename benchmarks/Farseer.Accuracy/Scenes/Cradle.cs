using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>Newton's cradle: balls that touch, each hung by a hinge.</summary>
internal static class Cradle
{
    private const double Length = 5;
    private const double Gravity = 10;
    private const double Raised = Math.PI / 4;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S10b_cradle", "balls", new(2, 50, WholeNumber: true), ["5"],
            ["last_ball_speed_rel_error", "energy_rel_change_20s"], trial => Swing(trial, 0.6, pinned: false)),
        new("S10c_smooth_cradle", "balls, which do not rub", new(2, 50, WholeNumber: true), ["5"],
            ["last_ball_speed_rel_error", "energy_rel_change_20s"], trial => Swing(trial, 0, pinned: false)),
        new("S10d_pinned_cradle", "balls, each on a rod that ends in a pin", new(2, 50, WholeNumber: true), ["5"],
            ["last_ball_speed_rel_error", "energy_rel_change_20s"], trial => Swing(trial, 0.6, pinned: true)),
    ];

    // Fixed to their rods the balls turn as they swing, and rub: each impact takes the share friction·radius/length of the turn. On pins
    // they do not turn, and there is nothing that rubs.
    private static void Swing(Trial trial, double friction, bool pinned) => trial.World(
        rig =>
        {
            int n = (int)trial.Parameter;
            rig.Restitution = 1;
            rig.Friction = friction;
            var balls = new List<Actor>();
            for (int i = 0; i < n; i++)
            {
                // The first ball is moved on its arc and turned with it.
                double angle = i == 0 ? -Raised : 0;
                Vec pivot = new(i, Length);
                Vec place = pivot + new Vec(0, -Length).Turned(angle);
                Actor ball = rig.AddCircle(place.X, place.Y, 0.5, angle: angle);
                Actor anchor = rig.AddAnchor(pivot.X, pivot.Y);
                if (pinned)
                {
                    rig.AddRod(anchor, ball, Length);
                }
                else
                {
                    rig.AddHinge(anchor, ball, pivot);
                }

                balls.Add(ball);
            }

            double start = Energy(balls);
            double fastest = 0;
            rig.Run(2.5, () => fastest = Math.Max(fastest, balls[^1].Velocity.X));
            rig.Run(17.5);
            double sum = 0;
            int samples = 0;
            rig.Run(2, () =>
            {
                sum += Energy(balls);
                samples++;
            });
            double exact = Math.Sqrt(2 * Gravity * Length * (1 - Math.Cos(Raised)));
            trial.Record("last_ball_speed_rel_error", Math.Abs((fastest / exact) - 1));
            trial.Record("energy_rel_change_20s", (sum / samples / start) - 1);
        },
        gravity: Gravity);

    /// <summary>Of the centres alone, above the lowest place.</summary>
    private static double Energy(List<Actor> balls)
    {
        double sum = 0;
        foreach (Actor ball in balls)
        {
            sum += ball.Mass * ((0.5 * Vec.Dot(ball.Velocity, ball.Velocity)) + (Gravity * ball.Position.Y));
        }

        return sum;
    }
}
