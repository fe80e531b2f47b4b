using System;
using System.Collections.Generic;
using System.IO;

namespace Farseer.Beside;

/// <summary>The command line: opens two builds, sets them side by side, writes the report.</summary>
internal static class Cli
{
    private const int Misused = 2;

    private static readonly IReadOnlyList<Part> _parts = Parts.All([], Options.DefaultRuns);

    private static readonly string _help = FormattableString.Invariant($"""
        Two builds of the library side by side: what each meets and misses, and how long it takes.

          Farseer.Beside BEFORE AFTER [options]

          BEFORE, AFTER         a checkout, whose programs are built first, or a folder with built programs
          --only PART[,PART..]  {Parts.AccuracyGroup} ({string.Join(' ', Parts.Names(_parts, areTimed: false))}),
                                {Parts.SpeedGroup} ({string.Join(' ', Parts.Names(_parts, areTimed: true))}), or some of these; default: all
          --turns N             how often each build is timed, by turns; the least time counts (default {Options.DefaultTurns});
                                where a mean exceeds the limit, up to three times as often
          --runs N              timed runs of a scene in a turn, after one that warms up (default {Options.DefaultRuns})
          --scene NAME[=SIZE]   a timing scene in place of all ten; may be repeated
          --limit X             largest geometric mean of the times after / before, of each part (default {Options.DefaultLimit})
          --out FILE.md         writes the report to a file too, with every line that differs

        Exit code 0: nothing is lost. 1: something that was met is missed, a part is no longer there, or a mean exceeds the limit.
        2: the command line is misused, or a build cannot be made.
        """);

    public static int Run(string[] args, TextWriter output, TextWriter errors)
    {
        if (args.Length == 0 || args[0] is "--help" or "-h" or "help")
        {
            output.WriteLine(_help);
            return 0;
        }

        try
        {
            Options options = Options.Parse(args);
            using StreamWriter? file = Open(options.OutPath);
            Build before = Build.Open(options.Before, options.Chosen, errors);
            Build after = Build.Open(options.After, options.Chosen, errors);
            using var bench = new Bench(before, after, options, errors);
            var results = new List<Result>();
            foreach (Part part in options.Chosen)
            {
                results.Add(bench.Run(part));
            }

            var report = new Report(before.Title, after.Title, results, options.Limit);
            report.Write(output, isFull: false);
            if (file is not null)
            {
                report.Write(file, isFull: true);
            }

            return report.ExitCode;
        }
        catch (UsageException mistake)
        {
            errors.WriteLine(mistake.Message);
            return Misused;
        }
    }

    /// <summary>Before anything runs, so that a name that cannot be written is told at once.</summary>
    private static StreamWriter? Open(string? path)
    {
        try
        {
            return path is null ? null : new StreamWriter(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new UsageException($"--out: {e.Message}");
        }
    }
}
