using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Extremes;

/// <summary>Masses, sizes, gravity.</summary>
internal static class MassExtremes
{
    public static IReadOnlyList<Extreme> All { get; } =
    [
        new("heavy-above", "mass of a box over that of the box below it", "stands, sinks by less than 10 % of a box", 1e6,
            [10, 100, 1e3, 1e4, 1e5, 1e6], r => Column("S17_mass_ratio", r)),
        new("heavy-below", "mass of a box over that of the box above it", "stands, sinks by less than 10 % of a box", 1e6,
            [10, 100, 1e3, 1e4, 1e5, 1e6], r => Column("S17_mass_ratio", 1 / r)),
        new("column", "mass ratio over a column of 5 boxes, heaviest on top", "stands, sinks by less than 10 % of a box", 1e6,
            [10, 100, 1e3, 1e4, 1e5, 1e6], r => Column("S17b_mass_column", r)),
        new("chain", "mass at the end of a hanging rope over a link's", "stretches by less than 0.1 %", 1e6,
            [10, 100, 1e3, 1e4, 1e5, 1e6], r => Probe.Figure("S11_rope", r, "stretch_pct") <= 0.1),
        new("swung-chain", "mass at the end of a swung rope over a link's", "joints open by less than 1 % in all", 1e6,
            [10, 100, 1e3, 1e4, 1e5, 1e6], r => Probe.Figure("S11b_rope_swing", r, "peak_total_separation_pct") <= 1),
        new("small", "side of the 5 boxes of a stack, m, downwards", "sinks by less than 1 % of a box", 1e-3,
            [1, 0.1, 0.01, 1e-3, 1e-4, 1e-5], s => Probe.Figure("S23_size", s, "height_error_pct_of_box") <= 1),
        new("large", "side of the 5 boxes of a stack, m, upwards", "sinks by less than 1 % of a box", 1e4,
            [1, 10, 100, 1e3, 1e4, 1e5], s => Probe.Figure("S23_size", s, "height_error_pct_of_box") <= 1),
        new("strong-gravity", "gravity on a stack of 10, m/s²", "sinks by less than 1 % of a box", 1e4,
            [0, 1, 10, 100, 1e3, 1e4, 1e5, 1e6], g => Probe.World(
                rig =>
                {
                    List<Actor> boxes = Probe.Stack(rig, 10);
                    rig.Run(10);
                    return Probe.Stayed(boxes, 0.01);
                },
                gravity: g)),
        new("light", "mass of each box of a stack of 5, kg, downwards", "stands within 1 % of a box, or the mass is refused", 1e-44,
            [1, 1e-10, 1e-20, 1e-30, 1e-36, 1e-38, 1e-40, 1e-44], Masses),
        new("heavy", "mass of each box of a stack of 5, kg, upwards", "stands within 1 % of a box, or the mass is refused", 1e38,
            [1, 1e10, 1e20, 1e30, 1e36, 3e37, 1e38], Masses),
    ];

    private static bool Column(string scene, double ratio) =>
        Probe.Figure(scene, ratio, "height_error_mm") <= 100 && Probe.Figure(scene, ratio, "stood") == 1;

    /// <summary>A mass whose inverse is no float is refused with an exception that names it; that holds as well.</summary>
    private static bool Masses(double mass) => Probe.World(rig =>
    {
        List<Actor> boxes;
        try
        {
            boxes = Probe.Stack(rig, 5, mass);
        }
        catch (ArgumentException)
        {
            return true;
        }

        rig.Run(10);
        return Probe.Stayed(boxes, 0.01);
    });
}
