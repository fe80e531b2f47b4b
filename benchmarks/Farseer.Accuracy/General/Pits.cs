using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>A pit of everything at once.</summary>
internal static class Pits
{
    private const double Half = 12;
    private const double CellWidth = 4;
    private const double CellHeight = 3.2;
    private const double Gravity = 10;

    private static readonly Solid[] _small = [Solid.Triangle, Solid.Hexagon, Solid.Cross];

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G27", "pit of bodies, ragdolls, open and closed chains, planks",
            [new("energy_rise", 1e-3), new("speed_end_mps", 0.01)], Pit),
    ];

    private static void Pit(GeneralRun run)
    {
        double seconds = run.IsFull ? 600 : 30;
        for (int i = 0; i < 2; i++)
        {
            string parameters = $"pit {i}, {seconds} s";
            run.Sample(parameters, () =>
            {
                using Rig rig = run.World(Gravity);
                Fill(rig, run.Dice);
                var energy = new RunningRise(rig);
                rig.Run(seconds, energy.Look);
                run.Note("energy_rise", energy.Rise / energy.Start, parameters);
                run.Note("speed_end_mps", Bookkeeping.Fastest(rig.Actors), parameters);
            });
        }
    }

    private static void Fill(Rig rig, Dice dice)
    {
        Loops.AddPit(rig, Half);
        var waiting = new List<Action<Vec>>();
        Repeat(8, place => Ragdolls.Add(rig, dice, place, dice.Angle()));
        Repeat(6, place => AddChain(rig, place, 8));
        Repeat(4, place => Loops.AddRing(rig, place, dice.Whole(8, 16), dice.Angle()));
        Repeat(5, place => Spread(place, at => rig.AddBox(at.X, at.Y, 1, 0.15, dice.Angle())));
        Repeat(15, place => Spread(place, at => AddBody(rig, dice, at)));

        int columns = (int)(2 * Half / CellWidth);
        for (int cell = 0; waiting.Count > 0; cell++)
        {
            int chosen = dice.Whole(0, waiting.Count - 1);
            waiting[chosen](new Vec(-Half + (CellWidth * ((cell % columns) + 0.5)), CellHeight * ((cell / columns) + 0.6)));
            waiting.RemoveAt(chosen);
        }

        void Repeat(int count, Action<Vec> add)
        {
            for (int i = 0; i < count; i++)
            {
                waiting.Add(add);
            }
        }
    }

    /// <summary>Four to a cell.</summary>
    private static void Spread(Vec place, Action<Vec> add)
    {
        for (int i = 0; i < 4; i++)
        {
            add(place + new Vec(i % 2 == 0 ? -1 : 1, i / 2 == 0 ? -0.7 : 0.7));
        }
    }

    private static void AddBody(Rig rig, Dice dice, Vec at)
    {
        switch (dice.Whole(0, 3))
        {
            case 0:
                rig.AddBox(at.X, at.Y, dice.Between(0.3, 0.9), dice.Between(0.3, 0.9), dice.Angle());
                break;
            case 1:
                rig.AddCircle(at.X, at.Y, dice.Between(0.2, 0.6));
                break;
            case 2:
                dice.Of(_small).Add(rig, at, dice.Angle());
                break;
            default:
                rig.AddCapsule(at, dice.Angle(), dice.Between(0.2, 0.6), dice.Between(0.1, 0.3));
                break;
        }
    }

    /// <summary>Boxes hinged end to end, lying across; neighbours do not collide.</summary>
    private static void AddChain(Rig rig, Vec place, int links)
    {
        const double Link = 0.4;
        Actor? before = null;
        for (int i = 0; i < links; i++)
        {
            double x = place.X + (Link * (i - (0.5 * links)));
            Actor link = rig.AddBox(x + (0.5 * Link), place.Y, Link, 0.15);
            if (before is not null)
            {
                rig.AddHinge(before, link, new Vec(x, place.Y)).CollideConnected = false;
            }

            before = link;
        }
    }
}
