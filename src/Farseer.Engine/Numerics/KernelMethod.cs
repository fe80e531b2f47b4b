using System.Runtime.CompilerServices;

namespace Farseer.Engine.Numerics;

/// <summary>How the compiler is to treat a method that is a whole pass over lanes.</summary>
internal static class KernelMethod
{
    /// <summary>
    /// Compiled in full at the first call (<c>AggressiveOptimization</c>, which netstandard2.0 cannot name), so that the first
    /// steps are as fast as the later ones; and never made part of its caller, where the budget for inlining runs out half way
    /// and leaves calls between lanes (the relax pass of a pyramid of 100: 0.77 ms a step against 0.34).
    /// </summary>
    public const MethodImplOptions Optimized = MethodImplOptions.NoInlining | (MethodImplOptions)512;
}
