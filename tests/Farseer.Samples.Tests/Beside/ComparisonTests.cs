using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Farseer.Beside;
using Xunit;

namespace Farseer.Samples.Tests.Beside;

/// <summary>What is read of two builds, and how figures and times are set side by side.</summary>
public sealed class ComparisonTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("farseer-beside-tests").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Figures_OfTwoFiles_AreSortedByWhatBecameOfThem()
    {
        const string Header = "name,value,limit,better\n";
        List<Figure> before = Figures(
            Header + "same,1,2,less\nbetter,1,2,less\nlost,1,2,less\ntiny,0,1,less\n"
            + "worse,5,4,more\ngained,3,4,more\ngone,1,2,less\n");
        List<Figure> after = Figures(
            Header + "same,1.05,2,less\nbetter,0.5,2,less\nlost,3,2,less\ntiny,1e-9,1,less\n"
            + "worse,4,4,more\ngained,4,4,more\nnew,1,2,less\n");

        var comparison = new FigureComparison(before, after);

        Assert.Equal(["lost"], Names(comparison, Change.Lost));
        Assert.Equal(["worse"], Names(comparison, Change.Worse));
        Assert.Equal(["gained"], Names(comparison, Change.Gained));
        Assert.Equal(["better"], Names(comparison, Change.Better));
        Assert.Equal(["same", "tiny"], Names(comparison, Change.Same).Order());
        Assert.Equal("gone", Assert.Single(comparison.Gone).Name);
        Assert.Equal(1, comparison.New);
        Assert.Equal((6, 1), (comparison.MetBefore, comparison.MissedBefore));
        Assert.Equal((6, 1), (comparison.MetAfter, comparison.MissedAfter));
    }

    [Fact]
    public void Figures_OfSurveys_AreNamedByTheirVariation()
    {
        List<Figure> figures = Figures("survey,variation,figure,limit,held\nK1,\"a, b\",0.5,1,1\nK1,\"a, b\",NaN,1,0\n");

        Assert.Equal([new Figure("K1: a, b", 0.5, 1, false), new Figure("K1: a, b", double.PositiveInfinity, 1, false)], figures);
    }

    [Theory]
    [InlineData("")]
    [InlineData("name,value\na,1\n")]
    [InlineData("name,value,limit\na,1\n")]
    [InlineData("name,value,limit\na,much,1\n")]
    public void Figures_OfAnotherFile_AreRefused(string text) => Assert.Throws<FormatException>(() => Figures(text));

    [Fact]
    public void Figures_OfOneName_DoNotHideEachOther()
    {
        Figure[] before = [new("a", 1, 2, false), new("a", 1, 2, false)];
        Figure[] after = [new("a", 1, 2, false), new("a", 3, 2, false)];

        Assert.Equal(["a (2)"], Names(new FigureComparison(before, after), Change.Lost));
    }

    [Fact]
    public void Figures_ThatAreNoNumber_AreWorseThanAny()
    {
        Figure[] missed = [new("a", 3, 2, false), new("b", 1, 2, true)];
        Figure[] lost = [new("a", double.PositiveInfinity, 2, false), new("b", double.NegativeInfinity, 2, true)];

        Assert.Equal(2, new FigureComparison(missed, lost).Of(Change.Worse).Count);
        Assert.Equal(2, new FigureComparison(lost, missed).Of(Change.Better).Count);
        Assert.Equal(2, new FigureComparison(lost, lost).Of(Change.Same).Count);
    }

    /// <summary>Of 300 pairs of builds: each figure has one change, and the other way round what was lost is gained.</summary>
    [Fact]
    public void Figures_OfRandomBuilds_TurnRoundWithTheOrder()
    {
        var random = new Random(1);
        for (int i = 0; i < 300; i++)
        {
            Figure[] before = Random(random);
            Figure[] after = Random(random);
            var there = new FigureComparison(before, after);
            var back = new FigureComparison(after, before);

            Assert.Equal(before.Length - there.Gone.Count, Enum.GetValues<Change>().Sum(change => there.Of(change).Count));
            Assert.Equal(there.Gone.Count, back.New);
            Assert.Equal(Names(there, Change.Lost).Order(), Names(back, Change.Gained).Order());
            Assert.Equal(there.MetAfter - there.MetBefore, back.MetBefore - back.MetAfter);
            foreach (FigurePair pair in there.Of(Change.Lost))
            {
                Assert.True(pair.Before.IsMet && !pair.After.IsMet);
            }

            Assert.Empty(new FigureComparison(before, before).Of(Change.Lost));
            Assert.Equal(before.Length, new FigureComparison(before, before).Of(Change.Same).Count);
        }
    }

    [Fact]
    public void Times_OfTurns_AreComparedByTheLeastOfEachBuild()
    {
        List<Timing> before = Timings(
            "scene,size,bodies,ms_step_min,state_hash\npile,10,9,2.0,aa\nrope,5,5,3,bb\npile,10,9,2.5,aa\npile,10,9,8,aa\n");
        List<Timing> after = Timings("scene,size,ms_step_min,state_hash\npile,10,1.5,aa\nrope,5,6,cc\npile,10,1,aa\nother,1,1,dd\n");

        var comparison = new TimeComparison(before, after);

        Assert.Equal(new TimePair("pile=10", 2, 1, 1.5, true), comparison.Pairs[0]);
        Assert.Equal(new TimePair("rope=5", 3, 6, double.PositiveInfinity, false), comparison.Pairs[1]);
        Assert.Equal(2, comparison.Pairs.Count);
        Assert.Equal(1, comparison.GeometricMean, 1e-12);
    }

    [Theory]
    [InlineData(5.0, 6.0, 5, 6)]
    [InlineData(null, 6.0, 10, 12)]
    [InlineData(5.0, null, 10, 12)]
    public void Times_OfQuietSteps_CountWhereBothBuildsTellThem(double? quietBefore, double? quietAfter, double before, double after)
    {
        TimePair pair = Assert.Single(new TimeComparison([new("pile", 10, quietBefore, "")], [new("pile", 12, quietAfter, "")]).Pairs);

        Assert.Equal((before, after), (pair.Before, pair.After));
    }

    /// <summary>Of 200 pairs of builds; a sum of twenty logarithms of double precision is right to 1e-14.</summary>
    [Fact]
    public void Times_OfRandomBuilds_HaveTheGeometricMeanOfTheirRatios()
    {
        var random = new Random(2);
        for (int i = 0; i < 200; i++)
        {
            var before = new List<Timing>();
            var after = new List<Timing>();
            double product = 1;
            int scenes = random.Next(1, 20);
            for (int scene = 0; scene < scenes; scene++)
            {
                double time = 0.001 + random.NextDouble();
                double ratio = 0.5 + random.NextDouble();
                before.Add(new Timing($"{scene}", time, null, string.Empty));
                after.Add(new Timing($"{scene}", time * ratio, null, string.Empty));
                product *= ratio;
            }

            double mean = new TimeComparison(before, after).GeometricMean;

            Assert.Equal(Math.Pow(product, 1.0 / scenes), mean, 1e-12);
            Assert.Equal(1 / mean, new TimeComparison(after, before).GeometricMean, 1e-12);
            Assert.Equal(1, new TimeComparison(before, before).GeometricMean);
        }
    }

    [Fact]
    public void Times_ThatAreNone_AreRefused()
    {
        Assert.Throws<FormatException>(() => Timings("scene,size,ms_step_min,state_hash\npile,10,0,aa\n"));
        Assert.Throws<FormatException>(() => Timings("scene,size,ms_step_min,state_hash,ms_step_quiet\npile,10,1,aa,0\n"));
    }

    private static Figure[] Random(Random random)
    {
        var figures = new List<Figure>();
        for (int i = 0; i < 30; i++)
        {
            if (random.Next(10) > 0)
            {
                figures.Add(new Figure($"{i}", random.Next(8), 4, i % 2 == 0));
            }
        }

        return [.. figures];
    }

    private static IEnumerable<string> Names(FigureComparison comparison, Change change) =>
        comparison.Of(change).Select(pair => pair.After.Name);

    private List<Figure> Figures(string text) => Figure.Read(Write(text));

    private List<Timing> Timings(string text) => Timing.Read(Write(text));

    private string Write(string text)
    {
        string path = Path.Combine(_folder, "figures.csv");
        File.WriteAllText(path, text);
        return path;
    }
}
