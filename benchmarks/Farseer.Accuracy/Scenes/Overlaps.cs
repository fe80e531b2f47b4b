using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>Bodies that begin inside one another: they must come out without being thrown.</summary>
internal static class Overlaps
{
    private const double Seconds = 10;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S19_overlap", "depth, m", new(0, 0.9), ["0.1", "0.5"], ["max_exit_speed_mps", "pop_height_mm", "recovery_time_s"], Single),
        new("S19b_overlap_stack", "share of a box", new(0, 0.9), ["0.25", "0.5"],
            ["max_speed_mps", "top_overshoot_m", "max_lateral_m", "end_penetration_mm"], Stack),
    ];

    private static void Single(Trial trial) => trial.World(rig =>
    {
        rig.AddGround();
        Actor box = rig.AddBox(0, 0.5 - trial.Parameter, 1, 1);
        double speed = 0;
        double highest = box.Position.Y;

        // A box that never comes up is given the whole run.
        double recovered = Seconds;
        rig.Run(Seconds, () =>
        {
            speed = Math.Max(speed, box.Velocity.Y);
            highest = Math.Max(highest, box.Position.Y);
            if (box.Position.Y > 0.49)
            {
                recovered = Math.Min(recovered, rig.Time);
            }
        });
        trial.Record("max_exit_speed_mps", speed);
        trial.Record("pop_height_mm", 1000 * Math.Max(0, highest - 0.5));
        trial.Record("recovery_time_s", recovered);
    });

    private static void Stack(Trial trial) => trial.World(rig =>
    {
        const int Boxes = 10;
        rig.AddGround();
        var boxes = new List<Actor>();
        for (int i = 0; i < Boxes; i++)
        {
            boxes.Add(rig.AddBox(0, 0.5 + (i * (1 - trial.Parameter)), 1, 1));
        }

        double speed = 0;
        double highest = 0;
        double lateral = 0;
        rig.Run(Seconds, () =>
        {
            foreach (Actor box in boxes)
            {
                speed = Math.Max(speed, box.Velocity.Length);
                highest = Math.Max(highest, box.Position.Y);
                lateral = Math.Max(lateral, Math.Abs(box.Position.X));
            }
        });
        trial.Record("max_speed_mps", speed);
        trial.Record("top_overshoot_m", Math.Max(0, highest - (Boxes - 0.5)));
        trial.Record("max_lateral_m", lateral);
        trial.Record("end_penetration_mm", 1000 * Metrics.Penetration(rig.Actors));
    });
}
