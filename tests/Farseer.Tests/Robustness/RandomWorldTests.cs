using System;
using System.Collections.Generic;
using System.Globalization;
using Xunit;
using Xunit.Abstractions;

namespace Farseer.Tests.Robustness;

/// <summary>
/// Worlds with joints of all kinds between any two bodies, in which something is put elsewhere, switched or removed all the time.
/// </summary>
public class RandomWorldTests
{
    private const int Seeds = 300;

    /// <summary>What a body may have of the energy that gravity, springs and motors gave: half of it more than all.</summary>
    private const double MostShare = 1.5;

    /// <summary>
    /// So many of the 300 may exceed it; 5 do (16 before soft pivots were solved as one, 14 before those at their own stops were asked
    /// again without them). 25: a soft slider that was overrun goes back with a speed. The others, of up to forty bodies with as many
    /// joints that contradict each other, were not reduced to a cause; which of them it are goes by chance, 2 in 100 of all seeds.
    /// </summary>
    private const int MostOver = 10;

    /// <summary>
    /// So many of these may have a body faster than this: one of 300 has (113: a slider, a gear and hinges that contradict each other; 3 of
    /// 1,200 seeds, and by chance which). 60 a second are usual, 683 in seed 30 before; a soft pivot swung up to 11,300 in seed 79 before
    /// that. (In a world within its energy a motor may drive a body faster.)
    /// </summary>
    private const int MostFast = 1;
    private const float Fastest = 700;

    private readonly ITestOutputHelper _output;

    public RandomWorldTests(ITestOutputHelper output) => _output = output;

    [Fact]
    public void RandomWorlds_Run_KeepWithinTheirEnergyAndAboveTheFloor()
    {
        var over = new List<string>();
        float fastest = 0;
        int fast = 0;
        for (int seed = 0; seed < Seeds; seed++)
        {
            var world = new RandomWorld(seed);
            world.Run();
            Assert.True(world.Quarantined == 0, $"{seed}: {world.Quarantined} bodies were quarantined");
            Assert.True(world.BelowFloor == 0, $"{seed}: {world.BelowFloor} bodies are below the floor");
            if (world.WorstShare > MostShare)
            {
                fastest = MathF.Max(fastest, world.Fastest);
                fast += world.Fastest > Fastest ? 1 : 0;
                over.Add(string.Create(CultureInfo.InvariantCulture, $"{seed} ({world.WorstShare:g3})"));
            }
        }

        _output.WriteLine(
            $"{over.Count} of {Seeds} exceed their energy: {string.Join(", ", over)}; the fastest body of those {fastest:g4}");
        Assert.InRange(over.Count, 0, MostOver);
        Assert.InRange(fast, 0, MostFast);
    }

    /// <summary>
    /// What was left of seed 79: a body of 0.1 kg on a soft pivot six sizes off it; the same with a limit of its angle and a heavy body
    /// that hangs on it and meets the floor.
    /// </summary>
    [Theory]
    [InlineData(38, 123)]
    [InlineData(27, 37, 38, 87, 98, 123)]
    public void SoftPivot_WhoseAnchorIsFarOffALightBody_KeepsWithinItsEnergy(params int[] parts)
    {
        var world = new RandomWorld(79, part => Array.IndexOf(parts, part) >= 0);

        world.Run();

        Assert.Equal(0, world.Quarantined);
        Assert.InRange(world.WorstShare, 0, 1);
    }

    /// <summary>
    /// What was left of seed 30: two bodies of 0.2 kg on a slider between two rods, at its stop, with a target, a servo and a limit of the
    /// angle, which contradict each other. Its servo found its impulse with the mass of all that the stop held, and the stop let go of it:
    /// they were off at 740 m/s with 45 times what they had been given.
    /// </summary>
    [Fact]
    public void Servo_ThatOpensTheStopOfALinkage_KeepsWithinItsEnergy()
    {
        int[] parts = { 9, 10, 11, 25, 26, 27, 35, 37, 46, 49, 57, 69 };
        var world = new RandomWorld(30, part => Array.IndexOf(parts, part) >= 0);

        world.Run();

        Assert.Equal(0, world.Quarantined);
        Assert.InRange(world.WorstShare, 0, 1);
        Assert.InRange(world.Fastest, 0, 10);
    }

    /// <summary>
    /// What was left of seed 692: a body of 0.3 kg at its stop, 4 m off its soft pivot, which pulled with the mass of the whole body. The
    /// stop let go of it: it was off at a kilometre a second, with seven times what had been given to all.
    /// </summary>
    [Fact]
    public void SoftPivot_ThatOpensItsOwnStop_KeepsWithinItsEnergy()
    {
        int[] parts = { 6, 9, 31, 32, 33, 34, 67, 89, 90 };
        var world = new RandomWorld(692, part => Array.IndexOf(parts, part) >= 0);

        world.Run();

        Assert.Equal(0, world.Quarantined);
        Assert.InRange(world.WorstShare, 0, 1);
        Assert.InRange(world.Fastest, 0, 200);
    }
}
