using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>The judge of recorded scenes knows none of them by name: a rule is about a kind of scene.</summary>
public sealed class JudgeTests
{
    [Fact]
    public void Source_OfTheJudge_NamesNoRecordedScene()
    {
        string[] folders = ["fidelity", "fidelity-box2d"];
        List<string> files = [.. folders.SelectMany(f => Repository.Files(Path.Combine("tests", "data", f), "*.json"))];
        HashSet<string> scenes = [.. files.Select(f => Path.GetFileNameWithoutExtension(f))];

        // A word of the format may be a scene's name too: what stands in a file elsewhere than as its name.
        scenes.ExceptWith(files.SelectMany(f => Regex.Matches(File.ReadAllText(f), "(?<!\"name\": ?)\"(\\w+)\"")
            .Select(m => m.Groups[1].Value)).Distinct().ToList());

        IEnumerable<string> named =
            from file in Repository.Files(Path.Combine("tests", "Farseer.Fidelity"), "*.cs")
            from Match text in Regex.Matches(File.ReadAllText(file), "\"([^\"\n]*)\"|`([^`\n]*)`")
            let word = text.Groups[1].Value + text.Groups[2].Value
            where scenes.Contains(word)
            select Repository.Relative(file) + ": " + word;

        Assert.True(scenes.Count > files.Count * 0.9);
        Assert.Empty(named);
    }
}
