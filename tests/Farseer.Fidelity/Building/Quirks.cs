using System;
using System.Collections.Generic;
using System.Linq;

namespace Farseer.Fidelity.Building;

/// <summary>
/// What was recorded is what the original did, with its faults: a scene is run with every compatibility flag of the library. One is
/// left off, <c>ForcesActAtOnce</c>, which is no fault of the outcome but the original's integrator, and that is judged by its error.
/// </summary>
public static class Quirks
{
    private static readonly string[] MethodFlags = ["ForcesActAtOnce"];

    /// <summary>The library's type of flags, or null while it has none.</summary>
    private static Type? EnumType => Facade.FindType("Farseer201Quirks");

    /// <summary>Each flag that a scene is run with.</summary>
    public static IReadOnlyList<object> Flags { get; } = EnumType is not { } type ? [] : [.. Enum.GetValues(type).Cast<object>()
        .Where(f => long.IsPow2(Bits(f)) && !MethodFlags.Contains(f.ToString()))];

    /// <summary>The flags together, or null while the library has none.</summary>
    public static object? All => Without(null);

    /// <summary>The flags together but for one.</summary>
    public static object? Without(object? flag) => EnumType is not { } type
        ? null
        : Enum.ToObject(type, Flags.Where(f => !f.Equals(flag)).Aggregate(0L, (sum, f) => sum | Bits(f)));

    public static void Set(object simulator, object quirks)
    {
        string? member = simulator.GetType().GetProperties().FirstOrDefault(p => p.PropertyType == quirks.GetType())?.Name;
        Facade.Set(simulator, member ?? throw new MissingPartException("PhysicsSimulator." + quirks.GetType().Name), quirks);
    }

    private static long Bits(object flag) => Convert.ToInt64(flag, System.Globalization.CultureInfo.InvariantCulture);
}
