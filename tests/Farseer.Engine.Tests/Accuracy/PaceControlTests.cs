using Farseer.Engine.Accuracy;
using Xunit;

namespace Farseer.Engine.Tests.Accuracy;

/// <summary>Steps that take a + b·n for n substeps are brought within a limit and kept there.</summary>
public class PaceControlTests
{
    [Theory]
    [InlineData(0, 1, 16)]
    [InlineData(4, 1, 16)]
    [InlineData(10, 0.5, 16)]
    [InlineData(1, 0.01, 5)]
    public void Pace_OfSteadySteps_StaysWithinTheLimitAndUsesMostOfIt(double once, double each, double limit)
    {
        var pace = new PaceControl();
        int substeps = 1;
        double time = 0;
        for (int i = 0; i < 60; i++)
        {
            time = once + (each * substeps);
            pace.Learn(time, substeps);
            substeps = System.Math.Min(pace.Most(limit), 2 * substeps);
            Assert.True(time <= limit, $"step {i}: {time} of {limit}");
        }

        // Nine tenths are aimed at, in whole substeps; one more is reckoned at the mean of those taken.
        Assert.True(time + (time / substeps) >= 0.9 * limit, $"{time} of {limit} used");
    }

    [Fact]
    public void Pace_AfterOneInterruptedStep_IsBackInAFewSteps()
    {
        var pace = new PaceControl();
        pace.Learn(8, 8);
        int before = pace.Most(16);
        pace.Learn(800, 8);
        Assert.True(pace.Most(16) < before);
        pace.Learn(8, 8);
        Assert.Equal(before, pace.Most(16));
    }

    [Fact]
    public void Pace_OfALoadThatGrew_FallsToItsShareWithinFourSteps()
    {
        var pace = new PaceControl();
        pace.Learn(16, 16);
        for (int i = 0; i < 4; i++)
        {
            int now = pace.Most(16);
            pace.Learn(4.0 * now, now);
        }

        // Half of each surprise is believed: after four steps it is 1/16 of 3 short of 4 a substep.
        Assert.InRange(pace.Most(16), 3, 4);
    }

    [Fact]
    public void Pace_WithoutALimitThatCanBeKept_IsOneAndUnknownIsUnbounded()
    {
        var pace = new PaceControl();
        Assert.Equal(int.MaxValue, pace.Most(1e-3));
        pace.Learn(1, 4);
        Assert.Equal(1, pace.Most(1e-9));
        pace.Reset();
        Assert.Equal(int.MaxValue, pace.Most(1e-9));
    }
}
