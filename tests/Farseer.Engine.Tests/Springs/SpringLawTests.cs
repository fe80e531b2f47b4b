using System;
using Farseer.Engine.Springs;
using Xunit;

namespace Farseer.Engine.Tests.Springs;

/// <summary>The exact law of a spring over a substep.</summary>
public class SpringLawTests
{
    /// <summary>An exact solution over h twice is that over 2h, whatever branch its coefficients come from.</summary>
    [Fact]
    public void TwoHalfSteps_AreOneStep_AtAnyStiffnessAndDamping()
    {
        var random = new Random(11);
        for (int i = 0; i < 20000; i++)
        {
            double k = i % 7 == 0 ? 0 : Math.Pow(10, (random.NextDouble() * 12) - 9);
            double c = i % 5 == 0 ? 0 : Math.Pow(10, (random.NextDouble() * 14) - 9);
            if (i % 11 == 0)
            {
                k = c * c / 4;
            }

            double x = random.NextDouble() - 0.5;
            double v = random.NextDouble() - 0.5;
            double load = random.NextDouble() - 0.5;
            Step(k, c, load, 1, x, v, out double wholeX, out double wholeV);
            Step(k, c, load, 0.5, x, v, out double halfX, out double halfV);
            Step(k, c, load, 0.5, halfX, halfV, out halfX, out halfV);

            // The coefficients of weak and of critically damped springs come from series cut at 1e-7.
            double size = 1 + (Math.Abs(v) * Math.Sqrt(k)) + k;
            Assert.InRange(Math.Abs(wholeX - halfX), 0, 1e-6 * size);
            Assert.InRange(Math.Abs(wholeV - halfV), 0, 1e-6 * size * (1 + c));
        }
    }

    [Fact]
    public void Law_AtRestUnderItsLoad_ChangesNothing()
    {
        foreach (double k in new[] { 1e-6, 1e-2, 1, 9, 1e4 })
        {
            foreach (double c in new[] { 0, 1e-3, 2, 1e5 })
            {
                var law = new SpringLaw(k, c);
                double rest = 0.7 / k;
                Assert.InRange(Math.Abs(law.Change(rest, 0, 0.7, 1)), 0, 1e-12);
                Assert.InRange(Math.Abs(law.Way(rest, 0, 0.7, 1)), 0, 1e-12 * Math.Max(1, rest));
            }
        }
    }

    [Theory]
    [InlineData(8.9, 0, true)]
    [InlineData(9.1, 0, false)]
    [InlineData(1e6, 1e9, true)]
    public void IsResolved_TellsWhetherASubstepShowsTheSwing(double k, double c, bool resolved) =>
        Assert.Equal(resolved, SpringLaw.IsResolved(k, c));

    // x'' = load − k·x − c·x' over the time h.
    private static void Step(double k, double c, double load, double h, double x, double v, out double nextX, out double nextV)
    {
        var law = new SpringLaw(k * h * h, c * h);
        nextX = x + law.Way(x, v, load * h, h);
        nextV = v + law.Change(x, v, load * h, h);
    }
}
