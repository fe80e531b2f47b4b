using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>Where a thrown box comes to rest.</summary>
internal static class Throws
{
    private const int Count = 20;
    private const double Longest = 10;

    /// <summary>A box slower than this for as many steps as said is at rest.</summary>
    private const double Still = 1e-5;
    private const int StillSteps = 10;

    private static readonly int[] _doublings = [1, 2, 4, 8];

    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        new("G09", "thrown box, friction 0.5: resting place against Iterations 640 at dt/8",
            [
                new("median_error_mm_e0", 2), new("factor_a_doubling_e0", 1.7, AtLeast: true),
                new("median_error_mm_e0.3", 2), new("factor_a_doubling_e0.3", 1.7, AtLeast: true),
            ],
            Thrown),
    ];

    private static void Thrown(GeneralRun run)
    {
        foreach (double e in new[] { 0, 0.3 })
        {
            var iterations = new List<double>[_doublings.Length];
            var steps = new List<double>[_doublings.Length];
            for (int k = 0; k < _doublings.Length; k++)
            {
                iterations[k] = [];
                steps[k] = [];
            }

            for (int i = 0; i < Count; i++)
            {
                var flight = new Flight(
                    run.Dice.Between(1, 3), run.Dice.Angle(), run.Dice.Between(2, 8), run.Dice.Between(-3, 3), run.Dice.Between(-10, 10));
                run.Sample(FormattableString.Invariant($"restitution {e}, throw {i}"), () =>
                {
                    Vec right = Rest(run.World(dial: run.Dial with { Iterations = 640, Dt = run.Dial.Dt / 8 }), e, flight);
                    for (int k = 0; k < _doublings.Length; k++)
                    {
                        int times = _doublings[k];
                        Dial finer = run.Dial with { Iterations = run.Dial.Iterations * times };
                        iterations[k].Add(1000 * (Rest(run.World(dial: finer), e, flight) - right).Length);
                        Dial shorter = run.Dial with { Dt = run.Dial.Dt / times };
                        steps[k].Add(1000 * (Rest(run.World(dial: shorter), e, flight) - right).Length);
                    }
                });
            }

            string at = FormattableString.Invariant($"_e{e}");
            double median = Bookkeeping.Median(iterations[0]);
            double byIterations = Factor(iterations);
            double bySteps = Factor(steps);
            run.Note("median_error_mm" + at, median, $"{Count} throws");
            run.Note(
                "factor_a_doubling" + at,
                Math.Max(byIterations, bySteps),
                FormattableString.Invariant($"Iterations {byIterations:G3}, 1/dt {bySteps:G3}"));
        }
    }

    /// <summary>Of the median, for each doubling, over all of them.</summary>
    private static double Factor(List<double>[] errors) =>
        Math.Pow(Bookkeeping.Median(errors[0]) / Bookkeeping.Median(errors[^1]), 1.0 / (errors.Length - 1));

    private static Vec Rest(Rig world, double restitution, Flight flight)
    {
        using Rig rig = world;
        rig.Friction = 0.5;
        rig.Restitution = restitution;
        rig.AddGround();
        Actor box = rig.AddBox(-20, flight.Height, 1, 1, flight.Angle);
        box.Velocity = new Vec(flight.Speed, flight.Up);
        box.Spin = flight.Spin;
        int still = 0;
        int most = rig.StepsIn(Longest);
        while (still < StillSteps && rig.Steps < most)
        {
            rig.Step();
            still = box.Velocity.Length < Still && Math.Abs(box.Spin) < Still ? still + 1 : 0;
        }

        return box.Position;
    }

    private readonly record struct Flight(double Height, double Angle, double Speed, double Up, double Spin);
}
