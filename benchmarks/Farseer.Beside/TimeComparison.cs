using System;
using System.Collections.Generic;

namespace Farseer.Beside;

/// <summary>The time of a scene in one turn.</summary>
/// <param name="Scene">Its name and size.</param>
/// <param name="Least">Milliseconds a step, of the fastest run of the turn.</param>
/// <param name="Quiet">Of a run made of the fastest of each step, which other work on the machine disturbs less; null: unknown.</param>
/// <param name="Hash">The state at the end.</param>
internal sealed record Timing(string Scene, double Least, double? Quiet, string Hash)
{
    /// <summary>Reads a file with the columns scene, size, ms_step_min, state_hash and, if it is known, ms_step_quiet.</summary>
    /// <exception cref="FormatException">It is no such file, or a time is not above 0.</exception>
    public static List<Timing> Read(string path)
    {
        CsvTable table = CsvTable.Read(path);
        int scene = table.Column("scene");
        int size = table.Column("size");
        int least = table.Column("ms_step_min");
        int hash = table.Column("state_hash");
        int quiet = table.Has("ms_step_quiet") ? table.Column("ms_step_quiet") : -1;
        var timings = new List<Timing>();
        for (int row = 0; row < table.Rows.Count; row++)
        {
            string[] cells = table.Rows[row];
            string name = $"{cells[scene]}={cells[size]}";
            var timing = new Timing(name, table.Number(row, least), quiet < 0 ? null : table.Number(row, quiet), cells[hash]);
            timings.Add(timing.Least > 0 && timing.Quiet is null or > 0
                ? timing
                : throw new FormatException($"{path}: {name} took no time."));
        }

        return timings;
    }
}

/// <summary>A scene in both builds.</summary>
/// <param name="Scene">Its name and size.</param>
/// <param name="Before">The least of all turns, ms a step.</param>
/// <param name="After">The same of the later build.</param>
/// <param name="Again">
/// The second fastest turn of a build, of its fastest: how well the least came again, the worse of the two builds; infinite after one
/// turn.
/// </param>
/// <param name="IsSame">Both end in the same state, to the last bit.</param>
internal sealed record TimePair(string Scene, double Before, double After, double Again, bool IsSame)
{
    public double Ratio => After / Before;
}

/// <summary>Sets the times of two builds side by side.</summary>
internal sealed class TimeComparison
{
    public TimeComparison(IReadOnlyList<Timing> before, IReadOnlyList<Timing> after)
    {
        Dictionary<string, List<Timing>> others = ByScene(after);
        foreach ((string scene, List<Timing> earlier) in ByScene(before))
        {
            if (others.TryGetValue(scene, out List<Timing>? later))
            {
                bool areQuiet = earlier.TrueForAll(turn => turn.Quiet is not null) && later.TrueForAll(turn => turn.Quiet is not null);
                (double leastBefore, double nextBefore) = Fastest(earlier, areQuiet);
                (double leastAfter, double nextAfter) = Fastest(later, areQuiet);
                double again = Math.Max(nextBefore / leastBefore, nextAfter / leastAfter);
                Pairs.Add(new TimePair(scene, leastBefore, leastAfter, again, earlier[0].Hash == later[0].Hash));
            }
        }
    }

    public List<TimePair> Pairs { get; } = [];

    /// <summary>Of the ratios after / before; 1 if no scene is in both.</summary>
    public double GeometricMean
    {
        get
        {
            double sum = 0;
            foreach (TimePair pair in Pairs)
            {
                sum += Math.Log(pair.Ratio);
            }

            return Math.Exp(sum / Math.Max(1, Pairs.Count));
        }
    }

    private static Dictionary<string, List<Timing>> ByScene(IReadOnlyList<Timing> timings)
    {
        var scenes = new Dictionary<string, List<Timing>>();
        foreach (Timing timing in timings)
        {
            if (!scenes.TryGetValue(timing.Scene, out List<Timing>? turns))
            {
                scenes.Add(timing.Scene, turns = []);
            }

            turns.Add(timing);
        }

        return scenes;
    }

    private static (double Least, double Next) Fastest(List<Timing> turns, bool areQuiet)
    {
        List<double> times = turns.ConvertAll(turn => areQuiet ? turn.Quiet!.Value : turn.Least);
        times.Sort();
        return (times[0], times.Count > 1 ? times[1] : double.PositiveInfinity);
    }
}
