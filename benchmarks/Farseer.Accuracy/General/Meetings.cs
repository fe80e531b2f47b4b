using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>Two free boxes meet, without gravity and friction.</summary>
internal static class Meetings
{
    private const int Pairs = 200;

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G05", "two boxes meet, restitution 1: of 200 those whose energy changes by more than 1 %",
            [new("pairs_off_boxes_1x1", 0), new("pairs_off_any_size", 0), new("momentum_change", 1e-5)], Elastic),
        new("G06", "two boxes meet, less than elastic: energy after the first impact, against Newton's rule",
            [new("energy_error_e0.5", 0.01), new("energy_error_any_e_and_size", 0.01)], Newton),
    ];

    private static void Elastic(GeneralRun run)
    {
        foreach (bool anySize in new[] { false, true })
        {
            int off = 0;
            for (int i = 0; i < Pairs; i++)
            {
                string parameters = $"{(anySize ? "any size" : "1x1")}, pair {i}";
                run.Sample(parameters, () =>
                {
                    using Rig rig = run.World(gravity: 0);
                    rig.Restitution = 1;
                    (Actor a, Actor b) = AddPair(rig, run.Dice, anySize);
                    double energy = Bookkeeping.Kinetic(rig.Actors);
                    Vec momentum = Bookkeeping.Momentum(rig.Actors);
                    double moved = (a.Mass * a.Velocity.Length) + (b.Mass * b.Velocity.Length);
                    rig.Run(2);
                    off += Math.Abs((Bookkeeping.Kinetic(rig.Actors) / energy) - 1) > 0.01 ? 1 : 0;
                    run.Note("momentum_change", (Bookkeeping.Momentum(rig.Actors) - momentum).Length / moved, parameters);
                });
            }

            run.Note(anySize ? "pairs_off_any_size" : "pairs_off_boxes_1x1", off, $"{Pairs} pairs");
        }
    }

    private static void Newton(GeneralRun run)
    {
        foreach (bool any in new[] { false, true })
        {
            for (int i = 0; i < Pairs; i++)
            {
                double e = any ? run.Dice.Next() : 0.5;
                string parameters = FormattableString.Invariant($"pair {i}, restitution {e:G4}");
                run.Sample(parameters, () => Meet(run, any, e, parameters));
            }
        }
    }

    private static void Meet(GeneralRun run, bool any, double e, string parameters)
    {
        using Rig rig = run.World(gravity: 0);
        rig.Restitution = e;
        (Actor a, Actor b) = AddPair(rig, run.Dice, any);
        Touch? touch = FirstTouch.Find(Flyer.Of(a), Flyer.Of(b), 2);
        if (touch is null || !touch.IsOnePoint)
        {
            return;
        }

        int steps = (int)Math.Ceiling(touch.Time / rig.Dt) + 1;
        (Flyer afterA, Flyer afterB) = FirstTouch.Newton(touch, e);
        if (!FirstTouch.StayApart(afterA, afterB, ((steps + 1) * rig.Dt) - touch.Time))
        {
            return;
        }

        double start = Bookkeeping.Kinetic(rig.Actors);
        rig.RunSteps(steps);
        double error = Math.Abs(Bookkeeping.Kinetic(rig.Actors) - afterA.Energy - afterB.Energy) / start;
        run.Note(any ? "energy_error_any_e_and_size" : "energy_error_e0.5", error, parameters);
    }

    /// <summary>Two boxes out of each other's reach, the second flying at the first with an offset.</summary>
    private static (Actor A, Actor B) AddPair(Rig rig, Dice dice, bool anySize)
    {
        rig.Friction = 0;
        Vec sizeA = anySize ? new Vec(dice.Scale(0.2, 2), dice.Scale(0.2, 2)) : new Vec(1, 1);
        Vec sizeB = anySize ? new Vec(dice.Scale(0.2, 2), dice.Scale(0.2, 2)) : new Vec(1, 1);
        Vec along = dice.Direction();
        double reach = 0.5 * (sizeA.Length + sizeB.Length);
        Vec place = (reach + dice.Between(0.02, 0.4)) * along;
        Vec aside = (dice.Between(-0.45, 0.45) * reach) * new Vec(-along.Y, along.X);
        Actor a = rig.AddBox(0, 0, sizeA.X, sizeA.Y, dice.Angle());
        Actor b = rig.AddBox(place.X + aside.X, place.Y + aside.Y, sizeB.X, sizeB.Y, dice.Angle());
        Vec drift = dice.Between(0, 2) * dice.Direction();
        a.Velocity = drift;
        b.Velocity = drift - (dice.Between(2, 10) * along);
        a.Spin = dice.Between(-10, 10);
        b.Spin = dice.Between(-10, 10);
        return (a, b);
    }
}
