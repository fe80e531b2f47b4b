using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Rules.Tests;

public sealed class QuirkDocumentTests
{
    [Fact]
    public void Flag_OfFarseer201Quirks_HasARowInPortingWithItsFigure()
    {
        string source = File.ReadAllText(Path.Combine(Repository.Root, "src", "Farseer", "Farseer201Quirks.cs"));
        List<string> flags = [.. Regex.Matches(source, @"^    (\w+) = \d+,", RegexOptions.Multiline).Select(m => m.Groups[1].Value)
            .Where(f => f is not "None" and not "All")];
        string[] lines = File.ReadAllLines(Path.Combine(Repository.Root, "docs", "Porting.md"));
        List<string[]> rows = [.. lines.SkipWhile(l => !l.Contains("| Flag of `Farseer201Quirks` |", StringComparison.Ordinal)).Skip(2)
            .TakeWhile(l => l.StartsWith('|')).Select(l => l.Trim('|', ' ').Split('|').Select(c => c.Trim()).ToArray())];

        Assert.NotEmpty(flags);
        Assert.Equal(flags.Order(StringComparer.Ordinal), rows.Select(r => r[2].Trim('`')).Order(StringComparer.Ordinal));
        Assert.All(rows, r => Assert.Equal(6, r.Count(c => c.Length > 0)));
    }
}
