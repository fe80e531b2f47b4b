using System.Linq;
using Farseer.Accuracy;
using Farseer.Accuracy.Sweeping;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>No error stays when the dial is turned up: each doubling divides it by 1.5 at least, until rounding.</summary>
public class FloorTests
{
    private const double Factor = 1.5;

    private static readonly int[] _dials = [1, 2, 4, 8, 16, 32, 64];

    [Theory]
    [InlineData("S03_bounce=0.8")]
    [InlineData("S08_pendulum=90")]
    [InlineData("S09_double_pendulum=90")]
    [InlineData("S11_rope=100")]
    [InlineData("S11b_rope_swing=10")]
    [InlineData("S12_bridge=100")]
    [InlineData("S15_stack=20")]
    [InlineData("S16_pyramid=10")]
    [InlineData("S17_mass_ratio=100")]
    [InlineData("S18_arch=1")]
    public void Error_OfASweepScene_FallsWithEachDoublingOfTheDial(string name)
    {
        SweepScene scene = SweepScene.All.Single(s => s.Scene == name);
        double coarse = Error(scene, _dials[0]);
        foreach (int dial in _dials.Skip(1))
        {
            double fine = Error(scene, dial);
            Assert.True(fine <= System.Math.Max(coarse / Factor, scene.Rounding), $"{name}, iterations {dial}: {coarse} -> {fine}");
            coarse = fine;
        }
    }

    [Fact]
    public void Hypervolume_OfKnownFronts_IsTheArea()
    {
        SweepPoint exact = new("x", "s", SweepKind.Dial, 1, 1, 1e-9, 10, Failed: false);
        SweepPoint middle = new("x", "s", SweepKind.Dial, 1, 1, 1e-2, 1000, Failed: false);
        SweepPoint failed = new("x", "s", SweepKind.Dial, 1, 1, 1, 10, Failed: true);
        Assert.Equal(1, Pareto.Hypervolume([exact, middle]), 12);
        Assert.Equal(0.25, Pareto.Hypervolume([middle]), 12);
        Assert.Equal(0.25, Pareto.Hypervolume([failed, middle]), 12);
        Assert.Equal(0, Pareto.Hypervolume([failed]), 12);
        Assert.Equal([middle], Pareto.Front([middle, middle with { Cost = 2000 }]));
        Assert.Null(Pareto.Cheapest([failed], 1));
    }

    [Fact]
    public void Peers_OfTheComparison_HaveThePublishedHypervolumes()
    {
        var points = SweepData.Peers();
        Assert.Equal(0.165, SweepTables.Hypervolume(points, "Box2D.NET").Mean, 3);
        Assert.Equal(0.159, SweepTables.Hypervolume(points, "Aether").Mean, 3);
        Assert.Equal(0.292, SweepTables.Hypervolume(points, "Box2D.NET(stiff)").Mean, 3);
    }

    private static double Error(SweepScene scene, int iterations) =>
        SweepCommand.Measure(scene, SweepKind.Dial, iterations, Options.DefaultDt, 1).Error;
}
