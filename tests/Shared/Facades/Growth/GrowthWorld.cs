using System;
using FarseerGames.FarseerPhysics;

namespace Farseer.Tests.Shared.Growth;

/// <summary>A kind of world of any size, whose time and memory are to grow with the work that it has, and no faster.</summary>
/// <param name="Name">What is in it.</param>
/// <param name="Counts">What its size counts.</param>
/// <param name="Build">Fills an empty simulator; what it returns is done before each update.</param>
/// <param name="Work">What time and memory may grow with, by size; without, n log n.</param>
internal sealed record GrowthWorld(string Name, string Counts, Func<PhysicsSimulator, int, Action> Build, Func<double, double>? Work = null)
{
    /// <summary>Of worlds that have nothing to do beside updates.</summary>
    public static Action Nothing { get; } = () => { };

    /// <summary>n log n, as what sorts has it.</summary>
    public static double Sorted(double n) => n * Math.Log2(n);

    /// <summary>All pairs of n: where all touch all, that many contacts are the answer.</summary>
    public static double Pairs(double n) => 0.5 * n * (n - 1);

    public double WorkOf(double size) => (Work ?? Sorted)(size);
}
