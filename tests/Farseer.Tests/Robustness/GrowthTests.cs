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
    private const int Turns = 5;

    private const int Pause = 200;

    /// <summary>Bytes that the process makes once for whatever world is the first of its kind.</summary>
    private const double MadeOnce = 65536;

    /// <summary>
    /// Of n log n, of which the larger size has eleven times as much. What goes by the square has a power of 1.73; what goes by n, and
    /// leaves the caches on the way, has 0.9 to 1.3.
    /// </summary>
    private const double MostPower = 1.5;

#if !NETSTANDARD_ASSET // The same sources, but its memory is pinned among what others left: what a world takes of it is for chance to say.
    public static TheoryData<string> Kinds => new(GrowthWorlds.All.Select(w => w.Name));

    [Theory]
    [MemberData(nameof(Kinds))]
    public void World_EightTimesAsLarge_TakesTimeAndMemoryByItsSize(string kind)
    {
        GrowthWorld world = GrowthWorlds.Find(kind);
        int share = world.Work is null ? 1 : 10;
        Powers powers = PowersBetween(world, Small / share, Large / share);

        // What first leaves the caches at the larger size does so once. What goes by the square does so between larger sizes as well.
        powers = powers.Most > MostPower ? powers.LeastWith(PowersBetween(world, Large / share, 8 * Large / share)) : powers;
        Assert.True(powers.Most <= MostPower, $"{kind}: {powers}");
    }

    /// <summary>The least powers of all turns, or of the first in which none is too large.</summary>
    private static Powers PowersBetween(GrowthWorld world, int smaller, int larger)
    {
        GrowthFigures small = GrowthFigures.Measure(world, smaller, Steps, 4);
        GrowthFigures large = GrowthFigures.Measure(world, larger, Steps, 2);
        for (int turn = 1; turn < Turns && Powers.Of(world, small, large).Most > MostPower; turn++)
        {
            Thread.Sleep(Pause);
            small = small.BestWith(GrowthFigures.Measure(world, smaller, Steps, 4));
            large = large.BestWith(GrowthFigures.Measure(world, larger, Steps, 2));
        }

        return Powers.Of(world, small, large);
    }

    /// <summary>The powers of the work with which a world's figures grow.</summary>
    private readonly record struct Powers(double Making, double Update, double Memory)
    {
        public double Most => Math.Max(Making, Math.Max(Update, Memory));

        public static Powers Of(GrowthWorld world, GrowthFigures small, GrowthFigures large) => new(
            GrowthFigures.Power(world, small, large, f => f.BuildSeconds),
            GrowthFigures.Power(world, small, large, f => f.StepSeconds),
            GrowthFigures.Power(world, small, large, f => Math.Max(MadeOnce, f.Bytes)));

        public Powers LeastWith(Powers other) =>
            new(Math.Min(Making, other.Making), Math.Min(Update, other.Update), Math.Min(Memory, other.Memory));
    }

    /// <summary>
    /// A node, a joint and its rows are some 3 KB, as much are contacts, shapes and what the facade keeps. With room for four trees side by
    /// side, of which there is one, it was 17 KB.
    /// </summary>
    [Theory]
    [InlineData("one ring of links")]
    [InlineData("a hub with many joints")]
    [InlineData("a comb: a chain of which each link carries another")]
    public void World_OfOneTree_KeepsRoomForOneTree(string kind)
    {
        GrowthFigures figures = GrowthFigures.Measure(GrowthWorlds.Find(kind), Large, Steps, 1);

        Assert.InRange(figures.Bytes / Large, 0, 10_000);
    }
#endif

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
