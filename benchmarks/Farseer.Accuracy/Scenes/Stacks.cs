using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>Boxes on boxes: exact is that nothing moves. Heights, drifts and penetration are read at the end of the run.</summary>
internal static class Stacks
{
    private const double Seconds = 10;

    private static readonly string[] StackMetrics =
    [
        "height_error_pct_of_box", "lateral_drift_pct_of_box", "tilt_deg", "rms_speed_box_per_s_e-3", "max_penetration_pct", "stood",
    ];

    private static readonly string[] ColumnMetrics = ["height_error_mm", "max_penetration_mm", "rms_speed_mmps", "stood"];

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S15_stack", "boxes", new(1, 1000, WholeNumber: true), ["10", "20", "40"], StackMetrics,
            trial => Stack(trial, (int)trial.Parameter, 1, 0, density: 1)),
        new("S16_pyramid", "boxes in the lowest row", new(1, 54, WholeNumber: true), ["10", "20"],
            ["max_displacement_mm", "top_height_error_mm", "rms_speed_mmps", "max_penetration_mm"], Pyramid),
        new("S17_mass_ratio", "mass ratio", new(1e-6, 1e6), ["10", "100", "1000", "10000"], ColumnMetrics,
            trial => Column(trial, [1, trial.Parameter])),
        new("S17b_mass_column", "mass ratio of top to bottom", new(1e-6, 1e6), ["10", "100", "1000"], ColumnMetrics, MassColumn),
        new("S22_far_stack", "distance, m", new(-2e7, 2e7), ["0", "1000", "10000", "100000", "1e6"], StackMetrics,
            trial => Stack(trial, 10, 1, trial.Parameter, density: 1)),
        new("S23_size", "size of a box, m", new(1e-6, 1e5), ["0.001", "0.01", "0.1", "1", "10", "100", "1000"], StackMetrics,
            trial => Stack(trial, 5, trial.Parameter, 0, density: 1 / (trial.Parameter * trial.Parameter))),
    ];

    private static void Stack(Trial trial, int n, double size, double offset, double density) => trial.World(
        rig =>
        {
            rig.AddStaticBox(offset, offset - (0.5 * size), 40 * size, size);
            var boxes = new List<Actor>();
            for (int i = 0; i < n; i++)
            {
                boxes.Add(rig.AddBox(offset, offset + ((0.5 + i) * size), size, size, density: density));
            }

            double rms = Metrics.RunForRmsSpeed(rig, Seconds);
            double drift = 0;
            double drop = 0;
            double tilt = 0;
            foreach (Actor box in boxes)
            {
                drift = Math.Max(drift, Math.Abs(box.Displacement.X));
                drop = Math.Max(drop, Math.Abs(box.Displacement.Y));
                tilt = Math.Max(tilt, Math.Abs(box.Turn));
            }

            bool stood = drift <= 0.5 * size && drop <= 0.5 * size * Math.Max(1, n / 10.0);
            trial.Record("height_error_pct_of_box", 100 * Math.Abs(boxes[^1].Displacement.Y) / size);
            trial.Record("lateral_drift_pct_of_box", 100 * drift / size);
            trial.Record("tilt_deg", tilt * 180 / Math.PI);
            trial.Record("rms_speed_box_per_s_e-3", 1000 * rms / size);
            trial.Record("max_penetration_pct", 100 * Metrics.Penetration(rig.Actors) / size);
            trial.Record("stood", stood ? 1 : 0);
        });

    private static void Pyramid(Trial trial) => trial.World(rig =>
    {
        int n = (int)trial.Parameter;
        rig.AddGround();
        Actor top = rig.Actors[0];
        for (int row = 0; row < n; row++)
        {
            int count = n - row;
            for (int i = 0; i < count; i++)
            {
                top = rig.AddBox((i - (0.5 * (count - 1))) * 1.1, 0.5 + row, 1, 1);
            }
        }

        double rms = Metrics.RunForRmsSpeed(rig, Seconds);
        trial.Record("max_displacement_mm", 1000 * Metrics.LargestDisplacement(rig.Actors));
        trial.Record("top_height_error_mm", 1000 * Math.Abs(top.Displacement.Y));
        trial.Record("rms_speed_mmps", 1000 * rms);
        trial.Record("max_penetration_mm", 1000 * Metrics.Penetration(rig.Actors));
    });

    private static void MassColumn(Trial trial)
    {
        var densities = new double[5];
        for (int i = 0; i < densities.Length; i++)
        {
            densities[i] = Math.Pow(trial.Parameter, i / 4.0);
        }

        Column(trial, densities);
    }

    private static void Column(Trial trial, double[] densities) => trial.World(rig =>
    {
        rig.AddGround();
        Actor top = rig.Actors[0];
        for (int i = 0; i < densities.Length; i++)
        {
            top = rig.AddBox(0, 0.5 + i, 1, 1, density: densities[i]);
        }

        double rms = Metrics.RunForRmsSpeed(rig, Seconds);
        bool stood = true;
        foreach (Actor actor in rig.Actors)
        {
            stood &= Math.Abs(actor.Displacement.X) <= 0.5 && Math.Abs(actor.Displacement.Y) <= 0.5;
        }

        trial.Record("height_error_mm", 1000 * Math.Abs(top.Displacement.Y));
        trial.Record("max_penetration_mm", 1000 * Metrics.Penetration(rig.Actors));
        trial.Record("rms_speed_mmps", 1000 * rms);
        trial.Record("stood", stood ? 1 : 0);
    });
}
