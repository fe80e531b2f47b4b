using System;
using System.Numerics;
using System.Reflection;
using System.Runtime.Versioning;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Scenes;

/// <summary>Which build of the library runs, and how wide its kernels are here.</summary>
internal static class Asset
{
    private const string Standard = "netstandard";

    /// <summary>The folder of the package that it is from: net8.0 or netstandard2.0. (The full name of a framework has a comma, which no column of a file may have.)</summary>
    public static string Name { get; } = ShortName(new FrameworkName(
        typeof(PhysicsSimulator).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName));

    /// <summary>The net8.0 asset always computes on eight lanes, the other one on as many as <see cref="Vector{T}"/> has.</summary>
    public static int Lanes => Name.StartsWith(Standard, StringComparison.Ordinal) ? Vector<float>.Count : 8;

    private static string ShortName(FrameworkName framework) =>
        $"{(framework.Identifier == ".NETStandard" ? Standard : "net")}{framework.Version.ToString(2)}";
}
