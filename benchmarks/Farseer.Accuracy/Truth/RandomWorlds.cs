using System;
using System.Collections.Generic;
using Farseer.Accuracy.General;

namespace Farseer.Accuracy.Truth;

/// <summary>Boxes, circles, rods and chains of hinges dropped in a pit: nothing may win energy.</summary>
internal static class RandomWorlds
{
    private const int Worlds = 40;
    private const double Seconds = 10;
    private const double Gravity = 10;
    private const double PitHalf = 5;
    private const double Cell = 2.5;

    /// <summary>As of the general scenes with pits and ragdolls.</summary>
    private const double LargestRise = 1e-3;

    public static void Add(List<TruthFigure> figures, uint seed)
    {
        for (int i = 0; i < Worlds; i++)
        {
            figures.Add(new($"world {i} energy_rise", Rise(new Dice(seed, $"world {i}")), LargestRise, false));
        }
    }

    /// <summary>Largest rise of the energy above its running minimum, of its start.</summary>
    private static double Rise(Dice dice)
    {
        using var rig = new Rig(GeneralSettings.Default.Dial, Gravity, 1);
        rig.Friction = dice.Between(0, 0.8);
        rig.Restitution = dice.Next() < 0.5 ? 0 : dice.Between(0, 0.6);
        Loops.AddPit(rig, PitHalf);
        int things = dice.Whole(6, 20);
        int columns = (int)(2 * PitHalf / Cell);
        for (int i = 0; i < things; i++)
        {
            AddThing(rig, dice, new Vec(-PitHalf + (Cell * ((i % columns) + 0.5)), Cell * ((i / columns) + 0.6)));
        }

        var energy = new RunningRise(rig);
        try
        {
            rig.Run(Seconds, energy.Look);
        }
        catch (ExplodedException)
        {
            return Runner.Exploded;
        }

        return energy.Rise / energy.Start;
    }

    private static void AddThing(Rig rig, Dice dice, Vec at)
    {
        double density = dice.Scale(0.2, 20);
        switch (dice.Whole(0, 3))
        {
            case 0:
                rig.AddBox(at.X, at.Y, dice.Between(0.2, 1.2), dice.Between(0.2, 1.2), dice.Angle(), density);
                break;
            case 1:
                double radius = dice.Between(0.1, 0.7);
                rig.AddCircle(at.X, at.Y, radius, density * Math.PI * radius * radius);
                break;
            case 2:
                rig.AddBox(at.X, at.Y, dice.Between(1, 2.2), dice.Between(0.08, 0.2), dice.Angle(), density);
                break;
            default:
                AddChain(rig, dice, at, density);
                break;
        }
    }

    private static void AddChain(Rig rig, Dice dice, Vec middle, double density)
    {
        int links = dice.Whole(2, 6);
        double length = 2.2 / links;
        double angle = dice.Between(-0.3, 0.3);
        Vec along = new Vec(length, 0).Turned(angle);
        Vec corner = middle - (0.5 * links * along);
        Actor? before = null;
        for (int i = 0; i < links; i++)
        {
            Vec centre = corner + (0.5 * along);
            Actor link = rig.AddBox(centre.X, centre.Y, length, 0.1, angle, density);
            if (before is not null)
            {
                rig.AddHinge(before, link, corner).CollideConnected = false;
            }

            before = link;
            corner += along;
        }
    }
}
