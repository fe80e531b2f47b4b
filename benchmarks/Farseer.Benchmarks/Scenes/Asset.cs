using System;
using System.Numerics;
using System.Reflection;
using System.Runtime.Versioning;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Scenes;

/// <summary>Which build of the library runs, and how wide its kernels are here.</summary>
internal static class Asset
{
    public static string Framework { get; } =
        typeof(PhysicsSimulator).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()?.FrameworkName ?? "unknown";

    /// <summary>The net8.0 asset always computes on eight lanes, the other one on as many as <see cref="Vector{T}"/> has.</summary>
    public static int Lanes => Framework.StartsWith(".NETCoreApp", StringComparison.Ordinal) ? 8 : Vector<float>.Count;
}
