using System;
using System.IO;
using System.Linq;
using Farseer.Accuracy;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>Scenes by themselves, as <c>--scene NAME=P</c> asks for them.</summary>
public sealed class SceneCommandTests
{
    [Theory]
    [InlineData(1, "--scene", "S19_overlap=0.5")]
    [InlineData(1, "--scene", "S19_overlap=0.5", "--iterations", "8")]
    [InlineData(1, "--scene", "S19_overlap=0.5", "--dt", "1/120")]
    [InlineData(4, "--scene", "S19_overlap=0.5", "--iterations", "5,8", "--dt", "1/60,1/120")]
    public void Scene_AtEachDial_PrintsItsFigures(int dials, params string[] args)
    {
        using var output = new StringWriter();
        Assert.Equal(0, Cli.Run(args, output, output));

        string[] rows = output.ToString().Split(Environment.NewLine, StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(dials, rows.Count(r => r.StartsWith("S19_overlap=0.5 ", StringComparison.Ordinal) && r.Contains(" pop_height_mm ")));
    }
}
