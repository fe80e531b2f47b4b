using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>Structures that stand by friction alone: exact is that nothing moves.</summary>
internal static class Masonry
{
    private const double Seconds = 10;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S18_arch", "thickness, m", new(0.05, 4), ["1", "0.7", "0.4"],
            ["max_displacement_mm", "crown_drop_mm", "rms_speed_mmps", "stood"], Arch),
        new("S18b_cards", "lean, degrees", new(1, 40), ["20"], ["max_displacement_mm", "rms_speed_mmps", "stood"], Cards),
    ];

    private static void Arch(Trial trial) => trial.World(
        rig =>
        {
            const int Stones = 17;
            const double MeanRadius = 5.5;
            double inner = MeanRadius - (0.5 * trial.Parameter);
            double outer = MeanRadius + (0.5 * trial.Parameter);
            rig.AddGround();
            var stones = new List<Actor>();
            for (int i = 0; i < Stones; i++)
            {
                Vec from = new Vec(1, 0).Turned(Math.PI * i / Stones);
                Vec to = new Vec(1, 0).Turned(Math.PI * (i + 1) / Stones);
                Vec[] corners = [inner * from, outer * from, outer * to, inner * to];
                Vec centre = Outlines.Centroid(corners);
                for (int k = 0; k < corners.Length; k++)
                {
                    corners[k] -= centre;
                }

                stones.Add(rig.AddPolygon(centre, 0, corners, [corners]));
            }

            double rms = Metrics.RunForRmsSpeed(rig, Seconds);
            double displacement = Metrics.LargestDisplacement(stones);
            trial.Record("max_displacement_mm", 1000 * displacement);
            trial.Record("crown_drop_mm", -1000 * stones[Stones / 2].Displacement.Y);
            trial.Record("rms_speed_mmps", 1000 * rms);
            trial.Record("stood", displacement < 0.5 ? 1 : 0);
        });

    private static void Cards(Trial trial) => trial.World(
        rig =>
        {
            const double Thickness = 0.02;
            double lean = trial.Parameter * Math.PI / 180;
            double frameHeight = Math.Cos(lean) + (Thickness * Math.Sin(lean));
            rig.Friction = 0.7;
            rig.AddGround();
            AddFrame(rig, -0.4, 0, lean, Thickness);
            AddFrame(rig, 0.4, 0, lean, Thickness);
            rig.AddBox(0, frameHeight + (0.5 * Thickness), 1.3, Thickness);
            AddFrame(rig, 0, frameHeight + Thickness, lean, Thickness);
            double rms = Metrics.RunForRmsSpeed(rig, Seconds);
            double displacement = Metrics.LargestDisplacement(rig.Actors);
            trial.Record("max_displacement_mm", 1000 * displacement);
            trial.Record("rms_speed_mmps", 1000 * rms);
            trial.Record("stood", displacement < 0.15 ? 1 : 0);
        });

    /// <summary>Two cards whose inner top corners meet above (x, ·) and whose inner bottom corners stand at height y.</summary>
    private static void AddFrame(Rig rig, double x, double y, double lean, double thickness)
    {
        double aside = (0.5 * Math.Sin(lean)) + (0.5 * thickness * Math.Cos(lean));
        double up = (0.5 * Math.Cos(lean)) + (0.5 * thickness * Math.Sin(lean));
        rig.AddBox(x - aside, y + up, thickness, 1, -lean);
        rig.AddBox(x + aside, y + up, thickness, 1, lean);
    }
}
