using System;
#if NETSTANDARD_ASSET
using System.Numerics;
#endif
using System.Reflection;
using System.Runtime.Versioning;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Scenes;

/// <summary>Which build of the library runs, and how wide its kernels are here.</summary>
internal static class Asset
{
    private const string Standard = "netstandard";

    /// <summary>
    /// The folder of the package that it is from: net8.0 or netstandard2.0. (The full name of a framework has a comma, which no column of a
    /// file may have.)
    /// </summary>
    public static string Name { get; } = ShortName(new FrameworkName(
        typeof(PhysicsSimulator).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName));

    /// <summary>
    /// Lanes of the passes over contacts: sixteen or eight in the net8.0 asset, in the other one as many as <see cref="Vector{T}"/> has.
    /// </summary>
#if NETSTANDARD_ASSET
    public static int Lanes => Vector<float>.Count;
#else
    public static int Lanes => Engine.Numerics.Sixteen.WideLanes.AreThere ? 16 : 8;
#endif

    private static string ShortName(FrameworkName framework) =>
        $"{(framework.Identifier == ".NETStandard" ? Standard : "net")}{framework.Version.ToString(2)}";
}
