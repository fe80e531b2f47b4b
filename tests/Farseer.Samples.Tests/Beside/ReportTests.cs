using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Farseer.Beside;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Samples.Tests.Beside;

/// <summary>The verdict over two builds, and the command that gives it.</summary>
public sealed class ReportTests : IDisposable
{
    private const double Limit = 1.02;

    private static readonly Reading<Figure> _met = new([new("a", 1, 2, false)], string.Empty);
    private static readonly Reading<Figure> _missed = new([new("a", 3, 2, false)], string.Empty);
    private static readonly Reading<Figure> _notThere = new([], "not there");

    private readonly string _folder = Directory.CreateTempSubdirectory("farseer-beside-tests").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    public static TheoryData<string, int> Verdicts => new()
    {
        { "met and met", 0 },
        { "met and missed", 1 },
        { "missed and met", 0 },
        { "missed and missed", 0 },
        { "not there and missed", 0 },
        { "met and not there", 1 },
        { "not there and not there", 0 },
    };

    [Theory]
    [MemberData(nameof(Verdicts))]
    public void Report_OfFigures_FailsWhereSomethingIsLost(string builds, int code)
    {
        string[] names = builds.Split(" and ");
        var known = new Dictionary<string, Reading<Figure>> { ["met"] = _met, ["missed"] = _missed, ["not there"] = _notThere };

        Assert.Equal(code, Of(Result.Of(Part("goals"), known[names[0]], known[names[1]])).ExitCode);
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(1.019, 0)]
    [InlineData(1.021, 1)]
    [InlineData(0.5, 0)]
    public void Report_OfTimes_FailsAboveTheLimit(double ratio, int code)
    {
        // One scene gains what the other one loses, but for the square of the mean.
        Reading<Timing> before = new([new("a", 1, null, "x"), new("b", 2, null, "x")], string.Empty);
        Reading<Timing> after = new([new("a", 4 * ratio, null, "x"), new("b", 0.5 * ratio, null, "y")], string.Empty);

        Assert.Equal(code, Of(Result.Of(Part("scenes"), before, after)).ExitCode);
    }

    /// <summary>Of draws as many are lost as gained if both builds are as good.</summary>
    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(4, 0, 0)]
    [InlineData(5, 0, 1)]
    [InlineData(30, 20, 0)]
    [InlineData(36, 20, 1)]
    [InlineData(0, 50, 0)]
    public void Report_OfRandomWorlds_FailsWhereMoreIsLostThanByChance(int lost, int gained, int code)
    {
        IEnumerable<Figure> before = Enumerable.Range(0, lost + gained).Select(i => new Figure($"{i}", i < lost ? 1 : 3, 2, false));
        IEnumerable<Figure> after = Enumerable.Range(0, lost + gained).Select(i => new Figure($"{i}", i < lost ? 3 : 1, 2, false));

        Farseer.Beside.Report report =
            Of(Result.Of(Part("energies"), new Reading<Figure>([.. before], string.Empty), new([.. after], string.Empty)));

        Assert.Equal(code, report.ExitCode);
    }

    [Fact]
    public void Report_OfTimesWithoutACommonScene_Fails()
    {
        Reading<Timing> before = new([new("a", 1, null, "x")], string.Empty);
        Reading<Timing> after = new([new("b", 1, null, "x")], string.Empty);

        Assert.Equal(1, Of(Result.Of(Part("scenes"), before, after)).ExitCode);
    }

    [Fact]
    public void Report_OfManyFigures_NamesAllThatAreLostAndFewOthers()
    {
        Figure[] before = [.. Enumerable.Range(0, 200).Select(i => new Figure($"figure {i}", 1, 2, false))];
        Figure[] after = [.. before.Select((figure, i) => figure with { Value = i < 100 ? 3 : 1.5 })];
        Farseer.Beside.Report report = Of(Result.Of(Part("surveys"), new Reading<Figure>(before, string.Empty), new(after, string.Empty)));

        string few = Written(report, isFull: false);
        string full = Written(report, isFull: true);

        for (int i = 0; i < before.Length; i++)
        {
            string line = i < 100 ? $"| surveys: figure {i} | 1 | 3 | ≤ 2 |" : $"| surveys: figure {i} | 1 | 1.5 | ≤ 2 |";
            Assert.Contains(line, i < 100 ? few : full, StringComparison.Ordinal);
        }

        Assert.Contains("80 more", few, StringComparison.Ordinal);
        Assert.EndsWith("**surveys: 100 lost.**", few.TrimEnd(), StringComparison.Ordinal);
    }

    [Fact]
    public void Report_OfFiguresWithOtherLimits_ShowsBoth()
    {
        Reading<Figure> tighter = new([new("a", 1, 0.5, false)], string.Empty);

        string report = Written(Of(Result.Of(Part("goals"), _met, tighter)), isFull: false);

        Assert.Contains("| goals: a | 1 | 1 | ≤ 2, then ≤ 0.5 |", report, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("before", "needs another one")]
    [InlineData("before after more", "takes BEFORE and AFTER, not 'more' besides")]
    [InlineData("before after --only all", "'all' is none of accuracy, speed, goals, aims,")]
    [InlineData("before after --only goals,goals", "named twice")]
    [InlineData("before after --turns 0", "--turns needs a whole number from 1 to 1000, not '0'")]
    [InlineData("before after --limit fast", "--limit needs a number above 0, not 'fast'")]
    [InlineData("before after --limit", "--limit needs a number above 0")]
    [InlineData("before after --worse 2", "has no option '--worse'")]
    [InlineData("nowhere nowhere", "'nowhere' is no folder")]
    public void Command_Misused_SaysSo(string arguments, string expected)
    {
        using var errors = new StringWriter();

        Assert.Equal(2, Cli.Run(arguments.Split(' '), TextWriter.Null, errors));
        Assert.Contains(expected, errors.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Command_OnAFolderWithoutPrograms_SaysWhatIsNotThere()
    {
        using var errors = new StringWriter();

        Assert.Equal(2, Cli.Run([_folder, _folder, "--only", "recordings"], TextWriter.Null, errors));
        Assert.Contains("has none of Farseer.Fidelity", errors.ToString(), StringComparison.Ordinal);
    }

    /// <summary>Five thousand steps of one box at rest, which take some milliseconds; the limit leaves their times out of it.</summary>
    [Fact]
    public void Command_OnOneBuildTwice_FindsTheSameBitsAndNothingLost()
    {
        string build = Path.Combine(Clone.Root, "benchmarks", "Farseer.Benchmarks", "bin", Clone.Configuration);
        string file = Path.Combine(_folder, "report.md");
        using var output = new StringWriter();
        using var errors = new StringWriter();

        string[] selection = ["--only", "goals,scenes", "--scene", "resting_boxes=1", "--runs", "1", "--turns", "2", "--limit", "1000"];
        int code = Cli.Run([build, build, .. selection, "--out", file], output, errors);

        Assert.True(code == 0, errors.ToString());
        Assert.Matches(@"\| resting_boxes=1 \|.*\| same \|", output.ToString());
        Assert.Contains("| goals | not there | not there |", output.ToString(), StringComparison.Ordinal);
        Assert.Contains("Nothing is lost, nothing is slower.", File.ReadAllText(file), StringComparison.Ordinal);
    }

    private static Part Part(string name) => Parts.Choose(Parts.All([], 1), [name])[0];

    private static Farseer.Beside.Report Of(Result result) => new("before", "after", [result], Limit);

    private static string Written(Farseer.Beside.Report report, bool isFull)
    {
        using var output = new StringWriter();
        report.Write(output, isFull);
        return output.ToString();
    }
}
