using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>A decision is one page: the question, the choice, its figures, what was rejected and why. The index names each.</summary>
public sealed class DecisionTests
{
    private const int MostLines = 55;

    private static readonly string _folder = Path.Combine(Repository.Root, "docs", "decisions");

    public static TheoryData<string> Decisions => new(Directory.GetFiles(_folder, "*.md")
        .Select(f => Path.GetFileName(f)!).Where(n => n != "README.md").Order(StringComparer.Ordinal));

    [Theory]
    [MemberData(nameof(Decisions))]
    public void Page_OfADecision_IsOnePage_WithQuestionChoiceAndWhatWasRejected(string name)
    {
        string[] lines = File.ReadAllLines(Path.Combine(_folder, name));

        Assert.StartsWith("# " + name[..3] + ": ", lines[0], StringComparison.Ordinal);
        Assert.True(lines.Length <= MostLines, $"{name} has {lines.Length} lines, {MostLines} are a page.");
        Assert.All(lines.Where(l => !l.StartsWith('|')), l => Assert.True(l.Length <= 150, l));
        Assert.Contains("## Question", lines);
        Assert.Contains(lines, l => l.StartsWith("## Choice", StringComparison.Ordinal));
        Assert.Contains("## Rejected", lines);
    }

    [Fact]
    public void Index_NamesEachDecisionByItsTitle()
    {
        string index = File.ReadAllText(Path.Combine(_folder, "README.md"));
        List<string> rows = [.. Regex.Matches(index, @"^\| \[\d{3}\]\((.+?)\) \| (.+?) \|$", RegexOptions.Multiline)
            .Select(m => m.Groups[1].Value + ": " + m.Groups[2].Value)];
        IEnumerable<string> pages = Directory.GetFiles(_folder, "0*.md").Order(StringComparer.Ordinal)
            .Select(f => Path.GetFileName(f) + ": " + File.ReadLines(f).First()[7..]);

        Assert.Equal(pages, rows);
    }
}
