using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>Closed chains: dropped in a pit, and hung by one link.</summary>
internal static class Loops
{
    private const double Side = 0.4;
    private const double Thick = 0.15;
    private const double PitHalf = 3.5;
    private const double Gravity = 10;

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G16", "loops of boxes dropped 1 m into a pit",
            [new("gap_end_mm", 0.1), new("speed_end_mps", 1e-3), new("gap_peak_mm", 20)], Pit),
        new("G19", "six links closed and hung by one, swinging", [new("energy_change", 0.01)], Hung),
    ];

    /// <summary>A ring of boxes hinged at the corners of a regular polygon; neighbours do not collide.</summary>
    public static List<Actor> AddRing(Rig rig, Vec centre, int boxes, double angle)
    {
        var ring = new List<Actor>();
        double step = 2 * Math.PI / boxes;
        double apothem = 0.5 * Side / Math.Tan(0.5 * step);
        for (int i = 0; i < boxes; i++)
        {
            double turn = angle + (i * step);
            Vec middle = centre + new Vec(0, -apothem).Turned(turn);
            ring.Add(rig.AddBox(middle.X, middle.Y, Side, Thick, turn));
        }

        double radius = RingRadius(boxes);
        for (int i = 0; i < boxes; i++)
        {
            Vec corner = centre + new Vec(0, -radius).Turned(angle + ((i + 0.5) * step));
            rig.AddHinge(ring[i], ring[(i + 1) % boxes], corner).CollideConnected = false;
        }

        return ring;
    }

    public static double RingRadius(int boxes) => 0.5 * Side / Math.Sin(Math.PI / boxes);

    public static void AddPit(Rig rig, double half)
    {
        rig.AddGround();
        rig.AddStaticBox(-half - 0.5, 25, 1, 50);
        rig.AddStaticBox(half + 0.5, 25, 1, 50);
    }

    private static void Pit(GeneralRun run)
    {
        foreach (int rings in new[] { 1, 4, 10 })
        {
            foreach (int boxes in new[] { 8, 12, 16, 24 })
            {
                DropRings(run, rings, boxes);
            }
        }

        for (int i = 0; i < 4; i++)
        {
            DropRings(run, run.Dice.Whole(1, 6), run.Dice.Whole(5, 28));
        }
    }

    private static void DropRings(GeneralRun run, int rings, int boxes)
    {
        string parameters = $"{rings} chains of {boxes}";
        run.Sample(parameters, () =>
        {
            using Rig rig = run.World(Gravity);
            AddPit(rig, PitHalf);
            double reach = RingRadius(boxes) + Thick;
            int columns = Math.Max(1, (int)(PitHalf / reach));
            for (int i = 0; i < rings; i++)
            {
                double middle = -PitHalf + ((2 * (i % columns) + 1) * PitHalf / columns);
                double room = Math.Max(0, (PitHalf / columns) - reach);
                double x = middle + (room * run.Dice.Between(-1, 1));
                double y = 1 + reach + (2 * reach * (i / columns));
                AddRing(rig, new Vec(x, y), boxes, run.Dice.Angle());
            }

            double peak = 0;
            rig.Run(20, () => peak = Math.Max(peak, rig.LargestHingeError()));
            run.Note("gap_end_mm", 1000 * rig.LargestHingeError(), parameters);
            run.Note("speed_end_mps", Bookkeeping.Fastest(rig.Actors), parameters);
            run.Note("gap_peak_mm", 1000 * peak, parameters);
        });
    }

    private static void Hung(GeneralRun run)
    {
        double seconds = run.IsFull ? 600 : 60;
        for (int i = 0; i < 4; i++)
        {
            double turn = i == 0 ? 1 : run.Dice.Between(0.5, 2.5);
            string parameters = FormattableString.Invariant($"turned by {turn:G4} rad, {seconds} s");
            run.Sample(parameters, () => run.Note("energy_change", Swing(run, turn, seconds), parameters));
        }
    }

    /// <summary>The largest change of the energy, of what the loop would lose if it came to hang at rest.</summary>
    private static double Swing(GeneralRun run, double turn, double seconds)
    {
        const int Links = 6;
        const double Length = 0.5;
        const double Mass = 0.5;
        using Rig rig = run.World(Gravity);
        Actor anchor = rig.AddAnchor(0, 0);
        double step = 2 * Math.PI / Links;
        double apothem = 0.5 * Length / Math.Tan(0.5 * step);
        double radius = 0.5 * Length / Math.Sin(0.5 * step);

        // The first link's middle is the pivot; the ring hangs below it, turned about it.
        Vec centre = new Vec(0, -apothem).Turned(turn);
        var links = new List<Actor>();
        for (int i = 0; i < Links; i++)
        {
            double angle = turn + (i * step);
            links.Add(rig.AddLooseBox(centre + new Vec(0, apothem).Turned(angle), Length, 0.05, angle, Mass));
        }

        for (int i = 0; i < Links; i++)
        {
            Vec corner = centre + new Vec(0, radius).Turned(turn + ((i + 0.5) * step));
            rig.AddHinge(links[i], links[(i + 1) % Links], corner);
        }

        rig.AddHinge(anchor, links[0], new Vec(0, 0));

        // At rest two links hang straight down on either side of the first and the last lies across: half a metre deep on the average.
        double start = Bookkeeping.Total(rig.Actors, Gravity);
        double scale = start + (Links * Mass * Gravity * Length);
        double change = 0;
        rig.Run(seconds, () => change = Math.Max(change, Math.Abs(Bookkeeping.Total(rig.Actors, Gravity) - start)));
        return change / scale;
    }
}
