using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>Bodies that bounce for long: in a closed room, on a floor, many at once.</summary>
internal static class Rooms
{
    private const double Half = 4.5;

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G04", "closed box: one body for 60 s, restitution 1",
            [
                new("energy_median_g0", 5e-3), new("gain_worst_g0", 1e-2), new("energy_median_g10", 5e-3), new("gain_worst_g10", 1e-2),
            ],
            Closed),
        new("G07", "falling box: rise of energy above its running minimum", [new("rise_e0.8", 1e-3), new("rise_e1", 1e-3)], Falling),
        new("G10", "gas of 20 boxes for 60 s, restitution 1",
            [new("energy_change", 0.02), new("energy_change_free_room", 0.02), new("momentum_change_free_room", 0.02)], Gas),
    ];

    private static void Closed(GeneralRun run)
    {
        const int Seeds = 20;
        foreach (double gravity in new[] { 0.0, 10.0 })
        {
            foreach (Solid solid in Solid.All)
            {
                var changes = new List<double>();
                for (int seed = 0; seed < Seeds; seed++)
                {
                    string parameters = FormattableString.Invariant($"{solid.Name}, throw {seed}");
                    run.Sample(parameters, () =>
                    {
                        (double change, double gain) = Bounce(run, solid, gravity);
                        changes.Add(Math.Abs(change));
                        run.Note($"gain_worst_g{gravity}", gain, parameters);
                    });
                }

                run.Note($"energy_median_g{gravity}", Bookkeeping.Median(changes), $"{solid.Name}, {Seeds} throws");
            }
        }
    }

    private static (double Change, double Gain) Bounce(GeneralRun run, Solid solid, double gravity)
    {
        using Rig rig = run.World(gravity);
        rig.Friction = 0;
        rig.Restitution = 1;
        AddWalls(rig);
        Actor body = solid.Add(rig, new Vec(run.Dice.Between(-2, 2), run.Dice.Between(-2, 2)), run.Dice.Angle());
        body.Velocity = run.Dice.Between(2, 8) * run.Dice.Direction();
        body.Spin = run.Dice.Between(-10, 10);
        double Energy() => body.KineticEnergy + (body.Mass * gravity * (body.Position.Y + Half));
        double start = Energy();
        double most = start;
        rig.Run(60, () => most = Math.Max(most, Energy()));
        return ((Energy() / start) - 1, (most / start) - 1);
    }

    private static void Falling(GeneralRun run)
    {
        const int Throws = 200;
        foreach (double restitution in new[] { 0.8, 1.0 })
        {
            for (int i = 0; i < Throws; i++)
            {
                double spin = run.Dice.Between(-20, 20);
                double angle = run.Dice.Angle();
                string parameters = FormattableString.Invariant($"spin {spin:G4} rad/s, angle {angle:G4}");
                run.Sample(parameters, () =>
                {
                    using Rig rig = run.World();
                    rig.Friction = 0;
                    rig.Restitution = restitution;
                    rig.AddGround();
                    Actor box = rig.AddBox(0, run.Dice.Between(2, 4), 1, 1, angle);
                    box.Spin = spin;
                    var energy = new RunningRise(rig);
                    rig.Run(10, energy.Look);
                    run.Note(FormattableString.Invariant($"rise_e{restitution}"), energy.Rise / energy.Start, parameters);
                });
            }
        }
    }

    private static void Gas(GeneralRun run)
    {
        const int Seeds = 4;
        for (int seed = 0; seed < Seeds; seed++)
        {
            foreach (bool free in new[] { false, true })
            {
                // The first of each are boxes of 1 m, as stated; the others are of sizes of their own.
                string parameters = FormattableString.Invariant($"{(seed == 0 ? "boxes 1x1" : "boxes of any size")}, seed {seed}");
                run.Sample(parameters, () => GasIn(run, free, seed > 0, parameters));
            }
        }
    }

    /// <summary>In a room that is free to move itself the momentum of all is kept, and known without the forces on walls.</summary>
    private static void GasIn(GeneralRun run, bool free, bool anySize, string parameters)
    {
        using Rig rig = run.World(gravity: 0);
        rig.Friction = 0;
        rig.Restitution = 1;
        if (free)
        {
            Part[] walls =
            [
                new(new Vec(0, -Half - 0.5), (2 * Half) + 2, 1), new(new Vec(0, Half + 0.5), (2 * Half) + 2, 1),
                new(new Vec(-Half - 0.5, 0), 1, 2 * Half), new(new Vec(Half + 0.5, 0), 1, 2 * Half),
            ];
            rig.AddCompound(new Vec(0, 0), 0, 1000, 2e4, walls);
        }
        else
        {
            AddWalls(rig);
        }

        double moved = 0;
        for (int i = 0; i < 20; i++)
        {
            Vec at = new(-3.6 + (1.8 * (i % 5)), -2.7 + (1.8 * (i / 5)));
            double width = anySize ? run.Dice.Between(0.3, 1) : 1;
            double height = anySize ? run.Dice.Between(0.3, 1) : 1;
            Actor box = rig.AddBox(at.X, at.Y, width, height, run.Dice.Angle());
            box.Velocity = run.Dice.Between(1, 5) * run.Dice.Direction();
            box.Spin = run.Dice.Between(-5, 5);
            moved += box.Mass * box.Velocity.Length;
        }

        double energy = Bookkeeping.Kinetic(rig.Actors);
        Vec momentum = Bookkeeping.Momentum(rig.Actors);
        rig.Run(60);
        double change = Math.Abs((Bookkeeping.Kinetic(rig.Actors) / energy) - 1);
        run.Note(free ? "energy_change_free_room" : "energy_change", change, parameters);
        if (free)
        {
            run.Note("momentum_change_free_room", (Bookkeeping.Momentum(rig.Actors) - momentum).Length / moved, parameters);
        }
    }

    private static void AddWalls(Rig rig)
    {
        rig.AddStaticBox(0, -Half - 0.5, (2 * Half) + 2, 1);
        rig.AddStaticBox(0, Half + 0.5, (2 * Half) + 2, 1);
        rig.AddStaticBox(-Half - 0.5, 0, 1, 2 * Half);
        rig.AddStaticBox(Half + 0.5, 0, 1, 2 * Half);
    }
}
