using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>A free body tows another by a slack chain: momentum is kept, energy is never won.</summary>
internal static class Towing
{
    private const double Link = 0.25;
    private const double Speed = 5;
    private const double Seconds = 5;

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G11", "tow: a slack chain between two free bodies, no gravity",
            [new("momentum_change", 1e-6), new("energy_gain", 1e-4)], Tows),
    ];

    private static void Tows(GeneralRun run)
    {
        foreach (int links in new[] { 1, 2, 3, 5, 9 })
        {
            foreach (double bend in new[] { 0.3, 0.8, 1.2, 1.4 })
            {
                foreach (double mass in new[] { 10.0, 100, 1000, 1e4 })
                {
                    Tow(run, links, bend, mass, mass);
                }
            }
        }

        for (int i = 0; i < 30; i++)
        {
            Tow(run, run.Dice.Whole(1, 20), run.Dice.Between(0.1, 1.5), run.Dice.Scale(1, 1e4), run.Dice.Scale(1, 1e4));
        }
    }

    private static void Tow(GeneralRun run, int links, double bend, double first, double last)
    {
        string parameters = FormattableString.Invariant($"{links} links at +-{bend:G4}, {first:G4} and {last:G4} kg");
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World(gravity: 0);
            Actor before = rig.AddLooseBox(new Vec(-0.5, 0), 1, 1, 0, first);
            Vec corner = new(0, 0);
            for (int i = 0; i < links; i++)
            {
                double angle = i % 2 == 0 ? bend : -bend;
                Vec along = new Vec(Link, 0).Turned(angle);
                Actor link = rig.AddLooseBox(corner + (0.5 * along), Link, 0.05, angle, 1);
                rig.AddHinge(before, link, corner);
                before = link;
                corner += along;
            }

            Actor towing = rig.AddLooseBox(corner + new Vec(0.5, 0), 1, 1, 0, last);
            rig.AddHinge(before, towing, corner);
            towing.Velocity = new Vec(Speed, 0);
            Vec momentum = Bookkeeping.Momentum(rig.Actors);
            double energy = Bookkeeping.Kinetic(rig.Actors);
            double change = 0;
            double most = energy;
            rig.Run(Seconds, () =>
            {
                change = Math.Max(change, (Bookkeeping.Momentum(rig.Actors) - momentum).Length);
                most = Math.Max(most, Bookkeeping.Kinetic(rig.Actors));
            });
            run.Note("momentum_change", change / momentum.Length, parameters);
            run.Note("energy_gain", (most / energy) - 1, parameters);
        });
    }
}
