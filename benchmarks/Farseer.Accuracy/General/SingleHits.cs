using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>One body hits a floor once, without gravity and friction.</summary>
internal static class SingleHits
{
    private const int Angles = 40;
    private const double Speed = 5;
    private const double Clearance = 0.01;

    private static readonly double[] _spins = [0, 2, 5, 10, 20];
    private static readonly double[] _tilts = [0.001, 0.003, 0.01, 0.03, 0.1, 0.35];

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G01", "one spinning hit of a box, restitution 1", [new("energy_mean_change", 1e-4)],
            run => Spinning(run, Solid.Box1, "energy_mean_change")),
        new("G02", "one spinning hit of other shapes, restitution 1",
            [.. Others().ConvertAll(solid => new Figure(MeanOf(solid), 1e-4))],
            run => Others().ForEach(solid => Spinning(run, solid, MeanOf(solid)))),
        new("G03", "flat landing, restitution 1", [new("energy_change_box", 1e-3), new("energy_change_rod", 1e-3)], Flat),
        new("G08", "corner hit, restitution 0", [new("omega_error_radps", 1e-4), new("vy_error_mps", 1e-4)], Corner),
    ];

    private static List<Solid> Others() => [Solid.Rod, Solid.Triangle, Solid.Hexagon, Solid.Capsule, Solid.Cross];

    private static string MeanOf(Solid solid) => "energy_mean_" + solid.Name.Split(' ')[0];

    private static void Spinning(GeneralRun run, Solid solid, string figure)
    {
        var spins = new List<double>(_spins);
        for (int i = 0; i < _spins.Length; i++)
        {
            spins.Add(run.Dice.Between(-20, 20));
        }

        foreach (double spin in spins)
        {
            string parameters = FormattableString.Invariant($"{solid.Name}, spin {spin:G4} rad/s, {Angles} angles");
            run.Sample(parameters, () =>
            {
                double sum = 0;
                for (int i = 0; i < Angles; i++)
                {
                    sum += EnergyChange(run, solid, spin, 2 * Math.PI * i / (Angles * solid.Symmetry));
                }

                run.Note(figure, sum / Angles, parameters);
            });
        }
    }

    private static void Flat(GeneralRun run)
    {
        var tilts = new List<double>(_tilts) { 0 };
        for (int i = 0; i < 30; i++)
        {
            tilts.Add(run.Dice.Scale(1e-4, 0.35) * (i % 2 == 0 ? 1 : -1));
        }

        foreach ((Solid solid, string figure) in new[] { (Solid.Box1, "energy_change_box"), (Solid.Rod, "energy_change_rod") })
        {
            foreach (double tilt in tilts)
            {
                string parameters = FormattableString.Invariant($"{solid.Name}, tilt {tilt:G4} rad");
                run.Sample(parameters, () => run.Note(figure, EnergyChange(run, solid, 0, tilt), parameters));
            }
        }
    }

    /// <summary>Share of the energy that a hit takes or gives; measured when the body has left the floor.</summary>
    private static double EnergyChange(GeneralRun run, Solid solid, double spin, double angle)
    {
        using Rig rig = run.World(gravity: 0);
        rig.Friction = 0;
        rig.Restitution = 1;
        rig.AddGround();

        // The hit falls anywhere within a step.
        double height = solid.Radius + 1 + (run.Dice.Next() * Speed * rig.Dt);
        Actor body = solid.Add(rig, new Vec(0, height), angle);
        body.Velocity = new Vec(0, -Speed);
        body.Spin = spin;
        double start = body.KineticEnergy;
        int most = rig.StepsIn(4);
        do
        {
            rig.Step();
        }
        while ((body.Velocity.Y <= 0 || solid.Lowest(body) < Clearance) && rig.Steps < most);
        return Math.Abs((body.KineticEnergy / start) - 1);
    }

    private static void Corner(GeneralRun run)
    {
        var cases = new List<(double Spin, double Angle)>();
        for (int spin = 0; spin <= 20; spin++)
        {
            cases.Add((spin, 0.35));
        }

        for (int i = 0; i < 100; i++)
        {
            cases.Add((run.Dice.Between(-20, 20), run.Dice.Angle()));
        }

        foreach ((double spin, double angle) in cases)
        {
            string parameters = FormattableString.Invariant($"spin {spin:G4} rad/s, angle {angle:G4}");
            run.Sample(parameters, () => CornerHit(run, spin, angle, parameters));
        }
    }

    private static void CornerHit(GeneralRun run, double spin, double angle, string parameters)
    {
        using Rig rig = run.World(gravity: 0);
        rig.Friction = 0;
        Actor ground = rig.AddGround();
        Actor box = rig.AddBox(0, 2, 1, 1, angle);
        box.Velocity = new Vec(0, -Speed);
        box.Spin = spin;
        Touch? touch = FirstTouch.Find(Flyer.Of(box), Flyer.Of(ground), 2);
        if (touch is null || !touch.IsOnePoint)
        {
            return;
        }

        // Without a second hit before the look at it, the corner's stop is all there was.
        int steps = (int)Math.Ceiling(touch.Time / rig.Dt) + 1;
        (Flyer after, Flyer floor) = FirstTouch.Newton(touch, 0);
        if (FirstTouch.StayApart(after, floor, ((steps + 1) * rig.Dt) - touch.Time))
        {
            rig.RunSteps(steps);
            run.Note("omega_error_radps", Math.Abs(box.Spin - after.Spin), parameters);
            run.Note("vy_error_mps", Math.Abs(box.Velocity.Y - after.Velocity.Y), parameters);
        }
    }
}
