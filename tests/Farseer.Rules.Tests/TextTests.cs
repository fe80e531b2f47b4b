using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>The text of the repository speaks of the project alone, and means the same on every machine.</summary>
public sealed class TextTests
{
    private static readonly HashSet<string> _binary = [".png", ".nupkg", ".snupkg", ".user"];

    // The rules are spelled so that this file keeps them: the last letter of each word stands in a class of its own.
    private static readonly Regex _path = new(@"(?<![\w.$}])/(work|root|home|tmp|Users)/|[A-Z]:\\+Users");

    private static readonly Regex _host =
        new(@"nuget\.or[g]|npmjs\.co[m]|pypi\.or[g]|crates\.i[o]|localhos[t]|127\.0\.0\.[1]", RegexOptions.IgnoreCase);

    private static readonly Regex _trade = new(
        @"\b(LL[M]|GP[T]|Claud[e]|Anthropi[c]|OpenA[I]|Copilo[t]|chatbo[t]|subagen[t]|sessio[n]s?|agen[t]s?|worktre[e])\b",
        RegexOptions.IgnoreCase);

    [Fact]
    public void Text_HasNoPathOfAMachine() => Assert.Empty(Matches(_path));

    [Fact]
    public void Text_NamesNoHostOfPackages() => Assert.Empty(Matches(_host));

    [Fact]
    public void Text_SpeaksOfTheProjectAlone() => Assert.Empty(Matches(_trade));

    [Fact]
    public void Text_IsRead()
    {
        List<string> names = [.. Texts().Select(Repository.Relative)];

        Assert.Contains("README.md", names);
        Assert.Contains(".ci/run", names);
        Assert.Contains("Directory.Build.props", names);
    }

    private static IEnumerable<string> Matches(Regex rule) =>
        from file in Texts()
        from Match match in rule.Matches(File.ReadAllText(file))
        select Repository.Relative(file) + ": " + match.Value;

    // A clone's .git is a folder, a linked one's a file that holds a path.
    private static IEnumerable<string> Texts() =>
        Repository.Files("", "*").Where(f => !_binary.Contains(Path.GetExtension(f)) && Path.GetFileName(f) != ".git");
}
