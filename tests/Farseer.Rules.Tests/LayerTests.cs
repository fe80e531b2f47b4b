using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using Xunit;

namespace Farseer.Rules.Tests;

public sealed class LayerTests
{
    private const string Prefix = "Farseer.Engine.";

    [Theory]
    [InlineData("netstandard2.0")]
    [InlineData("net8.0")]
    public void EngineFolder_UsesOnlyItsOwnAndLowerRanks(string framework)
    {
        List<string> ranks = [.. File.ReadAllLines(Path.Combine(Repository.EngineFolder, "layers.txt")).Where(l => l.Length > 0)];
        using AssemblyWalk walk = new(Repository.Library("Farseer.Engine", framework));
        IReadOnlyList<Use> uses = walk.Uses();
        List<string> wrong = [];
        foreach (Use use in uses)
        {
            if (Layer(use.User) is { } user && Layer(use.UsedType) is { } used)
            {
                int userRank = ranks.IndexOf(user);
                int usedRank = ranks.IndexOf(used);
                if (userRank < 0 || usedRank < 0 || usedRank > userRank)
                {
                    wrong.Add(use.User + " -> " + use.UsedType);
                }
            }
        }

        Assert.True(uses.Count > 1000, "the walk saw only " + uses.Count + " uses");
        Assert.Empty(wrong.Distinct());
    }

    [Theory]
    [InlineData("netstandard2.0")]
    [InlineData("net8.0")]
    public void Engine_ExportsNoPublicType(string framework)
    {
        using AssemblyWalk walk = new(Repository.Library("Farseer.Engine", framework));
        IEnumerable<string> exported = walk.Metadata.TypeDefinitions
            .Select(walk.Metadata.GetTypeDefinition)
            .Where(t => (t.Attributes & TypeAttributes.VisibilityMask) == TypeAttributes.Public)
            .Select(t => walk.Metadata.GetString(t.Name));

        Assert.Empty(exported);
    }

    [Theory]
    [InlineData("Farseer.Engine", "netstandard2.0")]
    [InlineData("Farseer.Engine", "net8.0")]
    [InlineData("Farseer", "netstandard2.0")]
    [InlineData("Farseer", "net8.0")]
    [InlineData("Farseer.Box2DFlash", "netstandard2.0")]
    [InlineData("Farseer.Box2DFlash", "net8.0")]
    public void Assembly_RefersDownwardsOnly(string name, string framework)
    {
        HashSet<string> allowed = framework == "netstandard2.0"
            ? ["netstandard", "System.Memory", "System.Numerics.Vectors", "System.Runtime.CompilerServices.Unsafe"]
            : [];
        if (name != "Farseer.Engine")
        {
            allowed.Add("Farseer.Engine");
        }

        using AssemblyWalk walk = new(Repository.Library(name, framework));
        IEnumerable<string> wrong = walk.Metadata.AssemblyReferences
            .Select(r => walk.Metadata.GetString(walk.Metadata.GetAssemblyReference(r).Name))
            .Where(r => !allowed.Contains(r) && !(framework == "net8.0" && r.StartsWith("System.", StringComparison.Ordinal)));

        Assert.Empty(wrong);
    }

    // Farseer.Engine.Bodies.X -> Bodies; types the compiler makes have no layer.
    private static string? Layer(string type)
    {
        if (!type.StartsWith(Prefix, StringComparison.Ordinal))
        {
            return null;
        }

        string[] parts = type[Prefix.Length..].Split('.');
        return parts.Length > 1 ? parts[0] : null;
    }
}
