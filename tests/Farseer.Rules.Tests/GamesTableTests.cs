using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>The table of docs/Games.md names tests: each is there.</summary>
public sealed class GamesTableTests
{
    [Fact]
    public void Test_NamedInTheTable_Exists_AndEachTestOfTheFolderIsOfAClassThatIsNamed()
    {
        string page = File.ReadAllText(Path.Combine(Repository.Root, "docs", "Games.md"));
        List<string> named = [.. Regex.Matches(page, @"\| `(\w+Tests\.\w+)` \|").Select(m => m.Groups[1].Value)];
        var existing = new HashSet<string>(StringComparer.Ordinal);
        var types = new HashSet<string>(StringComparer.Ordinal);
        foreach (string file in Repository.Files(Path.Combine("tests", "Farseer.Tests"), "*Tests.cs"))
        {
            string type = Path.GetFileNameWithoutExtension(file);
            if (Path.GetFileName(Path.GetDirectoryName(file)) == "Games")
            {
                types.Add(type);
            }

            foreach (Match method in Regex.Matches(
                File.ReadAllText(file), @"\[(?:Fact|Theory|MemberData\(\w+\(\w+\)\)|InlineData\([^\n]*\))\]\s+public void (\w+)\("))
            {
                existing.Add(type + "." + method.Groups[1].Value);
            }
        }

        Assert.True(named.Count >= 55);
        Assert.All(named, n => Assert.Contains(n, existing));
        Assert.Equal(named.Count, named.Distinct().Count());
        Assert.Empty(types.Except(named.Select(n => n.Split('.')[0])));
    }
}
