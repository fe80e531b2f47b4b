using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>What the documents point at is there, and what they show compiles and runs.</summary>
public sealed class DocumentTests
{
    private static readonly string[] _documents = [.. Repository.Files("", "*.md")];

    [Fact]
    public void Link_PointsToAFileThatExists()
    {
        IEnumerable<string> wrong =
            from file in _documents
            from Match link in Regex.Matches(File.ReadAllText(file), @"\]\(([^)#\s]+)(#[^)\s]*)?\)")
            let target = link.Groups[1].Value
            where !target.Contains("://", StringComparison.Ordinal)
            where !Path.Exists(Path.Combine(Path.GetDirectoryName(file)!, target))
            select Repository.Relative(file) + ": " + target;

        Assert.Empty(wrong);
    }

    [Fact]
    public void Link_WithAnAnchor_PointsToAHeading()
    {
        List<(string File, string Path, string Anchor)> links = [.. from file in _documents
            from Match link in Regex.Matches(File.ReadAllText(file), @"\]\(([^)#\s]*)#([^)\s]+)\)")
            let target = link.Groups[1].Value
            where !target.Contains("://", StringComparison.Ordinal)
            let path = target.Length == 0 ? file : Path.Combine(Path.GetDirectoryName(file)!, target)
            select (Repository.Relative(file), path, link.Groups[2].Value)];

        Assert.NotEmpty(links);
        Assert.DoesNotContain(links, l => !Anchors(l.Path).Contains(l.Anchor));
    }

    [Fact]
    public void Path_InBackticks_Exists()
    {
        IEnumerable<string> wrong =
            from file in _documents
            where !Repository.Relative(file).StartsWith("tests/data/", StringComparison.Ordinal)
            from Match code in Regex.Matches(File.ReadAllText(file), "`((src|tests|docs|samples|benchmarks)/[A-Za-z0-9_./-]+)`")
            where !Path.Exists(Path.Combine(Repository.Root, code.Groups[1].Value))
            select Repository.Relative(file) + ": " + code.Groups[1].Value;

        Assert.Empty(wrong);
    }

    [Fact]
    public void Command_NamesAProjectOrSolutionThatExists()
    {
        List<(string File, string Target)> targets = [.. from file in _documents
            from Match command in Regex.Matches(File.ReadAllText(file), @"dotnet (run|test|build|pack)\b[^`\n|]*")
            from string word in command.Value.Split(' ', StringSplitOptions.RemoveEmptyEntries)
            where Regex.IsMatch(word, @"^(src|tests|samples|benchmarks)/|\.sln$")
            select (Repository.Relative(file), word)];

        Assert.NotEmpty(targets);
        Assert.DoesNotContain(targets, t => !Path.Exists(Path.Combine(Repository.Root, t.Target)));
    }

    public static TheoryData<string> Pages => new(_documents
        .Where(f => Snippet.Blocks(File.ReadAllText(f)).Any() || Snippet.ForEngines(File.ReadAllText(f)).Any())
        .Select(Repository.Relative));

    [Theory]
    [MemberData(nameof(Pages))]
    public void Code_OfAPage_CompilesRunsAndPrintsWhatIsSaid(string page)
    {
        string text = File.ReadAllText(Path.Combine(Repository.Root, page));
        foreach ((string code, string? said) in Snippet.Programs(text))
        {
            string printed = Snippet.Run(code, page);
            Assert.Equal(said ?? printed, printed.ReplaceLineEndings("\n"));
        }

        foreach ((string engine, string code) in Snippet.ForEngines(text))
        {
            string stub = File.ReadAllText(Path.Combine(Repository.Root, "tests", "Farseer.Rules.Tests", "Stubs", engine + ".cs"));
            Assert.Empty(Snippet.Compile(code, stub, page));
        }
    }

    [Fact]
    public void Code_OfAllPages_IsFound()
    {
        Assert.True(_documents.Sum(f => Snippet.Blocks(File.ReadAllText(f)).Count()) >= 20);
        Assert.True(_documents.Sum(f => Snippet.ForEngines(File.ReadAllText(f)).Count()) >= 6);
    }

    [Fact]
    public void Code_InAFenceOfCSharp_IsOfOneOfTheTwoKinds()
    {
        IEnumerable<string> wrong =
            from file in _documents
            from Match fence in Regex.Matches(File.ReadAllText(file), "^```(cs|c#|csharp.*)$", RegexOptions.Multiline)
            let kind = fence.Groups[1].Value.Trim()
            where kind != "csharp" && !Regex.IsMatch(kind, @"^csharp stub:\w+$")
            select Repository.Relative(file) + ": " + kind;

        Assert.Empty(wrong);
    }

    /// <summary>What the headings of a document are called in links: lower case, without punctuation, hyphens for spaces.</summary>
    private static IEnumerable<string> Anchors(string document) =>
        from Match heading in Regex.Matches(File.ReadAllText(document), "^#+ (.+?)\r?$", RegexOptions.Multiline)
        let words = Regex.Replace(heading.Groups[1].Value.ToLowerInvariant(), @"[^\p{L}\p{N}\s_-]", "")
        select words.Trim().Replace(' ', '-');
}
