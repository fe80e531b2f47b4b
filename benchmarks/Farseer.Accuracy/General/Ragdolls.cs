using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Accuracy.General;

/// <summary>The ragdoll of S13, with limbs that collide, dropped in any pose.</summary>
internal static class Ragdolls
{
    private const int Drops = 100;
    private const double Gravity = 10;
    private const double Bend = Math.PI / 4;

    /// <summary>Not at rest: a centre faster than this, m/s.</summary>
    private const double Moving = 0.01;

    /// <summary>The head, of which only the radius counts, and then the limbs.</summary>
    private static readonly Limb[] _limbs =
    [
        new(0, 1.35, 0.4, 0.6), new(0, 0.9, 0.4, 0.3), new(0, 1.85, 0.4, 0),
        new(-0.28, 1.4, 0.12, 0.4), new(-0.28, 1.0, 0.12, 0.4), new(0.28, 1.4, 0.12, 0.4), new(0.28, 1.0, 0.12, 0.4),
        new(-0.12, 0.55, 0.14, 0.4), new(-0.12, 0.15, 0.14, 0.4), new(0.12, 0.55, 0.14, 0.4), new(0.12, 0.15, 0.14, 0.4),
    ];

    /// <summary>Each after the one that carries it.</summary>
    private static readonly Pivot[] _pivots =
    [
        new(0, 1, 0, 1.05), new(0, 2, 0, 1.65),
        new(0, 3, -0.28, 1.6), new(3, 4, -0.28, 1.2), new(0, 5, 0.28, 1.6), new(5, 6, 0.28, 1.2),
        new(1, 7, -0.12, 0.75), new(7, 8, -0.12, 0.35), new(1, 9, 0.12, 0.75), new(9, 10, 0.12, 0.35),
    ];

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G17", "ragdoll with colliding limbs, 100 drops",
            [new("moving_after_20_s", 0), new("energy_rise", 1e-3), new("deepest_at_rest_mm", 0.5)], Dropped),
        new("G18", "G17 with random steps and pauses", [new("rise_of_height_mm", 1), new("gap_peak_mm", 1)], Uneven),
    ];

    /// <summary>A ragdoll about a place, in a drawn pose within its limits in which nothing overlaps.</summary>
    public static List<Actor> Add(Rig rig, Dice dice, Vec place, double angle)
    {
        Vec[] places;
        double[] angles;
        do
        {
            (places, angles) = Pose(dice, place, angle);
        }
        while (Overlaps(places, angles));

        var limbs = new List<Actor>();
        for (int i = 0; i < _limbs.Length; i++)
        {
            limbs.Add(_limbs[i].Height > 0
                ? rig.AddBox(places[i].X, places[i].Y, _limbs[i].Width, _limbs[i].Height, angles[i])
                : rig.AddCircle(places[i].X, places[i].Y, 0.5 * _limbs[i].Width, angle: angles[i]));
        }

        foreach (Pivot pivot in _pivots)
        {
            double now = angles[pivot.B] - angles[pivot.A];
            RevoluteJoint joint = rig.AddHinge(limbs[pivot.A], limbs[pivot.B], At(pivot, places, angles));
            joint.CollideConnected = false;
            joint.AreLimitsEnabled = true;
            joint.LowerLimit = (float)(-Bend - now);
            joint.UpperLimit = (float)(Bend - now);
        }

        return limbs;
    }

    /// <summary>Depth of the limbs in each other and in all else, hinged neighbours left out.</summary>
    public static double Deepest(Rig rig)
    {
        double deepest = 0;
        for (int i = 0; i < rig.Actors.Count; i++)
        {
            for (int j = i + 1; j < rig.Actors.Count; j++)
            {
                Actor a = rig.Actors[i];
                Actor b = rig.Actors[j];
                if ((!a.IsStatic || !b.IsStatic) && !AreHinged(rig, a, b))
                {
                    deepest = Math.Max(deepest, Metrics.Penetration([a], b));
                }
            }
        }

        return deepest;
    }

    private static bool AreHinged(Rig rig, Actor a, Actor b)
    {
        foreach (Hinge hinge in rig.Hinges)
        {
            if ((hinge.A == a && hinge.B == b) || (hinge.A == b && hinge.B == a))
            {
                return true;
            }
        }

        return false;
    }

    private static void Dropped(GeneralRun run)
    {
        int moving = 0;
        string first = string.Empty;
        for (int i = 0; i < Drops; i++)
        {
            string parameters = $"drop {i}";
            run.Sample(parameters, () =>
            {
                using Rig rig = run.World(Gravity);
                Drop(rig, run.Dice);
                var energy = new RunningRise(rig);
                rig.Run(20, energy.Look);
                double speed = Bookkeeping.Fastest(rig.Actors);
                if (speed > Moving)
                {
                    moving++;
                    first = moving == 1 ? FormattableString.Invariant($", first: {parameters}, {speed:G3} m/s") : first;
                }

                run.Note("energy_rise", energy.Rise / energy.Start, parameters);
                run.Note("deepest_at_rest_mm", 1000 * Deepest(rig), parameters);
            });
        }

        run.Note("moving_after_20_s", moving, $"of {Drops}{first}");
    }

    private static void Uneven(GeneralRun run)
    {
        for (int i = 0; i < Drops / 2; i++)
        {
            string parameters = $"drop {i}";
            run.Sample(parameters, () =>
            {
                using Rig rig = run.World(Gravity);
                Drop(rig, run.Dice);
                var energy = new RunningRise(rig);
                double gap = 0;
                double time = 0;
                while (time < 10)
                {
                    double dt = run.Dice.Next() < 0.02 ? 0.2 : run.Dice.Between(1.0 / 120, 1.0 / 30);
                    rig.Step((float)dt);
                    time += dt;
                    energy.Look();
                    gap = Math.Max(gap, rig.LargestHingeError());
                }

                run.Note("rise_of_height_mm", 1000 * energy.Rise / (Bookkeeping.Mass(rig.Actors) * Gravity), parameters);
                run.Note("gap_peak_mm", 1000 * gap, parameters);
            });
        }
    }

    private static void Drop(Rig rig, Dice dice)
    {
        rig.AddGround();
        List<Actor> limbs = Add(rig, dice, new Vec(0, 1.5 + dice.Between(0.2, 5)), dice.Angle());

        // All turn about the torso as one.
        double spin = dice.Between(-5, 5);
        foreach (Actor limb in limbs)
        {
            Vec arm = limb.Position - limbs[0].Position;
            limb.Velocity = new Vec(-spin * arm.Y, spin * arm.X);
            limb.Spin = spin;
        }
    }

    private static (Vec[] Places, double[] Angles) Pose(Dice dice, Vec place, double angle)
    {
        var places = new Vec[_limbs.Length];
        var angles = new double[_limbs.Length];
        places[0] = place;
        angles[0] = (float)angle;
        foreach (Pivot pivot in _pivots)
        {
            Vec at = At(pivot, places, angles);
            angles[pivot.B] = (float)(angles[pivot.A] + dice.Between(-0.9 * Bend, 0.9 * Bend));
            places[pivot.B] = at + (_limbs[pivot.B].Place - pivot.Place).Turned(angles[pivot.B]);
        }

        return (places, angles);
    }

    private static Vec At(Pivot pivot, Vec[] places, double[] angles) =>
        places[pivot.A] + (pivot.Place - _limbs[pivot.A].Place).Turned(angles[pivot.A]);

    private static bool Overlaps(Vec[] places, double[] angles)
    {
        for (int i = 0; i < _limbs.Length; i++)
        {
            for (int j = i + 1; j < _limbs.Length; j++)
            {
                bool hinged = Array.Exists(_pivots, pivot => pivot.A == i && pivot.B == j);
                if (!hinged && Outlines.Depth(Outline(i), Outline(j)) > 0)
                {
                    return true;
                }
            }
        }

        return false;

        // About the head a square is on the safe side.
        Vec[] Outline(int i)
        {
            double height = _limbs[i].Height > 0 ? _limbs[i].Height : _limbs[i].Width;
            return Outlines.Placed(Outlines.Box(_limbs[i].Width, height), places[i], angles[i]);
        }
    }

    /// <summary>A box where it is in the upright pose; of height 0, a circle as wide.</summary>
    private readonly record struct Limb(double X, double Y, double Width, double Height)
    {
        public Vec Place => new(X, Y);
    }

    private readonly record struct Pivot(int A, int B, double X, double Y)
    {
        public Vec Place => new(X, Y);
    }
}
