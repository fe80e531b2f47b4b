using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>What the engine must not call, because its bits, its order or its time depend on the machine.</summary>
public sealed class EngineCallTests
{
    private static readonly HashSet<string> _transcendental =
    [
        "Sin", "Cos", "Tan", "SinCos", "Asin", "Acos", "Atan", "Atan2", "Sinh", "Cosh", "Tanh", "Pow", "Exp", "Log", "Log2",
        "Log10", "Cbrt", "FusedMultiplyAdd",
    ];

    private static readonly HashSet<string> _vector2 = ["Lerp", "Transform", "Normalize"];

    private static readonly HashSet<string> _types =
    [
        "System.Linq.Enumerable", "System.Random", "System.DateTime", "System.Environment", "System.Collections.Generic.HashSet`1",
        "System.Collections.Generic.Dictionary`2",
    ];

    [Theory]
    [InlineData("netstandard2.0")]
    [InlineData("net8.0")]
    public void Engine_CallsNothingBanned(string framework)
    {
        using AssemblyWalk walk = new(Repository.Library("Farseer.Engine", framework));

        Assert.Empty(walk.Uses().Where(IsBanned).Select(u => $"{u.User}: {u.UsedType}.{u.Member}").Distinct());
    }

    [Theory]
    [InlineData("netstandard2.0")]
    [InlineData("net8.0")]
    public void Engine_HasNoStaticFieldButConstants(string framework)
    {
        using AssemblyWalk walk = new(Repository.Library("Farseer.Engine", framework));
        MetadataReader metadata = walk.Metadata;
        List<string> wrong = [];
        foreach (TypeDefinition type in metadata.TypeDefinitions.Select(metadata.GetTypeDefinition))
        {
            string typeName = metadata.GetString(type.Name);
            if (typeName.Contains('<', StringComparison.Ordinal))
            {
                continue; // made by the compiler: cached delegates and data of initialisers
            }

            wrong.AddRange(type.GetFields()
                .Select(metadata.GetFieldDefinition)
                .Where(f => (f.Attributes & FieldAttributes.Static) != 0)
                // Readonly is not enough: the elements of a static array, or the insides of a static object, can still be written.
                .Where(f => (f.Attributes & FieldAttributes.Literal) == 0)
                .Select(f => typeName + "." + metadata.GetString(f.Name)));
        }

        Assert.Empty(wrong);
    }

    private static bool IsBanned(Use use)
    {
        // Who of several threads does what depends on the clock in any case, and nothing that is computed depends on who does it.
        bool clock = use.UsedType == "System.Diagnostics.Stopwatch"
            && use.User is not ("Farseer.Engine.Stepping.StepProfile" or "Farseer.Engine.Stepping.CrewPatience");
        bool thread = use.UsedType.StartsWith("System.Threading.", StringComparison.Ordinal)
            && use.User.Split('/')[0] is not ("Farseer.Engine.Stepping.StageRunner" or "Farseer.Engine.Stepping.StageList");
        bool lanes = use.Member.EndsWith("Estimate", StringComparison.Ordinal)
            || use.Member.StartsWith("MultiplyAdd", StringComparison.Ordinal)
            || use.Member == "FusedMultiplyAdd"
            // Two terms add to the same in either order, so Vector2.Dot is no horizontal sum in this sense.
            || (use.Member is "Sum" or "Dot"
                && use.UsedType != "System.Numerics.Vector2"
                && use.UsedType.StartsWith("System.Numerics.Vector", StringComparison.Ordinal));
        return clock || thread || lanes || _types.Contains(use.UsedType)
            || (use.UsedType is "System.Math" or "System.MathF" && _transcendental.Contains(use.Member))
            || (use.UsedType == "System.Numerics.Vector2" && _vector2.Contains(use.Member));
    }
}
