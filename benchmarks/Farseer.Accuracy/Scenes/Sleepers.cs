using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>Sleep must not move anything: the same pile with and without it.</summary>
internal static class Sleepers
{
    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S27_sleep_pyramid", "boxes in the lowest row", new(1, 54, WholeNumber: true), ["10"],
            ["max_pos_difference_mm", "max_speed_end_with_sleep_mmps", "asleep_frac"], Pyramid),
    ];

    private static void Pyramid(Trial trial)
    {
        var places = new List<Vec>();
        double difference = 0;
        double fastest = 0;
        double asleep = 0;
        foreach (bool sleeps in new[] { false, true })
        {
            trial.World(rig =>
            {
                rig.Simulator.AllowSleep = sleeps;
                rig.AddGround();
                int n = (int)trial.Parameter;
                for (int row = 0; row < n; row++)
                {
                    for (int i = 0; i < n - row; i++)
                    {
                        rig.AddBox((i - (0.5 * (n - row - 1))) * 1.1, 0.5 + row, 1, 1);
                    }
                }

                rig.Run(10);
                for (int i = 0; i < rig.Actors.Count; i++)
                {
                    if (!sleeps)
                    {
                        places.Add(rig.Actors[i].Position);
                        continue;
                    }

                    difference = Math.Max(difference, (rig.Actors[i].Position - places[i]).Length);
                    fastest = Math.Max(fastest, rig.Actors[i].Velocity.Length);
                }

                asleep = rig.Simulator.SleepingBodyCount / (rig.Actors.Count - 1.0);
            });
        }

        trial.Record("max_pos_difference_mm", 1000 * difference);
        trial.Record("max_speed_end_with_sleep_mmps", 1000 * fastest);
        trial.Record("asleep_frac", asleep);
    }
}
