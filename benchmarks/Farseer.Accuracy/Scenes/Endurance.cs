using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>Things that ought to go on as they are for as long as one likes.</summary>
internal static class Endurance
{
    private const int SettlingSteps = 60;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S28_soak", "steps", new(600, 1e8, WholeNumber: true), ["10000", "100000", "1e6"],
            ["incline_creep_mm", "stack_top_drift_mm", "pendulum_energy_ratio"], Soak),
    ];

    private static void Soak(Trial trial) => trial.World(
        rig =>
        {
            const double Slope = 15 * Math.PI / 180;
            const double Start = 30 * Math.PI / 180;
            rig.AddGround();
            Actor top = rig.Actors[0];
            for (int i = 0; i < 5; i++)
            {
                top = rig.AddBox(0, 0.5 + i, 1, 1);
            }

            rig.AddStaticBox(20, 10, 20, 1, -Slope);
            Vec onSlope = new Vec(20, 10) + new Vec(0, 1).Turned(-Slope);
            Actor slider = rig.AddBox(onSlope.X, onSlope.Y, 1, 1, -Slope);
            Vec pivot = new(-20, 10);
            Vec middle = pivot + new Vec(0, -1).Turned(Start);
            Actor rod = rig.AddLooseBox(middle, 0.1, 2, Start, 0.2);
            rig.AddHinge(rig.AddAnchor(pivot.X, pivot.Y), rod, pivot);

            rig.RunSteps(SettlingSteps);
            Vec sliderStart = slider.Position;
            Vec topStart = top.Position;
            int steps = (int)trial.Parameter;
            int last = rig.StepsIn(5);
            rig.RunSteps(steps - last);
            double largest = 0;
            rig.RunSteps(last, () => largest = Math.Max(largest, Math.Abs(rod.Angle)));
            trial.Record("incline_creep_mm", 1000 * (slider.Position - sliderStart).Length);
            trial.Record("stack_top_drift_mm", 1000 * (top.Position - topStart).Length);
            trial.Record("pendulum_energy_ratio", (1 - Math.Cos(largest)) / (1 - Math.Cos(Start)));
        });
}
