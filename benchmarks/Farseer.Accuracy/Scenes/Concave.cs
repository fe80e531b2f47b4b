using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>U-shapes dropped between two walls; each is one concave outline.</summary>
internal static class Concave
{
    /// <summary>Centre of mass of the base and the two posts, below the middle of the outline: areas 0.25, 0.1875, 0.1875.</summary>
    private const double CentreY = ((0.25 * -0.375) + (2 * 0.1875 * 0.125)) / 0.625;

    private const int SampleEvery = 20;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S29_concave", "bodies", new(1, 200, WholeNumber: true), ["24"],
            ["max_penetration_end_mm", "max_penetration_peak_mm", "rms_speed_mmps", "escaped"], Pile),
    ];

    private static void Pile(Trial trial) => trial.World(
        rig =>
        {
            int n = (int)trial.Parameter;
            rig.Friction = 0.5;
            rig.AddGround();
            rig.AddStaticBox(-4.5, 10, 1, 20);
            rig.AddStaticBox(4.5, 10, 1, 20);
            Vec shift = new(0, -CentreY);
            Vec[] outline =
            [
                shift + new Vec(-0.5, -0.5), shift + new Vec(0.5, -0.5), shift + new Vec(0.5, 0.5), shift + new Vec(0.25, 0.5),
                shift + new Vec(0.25, -0.25), shift + new Vec(-0.25, -0.25), shift + new Vec(-0.25, 0.5), shift + new Vec(-0.5, 0.5),
            ];
            Vec[][] pieces =
            [
                Outlines.Box(1, 0.25, shift + new Vec(0, -0.375)),
                Outlines.Box(0.25, 0.75, shift + new Vec(-0.375, 0.125)),
                Outlines.Box(0.25, 0.75, shift + new Vec(0.375, 0.125)),
            ];
            var shapes = new List<Actor>();
            uint random = 12345;
            for (int i = 0; i < n; i++)
            {
                double x = -2.4 + (1.6 * (i % 4)) + (0.1 * Next(ref random));
                double y = 1.2 + (1.7 * (i / 4));
                shapes.Add(rig.AddPolygon(new Vec(x, y), 2 * Math.PI * Next(ref random), outline, pieces));
            }

            double peak = 0;
            double rms = Metrics.RunForRmsSpeed(rig, 15, () =>
            {
                if (rig.Steps % SampleEvery == 0)
                {
                    peak = Math.Max(peak, Metrics.Penetration(rig.Actors));
                }
            });
            double end = Metrics.Penetration(rig.Actors);
            int escaped = 0;
            foreach (Actor shape in shapes)
            {
                escaped += shape.Position.Y < -1 || Math.Abs(shape.Position.X) >= 5 ? 1 : 0;
            }

            trial.Record("max_penetration_end_mm", 1000 * end);
            trial.Record("max_penetration_peak_mm", 1000 * Math.Max(peak, end));
            trial.Record("rms_speed_mmps", 1000 * rms);
            trial.Record("escaped", escaped);
        });

    private static double Next(ref uint state)
    {
        state = unchecked((1664525u * state) + 1013904223u);
        return (state >> 8) / 16777216.0;
    }
}
