using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Accuracy.Scenes;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Accuracy.General;

/// <summary>Springs: many in a row, and stiff ones of joints.</summary>
internal static class SpringRows
{
    private const int Masses = 20;
    private const double Periods = 10;

    private static readonly double[] _frequencies = [5, 12, 15, 20, 25, 29];
    private static readonly double[] _ratios = [0, 0.05, 0.3, 0.7, 1];

    private enum Setting
    {
        Distance,
        Wheel,
        Lever,
    }

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G20", "springs in a row: 20 masses of 1 kg between two walls",
            [new("amplitude_rel_error", 0.01), new("frequency_rel_error", 1e-3)], Rows),
        new("G21", "stiff springs of joints: distance, wheel, at the end of a lever",
            [
                .. EachSetting("sag_rel_error", 1e-4), .. EachSetting("frequency_rel_error", 1e-3), .. EachSetting("damping_error", 1e-2),
            ],
            Stiff),
    ];

    private static List<Figure> EachSetting(string metric, double limit)
    {
        var figures = new List<Figure>();
        foreach (Setting setting in Enum.GetValues<Setting>())
        {
            figures.Add(new Figure(Of(metric, setting), limit));
        }

        return figures;
    }

    private static string Of(string metric, Setting setting) => $"{metric}_{setting.ToString().ToLowerInvariant()}";

    private static void Rows(GeneralRun run)
    {
        foreach (double stiffness in new[] { 1e2, 1e4, 1e6 })
        {
            Mode(run, stiffness, 1);
            Mode(run, stiffness, 10);
        }

        for (int i = 0; i < 20; i++)
        {
            Mode(run, run.Dice.Scale(1e2, 1e6), run.Dice.Whole(1, Masses));
        }
    }

    private static void Mode(GeneralRun run, double stiffness, int mode)
    {
        const double Amplitude = 0.01;
        string parameters = FormattableString.Invariant($"k = {stiffness:G4} N/m, mode {mode}");
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World(gravity: 0);
            double wave = Math.PI * mode / (Masses + 1);
            double omega = 2 * Math.Sqrt((float)stiffness) * Math.Sin(0.5 * wave);
            var masses = new List<Actor>();
            Actor before = rig.AddAnchor(0, 0);
            for (int i = 1; i <= Masses; i++)
            {
                Actor mass = rig.AddLoose(new Vec(i + (Amplitude * Math.Sin(wave * i)), 0), 1, 0.1);
                rig.AddPairSpring(before, mass, 1, stiffness);
                masses.Add(mass);
                before = mass;
            }

            rig.AddPairSpring(before, rig.AddAnchor(Masses + 1, 0), 1, stiffness);

            // The phase is read each step and held against the right one, so no whole turns are lost between steps.
            double phase = 0;
            double late = 0;
            double amplitude = 0;
            int steps = (int)Math.Ceiling(2 * Math.PI * Periods / (omega * rig.Dt));
            rig.RunSteps(steps, () =>
            {
                double place = 0;
                double speed = 0;
                for (int i = 1; i <= Masses; i++)
                {
                    double share = Math.Sin(wave * i) * 2 / (Masses + 1);
                    place += share * (masses[i - 1].Position.X - i);
                    speed += share * masses[i - 1].Velocity.X;
                }

                double now = Math.Atan2(-speed / omega, place);
                late += Math.IEEERemainder(now - phase - (omega * rig.Dt), 2 * Math.PI);
                phase = now;
                amplitude = Math.Sqrt((place * place) + (speed * speed / (omega * omega)));
            });
            run.Note("amplitude_rel_error", Math.Abs((amplitude / Amplitude) - 1), parameters);
            run.Note("frequency_rel_error", Math.Abs(late / (omega * rig.Time)), parameters);
        });
    }

    private static void Stiff(GeneralRun run)
    {
        foreach (Setting setting in Enum.GetValues<Setting>())
        {
            foreach (double frequency in _frequencies)
            {
                foreach (double ratio in _ratios)
                {
                    Spring(run, setting, frequency, ratio, 1);
                }
            }

            for (int i = 0; i < 20; i++)
            {
                Spring(run, setting, run.Dice.Between(5, 29), run.Dice.Next(), run.Dice.Between(0.6, 1));
            }
        }
    }

    private static void Spring(GeneralRun run, Setting setting, double frequency, double ratio, double reach)
    {
        string where = setting == Setting.Lever ? FormattableString.Invariant($", {reach:G3} of the lever") : string.Empty;
        string parameters = FormattableString.Invariant($"{frequency:G4} Hz, damping ratio {ratio:G4}{where}");
        run.Sample(parameters, () =>
        {
            Swing(run, setting, frequency, ratio, reach, parameters);
            if (ratio >= 0.3)
            {
                Sag(run, setting, frequency, ratio, reach, parameters);
            }
        });
    }

    private static void Swing(GeneralRun run, Setting setting, double frequency, double ratio, double reach, string parameters)
    {
        const double Start = 1e-3;
        using Rig rig = run.World(gravity: 0);
        Actor mass = Attach(rig, setting, frequency, ratio, reach, Start);
        var samples = new List<double> { Way(mass, setting, reach) };
        rig.Run(12 / frequency, () => samples.Add(Way(mass, setting, reach)));
        Springs.Modes(samples, rig.Dt, out double turn, out double decay);
        double found = Math.Sqrt((turn * turn) + (decay * decay));
        run.Note(Of("frequency_rel_error", setting), Math.Abs((found / (2 * Math.PI * (float)frequency)) - 1), parameters);
        run.Note(Of("damping_error", setting), Math.Abs((decay / found) - ratio), parameters);
    }

    private static void Sag(GeneralRun run, Setting setting, double frequency, double ratio, double reach, string parameters)
    {
        // Little enough that the lever's arc does not matter.
        const double Gravity = 1;
        using Rig rig = run.World(Gravity);
        Actor mass = Attach(rig, setting, frequency, ratio, reach, 0);
        rig.Run(5);
        double omega = 2 * Math.PI * (float)frequency;
        double exact = Gravity / (omega * omega);

        // A rod about its end: the moment of its weight over the moment of inertia, 3/2 g/L, at the spring's place on it.
        exact *= setting == Setting.Lever ? 1.5 * reach : 1;
        run.Note(Of("sag_rel_error", setting), Math.Abs((-Way(mass, setting, reach) / exact) - 1), parameters);
    }

    /// <summary>A mass of 1 kg on a spring to a place above it, drawn out by some way; the lever is a rod of 1 m on a hinge.</summary>
    private static Actor Attach(Rig rig, Setting setting, double frequency, double ratio, double reach, double way)
    {
        Actor anchor = rig.AddAnchor(0, 0);
        if (setting == Setting.Lever)
        {
            double angle = way / reach;
            Actor rod = rig.AddLooseBox(new Vec(0.5, 0).Turned(angle), 1, 0, angle, 1);
            rig.AddHinge(anchor, rod, new Vec(0, 0));
            Distance(anchor, rod, new Vec(reach, 1), new Vec(reach - 0.5, 0));
            return rod;
        }

        Actor mass = rig.AddLoose(new Vec(0, 0), 1, 0.1);
        if (setting == Setting.Wheel)
        {
            rig.Simulator.Add(new WheelJoint(anchor.Body, mass.Body, Vector2.Zero, Vector2.UnitY)
            {
                Frequency = (float)frequency,
                DampingRatio = (float)ratio,
            });
        }
        else
        {
            Distance(anchor, mass, new Vec(0, 1), new Vec(0, 0));
        }

        mass.Body.SetPosition(0, way);
        return mass;

        void Distance(Actor a, Actor b, Vec anchorA, Vec anchorB) => rig.Simulator.Add(new DistanceJoint(
            a.Body, new Vector2((float)anchorA.X, (float)anchorA.Y), b.Body, new Vector2((float)anchorB.X, (float)anchorB.Y))
        {
            TargetDistance = 1,
            Frequency = (float)frequency,
            DampingRatio = (float)ratio,
        });
    }

    private static double Way(Actor mass, Setting setting, double reach) =>
        setting == Setting.Lever ? mass.Position.Y + ((reach - 0.5) * Math.Sin(mass.Angle)) : mass.Position.Y;
}
