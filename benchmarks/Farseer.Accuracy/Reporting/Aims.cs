using System.Collections.Generic;

namespace Farseer.Accuracy.Reporting;

/// <summary>A figure that the project aims at, with the default dial.</summary>
/// <param name="Subject">What the scene is, for people.</param>
/// <param name="Scene">Name and parameter.</param>
/// <param name="Metric">Name of the figure, which also tells its unit.</param>
/// <param name="Limit">The largest figure that meets the aim; with <paramref name="AtLeast"/> the smallest.</param>
/// <param name="AtLeast">More is better.</param>
/// <param name="Times">A scene whose same metric multiplies <paramref name="Limit"/>; null: the aim stands for itself.</param>
/// <param name="Peers">How the figure of another engine follows from what was measured of it; null: it has the same name.</param>
internal sealed record Aim(
    string Subject, string Scene, string Metric, double Limit, bool AtLeast = false, string? Times = null, PeerError? Peers = null);

/// <summary>The error of another engine: its own figure less the right one, which a metric of the aim's scene tells.</summary>
internal sealed record PeerError(string Scene, string Metric, string Right);

/// <summary>The figures that the project set out to reach; those that it promises are in <see cref="Goals"/>.</summary>
internal static class Aims
{
    public static IReadOnlyList<Aim> All { get; } =
    [
        new("free flight, 10 s", "S01_free_flight=10", "pos_error_m", 1e-6),
        new("linear drag 2", "S01b_linear_drag=2", "vel_rel_error", 1e-5),
        new("linear drag 2", "S01b_linear_drag=2", "dist_rel_error", 1e-5),
        new("spin 10 rad/s", "S02_spin=10", "angle_error_rad", 1e-4),
        new("spin 50 rad/s", "S02_spin=50", "angle_error_rad", 1e-4),
        new("bounce, restitution 1", "S03_bounce=1", "apex_max_rel_error", 1e-3),
        new("bounce, restitution 0.8", "S03_bounce=0.8", "apex_max_rel_error", 2e-3),
        new("bounce, restitution 0.5", "S03_bounce=0.5", "apex_max_rel_error", 2e-3),
        new("impact of two, elastic", "S04_pair=1", "ke_rel_error", 1e-6),
        new("impact of two, 1:1000", "S04_pair=31", "momentum_rel_error", 1e-6),
        new("impact on a corner", "S04b_corner_hit=0.5", "vy_error_mps", 1e-4),
        new("impact on a corner", "S04b_corner_hit=0.5", "omega_error_radps", 1e-4),
        new("slide, friction 0.3", "S05_friction_slide=0.3", "dist_rel_error", 3e-4),
        new("incline, friction 0.5", "S06_incline=0.5", "threshold_error_deg", 0.003),
        new("roll, 20°", "S07_roll=20", "dist_rel_error", 2e-4),
        new("pendulum 90°", "S08_pendulum=90", "period_rel_error", 2e-5),
        new("pendulum 90°", "S08_pendulum=90", "energy_rel_drift_60s", 1e-4),
        new("double pendulum", "S09_double_pendulum=90", "energy_max_error_frac", 1e-3),
        new("double pendulum", "S09_double_pendulum=90", "time_to_10cm_divergence_s", 6.3, AtLeast: true),
        new("line of 4 balls", "S10_newton_line=4", "velocity_l1_error", 0.02),
        new("cradle of 5 balls", "S10b_cradle=5", "energy_rel_change_20s", 0.02),
        new("cradle of 5 balls without friction", "S10c_smooth_cradle=5", "energy_rel_change_20s", 0.02),
        new("cradle of 5 balls that turn on pins", "S10d_pinned_cradle=5", "energy_rel_change_20s", 0.02),
        new("rope, load 100", "S11_rope=100", "stretch_pct", 1e-3),
        new("rope, load 1000", "S11_rope=1000", "stretch_pct", 1e-3),
        new("rope, load 10⁶", "S11_rope=1e6", "stretch_pct", 1e-2),
        new("swinging rope, load 100", "S11b_rope_swing=100", "peak_total_separation_pct", 5e-3),
        new("swinging rope, load 1000", "S11b_rope_swing=1000", "peak_total_separation_pct", 1e-2),
        new("bridge, load 100", "S12_bridge=100", "joint_error_peak_mm", 0.01),
        new("bridge, load 100", "S12_bridge=100", "load_penetration_end_mm", 2),
        new("bridge, load 1000", "S12_bridge=1000", "joint_error_peak_mm", 0.1),
        new("bridge, load 1000", "S12_bridge=1000", "load_lost", 0),
        new("bridge, load 1000", "S12_bridge=1000", "load_penetration_end_mm", 10),
        new("bridge, load 10: swing", "S12b_bridge_swing=10", "swing_error_mmps", 20, Peers: SwingOf("S12_bridge=10")),
        new("bridge, load 100: swing", "S12b_bridge_swing=100", "swing_error_mmps", 100, Peers: SwingOf("S12_bridge=100")),
        new("ragdoll, 3 m", "S13_ragdoll=3", "joint_error_peak_mm", 0.01),
        new("ragdoll, 3 m", "S13_ragdoll=3", "limit_overrun_deg", 0.2),
        new("spring 1 Hz", "S14_spring=1005", "freq_rel_error", 1e-3),
        new("spring 20 Hz", "S14_spring=20005", "freq_rel_error", 1e-3),
        new("spring 20 Hz", "S14_spring=20005", "damping_ratio_error", 1e-3),
        new("spring 45 Hz", "S14_spring=45005", "max_excursion_m", 1.01),
        new("stack of 10", "S15_stack=10", "height_error_pct_of_box", 0.05),
        new("stack of 20", "S15_stack=20", "height_error_pct_of_box", 0.1),
        new("stack of 40", "S15_stack=40", "height_error_pct_of_box", 0.2),
        new("stack of 100", "S15_stack=100", "height_error_pct_of_box", 0.5),
        new("pyramid of 20", "S16_pyramid=20", "max_displacement_mm", 3),
        new("pyramid of 20", "S16_pyramid=20", "rms_speed_mmps", 0.01),
        new("pyramid of 40", "S16_pyramid=40", "max_displacement_mm", 10),
        new("mass ratio 1:100", "S17_mass_ratio=100", "height_error_mm", 0.5),
        new("mass ratio 1:1000", "S17_mass_ratio=1000", "height_error_mm", 2),
        new("mass ratio 1:10⁴", "S17_mass_ratio=10000", "height_error_mm", 50),
        new("arch 1.0", "S18_arch=1", "max_displacement_mm", 3),
        new("arch 0.7", "S18_arch=0.7", "max_displacement_mm", 3),
        new("arch 0.62 stands", "S18_arch=0.62", "stood", 1, AtLeast: true),
        new("arch 0.55 falls", "S18_arch=0.55", "stood", 0),
        new("house of cards", "S18b_cards=20", "max_displacement_mm", 0.5),
        new("overlap by half", "S19_overlap=0.5", "pop_height_mm", 1e-4),
        new("overlapping stack", "S19b_overlap_stack=0.25", "top_overshoot_m", 1e-3),
        new("overlapping stack", "S19b_overlap_stack=0.25", "max_speed_mps", 3),
        new("shot of 100 m/s at a wall", "S20_tunnel=100", "tunnelled_frac", 0),
        new("shot of 10 km/s at a wall", "S20_tunnel=10000", "tunnelled_frac", 0),
        new("flight at 10 km/s", "S20_tunnel=10000", "free_travel_frac", 0.99999, AtLeast: true),
        new("shot at a wall that moves", "S20b_tunnel_bullet=1000", "tunnelled_frac", 0),
        new("shot at a wall that moves", "S20b_tunnel_bullet=1000", "momentum_rel_error_max", 1e-6),
        new("turning rod, 20 rad/s", "S21_spinner=20", "tunnelled_frac", 0),
        new("turning rod, 60 rad/s", "S21_spinner=60", "tunnelled_frac", 0),
        new("turning rod, 60 rad/s", "S21_spinner=60", "ke_gain_max_frac", 1e-6),
        new("stack at 10⁶ m", "S22_far_stack=1e6", "height_error_pct_of_box", 1.1, Times: "S15_stack=10"),
        new("bounce at 10⁶ m", "S22b_far_bounce=1e6", "apex1_rel_error", 1.1, Times: "S22b_far_bounce=0"),
        new("crawl at 10⁶ m", "S22c_far_crawl=1e6", "displacement_rel_error", 1e-6),
        new("boxes of 1 cm", "S23_size=0.01", "height_error_pct_of_box", 1),
        new("boxes of 1 km", "S23_size=1000", "height_error_pct_of_box", 1),
        new("boxes of 1 mm", "S23_size=0.001", "stood", 1, AtLeast: true),
        new("prismatic load", "S25_prismatic_load=100", "perp_error_mm", 1e-4),
        new("prismatic slide", "S25b_prismatic_slide=30", "perp_error_mm", 1e-3),
        new("gear", "S25c_gear=2", "gear_angle_error_max_deg", 1e-5),
        new("motor", "S26_motor=1", "lift_threshold_rel_error", 1e-5),
        new("sleep, pyramid of 10", "S27_sleep_pyramid=10", "max_pos_difference_mm", 0.01),
        new("sleep, pyramid of 10", "S27_sleep_pyramid=10", "asleep_frac", 1, AtLeast: true),
        new("soak of 10⁶ steps", "S28_soak=1e6", "incline_creep_mm", 0.05),
        new("soak of 10⁶ steps", "S28_soak=1e6", "stack_top_drift_mm", 0.05),
        new("soak of 10⁶ steps", "S28_soak=1e6", "pendulum_energy_ratio", 0.999, AtLeast: true),
        new("concave shapes", "S29_concave=24", "max_penetration_peak_mm", 5),
        new("concave shapes", "S29_concave=24", "max_penetration_end_mm", 0.2),
    ];

    private static PeerError SwingOf(string scene) => new(scene, "rms_speed_mmps", "swing_converged_mmps");
}
