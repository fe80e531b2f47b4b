using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.CommandLines;

namespace Farseer.Accuracy.Reporting;

/// <summary>A figure that has to hold not only at the published value of a scene's parameter but all around it.</summary>
/// <param name="Scene">Name without parameter.</param>
/// <param name="Metric">Name of the figure.</param>
/// <param name="Limit">The aim of the published value; its size counts.</param>
/// <param name="From">Least value of the parameter.</param>
/// <param name="To">Largest value.</param>
/// <param name="AtLeast">More is better.</param>
internal sealed record Neighbourhood(string Scene, string Metric, double Limit, double From, double To, bool AtLeast = false);

/// <summary>Tries parameters that nobody published: the ends of each neighbourhood and random values between them.</summary>
internal static class Neighbours
{
    private const int DefaultCount = 4;

    /// <summary>Beyond this ratio of its ends a neighbourhood is drawn from by its logarithm.</summary>
    private const double WideRange = 8;

    public static IReadOnlyList<Neighbourhood> All { get; } =
    [
        new("S01_free_flight", "pos_error_m", 1e-6, 1, 20),
        new("S01b_linear_drag", "vel_rel_error", 1e-5, 0.1, 3),
        new("S02_spin", "angle_error_rad", 1e-4, 1, 150),
        new("S03_bounce", "apex_max_rel_error", 2e-3, 0.45, 1),
        new("S04_pair", "momentum_rel_error", 1e-6, 0.1, 1),
        new("S04_pair", "momentum_rel_error", 1e-6, 30.1, 31),
        new("S04b_corner_hit", "vy_error_mps", 1e-4, 0.1, 1),
        new("S04b_corner_hit", "omega_error_radps", 1e-4, 0.1, 1),
        new("S05_friction_slide", "dist_rel_error", 3e-4, 0.1, 0.7),
        new("S06_incline", "threshold_error_deg", 3e-3, 0.2, 0.9),
        new("S07_roll", "dist_rel_error", 2e-4, 5, 30),
        new("S08_pendulum", "period_rel_error", 2e-5, 20, 95),
        new("S08_pendulum", "energy_rel_drift_60s", 1e-4, 20, 120),
        new("S09_double_pendulum", "energy_max_error_frac", 1e-3, 20, 110),
        new("S10_newton_line", "velocity_l1_error", 0.02, 1, 200),
        new("S10c_smooth_cradle", "energy_rel_change_20s", 0.02, 2, 12),
        new("S10d_pinned_cradle", "energy_rel_change_20s", 0.02, 2, 12),
        new("S11_rope", "stretch_pct", 1e-3, 1, 1e5),
        new("S11b_rope_swing", "peak_total_separation_pct", 5e-3, 1, 150),
        new("S11b_rope_swing", "peak_total_separation_pct", 1e-2, 150, 2000),
        new("S12_bridge", "joint_error_peak_mm", 0.01, 5, 130),
        new("S12_bridge", "load_penetration_end_mm", 2, 5, 130),
        new("S12_bridge", "joint_error_peak_mm", 0.1, 130, 1500),
        new("S12_bridge", "load_penetration_end_mm", 10, 130, 1500),
        new("S13_ragdoll", "joint_error_peak_mm", 0.01, 1, 6),
        new("S13_ragdoll", "limit_overrun_deg", 0.2, 1, 6),
        new("S14_spring", "freq_rel_error", 1e-3, 1001, 1060),
        new("S14_spring", "freq_rel_error", 1e-3, 7001, 7060),
        new("S14_spring", "freq_rel_error", 1e-3, 20001, 20060),
        new("S14_spring", "freq_rel_error", 1e-3, 29001, 29060),
        new("S15_stack", "height_error_pct_of_box", 0.05, 1, 11),
        new("S15_stack", "height_error_pct_of_box", 0.1, 12, 22),
        new("S15_stack", "height_error_pct_of_box", 0.2, 23, 44),
        new("S15_stack", "height_error_pct_of_box", 0.5, 45, 105),
        new("S16_pyramid", "max_displacement_mm", 3, 2, 22),
        new("S16_pyramid", "max_displacement_mm", 10, 23, 42),
        new("S17_mass_ratio", "height_error_mm", 0.5, 2, 150),
        new("S17_mass_ratio", "height_error_mm", 2, 150, 1500),
        new("S17_mass_ratio", "height_error_mm", 50, 1500, 5e4),
        new("S17b_mass_column", "height_error_mm", 2, 2, 1500),
        new("S18_arch", "max_displacement_mm", 3, 0.68, 1.1),
        new("S18_arch", "stood", 1, 0.62, 0.68, AtLeast: true),
        new("S18_arch", "stood", 0, 0.45, 0.56),
        // From 22.5° on the feet of the two lower frames overlap.
        new("S18b_cards", "max_displacement_mm", 0.5, 12, 22),
        new("S19_overlap", "pop_height_mm", 1e-4, 0.05, 0.6),
        new("S19b_overlap_stack", "top_overshoot_m", 1e-3, 0.1, 0.5),
        new("S19b_overlap_stack", "max_speed_mps", 3, 0.1, 0.5),
        new("S20_tunnel", "tunnelled_frac", 0, 10, 1e4),
        new("S20b_tunnel_bullet", "momentum_rel_error_max", 1e-6, 10, 1e4),
        new("S21_spinner", "tunnelled_frac", 0, 5, 200),
        new("S21_spinner", "ke_gain_max_frac", 1e-6, 5, 200),
        new("S23_size", "height_error_pct_of_box", 1, 0.01, 1000),
        new("S25_prismatic_load", "perp_error_mm", 1e-4, 1, 1000),
        new("S25b_prismatic_slide", "perp_error_mm", 1e-3, 5, 80),
        new("S25c_gear", "gear_angle_error_max_deg", 1e-5, 0.2, 10),
        new("S27_sleep_pyramid", "max_pos_difference_mm", 0.01, 2, 12),
        new("S29_concave", "max_penetration_peak_mm", 5, 12, 30),
    ];

    private static readonly Argument<string[]> _only = new("scene") { Description = "names of scenes, full or short; none: all" };
    private static readonly Option<int> _seed = Values.Whole("--seed", "draws the random values", 0, int.MaxValue, 1);
    private static readonly Option<int> _count = Values.Whole("--count", "random values of each parameter", 0, int.MaxValue, DefaultCount);

    public static Command Create() => Cli.Judged(
        "neighbours", "The aims at parameters that nobody published: ends of ranges and random values between.", Run, _only, _seed, _count);

    private static bool Run(ParseResult result)
    {
        TextWriter output = result.Output();
        var only = new List<string>();
        foreach (string word in result.GetValue(_only) ?? [])
        {
            only.Add((Catalogue.Find(word) ?? throw new UsageException($"neighbours: no scene is called '{word}'.")).Name);
        }

        output.WriteLine(Cli.Settings);
        output.WriteLine($"{"scene",-32} {"metric",-28} {"reached",13} {"aim",13}  result");
        var done = new Dictionary<string, List<Row>>();
        int met = 0;
        int missed = 0;
        foreach (Neighbourhood one in All)
        {
            if (only.Count > 0 && !only.Contains(one.Scene))
            {
                continue;
            }

            foreach (double parameter in Parameters(one, (uint)result.GetValue(_seed), result.GetValue(_count)))
            {
                bool holds = Check(one, parameter, done, output);
                met += holds ? 1 : 0;
                missed += holds ? 0 : 1;
            }
        }

        output.WriteLine($"{met} met, {missed} missed");
        return missed == 0;
    }

    private static bool Check(Neighbourhood one, double parameter, Dictionary<string, List<Row>> done, TextWriter output)
    {
        string scene = FormattableString.Invariant($"{one.Scene}={parameter:G6}");
        if (!done.TryGetValue(scene, out List<Row>? rows))
        {
            rows = Runner.Run(Options.ParseScene(scene), new Dial(Options.DefaultIterations, Options.DefaultDt), 1);
            done.Add(scene, rows);
        }

        double value = Math.Abs(rows.Find(row => row.Metric == one.Metric)!.Value);
        bool holds = value < Runner.Exploded && (one.AtLeast ? value >= one.Limit : value <= one.Limit);
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"{scene,-32} {one.Metric,-28} {value,13:G6} {one.Limit,13:G6}  {(holds ? "met" : "MISSED")}"));
        output.Flush();
        return holds;
    }

    /// <summary>Both ends and random values between, the same for the same seed and scene.</summary>
    public static List<double> Parameters(Neighbourhood one, uint seed, int count)
    {
        bool whole = Catalogue.Find(one.Scene)!.Range.WholeNumber;
        bool wide = one.From > 0 && one.To / one.From > WideRange;
        uint state = seed;
        foreach (char letter in one.Scene)
        {
            state = unchecked((1664525u * (state ^ letter)) + 1013904223u);
        }

        var values = new List<double> { one.From, one.To };
        for (int i = 0; i < count; i++)
        {
            state = unchecked((1664525u * state) + 1013904223u);
            double share = (state >> 8) / 16777216.0;
            double value = wide ? one.From * Math.Pow(one.To / one.From, share) : one.From + (share * (one.To - one.From));
            value =
                whole ? Math.Round(value) : double.Parse(value.ToString("G4", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
            if (!values.Contains(value))
            {
                values.Add(value);
            }
        }

        return values;
    }
}
