using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>Where the facade may touch the engine: in bulk in <c>Bridge</c>, elsewhere at most one folder of the engine a type.</summary>
public sealed class FacadeTests
{
    private const string Facade = "FarseerGames.FarseerPhysics.";
    private const string FlashFacade = "Box2D.";
    private const string Engine = "Farseer.Engine.";

    // What a type of the facade writes and reads its own fields with; it tells nothing of how the engine works.
    private const string Stream = Engine + "Storage.StateStream";

    // The types that need more, with all they may use. A longer list means that work belongs in Bridge.
    private static readonly Dictionary<string, string[]> _wider = new()
    {
        // Owns the engine's world and its settings, steps it and reads its profile.
        ["PhysicsSimulator"] = ["Accuracy", "Bodies", "BroadPhase", "Settings", "Simulation", "Stepping", "Storage"],
        // Outline and pose.
        ["Collisions.Geom"] = ["Bodies", "Shapes"],
        // What a float and a place may be.
        ["Require"] = ["Bodies", "Numerics"],
    };

    [Theory]
    [InlineData("Farseer", Facade, "netstandard2.0")]
    [InlineData("Farseer", Facade, "net8.0")]
    [InlineData("Farseer.Box2DFlash", FlashFacade, "netstandard2.0")]
    [InlineData("Farseer.Box2DFlash", FlashFacade, "net8.0")]
    public void Type_OutsideBridge_UsesOneEngineFolder(string library, string facade, string framework)
    {
        using AssemblyWalk walk = new(Repository.Library(library, framework));
        List<(string Type, List<string> Folders)> types = [.. walk.Uses()
            .Where(u => u.UsedType != Stream)
            .Where(u => u.UsedType.StartsWith(Engine, StringComparison.Ordinal) && u.User.StartsWith(facade, StringComparison.Ordinal))
            .Select(u => (Type: u.User.Split('/')[0][facade.Length..], Folder: u.UsedType[Engine.Length..].Split('.')[0]))
            .Where(u => !u.Type.StartsWith("Bridge.", StringComparison.Ordinal))
            .GroupBy(u => u.Type, u => u.Folder)
            .Select(g => (g.Key, g.Distinct().Order(StringComparer.Ordinal).ToList()))];

        Assert.True(types.Count >= _wider.Count, "the walk saw only " + types.Count + " types");
        Assert.Empty(types
            .Where(t => _wider.TryGetValue(t.Type, out string[]? allowed) ? t.Folders.Except(allowed).Any() : t.Folders.Count > 1)
            .Select(t => t.Type + " uses " + string.Join(", ", t.Folders)));
    }
}
