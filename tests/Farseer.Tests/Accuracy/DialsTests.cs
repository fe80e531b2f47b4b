using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Farseer.Accuracy;
using Farseer.Accuracy.Dials;
using Farseer.Accuracy.Reporting;
using Farseer.Accuracy.Sweeping;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>The page of the dials has a row for each kind of scene, and its figures mean what it says.</summary>
public class DialsTests
{
    [Fact]
    public void Catalogue_OfKinds_HasTenAtLeastEachWithAdvice()
    {
        Assert.True(DialKinds.All.Count >= 10);
        Assert.Equal(DialKinds.All.Count, DialKinds.All.Select(kind => kind.Name).Distinct().Count());
        foreach (DialKind kind in DialKinds.All)
        {
            Assert.All(kind.Metrics, metric => Assert.Contains(metric, kind.Scene.Metrics));
            Assert.All(kind.Parameters, parameter => Assert.True(kind.Scene.Range.Contains(parameter), kind.Name));
            Assert.EndsWith(".", kind.Advice, StringComparison.Ordinal);
            Assert.Contains(',', kind.Error);
        }
    }

    [Fact]
    public void Page_Generated_HasARowAndAPlotOfEveryKindAndSetting()
    {
        string docs = Path.Combine(Clone.Root, "docs");
        string part = GeneratedPart.Read(File.ReadAllText(Path.Combine(docs, DialsCommand.Document)), DialsCommand.Part);
        string[] lines = part.Split('\n');
        foreach (DialKind kind in DialKinds.All)
        {
            Assert.Single(lines, line => line.StartsWith($"| {kind.Title} | {kind.Error} |", StringComparison.Ordinal));
            Assert.Single(lines, line => line == kind.Advice);
            Assert.Contains($"(plots/dial-{kind.Name}.svg)", part, StringComparison.Ordinal);
            Assert.True(File.Exists(Path.Combine(docs, "plots", $"dial-{kind.Name}.svg")), kind.Name);
        }

        Assert.All(
            OtherDials.All,
            dial => Assert.Single(lines, line => line.StartsWith($"| {dial.What} | {dial.Kind.Title} |", StringComparison.Ordinal)));
    }

    /// <summary>The stored sweeps decide the plot of the readme: who renews them renews it.</summary>
    [Fact]
    public void Plot_OfTheReadme_IsThatOfTheStoredSweeps() => Assert.Equal(
        OverallPlot.Draw([.. SweepData.Stored(), .. SweepData.Peers()]),
        File.ReadAllText(Path.Combine(Clone.Root, "docs", "plots", DialsCommand.Overall)));

    [Fact]
    public void Curve_OfKnownOrder_HasItAndComparesByTime()
    {
        DialKind kind = DialKinds.Find("stack");
        var second = new DialCurve([(64, 100), (16, 150), (4, 225), (1, 337.5)], 0.1);
        var first = new DialCurve([(64, 100), (32, 150), (16, 225), (8, 337.5)], 0.1);
        var flat = new DialCurve([(64, 100), (60, 150), (62, 225), (58, 337.5)], 0.1);
        var exact = new DialCurve([(1e-5, 100), (2e-5, 150), (1e-5, 225), (1e-5, 337.5)], 0.1);
        Assert.Equal(2, second.Order, 12);
        Assert.Equal(1, first.Order, 12);
        Assert.Equal(1.5, second.CostFactor, 12);
        Assert.True(double.IsNaN(exact.Order));
        Assert.Equal("`Iterations`", new DialResult(kind, 0, second, first).Turn);
        Assert.Equal("1/dt", new DialResult(kind, 0, first, second).Turn);
        Assert.Equal("either", new DialResult(kind, 0, second, second).Turn);
        Assert.Equal("neither helps", new DialResult(kind, 0, flat, flat).Turn);
        Assert.Equal("neither: exact", new DialResult(kind, 0, exact, exact).Turn);
        Assert.Equal("neither: chance", new DialResult(kind, 30, second, second).Turn);
    }

    /// <summary>What an engine is exact in must not make up for what it fails in, and a setting that lacks a scene has no mean.</summary>
    [Fact]
    public void Means_OfSettings_ClampErrorsAndNeedEveryScene()
    {
        var points = new List<SweepPoint>();
        foreach (SweepScene scene in SweepScene.All)
        {
            points.Add(new SweepPoint("x", scene.Scene, SweepKind.Dial, 4, 1.0 / 60, 1e-12, 1000, Failed: false));
            points.Add(new SweepPoint("x", scene.Scene, SweepKind.Dial, 8, 1.0 / 60, 1e-2, 4000, Failed: false));
        }

        points.RemoveAt(points.Count - 1);
        SweepPoint mean = Assert.Single(OverallPlot.Means(points));
        Assert.Equal(OverallPlot.LeastError, mean.Error, 12);
        Assert.Equal(1000, mean.Cost, 6);
        Assert.Equal(4, mean.Dial);
    }

    [Theory]
    [InlineData("--docs needs the name of a folder", "dials", "--docs")]
    [InlineData("'dials' takes no arguments, not 'stack'", "dials", "stack")]
    [InlineData("dials: there is no nowhere", "dials", "--docs", "nowhere")]
    [InlineData("report: there is no nowhere", "report", "--plots", "--docs", "nowhere")]
    public void Command_Misused_SaysSo(string expected, params string[] args)
    {
        using var errors = new StringWriter();
        Assert.Equal(2, Cli.Run(args, TextWriter.Null, errors));
        Assert.StartsWith("error: " + expected, errors.ToString(), StringComparison.Ordinal);
    }

    /// <summary>A page without marks is told of before minutes are spent on its figures, and is left as it is.</summary>
    [Fact]
    public void Command_OnAPageWithoutMarks_SaysSoAndWritesNothing()
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("dials");
        try
        {
            string page = Path.Combine(folder.FullName, DialsCommand.Document);
            File.WriteAllText(page, "# Empty\n");
            Assert.Equal(2, Cli.Run(["dials", "--docs", folder.FullName], TextWriter.Null, TextWriter.Null));
            Assert.Equal("# Empty\n", File.ReadAllText(page));
            Assert.Single(folder.EnumerateFileSystemInfos());
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }
}
