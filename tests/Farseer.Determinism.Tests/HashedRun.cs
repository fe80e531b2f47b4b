using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Determinism.Tests;

/// <summary>What the console of Farseer.Determinism printed: the asset that ran, and a line for each scene, name and hash.</summary>
internal sealed class HashedRun
{
    private HashedRun(string asset, IReadOnlyList<string> hashes)
    {
        RanAs = asset;
        Hashes = hashes;
    }

    /// <summary>The slowest way, Debug without vectors, takes a quarter of a minute on two cores.</summary>
    public static TimeSpan Limit { get; } = TimeSpan.FromMinutes(4);

    public string RanAs { get; }

    public IReadOnlyList<string> Hashes { get; }

    public static string Asset(string project, string configuration) =>
        (project.EndsWith("NetStandard", StringComparison.Ordinal) ? ".NETStandard,Version=v2.0 " : ".NETCoreApp,Version=v8.0 ")
        + configuration;

    public static string Console(string project, string configuration) =>
        Path.Combine(Clone.Root, "tests", project, "bin", configuration, "net10.0", project + ".dll");

    // Two runs in one process, except without vectors, where one is slow enough: a state that leaks from run to run shows elsewhere.
    public static HashedRun OfBuilt(string project, string configuration, string switchedOff)
    {
        int runs = switchedOff == "DOTNET_EnableHWIntrinsic" ? 1 : 2;
        Dictionary<string, string> environment = switchedOff.Length > 0 ? new() { [switchedOff] = "0" } : [];
        return Of(Command.Dotnet(Clone.Root, ["exec", Console(project, configuration), .. Arguments(runs)], environment, Limit), runs);
    }

    public static IEnumerable<string> Arguments(int runs) => [runs.ToString(CultureInfo.InvariantCulture), .. GoldenHashes.Scenes];

    public static HashedRun Of((int Code, string Output) console, int runs)
    {
        Assert.True(console.Code == 0, console.Output);
        string[] lines = console.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        List<string> hashes = [];
        foreach (string[] parts in lines.Skip(1).Select(l => l.Split(' ')))
        {
            Assert.Equal(runs + 1, parts.Length);
            Assert.Single(parts.Skip(1).Distinct());
            hashes.Add(parts[0] + " " + parts[1]);
        }

        return new(lines[0], hashes);
    }

    public void MustBeGolden(string way, string asset)
    {
        Assert.Equal(asset, RanAs);
        List<string> wrong = [.. Hashes.Except(GoldenHashes.Read())];
        Assert.True(
            wrong.Count == 0 && Hashes.Count == GoldenHashes.Scenes.Count,
            $"{way}: {string.Join("; ", wrong)} is not in tests/data/golden-hashes.txt.\n"
            + $"If every way of running fails alike, the solver changed: renew with\n  {GoldenHashes.Renew}\n"
            + "If only some do, a result depends on the machine: that is a fault.");
    }
}
