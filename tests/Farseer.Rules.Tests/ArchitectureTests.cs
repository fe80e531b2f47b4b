using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>
/// docs/Architecture.md lists what there is: the engine's folders by rank, the phases of a step, the folders of the joints.
/// </summary>
public sealed class ArchitectureTests
{
    private static readonly string _text = File.ReadAllText(Path.Combine(Repository.Root, "docs", "Architecture.md"));

    [Fact]
    public void Folders_OfTheEngine_AreListedBottomFirst()
    {
        IEnumerable<string> ranked = File.ReadLines(Path.Combine(Repository.EngineFolder, "layers.txt"))
            .Where(l => Directory.Exists(Path.Combine(Repository.EngineFolder, l)));

        Assert.Equal(ranked, Names("The engine, bottom first"));
    }

    [Fact]
    public void Phases_OfAStep_AreListedInTheirOrder()
    {
        string source = File.ReadAllText(Path.Combine(Repository.EngineFolder, "Stepping", "StepStage.cs"));
        IEnumerable<string> stages = Regex.Matches(source, @"^    (\w+),\r?$", RegexOptions.Multiline).Select(m => m.Groups[1].Value)
            .Where(n => n != "Count");

        // A phase that comes twice counts where it comes first.
        Assert.Equal(stages, Names("One step").Distinct());
    }

    [Fact]
    public void Folders_OfTheJoints_AreListed()
    {
        IEnumerable<string> folders = Directory.GetDirectories(Path.Combine(Repository.EngineFolder, "Joints"))
            .Select(f => Path.GetFileName(f)!).Order(StringComparer.Ordinal);

        Assert.Equal(folders, Names("The joints").Order(StringComparer.Ordinal));
    }

    /// <summary>The names in backticks that the rows of the tables under a heading begin with.</summary>
    private static List<string> Names(string heading)
    {
        int start = _text.IndexOf("\n## " + heading + "\n", StringComparison.Ordinal) + 1;
        Assert.NotEqual(0, start);
        int end = _text.IndexOf("\n## ", start, StringComparison.Ordinal);
        return [.. Regex.Matches(_text[start..end], @"^\| `(\w+)`[^|]*\|", RegexOptions.Multiline).Select(m => m.Groups[1].Value)];
    }
}
