using System;
using System.Linq;
using System.Numerics;
using System.Threading;
using Farseer.Tests.Shared.Growth;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>Nothing takes time or memory with the square of a world's size: the kinds of worlds of the growth table, small.</summary>
[Collection("What the collector counts")]
public class GrowthTests
{
    private const int Small = 250;
    private const int Large = 2000;
    private const int Steps = 5;

    /// <summary>So many measurements, with pauses: a machine that does something else for a second does not spoil them all.</summary>
    private const int Turns = 10;

    private const int Pause = 200;

    /// <summary>Bytes that the process makes once for whatever world is the first of its kind.</summary>
    private const double MadeOnce = 65536;

    /// <summary>
    /// Of n log n, of which the larger size has eleven times as much. What goes by the square has a power of 1.73; what goes by n, and
    /// leaves the caches on the way, has 0.9 to 1.3.
    /// </summary>
    private const double MostPower = 1.5;

    public static TheoryData<string> Kinds => new(GrowthWorlds.All.Select(w => w.Name));

    [Theory]
    [MemberData(nameof(Kinds))]
    public void World_EightTimesAsLarge_TakesTimeAndMemoryByItsSize(string kind)
    {
        GrowthWorld world = GrowthWorlds.Find(kind);
        int share = world.Work is null ? 1 : 10;
        GrowthFigures small = GrowthFigures.Measure(world, Small / share, Steps, 4);
        GrowthFigures large = GrowthFigures.Measure(world, Large / share, Steps, 2);
        double Power(Func<GrowthFigures, double> amount) => GrowthFigures.Power(world, small, large, amount);
        double Build() => Power(f => f.BuildSeconds);
        double Step() => Power(f => f.StepSeconds);
        double Bytes() => Power(f => Math.Max(MadeOnce, f.Bytes));

        // What goes by the square does so in each turn.
        for (int turn = 1; turn < Turns && Math.Max(Build(), Math.Max(Step(), Bytes())) > MostPower; turn++)
        {
            Thread.Sleep(Pause);
            small = small.BestWith(GrowthFigures.Measure(world, Small / share, Steps, 4));
            large = large.BestWith(GrowthFigures.Measure(world, Large / share, Steps, 2));
        }

        Assert.True(Build() <= MostPower, $"{kind}: making, power {Build():F2}; {small}, {large}");
        Assert.True(Step() <= MostPower, $"{kind}: an update, power {Step():F2}; {small}, {large}");
        Assert.True(Bytes() <= MostPower, $"{kind}: memory, power {Bytes():F2}; {small}, {large}");
    }

    /// <summary>Some 30 ms each; one corner after the other, each beside all others, they took 4 s.</summary>
    [Theory]
    [InlineData("wave")]
    [InlineData("spikes")]
    [InlineData("spiral")]
    public void Outline_OfTenThousandCorners_IsCheckedAndCutInLittleTime(string name)
    {
        Vertices outline = name switch
        {
            "wave" => ShapeWorlds.Wave(10_000),
            "spikes" => ShapeWorlds.Spikes(10_000),
            _ => ShapeWorlds.Spiral(10_000),
        };
        double start = GrowthClock.Seconds();

        Assert.True(outline.IsSimple());
        OutlineTriangles.Cut(outline.ToArray(), true, nameof(outline), out Vector2[] corners, out short[] indices);

        Assert.InRange(GrowthClock.Seconds() - start, 0, 1);
        Assert.Equal(3 * (corners.Length - 2), indices.Length);
        double area = 0;
        for (int i = 0; i < indices.Length; i += 3)
        {
            area += Math.Abs(new Vertices(new[] { corners[indices[i]], corners[indices[i + 1]], corners[indices[i + 2]] }).GetSignedArea());
        }

        // Sums of ten thousand floats.
        Assert.Equal(1, area / Math.Abs(outline.GetSignedArea()), 1e-4);
    }
}
