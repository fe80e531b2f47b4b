using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>A pyramid twice, once with sleep allowed: exact is that it ends where the other does.</summary>
internal static class Sleep
{
    private const double Seconds = 10;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S27_sleep_pyramid", "boxes in the lowest row", new(1, 54, WholeNumber: true), ["5", "10"],
            ["max_pos_difference_mm", "max_speed_end_with_sleep_mmps", "asleep"], Pyramid),
    ];

    private static void Pyramid(Trial trial)
    {
        int n = (int)trial.Parameter;
        trial.World(awake => trial.World(asleep =>
        {
            asleep.Simulator.AllowSleep = true;
            Build(awake, n);
            Build(asleep, n);
            double most = 0;
            for (int step = awake.StepsIn(Seconds); step > 0; step--)
            {
                awake.Step();
                asleep.Step();
                for (int i = 0; i < awake.Actors.Count; i++)
                {
                    most = Math.Max(most, (awake.Actors[i].Position - asleep.Actors[i].Position).Length);
                }
            }

            trial.Record("max_pos_difference_mm", 1000 * most);
            double speed = 0;
            foreach (Actor actor in asleep.Actors)
            {
                speed = Math.Max(speed, actor.Body.LinearVelocity.Length());
            }

            trial.Record("max_speed_end_with_sleep_mmps", 1000 * speed);
            trial.Record("asleep", asleep.Simulator.SleepingBodyCount);
        }));
    }

    private static void Build(Rig rig, int n)
    {
        rig.AddGround();
        for (int row = 0; row < n; row++)
        {
            for (int i = 0; i < n - row; i++)
            {
                rig.AddBox((i - (0.5 * (n - row - 1))) * 1.1, 0.5 + row, 1, 1);
            }
        }
    }
}
