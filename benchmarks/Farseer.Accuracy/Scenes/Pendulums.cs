using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>Rods on hinges: period and energy against the exact pendulum, and the double pendulum against Runge-Kutta.</summary>
internal static class Pendulums
{
    private const double Gravity = 10;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S08_pendulum", "degrees from straight down", new(0.1, 175), ["10", "90", "150"],
            ["period_rel_error", "energy_rel_drift_60s", "joint_error_max_mm"], Pendulum),
        new("S09_double_pendulum", "degrees from straight down", new(0.1, 175), ["90"],
            ["energy_max_error_frac", "time_to_10cm_divergence_s", "joint_error_max_mm"], DoublePendulum),
    ];

    private static void Pendulum(Trial trial) => trial.World(
        rig =>
        {
            double start = trial.Parameter * Math.PI / 180;
            Actor anchor = rig.AddAnchor(0, 0);
            Actor rod = rig.AddLooseBox(new Vec(Math.Sin(start), -Math.Cos(start)), 0.1, 2, start, 0.2);
            rig.AddHinge(anchor, rod, new Vec(0, 0));
            double energy = Energy(rod);
            double error = 0;
            var crossings = new List<double>();
            double lastEnergies = 0;
            int lastCount = 0;
            int steps = rig.StepsIn(60);
            double before = rod.Angle;
            for (int i = 1; i <= steps; i++)
            {
                rig.Step();
                error = Math.Max(error, rig.LargestHingeError());
                double now = rod.Angle;
                if (before > 0 && now <= 0)
                {
                    crossings.Add((i - 1 + (before / (before - now))) * rig.Dt);
                }

                before = now;
                if (i > steps - rig.StepsIn(5))
                {
                    lastEnergies += Energy(rod);
                    lastCount++;
                }
            }

            double inertia = rod.Inertia + rod.Mass;
            double exact = 4 * Math.Sqrt(inertia / (rod.Mass * Gravity)) * QuarterPeriod(Math.Sin(start / 2));
            double period = crossings.Count > 5 ? (crossings[5] - crossings[0]) / 5 : 0;
            trial.Record("period_rel_error", Math.Abs((period / exact) - 1));
            trial.Record("energy_rel_drift_60s", Math.Abs((lastEnergies / lastCount / energy) - 1));
            trial.Record("joint_error_max_mm", 1000 * error);
        },
        gravity: Gravity);

    private static double Energy(Actor rod) => rod.KineticEnergy + (rod.Mass * Gravity * (rod.Position.Y + 1));

    /// <summary>The complete elliptic integral K(k) by the arithmetic-geometric mean.</summary>
    private static double QuarterPeriod(double k)
    {
        double a = 1;
        double b = Math.Sqrt(1 - (k * k));
        for (int i = 0; i < 20; i++)
        {
            (a, b) = ((a + b) / 2, Math.Sqrt(a * b));
        }

        return Math.PI / (2 * a);
    }

    private static void DoublePendulum(Trial trial) => trial.World(
        rig =>
        {
            double start = trial.Parameter * Math.PI / 180;
            Vec along = new(Math.Sin(start), -Math.Cos(start));
            Actor anchor = rig.AddAnchor(0, 0);
            Actor upper = rig.AddLooseBox(0.5 * along, 0.1, 1, start, 0.1);
            Actor lower = rig.AddLooseBox(1.5 * along, 0.1, 1, start, 0.1);
            rig.AddHinge(anchor, upper, new Vec(0, 0));
            rig.AddHinge(upper, lower, along);
            var exact = new TwoRods(start, upper.Mass, upper.Inertia, Gravity);
            double scale = 4 * upper.Mass * Gravity;
            double energy = TwoRodEnergy(upper, lower);
            double worst = 0;
            double error = 0;
            double divergence = 20;
            rig.Run(20, () =>
            {
                exact.Advance(rig.Dt);
                worst = Math.Max(worst, Math.Abs(TwoRodEnergy(upper, lower) - energy) / scale);
                error = Math.Max(error, rig.LargestHingeError());
                Vec tip = lower.Position + new Vec(0, -0.5).Turned(lower.Angle);
                if (divergence == 20 && (tip - exact.Tip).Length > 0.1)
                {
                    divergence = rig.Time;
                }
            });
            trial.Record("energy_max_error_frac", worst);
            trial.Record("time_to_10cm_divergence_s", divergence);
            trial.Record("joint_error_max_mm", 1000 * error);
        },
        gravity: Gravity);

    private static double TwoRodEnergy(Actor upper, Actor lower) => upper.KineticEnergy + lower.KineticEnergy
        + (Gravity * ((upper.Mass * upper.Position.Y) + (lower.Mass * lower.Position.Y)));

    /// <summary>Two equal rods of length 1, integrated by the classical Runge-Kutta method at 0.1 ms.</summary>
    private sealed class TwoRods
    {
        private readonly double _mass;
        private readonly double _inertia;
        private readonly double _gravity;
        private double[] _state;

        public TwoRods(double start, double mass, double inertia, double gravity)
        {
            _mass = mass;
            _inertia = inertia;
            _gravity = gravity;
            _state = [start, start, 0, 0];
        }

        public Vec Tip => new(Math.Sin(_state[0]) + Math.Sin(_state[1]), -Math.Cos(_state[0]) - Math.Cos(_state[1]));

        public void Advance(double time)
        {
            int steps = (int)Math.Ceiling(time / 1e-4);
            double h = time / steps;
            for (int i = 0; i < steps; i++)
            {
                double[] k1 = Slope(_state);
                double[] k2 = Slope(Moved(k1, h / 2));
                double[] k3 = Slope(Moved(k2, h / 2));
                double[] k4 = Slope(Moved(k3, h));
                for (int k = 0; k < 4; k++)
                {
                    _state[k] += h / 6 * (k1[k] + (2 * k2[k]) + (2 * k3[k]) + k4[k]);
                }
            }
        }

        private double[] Moved(double[] slope, double h)
        {
            var moved = new double[4];
            for (int k = 0; k < 4; k++)
            {
                moved[k] = _state[k] + (h * slope[k]);
            }

            return moved;
        }

        // Lagrange: with l = 1, d = 1/2, c = cos(a - b), s = sin(a - b).
        private double[] Slope(double[] q)
        {
            (double a, double b, double u, double v) = (q[0], q[1], q[2], q[3]);
            double m11 = _inertia + (0.25 * _mass) + _mass;
            double m12 = 0.5 * _mass * Math.Cos(a - b);
            double m22 = _inertia + (0.25 * _mass);
            double f1 = (-0.5 * _mass * Math.Sin(a - b) * v * v) - (1.5 * _mass * _gravity * Math.Sin(a));
            double f2 = (0.5 * _mass * Math.Sin(a - b) * u * u) - (0.5 * _mass * _gravity * Math.Sin(b));
            double det = (m11 * m22) - (m12 * m12);
            return [u, v, ((m22 * f1) - (m12 * f2)) / det, ((m11 * f2) - (m12 * f1)) / det];
        }
    }
}
