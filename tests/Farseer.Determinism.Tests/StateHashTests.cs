using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.Intrinsics;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Determinism.Tests;

/// <summary>
/// The same scene gives the same bits whatever the asset, the build configuration and the width of the processor's vectors, and the bits
/// that the repository holds. FARSEER_UPDATE_HASHES=1 writes those anew, from one way of running; all others are held to it at once.
/// </summary>
public sealed class StateHashTests
{
    // The slowest way, Debug without vectors, takes a quarter of a minute on two cores.
    private static readonly TimeSpan _limit = TimeSpan.FromMinutes(4);

    private static readonly object _once = new();
    private static bool _renewed;

    public static TheoryData<string, string, string> Ways()
    {
        string[] settings = ["", "DOTNET_EnableAVX512", "DOTNET_EnableAVX2", "DOTNET_EnableAVX", "DOTNET_EnableHWIntrinsic"];
        TheoryData<string, string, string> ways = [];
        foreach (string project in new[] { "Farseer.Determinism", "Farseer.Determinism.NetStandard" })
        {
            foreach (string configuration in new[] { "Release", "Debug" })
            {
                foreach (string setting in settings)
                {
                    ways.Add(project, configuration, setting);
                }
            }
        }

        return ways;
    }

    [Theory]
    [MemberData(nameof(Ways))]
    public void Scenes_RunThisWay_GiveTheGoldenHashes(string project, string configuration, string switchedOff)
    {
        RenewIfAsked();

        (string asset, IReadOnlyList<string> hashes) = Run(project, configuration, switchedOff);

        string framework = project.EndsWith("NetStandard", StringComparison.Ordinal) ? ".NETStandard,Version=v2.0" : ".NETCoreApp,Version=v8.0";
        Assert.Equal($"{framework} {configuration}", asset);
        List<string> wrong = [.. hashes.Except(GoldenHashes.Read())];
        Assert.True(
            wrong.Count == 0 && hashes.Count == GoldenHashes.Scenes.Count,
            $"{project}, {configuration}, without '{switchedOff}': {string.Join("; ", wrong)} is not in tests/data/golden-hashes.txt.\n"
            + $"If every way of running fails alike, the solver changed: renew with\n  {GoldenHashes.Renew}\n"
            + "If only some do, a result depends on the machine: that is a fault.");
    }

    [Fact]
    public void GoldenHashes_NameTheScenesOnce()
    {
        RenewIfAsked();

        Assert.Equal(GoldenHashes.Scenes, GoldenHashes.Read().Select(l => l.Split(' ')[0]));
    }

    /// <summary>The runtime makes <c>Vector&lt;float&gt;</c> longer than eight lanes if it is told to and the processor has them.</summary>
    [Theory]
    [InlineData("Farseer.Determinism")]
    [InlineData("Farseer.Determinism.NetStandard")]
    public void Simulator_WithVectorsLongerThanABundle_TellsWhatToUnset(string project)
    {
        string console = Path.Combine(Clone.Root, "tests", project, "bin", Clone.Configuration, "net10.0", project + ".dll");

        (int code, string output) = Command.Dotnet(
            Clone.Root, ["exec", console, "1", "falling-stack"], new Dictionary<string, string> { ["DOTNET_MaxVectorTBitWidth"] = "512" }, _limit);

        if (Vector512.IsHardwareAccelerated)
        {
            Assert.NotEqual(0, code);
            Assert.Contains("PlatformNotSupportedException: Vector<float> has 16 lanes", output, StringComparison.Ordinal);
            Assert.Contains("DOTNET_MaxVectorTBitWidth", output, StringComparison.Ordinal);
        }
        else
        {
            Assert.True(code == 0, output);
        }
    }

    private static void RenewIfAsked()
    {
        lock (_once)
        {
            if (!_renewed && Environment.GetEnvironmentVariable("FARSEER_UPDATE_HASHES") == "1")
            {
                GoldenHashes.Write(Run("Farseer.Determinism", Clone.Configuration, "").Hashes);
                _renewed = true;
            }
        }
    }

    // Two runs in one process, except without vectors, where one is slow enough: a state that leaks from run to run shows elsewhere.
    private static (string Asset, IReadOnlyList<string> Hashes) Run(string project, string configuration, string switchedOff)
    {
        int runs = switchedOff == "DOTNET_EnableHWIntrinsic" ? 1 : 2;
        string console = Path.Combine(Clone.Root, "tests", project, "bin", configuration, "net10.0", project + ".dll");
        Dictionary<string, string> environment = switchedOff.Length > 0 ? new() { [switchedOff] = "0" } : [];
        (int code, string output) = Command.Dotnet(
            Clone.Root, ["exec", console, runs.ToString(), .. GoldenHashes.Scenes], environment, _limit);
        Assert.True(code == 0, output);

        string[] lines = output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        List<string> hashes = [];
        foreach (string[] parts in lines.Skip(1).Select(l => l.Split(' ')))
        {
            Assert.Equal(runs + 1, parts.Length);
            Assert.Single(parts.Skip(1).Distinct());
            hashes.Add(parts[0] + " " + parts[1]);
        }

        return (lines[0], hashes);
    }
}
