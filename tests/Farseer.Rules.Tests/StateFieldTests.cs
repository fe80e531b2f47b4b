using System;
using System.Linq;
using Box2D.Dynamics;
using FarseerGames.FarseerPhysics;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>What lives from step to step is saved and restored, or says why it need not be.</summary>
public sealed class StateFieldTests
{
    [Fact]
    public void Fields_ThatLiveFromStepToStep_AreVisitedOrSayWhyNot()
    {
        var walk = new StateWalk(typeof(PhysicsSimulator).Assembly, typeof(b2World).Assembly);
        walk.Walk(typeof(PhysicsSimulator));
        walk.Walk(typeof(b2World));

        Assert.True(
            walk.Visited > 400 && walk.Reasons.Count > 150,
            $"the walk saw only {walk.Visited} fields with state and {walk.Reasons.Count} reasons");
        Assert.True(!walk.Missing.Any(), "Missing: " + string.Join("\n", walk.Missing));
        Assert.True(!walk.Unvisited.Any(), "Unvisited: " + string.Join("\n", walk.Unvisited));
        Assert.True(!walk.Contradictory.Any(), "Contradictory: " + string.Join("\n", walk.Contradictory));
        Assert.True(!walk.Unasked.Any(), "Unasked: " + string.Join("\n", walk.Unasked));
    }

    // What chance leaves between fields would be in the hash of a state.
    [Fact]
    public void Records_OfAState_HaveNoPadding()
    {
        var walk = new StateWalk(typeof(PhysicsSimulator).Assembly, typeof(b2World).Assembly);

        Assert.True(walk.Records.Count > 80, $"the walk saw only {walk.Records.Count} records");
        Assert.True(!walk.Padded.Any(), "Padded: " + string.Join("\n", walk.Padded));
    }
}
