using System.Collections.Generic;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;
using Farseer.Engine.Tests.Simulation;
using Xunit;

namespace Farseer.Engine.Tests.Islands;

public sealed class IslandGroupTests
{
    private const int Piles = 60;
    private const int Boxes = 12;
    private const int Steps = 160;

    /// <summary>Piles that are struck and fall onto each other, so that rows come to tie groups, and are sorted again.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void PilesSolvedByGroups_MoveAsAllTogether_BitForBit(int workers)
    {
        SleepScene together = Build(int.MaxValue, 1, out List<Handle> strikers);
        SleepScene grouped = Build(40, workers, out _);
        for (int step = 0; step < Steps; step++)
        {
            if (step % 40 == 20)
            {
                Strike(together, strikers, step);
                Strike(grouped, strikers, step);
            }

            together.World.Step(SleepScene.Dt);
            grouped.World.Step(SleepScene.Dt);
            Assert.Equal(together.World.Bodies.MotionHash(), grouped.World.Bodies.MotionHash());
        }

        Assert.Equal(0, together.World.Solver.IslandGroups.Sorts);
        Assert.True(
            grouped.World.Solver.IslandGroups.Sorts > 1, "The rows were sorted " + grouped.World.Solver.IslandGroups.Sorts + " times.");
        grouped.World.Dispose();
    }

    private static SleepScene Build(int groupRows, int workers, out List<Handle> strikers)
    {
        var scene = new SleepScene(allowSleep: false);
        scene.World.Solver.IslandGroups.GroupRows = groupRows;
        scene.World.SetWorkers(workers, workers, null);
        strikers = [];
        for (int i = 0; i < Piles; i++)
        {
            for (int k = 0; k < Boxes; k++)
            {
                Handle box = scene.Box(1.3f * (i - (Piles / 2)), 0.5f + k, 1, 1, BodyFlags.None);
                if (k == Boxes - 1)
                {
                    strikers.Add(box);
                }
            }
        }

        return scene;
    }

    private static void Strike(SleepScene scene, List<Handle> strikers, int step)
    {
        for (int i = step / 40; i < strikers.Count; i += 7)
        {
            scene.SetVelocity(strikers[i], 4, 0);
        }
    }
}
