using System;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

public class WorkerTests
{
    [Theory]
    [InlineData(2)]
    [InlineData(8)]
    [InlineData(0)]
    public void SetWorkerCount_ToAnyNumber_GivesTheSameWorld(int workers)
    {
        Assert.Equal(Hash(1), Hash(workers));
    }

    [Fact]
    public void SetWorkerCount_BelowZero_IsRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => Bench.World().SetWorkerCount(-1));
    }

    private static ulong Hash(int workers)
    {
        b2World world = Bench.World(half: 1000);
        Bench.Static(world, 0, -1, 500, 1);
        for (int i = 0; i < 1200; i++)
        {
            float x = (i % 80) * 1.02f;
            float y = 0.5f + (i / 80);
            if (i % 3 == 0)
            {
                Bench.Ball(world, x, y, restitution: 0.2f);
            }
            else
            {
                Bench.Dynamic(world, x, y);
            }
        }

        world.SetWorkerCount(workers);
        Bench.Step(world, 60);
        return world.MotionHash();
    }
}
