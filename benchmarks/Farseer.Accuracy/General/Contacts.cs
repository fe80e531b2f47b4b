using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>Tips that must not slip, stacks and heaps at every dial and every rhythm of steps.</summary>
internal static class Contacts
{
    private static readonly int[] _dials = [5, 10, 20, 40];

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G23", "falling pencil: a rod on its tip, friction 5", [new("tip_slip_mm", 0.01)], Pencils),
        new("G24", "overlapping stack (S19b) at each dial", [new("overshoot_mm", 1), new("overshoot_dt_1/240_mm", 1)], Overlaps),
        new("G25", "concave heap (S29) at each dial",
            [new("peak_depth_at_5_mm", 10), new("peak_depth_ratio_of_a_doubling", 1)], Heaps),
        new("G26", "stack of 10 at even and uneven steps",
            [new("top_speed_even_mmps", 0.02), new("top_speed_uneven_mmps", 0.02)], Stacks),

        // 4 less what rounding, 1e-7 of a box, is of the error at 20, 1e-5; at 40 it is a twentieth, for boxes of 1 m too.
        new("G29", "small boxes (S23): error for each doubling of Iterations", [new("least_factor", 3.95, AtLeast: true)], Small),
    ];

    private static void Pencils(GeneralRun run)
    {
        Pencil(run, 0.1, 2, 0.1);
        for (int i = 0; i < 30; i++)
        {
            double length = run.Dice.Scale(0.2, 5);
            double thickness = length * run.Dice.Between(0.02, 0.08);

            // It falls over if its middle is beyond the tip.
            double balance = Math.Atan2(thickness, length);
            Pencil(run, balance + run.Dice.Between(0.02, 0.3), length, thickness);
        }
    }

    /// <summary>
    /// Until the rod leans by 0.9: of a thin rod friction 5 holds the tip to 1.03, where the floor's push has all but gone.
    /// </summary>
    private static void Pencil(GeneralRun run, double tilt, double length, double thickness)
    {
        const double Last = 0.9;
        string parameters = FormattableString.Invariant($"tilt {tilt:G4}, {length:G4}x{thickness:G4} m");
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World();
            rig.Friction = 5;
            rig.AddGround();
            Vec corner = new(0.5 * thickness, -0.5 * length);

            // As the body receives the angle.
            double angle = (float)-tilt;
            Vec middle = new Vec(0, 0) - corner.Turned(angle);
            Actor rod = rig.AddBox(middle.X, middle.Y, thickness, length, angle);
            double slip = 0;
            int most = rig.StepsIn(20);
            while (rod.Angle > -Last && rig.Steps < most)
            {
                rig.Step();
                slip = rod.Angle > -Last ? Math.Max(slip, Math.Abs((rod.Position + corner.Turned(rod.Angle)).X)) : slip;
            }

            run.Note("tip_slip_mm", rig.Steps < most ? 1000 * slip : Runner.Exploded, parameters);
        });
    }

    private static void Overlaps(GeneralRun run)
    {
        const string Scene = "S19b_overlap_stack";
        const string Metric = "top_overshoot_m";
        var shares = new List<double> { 0.25, 0.5 };
        for (int i = 0; i < 4; i++)
        {
            shares.Add(Math.Round(run.Dice.Between(0.05, 0.6), 3));
        }

        foreach (double share in shares)
        {
            foreach (int iterations in _dials)
            {
                string parameters = FormattableString.Invariant($"overlap {share} of a box, Iterations {iterations}");
                Dial dial = run.Dial with { Iterations = iterations };
                run.Note("overshoot_mm", 1000 * run.Published(Scene, share, Metric, dial), parameters);
            }

            string shorter = FormattableString.Invariant($"overlap {share} of a box, dt 1/240");
            run.Note("overshoot_dt_1/240_mm", 1000 * run.Published(Scene, share, Metric, run.Dial with { Dt = 1.0 / 240 }), shorter);
        }
    }

    private static void Heaps(GeneralRun run)
    {
        var counts = new List<int> { 24, 40, 60, run.Dice.Whole(16, 32), run.Dice.Whole(32, 56) };
        foreach (int count in counts)
        {
            double before = 0;
            foreach (int iterations in _dials)
            {
                Dial dial = run.Dial with { Iterations = iterations };
                double peak = run.Published("S29_concave", count, "max_penetration_peak_mm", dial);
                if (iterations == _dials[0])
                {
                    run.Note("peak_depth_at_5_mm", peak, $"{count} bodies");
                }
                else
                {
                    string parameters = FormattableString.Invariant(
                        $"{count} bodies, Iterations {iterations / 2} to {iterations}: {before:G3} to {peak:G3} mm");
                    run.Note("peak_depth_ratio_of_a_doubling", peak / before, parameters);
                }

                before = peak;
            }
        }
    }

    private static void Stacks(GeneralRun run)
    {
        foreach (int count in new[] { 10, 5, 20 })
        {
            Stack(run, count, "top_speed_even_mmps", [run.Dial.Dt]);
            Stack(run, count, "top_speed_uneven_mmps", [1.0 / 50, 1.0 / 75]);
        }

        for (int i = 0; i < 6; i++)
        {
            var rhythm = new double[run.Dice.Whole(2, 5)];
            for (int k = 0; k < rhythm.Length; k++)
            {
                rhythm[k] = 1 / run.Dice.Between(45, 100);
            }

            Stack(run, 10, "top_speed_uneven_mmps", rhythm);
        }
    }

    private static void Stack(GeneralRun run, int count, string figure, double[] rhythm)
    {
        const double Seconds = 10;
        string steps = string.Join(", ", Array.ConvertAll(rhythm, dt => FormattableString.Invariant($"1/{1 / dt:G4}")));
        string parameters = $"{count} boxes, steps of {steps} s";
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World();
            rig.AddGround();
            Actor top = rig.Actors[0];
            for (int i = 0; i < count; i++)
            {
                top = rig.AddBox(0, 0.5 + i, 1, 1);
            }

            double time = 0;
            double sum = 0;
            int looks = 0;
            for (int i = 0; time < Seconds; i++)
            {
                double dt = rhythm[i % rhythm.Length];
                rig.Step((float)dt);
                time += dt;
                if (time > Seconds - 1)
                {
                    sum += Vec.Dot(top.Velocity, top.Velocity);
                    looks++;
                }
            }

            run.Note(figure, 1000 * Math.Sqrt(sum / looks), parameters);
        });
    }

    private static void Small(GeneralRun run)
    {
        var sizes = new List<double> { 0.01, 0.02, 0.05, 0.1, 0.2, 0.4 };
        for (int i = 0; i < 6; i++)
        {
            sizes.Add(Math.Round(run.Dice.Scale(0.01, 0.4), 4));
        }

        foreach (double about in sizes)
        {
            // The nearest size of which floats know all multiples, so that the boxes lie on each other.
            double size = Math.Round(about * 4096) / 4096;
            double before = 0;
            foreach (int iterations in new[] { 5, 10, 20 })
            {
                double error = run.Published("S23_size", size, "height_error_pct_of_box", run.Dial with { Iterations = iterations });
                if (before > 0)
                {
                    run.Note("least_factor", before / error, FormattableString.Invariant(
                        $"boxes of {size:G4} m, Iterations {iterations / 2} to {iterations}: {before:G3} to {error:G3} %"));
                }

                before = error;
            }
        }
    }
}
