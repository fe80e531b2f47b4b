using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>Every row of the manual's table (tests/data/manual-farseer.tsv) that is built has a test that names it.</summary>
public class ManualCoverageTests
{
    /// <summary>
    /// The rows that are built: all chapters. Whoever takes up other rows
    /// adds them here and nowhere else.
    /// </summary>
    private static readonly (int First, int Last)[] _built = { (1, 312) };

    [Fact]
    public void ManualRows_InScope_HaveATestEach()
    {
        var tested = TestedRows().ToHashSet(StringComparer.Ordinal);
        var missing = Rows()
            .Where(row => _built.Any(range => row.Number >= range.First && row.Number <= range.Last) && !tested.Contains(row.Id))
            .Select(row => row.Text)
            .ToArray();
        Assert.True(missing.Length == 0, $"{missing.Length} rows without a test:\n{string.Join('\n', missing)}");
    }

    [Fact]
    public void ManualRowAttributes_NameRowsOfTheTable()
    {
        var known = Rows().Select(row => row.Id).ToHashSet(StringComparer.Ordinal);
        Assert.All(TestedRows(), id => Assert.Contains(id, known));
    }

    [Fact]
    public void ManualRowAttribute_NamesTheAssemblyThatHasItsDiscoverer()
    {
        // A wrong name is no error: the filter by row would just find nothing.
        Assert.Equal(ManualRowAttribute.AssemblyName, typeof(ManualRowDiscoverer).Assembly.GetName().Name);
    }

    private static IEnumerable<string> TestedRows()
    {
        foreach (var type in typeof(ManualCoverageTests).Assembly.GetTypes())
        {
            foreach (var method in type.GetMethods())
            {
                // A row named on a class counts only if the class has a test, and a test that is skipped proves nothing.
                if (method.GetCustomAttribute<FactAttribute>() is { Skip: null })
                {
                    foreach (var row in method.GetCustomAttributes<ManualRowAttribute>()
                        .Concat(type.GetCustomAttributes<ManualRowAttribute>()))
                    {
                        yield return row.Id;
                    }
                }
            }
        }
    }

    private static IEnumerable<(string Id, int Number, string Text)> Rows() => TestData.Read("manual-farseer.tsv")
        .Split('\n')
        .Skip(1)
        .Select(line => line.TrimEnd('\r').Split('\t'))
        .Where(cells => cells.Length > 4)
        .Select(cells => (cells[0], int.Parse(cells[0].AsSpan(1), provider: null), string.Join(" | ", cells.Take(5))));
}
