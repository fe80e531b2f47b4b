using System.Collections.Generic;

namespace Farseer.Accuracy.Sweeping;

/// <summary>A scene by which speed and accuracy are compared.</summary>
/// <param name="Scene">Name and parameter.</param>
/// <param name="Metric">Its main error.</param>
/// <param name="Scale">What the metric is divided by: the error at which the scene has failed, in the metric's unit.</param>
/// <param name="Title">What the scene is, for people.</param>
/// <param name="Rounding">Errors below this share of the scale are rounding or sampling, not modelling: no floor is sought in them.</param>
internal sealed record SweepScene(string Scene, string Metric, double Scale, string Title, double Rounding)
{
    /// <summary>Share of the scale that counts as "right" in the time to tolerance.</summary>
    public const double Tolerance = 0.01;

    public static IReadOnlyList<SweepScene> All { get; } =
    [
        // Apexes are sampled at steps: g·dt²/8 is 3.5e-4 m at 60 steps a second, whatever the dial, and the lowest apex is 1.07 m.
        new("S03_bounce=0.8", "apex_max_rel_error", 1, "bouncing ball, restitution 0.8: apexes", 4e-4),
        new("S08_pendulum=90", "energy_rel_drift_60s", 1, "pendulum from 90°: energy after a minute", 1e-5),
        // Velocities are floats: their rounding adds up over 1200 steps.
        new("S09_double_pendulum=90", "energy_max_error_frac", 1, "double pendulum from 90°: energy", 3e-5),
        new("S11_rope=100", "stretch_pct", 100, "hanging rope, load 100 links: stretch", 1e-7),
        // A whip is chaotic: which of two runs ends a hundredth of a millimetre better in each of its 50 joints is chance.
        new("S11b_rope_swing=10", "peak_total_separation_pct", 100, "swinging rope, load 10 links: opened joints", 2e-5),
        new("S12_bridge=100", "joint_error_end_mm", 1000, "bridge, load 100 planks: opened joints", 1e-6),
        new("S15_stack=20", "height_error_pct_of_box", 100, "stack of 20 boxes: height", 1e-7),
        new("S16_pyramid=10", "max_displacement_mm", 1000, "pyramid of 10 rows: displacement", 1e-5),
        new("S17_mass_ratio=100", "height_error_mm", 1000, "light box under 100 times its weight: height", 1e-7),
        // Stones that lean on each other by friction creep with what rounding leaves of it: 0.02 mm in 10 s of 8,000 substeps a second.
        new("S18_arch=1", "max_displacement_mm", 1000, "arch of 17 stones: displacement", 3e-5),
    ];

    public static SweepScene? Find(string scene)
    {
        foreach (SweepScene one in All)
        {
            if (one.Scene == scene)
            {
                return one;
            }
        }

        return null;
    }
}
