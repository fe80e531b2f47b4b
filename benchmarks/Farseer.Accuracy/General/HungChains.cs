using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>Chains of hinges that snap taut under a load.</summary>
internal static class HungChains
{
    private const double Link = 0.2;
    private const double LinkMass = 0.2;
    private const double Gravity = 10;
    private const double LoadRadius = 0.25;
    private const double Seconds = 10;

    /// <summary>A gap up to this is no torn joint, m.</summary>
    private const double Whole = 1e-3;

    private static readonly double[] _bends = [0.3, 0.8, 1.2, 1.4];
    private static readonly int[] _zigzagLinks = [2, 5, 10, 20, 30, 50, 100];
    private static readonly int[] _hairpinLinks = [10, 20, 40, 80];

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G12", "zigzag drop: links of 0.2 kg, load to 1:1000", [new("gap_peak_mm", 1), new("gap_end_mm", 1e-3)], Zigzags),
        new("G13", "hairpin drop: load beside the anchor, 1:20 to 1:1000", [new("gap_peak_mm", 1), new("gap_end_mm", 1)], Hairpins),
        new("G14", "zigzag and hairpin at 1:10000",
            [new("gap_peak_mm", 50), new("longest_open_s", 1), new("energy_gain", 1e-4)], Heavy),
        new("G15", "crane: a slack chain lifts its load at 0.5 m/s",
            [new("gap_peak_mm", 1), new("lift_speed_rel_error", 0.01)], Cranes),
    ];

    private static void Zigzags(GeneralRun run)
    {
        foreach (int links in _zigzagLinks)
        {
            foreach (double bend in _bends)
            {
                foreach (double ratio in new[] { 1.0, 10, 100, 500, 1000 })
                {
                    Drop(run, ZigzagOf(links, bend), FormattableString.Invariant($"{links} links at +-{bend}"), ratio);
                }
            }
        }

        for (int i = 0; i < 30; i++)
        {
            int links = run.Dice.Whole(2, 100);
            double bend = run.Dice.Between(0.2, 1.45);
            Drop(run, ZigzagOf(links, bend), FormattableString.Invariant($"{links} links at +-{bend:G4}"), run.Dice.Scale(1, 1000));
        }
    }

    private static void Hairpins(GeneralRun run)
    {
        foreach (int links in _hairpinLinks)
        {
            foreach (double ratio in new[] { 20.0, 100, 300, 1000 })
            {
                Drop(run, HairpinOf(links), $"{links} links", ratio);
            }
        }

        for (int i = 0; i < 15; i++)
        {
            int links = 2 * run.Dice.Whole(5, 40);
            Drop(run, HairpinOf(links), $"{links} links", run.Dice.Scale(20, 1000));
        }
    }

    private static void Drop(GeneralRun run, List<Vec> corners, string shape, double ratio)
    {
        string parameters = FormattableString.Invariant($"{shape}, load 1:{ratio:G4}");
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World(Gravity);
            Hang(rig, corners, ratio);
            double peak = 0;
            rig.Run(Seconds, () => peak = Math.Max(peak, rig.LargestHingeError()));
            run.Note("gap_peak_mm", 1000 * peak, parameters);
            run.Note("gap_end_mm", 1000 * rig.LargestHingeError(), parameters);
        });
    }

    private static void Heavy(GeneralRun run)
    {
        foreach (int links in _zigzagLinks)
        {
            foreach (double bend in _bends)
            {
                HeavyDrop(run, ZigzagOf(links, bend), FormattableString.Invariant($"zigzag of {links} at +-{bend}"));
            }
        }

        foreach (int links in _hairpinLinks)
        {
            HeavyDrop(run, HairpinOf(links), $"hairpin of {links}");
        }

        for (int i = 0; i < 10; i++)
        {
            int links = run.Dice.Whole(2, 100);
            double bend = run.Dice.Between(0.2, 1.45);
            HeavyDrop(run, ZigzagOf(links, bend), FormattableString.Invariant($"zigzag of {links} at +-{bend:G4}"));
        }
    }

    private static void HeavyDrop(GeneralRun run, List<Vec> corners, string parameters) => run.Sample(parameters, () =>
    {
        using Rig rig = run.World(Gravity);
        Hang(rig, corners, 1e4);
        double start = Bookkeeping.Total(rig.Actors, Gravity);
        double scale = Bookkeeping.Mass(rig.Actors) * Gravity * Link * corners.Count;
        double most = start;
        double peak = 0;
        int open = 0;
        int longest = 0;
        rig.Run(Seconds, () =>
        {
            double gap = rig.LargestHingeError();
            peak = Math.Max(peak, gap);
            open = gap > Whole ? open + 1 : 0;
            longest = Math.Max(longest, open);
            most = Math.Max(most, Bookkeeping.Total(rig.Actors, Gravity));
        });
        run.Note("gap_peak_mm", 1000 * peak, parameters);
        run.Note("longest_open_s", longest * rig.Dt, parameters);
        run.Note("energy_gain", (most - start) / scale, parameters);
    });

    private static void Cranes(GeneralRun run)
    {
        Crane(run, 20, 0.8, 1000);
        for (int i = 0; i < 12; i++)
        {
            Crane(run, run.Dice.Whole(5, 40), run.Dice.Between(0.3, 1.2), run.Dice.Scale(10, 1000));
        }
    }

    private static void Crane(GeneralRun run, int links, double bend, double ratio)
    {
        const double Speed = 0.5;
        const double Lift = 5;
        string parameters = FormattableString.Invariant($"{links} links at +-{bend:G4} about the vertical, load 1:{ratio:G4}");
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World(Gravity);
            rig.AddGround();
            Actor load = rig.AddBox(0, 0.5, 1, 1, 0, LinkMass * ratio);
            var corners = new List<Vec> { new(0, 1) };
            for (int i = 0; i < links; i++)
            {
                corners.Add(corners[^1] + new Vec(0, Link).Turned(i % 2 == 0 ? bend : -bend));
            }

            Actor hook = rig.AddLoose(corners[^1], 1, 1);
            hook.Body.IsKinematic = true;
            hook.Velocity = new Vec(0, Speed);
            rig.AddHinge(AddLinks(rig, load, corners), hook, corners[^1]);

            double slack = (Link * links) - (corners[^1].Y - 1);
            int steps = rig.StepsIn((slack / Speed) + Lift);
            int settling = rig.StepsIn(0.5);
            double peak = 0;
            int lifted = int.MaxValue;
            double height = 0;
            rig.RunSteps(steps, () =>
            {
                peak = Math.Max(peak, rig.LargestHingeError());
                if (lifted == int.MaxValue && load.Position.Y > 0.5 + Whole)
                {
                    lifted = rig.Steps;
                }

                height = rig.Steps == (long)lifted + settling ? load.Position.Y : height;
            });
            double error = lifted > steps - (2 * settling)
                ? 1
                : Math.Abs(((load.Position.Y - height) / ((steps - lifted - settling) * rig.Dt * Speed)) - 1);
            run.Note("gap_peak_mm", 1000 * peak, parameters);
            run.Note("lift_speed_rel_error", error, parameters);
        });
    }

    private static List<Vec> ZigzagOf(int links, double bend)
    {
        var corners = new List<Vec> { new(0, 0) };
        for (int i = 0; i < links; i++)
        {
            corners.Add(corners[^1] + new Vec(Link, 0).Turned(i % 2 == 0 ? bend : -bend));
        }

        return corners;
    }

    /// <summary>Half of the links hang down, one goes across, the others come back up.</summary>
    private static List<Vec> HairpinOf(int links)
    {
        var corners = new List<Vec> { new(0, 0) };
        for (int i = 0; i < links; i++)
        {
            Vec along = i < links / 2 ? new Vec(0, -1) : i == links / 2 ? new Vec(1, 0) : new Vec(0, 1);
            corners.Add(corners[^1] + (Link * along));
        }

        return corners;
    }

    /// <summary>A chain that hangs from the world at its first corner, with a load below its last.</summary>
    private static void Hang(Rig rig, List<Vec> corners, double ratio)
    {
        Actor last = AddLinks(rig, rig.AddAnchor(0, 0), corners);
        double mass = LinkMass * ratio;
        Actor load = rig.AddLoose(corners[^1] + new Vec(0, -LoadRadius), mass, 0.5 * mass * LoadRadius * LoadRadius);
        rig.AddHinge(last, load, corners[^1]);
    }

    private static Actor AddLinks(Rig rig, Actor first, List<Vec> corners)
    {
        Actor before = first;
        for (int i = 1; i < corners.Count; i++)
        {
            Vec along = corners[i] - corners[i - 1];
            Actor link = rig.AddLooseBox(
                0.5 * (corners[i] + corners[i - 1]), Link, 0.25 * Link, Math.Atan2(along.Y, along.X), LinkMass);
            rig.AddHinge(before, link, corners[i - 1]);
            before = link;
        }

        return before;
    }
}
