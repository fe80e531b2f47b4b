using System;
using FarseerGames.FarseerPhysics;
using Xunit;
using Xunit.Abstractions;

namespace Farseer.Tests.Behavior;

/// <summary>
/// Steps of warm worlds allocate nothing, in many worlds in which all kinds of things happen: see <see cref="WarmWorld"/>.
/// </summary>
public class WarmStepTests
{
    private const int Worlds = 60;

    /// <summary>Worlds that compile what the others use.</summary>
    private const int FirstWorlds = 20;
    private const int FirstSteps = 60;
    private const int Steps = 200;
    private const int WarmSteps = 600;
    private const int LaterSteps = 400;

    /// <summary>
    /// Of the 24,000 later steps so many may allocate: a heap has more pairs or rows than ever before also after a thousand steps, and then
    /// its stores double. 3 do; before rooms were made with the bodies, joints and contacts that they are for, a hundred did.
    /// </summary>
    private const int MostGrowths = 6;

    private readonly ITestOutputHelper _output;

    public WarmStepTests(ITestOutputHelper output) => _output = output;

    /// <summary>
    /// The same motion twice, the second time from a restored state: then nothing is more than it was, so every byte is one that a step
    /// takes each time, or that restoring makes it take.
    /// </summary>
    [Fact]
    public void SameMotionAgain_FromARestoredState_AllocatesNothing()
    {
        for (int seed = 0; seed < FirstWorlds; seed++)
        {
            CountAgain(Worlds + seed);
        }

        for (int seed = 0; seed < Worlds; seed++)
        {
            long bytes = CountAgain(seed);
            Assert.True(bytes == 0, $"world {seed}: {bytes} bytes");
        }
    }

    /// <summary>
    /// Another motion of the same bodies, joints and handlers: what comes for the first time (a blow, a body asleep, a colour of rows)
    /// finds its room made, whenever it comes.
    /// </summary>
    [Fact]
    public void LaterMotion_OfAWarmWorld_AllocatesOnlyForMoreThanEver()
    {
        for (int seed = 0; seed < FirstWorlds; seed++)
        {
            CountLater(Worlds + seed);
        }

        int growths = 0;
        for (int seed = 0; seed < Worlds; seed++)
        {
            growths += CountLater(seed);
        }

        _output.WriteLine($"{growths} of {Worlds * LaterSteps} steps allocate");
        Assert.InRange(growths, 0, MostGrowths);
    }

    private static long CountAgain(int seed)
    {
        var world = new WarmWorld(seed, switches: true);
        Run(world, 0, FirstSteps);
        PhysicsSimulatorState state = world.Simulator.Capture();
        Run(world, FirstSteps, FirstSteps + Steps);
        ulong end = world.Simulator.StateHash();
        world.Simulator.Restore(state);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Run(world, FirstSteps, FirstSteps + Steps);
        long bytes = GC.GetAllocatedBytesForCurrentThread() - before;
        Assert.Equal(end, world.Simulator.StateHash());
        return bytes;
    }

    private int CountLater(int seed)
    {
        var world = new WarmWorld(seed, switches: false);
        Run(world, 0, WarmSteps);
        int growths = 0;
        for (int step = WarmSteps; step < WarmSteps + LaterSteps; step++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            world.Step(step);
            long bytes = GC.GetAllocatedBytesForCurrentThread() - before;
            if (bytes > 0)
            {
                growths++;
                _output.WriteLine($"world {seed}, step {step}: {bytes} bytes");
            }
        }

        return growths;
    }

    private static void Run(WarmWorld world, int from, int to)
    {
        for (int step = from; step < to; step++)
        {
            world.Step(step);
        }
    }
}
