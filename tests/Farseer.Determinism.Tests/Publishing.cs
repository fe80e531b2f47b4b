using System;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using Xunit;

namespace Farseer.Determinism.Tests;

/// <summary>What a machine needs to publish for another processor and to run the result. Looked for, not installed.</summary>
internal static class Publishing
{
    public const string Emulator = "qemu-aarch64-static";

    /// <summary>Debian's libc6-arm64-cross and libstdc++6-arm64-cross put the libraries of an ARM64 system here.</summary>
    public const string Arm64Root = "/usr/aarch64-linux-gnu";

    /// <summary>Set to a reason, the tests that publish are skipped with it.</summary>
    private const string Unwanted = "FARSEER_PUBLISH_NOTHING";

    public static bool HasClang { get; } = Has("clang");

    public static string? WhyNoArm64 { get; } =
        WhyNothing() ?? (!Has(Emulator) || !File.Exists(Arm64Root + "/lib/libstdc++.so.6")
            ? "an ARM64 processor is emulated with Debian's qemu-user-static, libc6-arm64-cross and libstdc++6-arm64-cross, which are "
                + "not all here" : null);

    public static string? WhyNoNative { get; } =
        WhyNothing() ?? (!HasClang && !Has("gcc") ? "native code is linked with clang or gcc, and neither is here" : null);

    private static string? WhyNothing() =>
        Environment.GetEnvironmentVariable(Unwanted) is { Length: > 0 } reason ? reason
        : !OperatingSystem.IsLinux() || RuntimeInformation.ProcessArchitecture != Architecture.X64 ? "published on Linux x64 only" : null;

    private static bool Has(string program) =>
        (Environment.GetEnvironmentVariable("PATH") ?? string.Empty).Split(Path.PathSeparator)
            .Any(folder => File.Exists(Path.Combine(folder, program)));
}

/// <summary>A test that runs on an emulated ARM64 processor: skipped, and reported so, where there is no emulator.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class Arm64TheoryAttribute : TheoryAttribute
{
    public Arm64TheoryAttribute() => Skip = Publishing.WhyNoArm64;
}

/// <summary>A test that compiles to native code: skipped, and reported so, where there is no linker.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class NativeTheoryAttribute : TheoryAttribute
{
    public NativeTheoryAttribute() => Skip = Publishing.WhyNoNative;
}
