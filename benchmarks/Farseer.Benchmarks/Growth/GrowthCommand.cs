using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using Farseer.CommandLines;
using Farseer.Tests.Shared.Growth;

namespace Farseer.Benchmarks.Growth;

/// <summary>The verb <c>growth</c>: how time and memory grow with the size of a world, by kinds of worlds.</summary>
internal static class GrowthCommand
{
    private const int Smallest = 500;
    private const int Factor = 4;
    private const int Steps = 10;
    private const int LeastRuns = 2;
    private const int MostRuns = 8;

    /// <summary>A kind is run so long before it is timed, for the compiler.</summary>
    private const double WarmSeconds = 0.5;

    /// <summary>A kind's next size is not tried when this one took so long, seconds.</summary>
    private const double Patience = 20;

    /// <summary>
    /// What grows with n log n has a power of 1. A world that no longer fits into caches costs 2.5 times as much a body in all, over two
    /// powers of ten: 0.2 of a power.
    /// </summary>
    private const double MostPower = 1.25;

    private static readonly Argument<int> _largest = Verb.Maybe("largest", "the largest size", 32_000);
    private static readonly Option<string?> _only = Values.Word("--only", "WORD", "a word", "kinds with this word in their name");

    public static Command Create() =>
        Verb.Of("growth", "How time and memory grow with the size of a world, by kinds of worlds.", Run, _largest, _only);

    private static int Run(ParseResult result)
    {
        TextWriter output = result.Output();
        int largest = result.GetValue(_largest);
        string word = result.GetValue(_only) ?? "";
        output.WriteLine($"one worker; of each of {Steps} updates the least of {LeastRuns} or more; powers of n log n, or of all pairs");
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"where it says so, between the last two sizes; more than {MostPower} is a miss"));
        output.WriteLine("| world | size counts | sizes | making, ms | power | an update, ms | power | KiB | power |");
        output.WriteLine("|---|---|---|---|---|---|---|---|---|");
        int misses = 0;
        foreach (GrowthWorld world in GrowthWorlds.All.Where(w => w.Name.Contains(word, StringComparison.OrdinalIgnoreCase)))
        {
            misses += Print(output, world, largest);
        }

        output.WriteLine($"{misses} misses");
        return misses == 0 ? 0 : 1;
    }

    private static int Print(TextWriter output, GrowthWorld world, int largest)
    {
        var rows = new List<GrowthFigures>();
        int smallest = world.Work is null ? Smallest : Smallest / 16;
        for (double warm = 0; warm < WarmSeconds;)
        {
            GrowthFigures figures = GrowthFigures.Measure(world, smallest, Steps, 1);
            warm += Math.Max(1e-3, figures.BuildSeconds + (2 * Steps * figures.StepSeconds));
        }

        for (int size = smallest; size <= largest; size *= Factor)
        {
            GrowthFigures first = GrowthFigures.Measure(world, size, Steps, 1);
            double once = first.BuildSeconds + (2 * Steps * first.StepSeconds);
            int runs = (int)Math.Clamp(2 / once, LeastRuns, MostRuns);
            rows.Add(GrowthFigures.Measure(world, size, Steps, runs) with { Bytes = first.Bytes });
            if (once > Patience / (Factor * (1 + LeastRuns)))
            {
                break;
            }
        }

        double build = Power(world, rows, r => r.BuildSeconds);
        double step = Power(world, rows, r => r.StepSeconds);
        double bytes = Power(world, rows, r => r.Bytes);
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"| {world.Name} | {world.Counts}{(world.Work is null ? "" : ", all pairs")} | {Join(rows, r => r.Size, "N0")} | "
                + $"{Join(rows, r => 1e3 * r.BuildSeconds, "G3")} | {build:F2} | "
                + $"{Join(rows, r => 1e3 * r.StepSeconds, "G3")} | {step:F2} | "
                + $"{Join(rows, r => r.Bytes / 1024.0, "F0")} | {bytes:F2} |"));
        output.Flush();
        return new[] { build, step, bytes }.Count(p => p > MostPower);
    }

    private static double Power(GrowthWorld world, List<GrowthFigures> rows, Func<GrowthFigures, double> amount) =>
        rows.Count < 2 ? double.NaN : GrowthFigures.Power(world, rows[^2], rows[^1], amount);

    private static string Join(List<GrowthFigures> rows, Func<GrowthFigures, double> value, string format) =>
        string.Join(" – ", rows.Select(r => value(r).ToString(format, CultureInfo.InvariantCulture)));
}
