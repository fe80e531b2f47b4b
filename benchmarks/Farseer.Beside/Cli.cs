using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using Farseer.CommandLines;

namespace Farseer.Beside;

/// <summary>The command line: opens two builds, sets them side by side, writes the report.</summary>
internal static class Cli
{
    private const string About = """
        Two builds of the library side by side: what each meets and misses, and how long it takes.
        Exit code 0: nothing is lost. 1: something that was met is missed, a part is no longer there, or a mean exceeds the limit.
        2: the command line is misused, or a build cannot be made.
        """;

    public static int Run(string[] args, TextWriter output, TextWriter errors)
    {
        RootCommand root = Options.Root(About, Compare);
        return CommandLine.Run(root, args.Length == 0 ? ["--help"] : args, output, errors);
    }

    private static int Compare(Options options, ParseResult result)
    {
        TextWriter output = result.InvocationConfiguration.Output;
        TextWriter errors = result.InvocationConfiguration.Error;
        using StreamWriter? file = Values.Open(Options.OutName, options.OutPath);
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
}
