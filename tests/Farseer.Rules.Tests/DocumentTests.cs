using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Box2D.Dynamics;
using FarseerGames.FarseerPhysics;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>What the documents point at is there, and what they show compiles and runs.</summary>
public sealed class DocumentTests
{
    /// <summary>What a page loads in a moment.</summary>
    private const int MostBytesOfAPicture = 60_000;

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
    public void Project_OfAProgramOfOneFile_Exists()
    {
        List<string> projects = [.. from file in _documents
            from Match line in Regex.Matches(File.ReadAllText(file), "^#:project (.+?)\r?$", RegexOptions.Multiline)
            select line.Groups[1].Value];

        Assert.NotEmpty(projects);
        Assert.DoesNotContain(projects, p => Directory.GetFiles(Path.Combine(Repository.Root, p), "*.csproj").Length != 1);
    }

    [Fact]
    public void FileOfCode_InBackticks_Exists()
    {
        HashSet<string> names = [.. Repository.Files("", "*.cs").Select(f => Path.GetFileName(f)!)];
        List<(string Page, string Name)> named = [.. from file in _documents
            from Match code in Regex.Matches(File.ReadAllText(file), @"`((?:[A-Z]|b2)[A-Za-z0-9.]+\.cs)`")
            select (Repository.Relative(file), code.Groups[1].Value)];

        Assert.NotEmpty(named);
        Assert.DoesNotContain(named, n => !names.Contains(n.Name));
    }

    /// <summary>Pages that speak of other libraries and engines, whose names are not ours.</summary>
    private static readonly string[] _ofOthers = ["docs/Migration.md", "docs/Porting.md", "docs/Box2DFlash.md", "docs/engines/"];

    /// <summary>Names of the runtime, of browsers and of other engines that the other pages speak of.</summary>
    private static readonly HashSet<string> _foreign = new(StringComparer.Ordinal)
    {
        "PrepareMethod", "b2GetByteCount", "AggressiveOptimization", "DecompressionStream",
    };

    [Fact]
    public void Name_InBackticks_IsInTheSources()
    {
        HashSet<string> words = Words();
        IEnumerable<string> wrong =
            from file in _documents
            let page = Repository.Relative(file)
            where !page.StartsWith("tests/", StringComparison.Ordinal) && !_ofOthers.Any(o => page.StartsWith(o, StringComparison.Ordinal))
            from Match code in Regex.Matches(File.ReadAllText(file), @"(?<!`)`((?:[A-Z]|b2)\w+(?:\.\w+)*)(?:\(\))?`(?!`)")
            from string name in code.Groups[1].Value.Split('.')
            where !words.Contains(name) && !_foreign.Contains(name)
            select page + ": " + code.Groups[1].Value;

        Assert.Empty(wrong);
    }

    [Fact]
    public void MemberOfAType_InBackticks_Exists()
    {
        ILookup<string, Type> types = Assembly.GetAssembly(typeof(PhysicsSimulator))!.GetExportedTypes()
            .Concat(Assembly.GetAssembly(typeof(b2World))!.GetExportedTypes())
            .ToLookup(t => t.Name, StringComparer.Ordinal);
        List<(string Page, string Type, string Member)> named = [.. from file in _documents
            let page = Repository.Relative(file)
            where !_ofOthers.Contains(page)
            from Match code in Regex.Matches(File.ReadAllText(file), @"(?<!`)`([A-Za-z]\w+)\.(\w+)[^`\n]*`(?!`)")
            where types.Contains(code.Groups[1].Value) && !code.Value.EndsWith(".cs`", StringComparison.Ordinal)
            select (page, code.Groups[1].Value, code.Groups[2].Value)];

        Assert.True(named.Count >= 50);
        Assert.DoesNotContain(named, n => !types[n.Type].Any(t => HasMember(t, n.Member)));
    }

    private static bool HasMember(Type type, string name) =>
        type.GetMember(name, BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static).Length > 0
        || (type.BaseType is { } parent && HasMember(parent, name))
        || type.GetInterfaces().Any(i => HasMember(i, name));

    /// <summary>Words of the code, without its comments, and names of files and folders.</summary>
    private static HashSet<string> Words()
    {
        HashSet<string> words = new(StringComparer.Ordinal);
        foreach (string file in Repository.Files("", "*").Where(f => !f.EndsWith(".md", StringComparison.Ordinal)))
        {
            words.UnionWith(Regex.Matches(Repository.Relative(file), @"\w+").Select(m => m.Value));
            if (Path.GetExtension(file) is ".cs" or ".csproj" or ".props" or ".targets")
            {
                words.UnionWith(File.ReadLines(file)
                    .Where(l => !l.TrimStart().StartsWith("//", StringComparison.Ordinal))
                    .SelectMany(l => Regex.Matches(l, @"\w+")).Select(m => m.Value));
            }
        }

        return words;
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
            foreach (string name in Snippet.Pictures(code))
            {
                string drawn = Path.Combine(Environment.CurrentDirectory, name);
                string kept = Path.Combine(Repository.Root, "docs", "pictures", name);
                if (Environment.GetEnvironmentVariable("FARSEER_UPDATE_PICTURES") == "1")
                {
                    File.Copy(drawn, kept, overwrite: true);
                }

                Assert.Equal(File.ReadAllText(kept), File.ReadAllText(drawn));
                File.Delete(drawn);
            }
        }

        foreach ((string engine, string code) in Snippet.ForEngines(text))
        {
            string stub = File.ReadAllText(Path.Combine(Repository.Root, "tests", "Farseer.Rules.Tests", "Stubs", engine + ".cs"));
            Assert.Empty(Snippet.Compile(code, stub, page));
        }
    }

    /// <summary>Whoever reads a tutorial sees what comes out of it: the picture that its program saves.</summary>
    [Fact]
    public void Tutorial_ShowsThePicturesThatItsProgramDraws()
    {
        List<(string Page, string Text)> tutorials = [.. _documents
            .Select(f => (Page: Repository.Relative(f), Text: File.ReadAllText(f)))
            .Where(t => t.Page.StartsWith("docs/tutorials/", StringComparison.Ordinal))];

        Assert.True(tutorials.Count >= 5);
        foreach ((string page, string text) in tutorials)
        {
            List<string> drawn = [.. Snippet.Blocks(text).SelectMany(Snippet.Pictures)];
            List<string> shown = [.. Regex.Matches(text, @"!\[[^]]+\]\(\.\./pictures/([^)]+)\)").Select(m => m.Groups[1].Value)];
            Assert.NotEmpty(drawn);
            Assert.Equal(drawn, shown);
            Assert.All(drawn, name => Assert.InRange(
                new FileInfo(Path.Combine(Repository.Root, "docs", "pictures", name)).Length, 1, MostBytesOfAPicture));
        }
    }

    [Fact]
    public void Code_OfAllPages_IsFound()
    {
        Assert.True(_documents.Sum(f => Snippet.Blocks(File.ReadAllText(f)).Count()) >= 20);
        Assert.True(_documents.Sum(f => Snippet.ForEngines(File.ReadAllText(f)).Count()) >= 6);
    }

    [Fact]
    public void Code_OfAPart_StandsInAProgramOfItsPage()
    {
        List<(string Page, string Part, bool Found)> parts = [.. from file in _documents
            let text = File.ReadAllText(file)
            from part in Snippet.Parts(text)
            select (Repository.Relative(file), part, Snippet.Blocks(text).Any(b => Snippet.IsPartOf(part, b)))];

        Assert.True(parts.Count >= 20);
        Assert.DoesNotContain(parts, p => !p.Found);
    }

    [Fact]
    public void Code_InAFenceOfCSharp_IsOfOneOfTheThreeKinds()
    {
        IEnumerable<string> wrong =
            from file in _documents
            from Match fence in Regex.Matches(File.ReadAllText(file), "^```(cs|c#|csharp.*)$", RegexOptions.Multiline)
            let kind = fence.Groups[1].Value.Trim()
            where kind is not ("csharp" or "csharp part") && !Regex.IsMatch(kind, @"^csharp stub:\w+$")
            select Repository.Relative(file) + ": " + kind;

        Assert.Empty(wrong);
    }

    /// <summary>What the headings of a document are called in links: lower case, without punctuation, hyphens for spaces.</summary>
    private static IEnumerable<string> Anchors(string document) =>
        from Match heading in Regex.Matches(File.ReadAllText(document), "^#+ (.+?)\r?$", RegexOptions.Multiline)
        let words = Regex.Replace(heading.Groups[1].Value.ToLowerInvariant(), @"[^\p{L}\p{N}\s_-]", "")
        select words.Trim().Replace(' ', '-');
}
