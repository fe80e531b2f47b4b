using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Scenes;

/// <summary>Sliding and rolling on a level face and on an incline; the references are closed forms.</summary>
internal static class Friction
{
    private const double Gravity = 10;
    private const int Bisections = 14;
    private const double SlideThreshold = 1e-3;

    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        new("S05_friction_slide", "friction", new(0.03, 2), ["0.1", "0.3", "0.6"], ["dist_rel_error", "residual_speed_mps"], Slide),
        new("S06_incline", "friction", new(0.05, 1), ["0.5"],
            ["threshold_error_deg", "creep_mm_per_s_at_0.9", "slide_dist_rel_error_at_1.2"], Incline),
        new("S07_roll", "slope, degrees", new(0.1, 40), ["20"], ["dist_rel_error", "speed_rel_error"], Roll),
    ];

    private static void Slide(Trial trial) => trial.World(rig =>
    {
        double mu = trial.Parameter;
        rig.Friction = mu;
        rig.AddStaticBox(0, -0.5, 200, 1);
        Actor box = rig.AddBox(-40, 0.5, 1, 1);
        box.Velocity = new Vec(10, 0);
        rig.Run((10 / (Gravity * mu)) + 3);
        double exact = 100 / (2 * mu * Gravity);
        trial.Record("dist_rel_error", Math.Abs(box.Displacement.X - exact) / exact);
        trial.Record("residual_speed_mps", box.Velocity.Length);
    });

    private static void Incline(Trial trial)
    {
        double mu = trial.Parameter;
        double critical = Math.Atan(mu);
        double holds = 0.7 * critical;
        double slides = 1.3 * critical;
        for (int i = 0; i < Bisections; i++)
        {
            double middle = 0.5 * (holds + slides);
            double slipped = 0;
            OnIncline(trial, middle, mu, slip =>
            {
                slip.Rig.Run(1);
                double at1 = slip.Along;
                slip.Rig.Run(2);
                slipped = Math.Abs(slip.Along - at1);
            });
            if (slipped > SlideThreshold)
            {
                slides = middle;
            }
            else
            {
                holds = middle;
            }
        }

        trial.Record("threshold_error_deg", Math.Abs((0.5 * (holds + slides)) - critical) * 180 / Math.PI);
        OnIncline(trial, 0.9 * critical, mu, slip =>
        {
            slip.Rig.Run(2);
            double at2 = slip.Along;
            double t2 = slip.Rig.Time;
            slip.Rig.Run(10);
            trial.Record("creep_mm_per_s_at_0.9", 1000 * Math.Abs(slip.Along - at2) / (slip.Rig.Time - t2));
        });
        double steep = 1.2 * critical;
        OnIncline(trial, steep, mu, slip =>
        {
            slip.Rig.Run(2);
            double t = slip.Rig.Time;
            double exact = 0.5 * Gravity * (Math.Sin(steep) - (mu * Math.Cos(steep))) * t * t;
            trial.Record("slide_dist_rel_error_at_1.2", Math.Abs(slip.Along - exact) / exact);
        });
    }

    private static void OnIncline(Trial trial, double theta, double mu, Action<Slope> measure) => trial.World(rig =>
    {
        rig.Friction = mu;
        var slope = new Slope(rig, theta);
        slope.Place(20, (x, y) => rig.AddBox(x, y, 1, 1, -theta));
        measure(slope);
    });

    private static void Roll(Trial trial) => trial.World(rig =>
    {
        double theta = trial.Parameter * Math.PI / 180;
        rig.Friction = 0.9;
        var slope = new Slope(rig, theta);
        slope.Place(40, (x, y) => rig.AddCircle(x, y, 0.5));
        rig.Run(4);
        double acceleration = 2.0 / 3.0 * Gravity * Math.Sin(theta);
        double t = rig.Time;
        double distance = 0.5 * acceleration * t * t;
        double speed = acceleration * t;
        trial.Record("dist_rel_error", Math.Abs(slope.Along - distance) / distance);
        trial.Record("speed_rel_error", Math.Abs(slope.Speed - speed) / speed);
    });

    /// <summary>A static box 100×1 at the origin turned by -θ, and a body of half height 0.5 on its upper face.</summary>
    private sealed class Slope
    {
        private readonly Vec _downhill;
        private readonly Vec _outward;
        private Actor? _body;

        public Slope(Rig rig, double theta)
        {
            Rig = rig;
            _downhill = new Vec(1, 0).Turned(-theta);
            _outward = new Vec(0, 1).Turned(-theta);
            rig.AddStaticBox(0, 0, 100, 1, -theta);
        }

        public Rig Rig { get; }

        public double Along => Vec.Dot(_body!.Displacement, _downhill);

        public double Speed => Vec.Dot(_body!.Velocity, _downhill);

        public void Place(double uphill, Func<double, double, Actor> add)
        {
            Vec position = _outward - (uphill * _downhill);
            _body = add(position.X, position.Y);
        }
    }
}
