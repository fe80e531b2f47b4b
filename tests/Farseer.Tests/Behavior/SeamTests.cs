using System;
using System.Collections.Generic;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Static pieces that lie side by side are one surface, and what is thin is a wall; over many worlds each.</summary>
public class SeamTests
{
    private const int Worlds = 400;

    /// <summary>Share of a speed or a way that counts as a loss: what is stopped or thrown up at a seam loses a tenth and more.</summary>
    private const float Loss = 0.01f;

    [Fact]
    public void Body_LandingOnAFloorOfPieces_KeepsItsSpeedAlong() => AssertNone(SeamScenes.Landing, Loss);

    [Fact]
    public void FastBody_LandingOnAFloorOfPieces_KeepsItsSpeedAlong() => AssertNone(SeamScenes.FastLanding, Loss);

    [Fact]
    public void Body_PressedOnAWallOfPieces_FallsAlongIt() => AssertNone(SeamScenes.Pressed, Loss);

    [Fact]
    public void Body_WalkingAtASetSpeed_GoesItsWay() => AssertNone(SeamScenes.Walking, Loss);

    [Fact]
    public void Body_SlidingOnToAPieceThatLeadsDown_KeepsItsSpeedAlong() => AssertNone(SeamScenes.Bend, Loss);

    [Fact]
    public void Box_CornerOnCornerWithPieces_SlidesOff() => AssertNone(SeamScenes.Aligned, Loss);

    // A box is pressed in by as much as a step's blow of the contact's softness: a fiftieth of its size.
    [Fact]
    public void Body_AgainstAPieceThatStandsHigher_IsStopped() => AssertNone(SeamScenes.Ledge, 0.02f);

    [Fact]
    public void SmallBall_AgainstSomethingThin_DoesNotPass() => AssertNone(seed => SeamScenes.Passes(seed) ? 1 : 0, 0);

    // With 1 mm of overlap on one side the box, which sinks in by 4 mm, tips over that side and jams in the hole, 0.29 m deep.
    [Fact]
    public void Box_OverANarrowerHole_DoesNotFallThrough() => AssertNone(SeamScenes.Hole, 0.3f);

    private static void AssertNone(Func<int, float> scene, float most)
    {
        var failed = new List<string>();
        for (int seed = 0; seed < Worlds; seed++)
        {
            float found = scene(seed);
            if (!(found <= most))
            {
                failed.Add($"{seed}: {found:g3}");
            }
        }

        Assert.True(failed.Count == 0, $"{failed.Count} of {Worlds}: {string.Join(", ", failed)}");
    }
}
