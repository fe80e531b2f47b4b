using System;
using System.Collections.Generic;
using Farseer.Accuracy.General;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Accuracy.Energies;

/// <summary>A kind of random worlds in which nothing drives.</summary>
/// <param name="Name">For people and files.</param>
/// <param name="Add">Adds one thing at a place that it has for itself.</param>
internal sealed record EnergyKind(string Name, Action<Rig, Dice, Vec> Add);

/// <summary>
/// Things dropped in a pit, without drag: gravity, loads and impacts only turn energy over or take it away, so it may
/// never rise again above what it came down to.
/// </summary>
internal static class EnergyWorlds
{
    private const double Gravity = 10;
    private const double PitHalf = 5;

    /// <summary>Nothing reaches further than half of it from its place: nothing overlaps at the start.</summary>
    private const double Cell = 2.5;

    /// <summary>From end to end of a chain.</summary>
    private const double ChainLength = 2.2;

    /// <summary>A hinge is in the middle between two bodies so far apart.</summary>
    private const double Arm = 0.5;

    /// <summary>Centre of mass of a block with a notch: areas 0.75 at the middle, less 0.125 at a height of 0.25.</summary>
    private const double NotchedY = -0.125 * 0.25 / 0.625;

    private static readonly Solid[] _solids = [Solid.Triangle, Solid.Hexagon, Solid.Cross, Solid.Capsule];

    public static EnergyKind[] Kinds { get; } =
    [
        new("bodies", (rig, dice, at) => AddBody(rig, dice, at, 1)),
        new("hinges", AddHinged),
        new("chains", AddChain),
        new("ropes", AddRope),
        new("mixed", AddAny),
    ];

    /// <summary>The largest rise of the energy above its running minimum, of the start's; heights are those above the ground.</summary>
    public static double Rise(EnergyKind kind, int seed, double seconds)
    {
        var dice = new Dice((uint)seed, kind.Name);
        using var rig = new Rig(GeneralSettings.Default.Dial, Gravity);
        rig.Friction = dice.Next();
        rig.Restitution = dice.Next();
        Loops.AddPit(rig, PitHalf);
        int things = dice.Whole(6, 20);
        int columns = (int)(2 * PitHalf / Cell);
        for (int i = 0; i < things; i++)
        {
            kind.Add(rig, dice, new Vec(-PitHalf + (Cell * ((i % columns) + 0.5)), Cell * ((i / columns) + 0.6)));
        }

        var energy = new RunningRise(rig);
        try
        {
            rig.Run(seconds, energy.Look);
        }
        catch (ExplodedException)
        {
            return Runner.Exploded;
        }

        return energy.Rise / energy.Start;
    }

    private static void AddAny(Rig rig, Dice dice, Vec at) => Kinds[dice.Whole(0, Kinds.Length - 2)].Add(rig, dice, at);

    private static Actor AddBody(Rig rig, Dice dice, Vec at, double size)
    {
        double density = dice.Scale(0.2, 20);
        switch (dice.Whole(0, 4))
        {
            case 0:
                return rig.AddBox(at.X, at.Y, size * dice.Between(0.2, 1.2), size * dice.Between(0.2, 1.2), dice.Angle(), density);
            case 1:
                double radius = size * dice.Between(0.1, 0.7);
                return rig.AddCircle(at.X, at.Y, radius, density * Math.PI * radius * radius);
            case 2:
                return rig.AddBox(at.X, at.Y, size * dice.Between(1, 2.2), size * dice.Between(0.08, 0.2), dice.Angle(), density);
            case 3:
                return dice.Of(_solids).Add(rig, at, dice.Angle());
            default:
                return AddNotched(rig, at, dice.Angle());
        }
    }

    /// <summary>A block of 1 m by 0.75 m with a notch: one concave outline.</summary>
    private static Actor AddNotched(Rig rig, Vec at, double angle)
    {
        Vec shift = new(0, -NotchedY);
        Vec[] outline =
        [
            shift + new Vec(-0.5, -0.375), shift + new Vec(0.5, -0.375), shift + new Vec(0.5, 0.375), shift + new Vec(0.25, 0.375),
            shift + new Vec(0.25, 0.125), shift + new Vec(-0.25, 0.125), shift + new Vec(-0.25, 0.375), shift + new Vec(-0.5, 0.375),
        ];
        return rig.AddPolygon(at, angle, outline, []);
    }

    /// <summary>Two bodies on a hinge, every other one with limits, every third hung up.</summary>
    private static void AddHinged(Rig rig, Dice dice, Vec at)
    {
        Actor a = AddBody(rig, dice, at - new Vec(Arm, 0), 0.5);
        Actor b = AddBody(rig, dice, at + new Vec(Arm, 0), 0.5);
        RevoluteJoint hinge = rig.AddHinge(a, b, at);
        hinge.CollideConnected = false;
        if (dice.Next() < 0.5)
        {
            hinge.LowerLimit = (float)dice.Between(-1.5, 0);
            hinge.UpperLimit = (float)dice.Between(0, 1.5);
            hinge.AreLimitsEnabled = true;
        }

        if (dice.Whole(0, 2) == 0)
        {
            Vec above = a.Position + new Vec(0, Arm);
            rig.AddHinge(rig.AddAnchor(above.X, above.Y), a, above);
        }
    }

    /// <summary>Links end to end, or a ring of them; neighbours do not collide.</summary>
    private static void AddChain(Rig rig, Dice dice, Vec at)
    {
        if (dice.Whole(0, 2) == 0)
        {
            Loops.AddRing(rig, at, dice.Whole(4, 14), dice.Angle());
            return;
        }

        AddLinks(rig, dice, at);
    }

    /// <summary>A chain that hangs by one end, every other one with a load at the other; or a body on a rope of one piece.</summary>
    private static void AddRope(Rig rig, Dice dice, Vec at)
    {
        if (dice.Whole(0, 2) == 0)
        {
            Actor body = AddBody(rig, dice, at, 0.5);
            Vec top = at + new Vec(dice.Between(-1, 1), dice.Between(0, 1));
            rig.AddTether(rig.AddAnchor(top.X, top.Y), body, (top - at).Length + dice.Between(0, 1));
            return;
        }

        List<Actor> links = AddLinks(rig, dice, at);
        Vec end = links[0].Position - new Vec(0.5 * ChainLength / links.Count, 0).Turned(links[0].Angle);
        rig.AddHinge(rig.AddAnchor(end.X, end.Y), links[0], end);
        if (dice.Next() < 0.5)
        {
            Vec last = links[^1].Position;
            Actor load = rig.AddCircle(last.X, last.Y, 0.15, dice.Scale(1, 100) * links[^1].Mass);
            rig.AddHinge(links[^1], load, last).CollideConnected = false;
        }
    }

    private static List<Actor> AddLinks(Rig rig, Dice dice, Vec middle)
    {
        double density = dice.Scale(0.2, 20);
        int count = dice.Whole(2, 6);
        double length = ChainLength / count;
        double angle = dice.Between(-0.3, 0.3);
        Vec along = new Vec(length, 0).Turned(angle);
        Vec corner = middle - (0.5 * count * along);
        var links = new List<Actor>();
        for (int i = 0; i < count; i++)
        {
            Vec centre = corner + (0.5 * along);
            Actor link = rig.AddBox(centre.X, centre.Y, length, 0.1, angle, density);
            if (i > 0)
            {
                rig.AddHinge(links[^1], link, corner).CollideConnected = false;
            }

            links.Add(link);
            corner += along;
        }

        return links;
    }
}
