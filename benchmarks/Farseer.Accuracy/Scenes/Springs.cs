using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>A body on a spring; the reference is the damped oscillator.</summary>
internal static class Springs
{
    private const double RestLength = 5;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new(
            "S14_spring",
            "1000 times the frequency plus 100 times the damping ratio",
            new(1000, 100000),
            ["1005", "2005", "8010", "20005"],
            ["freq_rel_error", "damping_ratio_error", "max_excursion_m"],
            Spring),
    ];

    private static void Spring(Trial trial) => trial.World(
        rig =>
        {
            double frequency = Math.Floor(trial.Parameter / 1000);
            double ratio = (trial.Parameter - (1000 * frequency)) / 100;
            double omega = 2 * Math.PI * frequency;
            Actor ball = rig.AddCircle(RestLength + 1, 0, 0.25, 1);
            rig.AddFixedSpring(ball, RestLength, omega * omega, 2 * ratio * omega);
            var samples = new List<double> { 1 };
            double most = 0;
            rig.Run(12 / frequency, () =>
            {
                double x = ball.Position.Length - RestLength;
                samples.Add(x);
                most = Math.Max(most, Math.Abs(x));
            });
            Modes(samples, rig.Dt, out double turn, out double decay);
            double found = Math.Sqrt((turn * turn) + (decay * decay));
            double exact = omega * Math.Sqrt(1 - (ratio * ratio));
            trial.Record("freq_rel_error", Math.Abs((turn / exact) - 1));
            trial.Record("damping_ratio_error", Math.Abs((decay / found) - ratio));
            trial.Record("max_excursion_m", most);
        },
        gravity: 0);

    /// <summary>
    /// Every damped oscillation sampled at steps h obeys x₂ = t·x₁ − d·x₀ with d = e^(−2λh) and t = 2√d·cos ωh; t and d by least
    /// squares. Crossings and maxima between three samples a period, as at 20 Hz, would measure the interpolation.
    /// </summary>
    internal static void Modes(List<double> x, double h, out double turn, out double decay)
    {
        double s00 = 0;
        double s01 = 0;
        double s11 = 0;
        double r0 = 0;
        double r1 = 0;
        for (int i = 2; i < x.Count; i++)
        {
            s00 += x[i - 1] * x[i - 1];
            s01 += x[i - 1] * x[i - 2];
            s11 += x[i - 2] * x[i - 2];
            r0 += x[i] * x[i - 1];
            r1 += x[i] * x[i - 2];
        }

        double determinant = (s00 * s11) - (s01 * s01);
        double t = ((r0 * s11) - (r1 * s01)) / determinant;
        double d = ((r0 * s01) - (r1 * s00)) / determinant;
        decay = -Math.Log(d) / (2 * h);
        turn = Math.Acos(Math.Clamp(t / (2 * Math.Sqrt(d)), -1, 1)) / h;
    }
}
