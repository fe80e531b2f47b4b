using System;
using System.Collections.Generic;
using System.Globalization;
using Xunit;
using Xunit.Abstractions;

namespace Farseer.Tests.Robustness;

/// <summary>Worlds with joints of all kinds between any two bodies, in which something is put elsewhere, switched or removed all the time.</summary>
public class RandomWorldTests
{
    private const int Seeds = 300;

    /// <summary>What a body may have of the energy that gravity, springs and motors gave: half of it more than all.</summary>
    private const double MostShare = 1.5;

    /// <summary>
    /// Of the 300 these exceed it (20 before limbs had rows beside what they pass). 74 and 79: soft pivots with anchors up to seven sizes off their bodies, of which both rows are iterated. 25: a
    /// soft slider that was overrun goes back with a speed. 100: joints that contradict each other. The others, of up to forty bodies with as many joints, were not reduced to a cause.
    /// </summary>
    private const int MostOver = 16;

    /// <summary>The soft pivot of seed 79, of 0.1 kg with its anchor metres off, swings up to 11,300 a second at random steps. (In a world within its energy a motor may drive a body faster.)</summary>
    private const float Fastest = 12000;

    private readonly ITestOutputHelper _output;

    public RandomWorldTests(ITestOutputHelper output) => _output = output;

    [Fact]
    public void RandomWorlds_Run_KeepWithinTheirEnergyAndAboveTheFloor()
    {
        var worlds = new RandomWorld[Seeds];
        for (int seed = 0; seed < Seeds; seed++)
        {
            worlds[seed] = new RandomWorld(seed);
            worlds[seed].Run();
        }

        var over = new List<string>();
        float fastest = 0;
        for (int seed = 0; seed < Seeds; seed++)
        {
            RandomWorld world = worlds[seed];
            Assert.True(world.Quarantined == 0, $"{seed}: {world.Quarantined} bodies were quarantined");
            Assert.True(world.BelowFloor == 0, $"{seed}: {world.BelowFloor} bodies are below the floor");
            if (world.WorstShare > MostShare)
            {
                fastest = MathF.Max(fastest, world.Fastest);
                over.Add(string.Create(CultureInfo.InvariantCulture, $"{seed} ({world.WorstShare:g3})"));
            }
        }

        _output.WriteLine($"{over.Count} of {Seeds} exceed their energy: {string.Join(", ", over)}; the fastest body of those {fastest:g4}");
        Assert.InRange(over.Count, 0, MostOver);
        Assert.InRange(fastest, 0, Fastest);
    }
}
