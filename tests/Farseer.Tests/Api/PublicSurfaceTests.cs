using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>
/// Every public member of version 2.0.1 (tests/data/farseer-2.0.1.tsv) is there under the same name and with the same
/// parameters, except those listed here with a reason.
/// </summary>
public class PublicSurfaceTests
{
    /// <summary>Types, or single members ("Type: signature"), that are left out on purpose.</summary>
    private static readonly Dictionary<string, string> _intendedAbsences = new(StringComparer.Ordinal)
    {
        ["Vector2"] = "System.Numerics.Vector2 takes its place",
        ["Vector3"] = "System.Numerics.Vector3 takes its place",
        ["Matrix"] = "System.Numerics.Matrix4x4 takes its place",
        ["Geom: bool IsDisposed"] = "a program that sets it breaks the simulator; reading it is the same as before",
        ["Body: bool IsDisposed"] = "a program that sets it breaks the simulator; reading it is the same as before",
        ["Spring: bool IsDisposed"] = "a program that sets it breaks the simulator; reading it is the same as before",
        ["Joint: bool IsDisposed"] = "a program that sets it breaks the simulator; reading it is the same as before",
        ["Controller: bool IsDisposed"] = "a program that sets it breaks the simulator; reading it is the same as before",
        ["SweepAndPruneCollider: SweepAndPruneCollider.CollisionPairDictionary CollisionPairs"] =
            "a view of the pairs found; to replace it has no meaning",
        ["SweepAndPruneCollider.Extent"] = "working data of the sort, which is done elsewhere now",
        ["SweepAndPruneCollider.ExtentInfo"] = "working data of the sort, which is done elsewhere now",
        ["SweepAndPruneCollider.ExtentList"] = "working data of the sort, which is done elsewhere now",
    };

    [Fact]
    public void PublicSurface_OfVersion201_IsThere()
    {
        var rows = ApiRow.All();
        Assert.True(rows.Count > 1000, $"Only {rows.Count} rows were read.");
        var faults = rows
            .Where(row => !IsAbsentOnPurpose(row))
            .Select(row => (row, fault: PublicSurface.Fault(row)))
            .Where(pair => pair.fault != null)
            .Select(pair => $"{pair.row.Namespace} {pair.row.Key} -- {pair.fault}")
            .ToArray();
        Assert.True(faults.Length == 0, $"{faults.Length} members:\n{string.Join('\n', faults)}");
    }

    [Fact]
    public void IntendedAbsences_NameRowsThatAreAbsent()
    {
        var rows = ApiRow.All();
        foreach (var (name, reason) in _intendedAbsences)
        {
            Assert.False(string.IsNullOrWhiteSpace(reason), name);
            var named = rows.Where(row => row.Type == name || row.Key == name).ToArray();
            Assert.True(named.Length > 0, $"{name} names no row.");
            Assert.All(named, row => Assert.True(PublicSurface.Fault(row) != null, $"{row.Key} is there: take it off the list."));
        }
    }

    [Fact]
    public void IntendedAbsences_AreThoseOfThePortingGuide()
    {
        string guide = TestData.Read("Porting.md");
        int start = guide.IndexOf("## Left out", StringComparison.Ordinal);
        string[] lines = guide.Substring(start, guide.IndexOf("\n## ", start + 1, StringComparison.Ordinal) - start).Split('\n');
        var told = lines.Where(line => line.StartsWith("| `", StringComparison.Ordinal))
            .SelectMany(line => Regex.Matches(line.Split('|')[1], "`([^`]+)`").Select(match => match.Groups[1].Value));

        // "Geom: bool IsDisposed" is Geom.IsDisposed there.
        var meant = _intendedAbsences.Keys.Select(name => Regex.Replace(name, "^(.*?): .* ", "$1."));
        Assert.Equal(meant.Order(StringComparer.Ordinal), told.Order(StringComparer.Ordinal));
    }

    private static bool IsAbsentOnPurpose(ApiRow row) =>
        _intendedAbsences.ContainsKey(row.Type) || _intendedAbsences.ContainsKey(row.Key);
}
