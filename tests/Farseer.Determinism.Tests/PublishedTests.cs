using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Determinism.Tests;

/// <summary>The bits that the repository holds also come out of an ARM64 processor, and of code that was compiled ahead of time.</summary>
public sealed class PublishedTests
{
    /// <summary>The newest level of x86-64 that this processor has lanes for, and the one that a publisher gets who names none.</summary>
    public static TheoryData<string> Instructions() =>
        Vector512.IsHardwareAccelerated ? ["", "x86-64-v4"] : Avx2.IsSupported ? ["", "x86-64-v3"] : [""];

    [Arm64Theory]
    [InlineData("Farseer.Determinism")]
    [InlineData("Farseer.Determinism.NetStandard")]
    public void Scenes_OnArm64_GiveTheGoldenHashes(string project) =>
        WithPublished(project, ["-p:Published=arm64"], folder =>
        {
            // The emulator translates code once: a runtime that writes it through a second mapping would not be seen to change it.
            Dictionary<string, string> environment = new() { ["DOTNET_EnableWriteXorExecute"] = "0" };
            HashedRun run = HashedRun.Of(
                Command.Run(
                    Publishing.Emulator,
                    folder,
                    ["-L", Publishing.Arm64Root, Path.Combine(folder, project), .. HashedRun.Arguments(1)],
                    environment,
                    HashedRun.Limit), 1);

            run.MustBeGolden($"{project}, ARM64", HashedRun.Asset(project, "Release"));
        });

    [NativeTheory]
    [MemberData(nameof(Instructions))]
    public void Scenes_InNativeCode_GiveTheGoldenHashes(string instructions)
    {
        const string project = "Farseer.Determinism";
        string[] linker = Publishing.HasClang ? [] : ["-p:CppCompilerAndLinker=gcc", "-p:LinkerFlavor=bfd"];
        WithPublished(project, ["-p:Published=native", "-p:Instructions=" + instructions, .. linker], folder =>
        {
            HashedRun run = HashedRun.Of(
                Command.Run(
                    Path.Combine(folder, project), folder, HashedRun.Arguments(2), new Dictionary<string, string>(), HashedRun.Limit), 2);

            run.MustBeGolden($"{project}, native, '{instructions}'", HashedRun.Asset(project, "Release"));
        });
    }

    private static void WithPublished(string project, string[] properties, Action<string> test)
    {
        string folder = Directory.CreateTempSubdirectory("farseer-published").FullName;
        try
        {
            (int code, string output) = Command.Dotnet(
                Clone.Root,
                ["publish", "-c", "Release", Path.Combine("tests", project), "-o", folder, .. properties],
                new Dictionary<string, string>(),
                HashedRun.Limit);
            Assert.True(code == 0, output);
            test(folder);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
