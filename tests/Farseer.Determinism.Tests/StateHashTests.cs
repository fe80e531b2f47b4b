using System;
using System.Collections.Generic;
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
        HashedRun run = HashedRun.OfBuilt(project, configuration, switchedOff);

        run.MustBeGolden($"{project}, {configuration}, without '{switchedOff}'", HashedRun.Asset(project, configuration));
    }

    [Fact]
    public void GoldenHashes_NameTheScenesOnce()
    {
        Assert.Equal(GoldenHashes.Scenes, GoldenHashes.Read().Select(l => l.Split(' ')[0]));
    }

    /// <summary>The runtime makes <c>Vector&lt;float&gt;</c> longer than eight lanes if it is told to and the processor has them.</summary>
    [Theory]
    [InlineData("Farseer.Determinism")]
    [InlineData("Farseer.Determinism.NetStandard")]
    public void Simulator_WithVectorsLongerThanABundle_TellsWhatToUnset(string project)
    {
        (int code, string output) = Command.Dotnet(
            Clone.Root,
            ["exec", HashedRun.Console(project, Clone.Configuration), "1", "falling-stack"],
            new Dictionary<string, string> { ["DOTNET_MaxVectorTBitWidth"] = "512" },
            HashedRun.Limit);

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
}
