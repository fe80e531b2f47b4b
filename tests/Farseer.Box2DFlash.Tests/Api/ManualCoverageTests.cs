using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>Every row of the manual's table (tests/data/manual-box2dflash.tsv) has a test that names it.</summary>
public sealed class ManualCoverageTests
{
    /// <summary>Rows that nothing shows yet; a row that gets a test must leave the list.</summary>
    private static readonly HashSet<string> _open = new(StringComparer.Ordinal);

    [Fact]
    public void ManualRows_HaveATestEach()
    {
        HashSet<string> tested = [.. Tested()];
        string[] missing = [.. Rows().Where(r => !tested.Contains(r[0]) && !_open.Contains(r[0]))
            .Select(r => string.Join(" | ", r.Take(5)))];

        Assert.True(missing.Length == 0, $"{missing.Length} rows without a test:\n{string.Join('\n', missing)}");
        Assert.Empty(_open.Intersect(tested));
    }

    [Fact]
    public void ManualRowAttributes_NameRowsOfTheTable()
    {
        HashSet<string> known = [.. Rows().Select(r => r[0])];

        Assert.All(Tested(), id => Assert.Contains(id, known));
    }

    private static string[][] Rows() => TestData.Table("manual-box2dflash.tsv");

    private static IEnumerable<string> Tested() => typeof(ManualCoverageTests).Assembly.GetTypes()
        .SelectMany(t => t.GetMethods())
        .Where(m => m.GetCustomAttribute<FactAttribute>() is { Skip: null })
        .SelectMany(m => m.GetCustomAttributes<ManualRowAttribute>())
        .SelectMany(a => a.Ids)
        .SelectMany(Expand);

    private static IEnumerable<string> Expand(string id)
    {
        int dash = id.IndexOf('-', StringComparison.Ordinal);
        if (dash < 0)
        {
            return [id];
        }

        int first = int.Parse(id.AsSpan(1, dash - 1), CultureInfo.InvariantCulture);
        int last = int.Parse(id.AsSpan(dash + 2), CultureInfo.InvariantCulture);
        return Enumerable.Range(first, last - first + 1).Select(n => "B" + n.ToString("000", CultureInfo.InvariantCulture));
    }
}
