using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Extremes;

/// <summary>Many bodies, long chains, long runs.</summary>
internal static class CrowdExtremes
{
    /// <summary>More than so many bodies at one place are given twice the time to part, and three times to come to rest.</summary>
    private const double Many = 100;

    public static IReadOnlyList<Extreme> All { get; } =
    [
        new("tall", "boxes of a stack", "stands for 10 s, sinks by less than 10 % of a box", 100,
            [
                10, 20, 50, 100, 200,
            ], n => Probe.Figure("S15_stack", n, "height_error_pct_of_box") <= 10 && Probe.Figure("S15_stack", n, "stood") == 1),
        new("long-rope", "links of a hanging rope with 100 times a link's mass at its end", "stretches by less than 0.1 %", 1000,
            [10, 100, 1000, 2000], Rope),
        new("coincident", "discs of 1 m at one and the same place, without "
            + "gravity", "part, none ever faster than 2 m/s, no number is lost", 1000,
            [2, 10, 100, 1000], Coincident),
        new("coincident-boxes", "boxes of 1 m at one and the same place above a ground", "part and come to rest, no number is lost", 1000,
            [2, 10, 100, 1000], CoincidentBoxes),
        new(
            "soak",
            "steps of a stack, a box on a slope and a pendulum",
            "drifts by less than 0.05 mm, energy within 0.1 %",
            1e6,
            [1e4, 1e5, 1e6],
            Soak),
    ];

    private static bool Rope(double links) => Probe.World(rig =>
    {
        int n = (int)links;
        Actor before = rig.AddAnchor(0, 0);
        for (int i = 0; i < n; i++)
        {
            Actor link = rig.AddLooseBox(new Vec(0, -0.25 - (0.5 * i)), 0.125, 0.5, 0, 1);
            rig.AddHinge(before, link, new Vec(0, -0.5 * i));
            before = link;
        }

        double length = 0.5 * n;
        Actor weight = rig.AddLoose(new Vec(0, -length - 0.5), 100, 12.5);
        rig.AddHinge(before, weight, new Vec(0, -length));
        rig.Run(5);
        return rig.TotalHingeError() <= 1e-3 * length && Math.Abs(weight.Displacement.Y) <= 1e-3 * length;
    });

    private static bool Coincident(double count) => Probe.World(
        rig =>
        {
            var discs = new List<Actor>();
            for (int i = 0; i < (int)count; i++)
            {
                discs.Add(rig.AddCircle(0, 0, 0.5));
            }

            double fastest = 0;
            rig.Run(count > Many ? 10 : 5, () => fastest = Math.Max(fastest, Fastest(discs)));
            return fastest <= 2 && Apart(discs);
        },
        gravity: 0);

    private static bool CoincidentBoxes(double count) => Probe.World(rig =>
    {
        rig.AddStaticBox(0, -0.5, 10000, 1);
        var boxes = new List<Actor>();
        for (int i = 0; i < (int)count; i++)
        {
            boxes.Add(rig.AddBox(0, 5, 1, 1));
        }

        // A heap of a hundred settles by slips, of which some come after half a minute.
        rig.Run(count > Many ? 90 : 60);
        return Fastest(boxes) <= 0.05 && Metrics.Penetration(rig.Actors) <= 0.05;
    });

    private static double Fastest(List<Actor> actors)
    {
        double fastest = 0;
        foreach (Actor actor in actors)
        {
            fastest = Math.Max(fastest, actor.Velocity.Length);
        }

        return fastest;
    }

    /// <summary>No two discs of 1 m overlap by more than 5 cm.</summary>
    private static bool Apart(List<Actor> discs)
    {
        for (int i = 0; i < discs.Count; i++)
        {
            for (int j = i + 1; j < discs.Count; j++)
            {
                if ((discs[i].Position - discs[j].Position).Length < 0.95)
                {
                    return false;
                }
            }
        }

        return true;
    }

    private static bool Soak(double steps) =>
        Probe.Figure("S28_soak", steps, "incline_creep_mm") <= 0.05
        && Probe.Figure("S28_soak", steps, "stack_top_drift_mm") <= 0.05
        && Math.Abs(Probe.Figure("S28_soak", steps, "pendulum_energy_ratio") - 1) <= 1e-3;
}
