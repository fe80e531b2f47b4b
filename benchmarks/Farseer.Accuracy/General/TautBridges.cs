using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>A heavy box falls on a bridge that is stretched between its ends.</summary>
internal static class TautBridges
{
    private const double PlankMass = 5;

    /// <summary>Gaps are judged up to this load, of a plank's mass.</summary>
    private const double LargestJudged = 1000;

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G28", "taut bridge of 20 planks, box of 1:100 to 1:5000 dropped on it",
            [new("loads_lost", 0), new("gap_peak_to_1:1000_mm", 1)], Bridges),
    ];

    private static void Bridges(GeneralRun run)
    {
        int lost = 0;
        int drops = 0;
        string first = string.Empty;
        foreach (double ratio in new[] { 100.0, 300, 1000, 3000, 5000 })
        {
            Fall(ratio, 1, 20, 0);
            Fall(ratio, 4.5, 20, 0);
        }

        for (int i = 0; i < 10; i++)
        {
            Fall(run.Dice.Scale(100, 5000), run.Dice.Between(0.5, 4.5), run.Dice.Whole(10, 30), run.Dice.Between(-3, 3));
        }

        run.Note("loads_lost", lost, $"of {drops}{(lost > 0 ? ", first: " + first : string.Empty)}");

        void Fall(double ratio, double height, int planks, double aside)
        {
            string parameters = FormattableString.Invariant($"{planks} planks, 1:{ratio:G4} from {height:G3} m, {aside:G3} m aside");
            run.Sample(parameters, () =>
            {
                drops++;
                using Rig rig = run.World();
                Actor before = rig.AddAnchor(-0.5 * planks, 0);
                for (int i = 0; i < planks; i++)
                {
                    Vec end = new((-0.5 * planks) + i, 0);
                    Actor plank = rig.AddBox(end.X + 0.5, 0, 1, 0.25, 0, PlankMass / 0.25);
                    rig.SetGroup(plank, 1);
                    rig.AddHinge(before, plank, end);
                    before = plank;
                }

                rig.AddHinge(before, rig.AddAnchor(0.5 * planks, 0), new Vec(0.5 * planks, 0));
                Actor load = rig.AddBox(aside, 1.125 + height, 2, 2, 0, 0.25 * PlankMass * ratio);
                double peak = 0;
                rig.Run(10, () => peak = Math.Max(peak, rig.LargestHingeError()));
                if (load.Position.Y < -0.5 * planks)
                {
                    lost++;
                    first = lost == 1 ? parameters : first;
                }

                if (ratio <= LargestJudged)
                {
                    run.Note("gap_peak_to_1:1000_mm", 1000 * peak, parameters);
                }
            });
        }
    }
}
