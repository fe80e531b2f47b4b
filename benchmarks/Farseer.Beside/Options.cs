using System;
using System.Collections.Generic;
using System.CommandLine;
using Farseer.CommandLines;

namespace Farseer.Beside;

/// <summary>The command line of a comparison.</summary>
internal sealed class Options
{
    public const int DefaultRuns = 3;

    private const int DefaultTurns = 3;
    private const double DefaultLimit = 1.02;
    private const int Most = 1000;

    private static readonly Argument<string> _before = new("BEFORE")
    {
        Description = "a checkout, whose programs are built first, or a folder with built programs",
    };

    private static readonly Argument<string> _after = new("AFTER") { Description = "another one" };

    private static readonly ValueOption<string?> _only =
        Values.Word("--only", "PART,..", "names of parts, joined by commas", WordsOfParts());

    private static readonly Option<int> _turns = Values.Whole(
        "--turns",
        "how often each build is timed, by turns; the least time counts; where a mean exceeds the limit, up to three times as often",
        1, Most, DefaultTurns);

    private static readonly Option<int> _runs =
        Values.Whole("--runs", "timed runs of a scene in a turn, after one that warms up", 1, Most, DefaultRuns);

    private static readonly ValuesOption<string> _scenes = new(
        "--scene", "NAME[=SIZE]", "the name of a scene", "a timing scene in place of all ten; may be repeated", Values.TryText);

    private static readonly ValueOption<double?> _limit = Values.Positive(
        "--limit", "X", "a number above 0",
        FormattableString.Invariant($"largest geometric mean of the times after / before, of each part; {DefaultLimit} by default"));

    private static readonly ValueOption<string?> _out =
        Values.File("--out", "writes the report to a file too, with every line that differs", "FILE.md");

    /// <exception cref="UsageException">A part is unknown.</exception>
    private Options(ParseResult result)
    {
        Before = result.GetRequiredValue(_before);
        After = result.GetRequiredValue(_after);
        Turns = result.GetValue(_turns);
        Limit = result.GetValue(_limit) ?? DefaultLimit;
        OutPath = result.GetValue(_out);
        string[] only = result.GetValue(_only)?.Split(',') ?? [Parts.AccuracyGroup, Parts.SpeedGroup];
        Chosen = Parts.Choose(Parts.All(result.GetRequiredValue(_scenes), result.GetValue(_runs)), only);
    }

    public string Before { get; }

    public string After { get; }

    /// <summary>How often each build is timed.</summary>
    public int Turns { get; }

    /// <summary>The largest geometric mean of times, after / before, that is not slower.</summary>
    public double Limit { get; }

    public string? OutPath { get; }

    public IReadOnlyList<Part> Chosen { get; }

    /// <summary>Where the report is written to a file, the option that says so.</summary>
    public static string OutName => _out.Name;

    public static RootCommand Root(string about, Func<Options, ParseResult, int> run)
    {
        RootCommand root = new(about) { _before, _after, _only, _turns, _runs, _scenes, _limit, _out };
        root.SetAction(result => run(new Options(result), result));
        return root;
    }

    private static string WordsOfParts()
    {
        IReadOnlyList<Part> all = Parts.All([], DefaultRuns);
        return FormattableString.Invariant($"{Parts.AccuracyGroup} ({string.Join(' ', Parts.Names(all, areTimed: false))}), ")
            + FormattableString.Invariant(
                $"{Parts.SpeedGroup} ({string.Join(' ', Parts.Names(all, areTimed: true))}), or some of these; by default all");
    }
}
