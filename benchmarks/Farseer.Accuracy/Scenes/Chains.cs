using System;
using System.Collections.Generic;
using System.Linq;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Accuracy.Scenes;

/// <summary>Chains and trees of hinges under load.</summary>
internal static class Chains
{
    private const int Links = 50;
    private const int Planks = 30;
    private const double Length = 25;
    private const double BridgeSize = 0.25;

    /// <summary>Of a reference: how many times more steps, and how many times more iterations.</summary>
    private static readonly int[] _finerSteps = [4, 8];
    private static readonly int[] _finerIterations = [1, 2, 4];

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S11_rope", "mass of the weight, kg", new(1e-3, 1e6), ["1", "100", "1000"],
            ["stretch_pct", "joint_error_max_mm", "peak_stretch_pct", "rms_speed_mmps"], Rope),
        new("S11b_rope_swing", "mass of the weight, kg", new(1e-3, 1e6), ["10", "100", "1000"],
            ["peak_total_separation_pct", "joint_error_peak_mm"], Swing),
        new("S12_bridge", "mass of the load over that of a plank", new(0.1, 1e5), ["10", "100", "1000"],
            [
                "joint_error_end_mm", "joint_error_peak_mm", "load_lost", "load_penetration_peak_mm", "load_penetration_end_mm",
                "rms_speed_mmps",
            ],
            Bridge),
        new("S12b_bridge_swing", "mass of the load over that of a plank", new(0.1, 1e5), ["10", "100"],
            ["swing_mmps", "swing_converged_mmps", "swing_spread_mmps", "swing_error_mmps", "swing_error_in_spreads"], BridgeSwing),
        new("S13_ragdoll", "height, m", new(0, 100), ["3"],
            ["limit_overrun_deg", "joint_error_peak_mm", "joint_error_end_mm", "rms_speed_mmps"], Ragdoll),
    ];

    private static void Rope(Trial trial) => trial.World(
        rig =>
        {
            Actor weight = MakeRope(rig, trial.Parameter, new Vec(0, -1));
            double peak = 0;
            double worst = 0;
            double stretch = 0;
            int steps = rig.StepsIn(10);
            int last = rig.StepsIn(1);
            int step = 0;
            double rms = Metrics.RunForRmsSpeed(rig, 10, () =>
            {
                peak = Math.Max(peak, rig.TotalHingeError());
                if (++step > steps - last)
                {
                    worst = Math.Max(worst, rig.LargestHingeError());
                    Vec end = weight.Position + new Vec(0, 0.5).Turned(weight.Angle);
                    stretch += Math.Abs(end.Length - Length) / last;
                }
            });
            trial.Record("stretch_pct", 100 * stretch / Length);
            trial.Record("joint_error_max_mm", 1000 * worst);
            trial.Record("peak_stretch_pct", 100 * peak / Length);
            trial.Record("rms_speed_mmps", 1000 * rms);
        });

    private static void Swing(Trial trial) => trial.World(
        rig =>
        {
            MakeRope(rig, trial.Parameter, new Vec(1, 0));
            double total = 0;
            double worst = 0;
            rig.Run(10, () =>
            {
                total = Math.Max(total, rig.TotalHingeError());
                worst = Math.Max(worst, rig.LargestHingeError());
            });
            trial.Record("peak_total_separation_pct", 100 * total / Length);
            trial.Record("joint_error_peak_mm", 1000 * worst);
        });

    /// <summary>A straight rope from the origin with a weight at its end, which is returned.</summary>
    public static Actor MakeRope(Rig rig, double mass, Vec along)
    {
        double angle = Math.Atan2(along.X, -along.Y);
        Actor before = rig.AddAnchor(0, 0);
        for (int i = 0; i < Links; i++)
        {
            Actor link = rig.AddLooseBox((0.25 + (0.5 * i)) * along, 0.125, 0.5, angle, 1);
            rig.AddHinge(before, link, 0.5 * i * along);
            before = link;
        }

        Actor weight = rig.AddLoose((Length + 0.5) * along, mass, 0.5 * mass * 0.25);
        rig.AddHinge(before, weight, Length * along);
        return weight;
    }

    private static void Bridge(Trial trial) => trial.World(
        rig =>
        {
            (List<Actor> planks, Actor load) = MakeBridge(rig, trial.Parameter);
            double peak = 0;
            double last = 0;
            double depth = 0;
            double lastDepth = 0;
            int steps = rig.StepsIn(10);
            int step = 0;
            double rms = Metrics.RunForRmsSpeed(rig, 10, () =>
            {
                double error = rig.LargestHingeError();
                double penetration = Metrics.Penetration(planks, load);
                peak = Math.Max(peak, error);
                depth = Math.Max(depth, penetration);
                if (++step > steps - rig.StepsIn(1))
                {
                    last = Math.Max(last, error);
                    lastDepth = Math.Max(lastDepth, penetration);
                }
            });
            trial.Record("joint_error_end_mm", 1000 * last);
            trial.Record("joint_error_peak_mm", 1000 * peak);
            trial.Record("load_lost", load.Position.Y > -30 ? 0 : 1);
            trial.Record("load_penetration_peak_mm", 1000 * depth);
            trial.Record("load_penetration_end_mm", 1000 * lastDepth);
            trial.Record("rms_speed_mmps", 1000 * rms);
        });

    /// <summary>
    /// The speed of S12's tenth second is true swinging, so its size says nothing of a solver: more of it can be right and less wrong. Held
    /// against it is the mean of runs of 4 to 32 times finer substeps, of which the depth of the load has gone; their spread is what chaos
    /// leaves open.
    /// </summary>
    private static void BridgeSwing(Trial trial)
    {
        double swing = 0;
        trial.World(rig => swing = SwingOfBridge(rig, trial.Parameter));
        var finer = new List<double>();
        foreach (int share in _finerSteps)
        {
            foreach (int times in _finerIterations)
            {
                Dial dial = trial.Dial with { Iterations = times * trial.Dial.Iterations, Dt = trial.Dial.Dt / share };
                Trial.Reference(dial, rig => finer.Add(SwingOfBridge(rig, trial.Parameter)));
            }
        }

        double mean = finer.Average();
        double spread = Math.Sqrt(finer.Sum(one => (one - mean) * (one - mean)) / (finer.Count - 1));
        trial.Record("swing_mmps", swing);
        trial.Record("swing_converged_mmps", mean);
        trial.Record("swing_spread_mmps", spread);
        trial.Record("swing_error_mmps", Math.Abs(swing - mean));
        trial.Record("swing_error_in_spreads", Math.Abs(swing - mean) / spread);
    }

    private static double SwingOfBridge(Rig rig, double ratio)
    {
        MakeBridge(rig, ratio);
        return 1000 * Metrics.RunForRmsSpeed(rig, 10);
    }

    private static (List<Actor> Planks, Actor Load) MakeBridge(Rig rig, double ratio)
    {
        // 30 chords of 1 m on an arc whose chord is 28 m: sin(15 f) / sin(f / 2) = 28.
        double low = 1e-3;
        double high = 0.2;
        for (int i = 0; i < 100; i++)
        {
            double middle = (low + high) / 2;
            (low, high) = Math.Sin(15 * middle) / Math.Sin(middle / 2) > 28 ? (middle, high) : (low, middle);
        }

        Actor before = rig.AddAnchor(-14, 0);
        var planks = new List<Actor>();
        Vec end = new(-14, 0);
        for (int i = 0; i < Planks; i++)
        {
            double angle = (i - 14.5) * low;
            Vec along = new(Math.Cos(angle), Math.Sin(angle));
            Actor plank = rig.AddBox(end.X + (0.5 * along.X), end.Y + (0.5 * along.Y), 1, 0.25, angle, 20);
            rig.SetGroup(plank, 1);
            rig.AddHinge(before, plank, end);
            planks.Add(plank);
            before = plank;
            end += along;
        }

        rig.AddHinge(before, rig.AddAnchor(14, 0), end);
        Vec centre = 0.5 * (planks[14].Position + planks[15].Position);
        return (planks, rig.AddBox(0, centre.Y + 0.125 + 0.1 + 1, 2, 2, 0, 5 * ratio / 4));
    }

    private static void Ragdoll(Trial trial) => trial.World(
        rig =>
        {
            double h = trial.Parameter;
            rig.AddGround();
            Actor torso = Part(rig.AddBox(0, 1.35 + h, 0.4, 0.6), rig);
            Actor pelvis = Part(rig.AddBox(0, 0.9 + h, 0.4, 0.3), rig);
            Actor head = Part(rig.AddCircle(0, 1.85 + h, 0.2), rig);
            Join(rig, torso, pelvis, 0, 1.05 + h);
            Join(rig, torso, head, 0, 1.65 + h);
            for (int side = -1; side <= 1; side += 2)
            {
                Actor upperArm = Part(rig.AddBox(0.28 * side, 1.4 + h, 0.12, 0.4), rig);
                Actor lowerArm = Part(rig.AddBox(0.28 * side, 1.0 + h, 0.12, 0.4), rig);
                Actor upperLeg = Part(rig.AddBox(0.12 * side, 0.55 + h, 0.14, 0.4), rig);
                Actor lowerLeg = Part(rig.AddBox(0.12 * side, 0.15 + h, 0.14, 0.4), rig);
                Join(rig, torso, upperArm, 0.28 * side, 1.6 + h);
                Join(rig, upperArm, lowerArm, 0.28 * side, 1.2 + h);
                Join(rig, pelvis, upperLeg, 0.12 * side, 0.75 + h);
                Join(rig, upperLeg, lowerLeg, 0.12 * side, 0.35 + h);
            }

            double overrun = 0;
            double peak = 0;
            double last = 0;
            int steps = rig.StepsIn(10);
            int step = 0;
            double rms = Metrics.RunForRmsSpeed(rig, 10, () =>
            {
                double error = rig.LargestHingeError();
                peak = Math.Max(peak, error);
                last = ++step > steps - rig.StepsIn(1) ? Math.Max(last, error) : 0;
                foreach (Hinge hinge in rig.Hinges)
                {
                    overrun = Math.Max(overrun, (Math.Abs(hinge.Angle) * 180 / Math.PI) - 45);
                }
            });
            trial.Record("limit_overrun_deg", overrun);
            trial.Record("joint_error_peak_mm", 1000 * peak);
            trial.Record("joint_error_end_mm", 1000 * last);
            trial.Record("rms_speed_mmps", 1000 * rms);
        });

    private static Actor Part(Actor actor, Rig rig)
    {
        rig.SetGroup(actor, 1);
        return actor;
    }

    private static void Join(Rig rig, Actor a, Actor b, double x, double y)
    {
        RevoluteJoint joint = rig.AddHinge(a, b, new Vec(x, y));
        joint.AreLimitsEnabled = true;
        joint.LowerLimit = (float)(-Math.PI / 4);
        joint.UpperLimit = (float)(Math.PI / 4);
    }
}
