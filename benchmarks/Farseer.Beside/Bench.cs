using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Threading.Tasks;

namespace Farseer.Beside;

/// <summary>Runs the programs of two builds and reads what they write.</summary>
internal sealed class Bench : IDisposable
{
    private const string NotThere = "not there";

    /// <summary>What the programs end with when figures are missed: they have told them all.</summary>
    private const int Missed = 1;

    /// <summary>What they end with when they do not know a command.</summary>
    private const int Misused = 2;

    private const int MostRounds = 3;

    private readonly Build _before;
    private readonly Build _after;
    private readonly int _turns;
    private readonly double _limit;
    private readonly TextWriter _progress;
    private readonly string _folder = Directory.CreateTempSubdirectory("farseer-beside").FullName;
    private int _files;

    public Bench(Build before, Build after, Options options, TextWriter progress)
    {
        _before = before;
        _after = after;
        _turns = options.Turns;
        _limit = options.Limit;
        _progress = TextWriter.Synchronized(progress);
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    public Result Run(Part part) => part.IsTimed ? Time(part) : Compare(part);

    /// <summary>Both builds at once: no figure depends on the time that it took.</summary>
    private Result Compare(Part part)
    {
        Task<Reading<Figure>> before = AskAsync(_before, part, part.Batches[0], Figure.Read);
        Task<Reading<Figure>> after = AskAsync(_after, part, part.Batches[0], Figure.Read);
        return Result.Of(part, before.GetAwaiter().GetResult(), after.GetAwaiter().GetResult());
    }

    /// <summary>
    /// Where the mean exceeds the limit all turns are taken again, for other work on the machine makes times longer and never shorter:
    /// the least of more turns is nearer to the truth, and a build that is slower stays so.
    /// </summary>
    private Result Time(Part part)
    {
        var before = new Reading<Timing>([], string.Empty);
        Reading<Timing> after = before;
        Result result;
        int round = 0;
        do
        {
            foreach (IReadOnlyList<string> batch in part.Batches)
            {
                (before, after) = TakeTurns(part, batch, before, after);
            }

            result = Result.Of(part, before, after);
            round++;
        }
        while (round < MostRounds && result.Times?.GeometricMean > _limit);
        return result;
    }

    /// <summary>One process at a time: before, after, after, before, and so on.</summary>
    private (Reading<Timing> Before, Reading<Timing> After) TakeTurns(
        Part part, IReadOnlyList<string> batch, Reading<Timing> before, Reading<Timing> after)
    {
        for (int turn = 0; turn < 2 * _turns && before.Fault.Length + after.Fault.Length == 0; turn++)
        {
            // 0 and 3 of each four.
            bool isBefore = ((turn + 1) & 2) == 0;
            Reading<Timing> told = AskAsync(isBefore ? _before : _after, part, batch, Timing.Read).GetAwaiter().GetResult();
            before = isBefore ? new([.. before.Items, .. told.Items], told.Fault) : before;
            after = isBefore ? after : new([.. after.Items, .. told.Items], told.Fault);
        }

        return (before, after);
    }

    private async Task<Reading<T>> AskAsync<T>(Build build, Part part, IReadOnlyList<string> batch, Func<string, List<T>> read)
    {
        string file = Path.Combine(_folder, FormattableString.Invariant($"{_files++}.csv"));
        long start = Stopwatch.GetTimestamp();
        Ending? ending = await build.RunAsync(part.Program, [.. batch, file]).ConfigureAwait(false);
        string who = $"{string.Join(' ', batch)} {(build == _before ? "before" : "after")}";
        double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        await _progress.WriteLineAsync(FormattableString.Invariant($"{who}: {seconds:F0} s: {ending?.LastLine}")).ConfigureAwait(false);
        if (ending is not null and not { Code: 0 or Missed or Misused })
        {
            return new([], FormattableString.Invariant($"ended with {ending.Code}: {ending.LastLine}"));
        }

        // A runner that takes the option for something else may end well and write nothing.
        if (ending is null or { Code: Misused } || !File.Exists(file))
        {
            return new([], NotThere);
        }

        try
        {
            return new(read(file), string.Empty);
        }
        catch (FormatException mistake)
        {
            return new([], mistake.Message);
        }
    }
}
