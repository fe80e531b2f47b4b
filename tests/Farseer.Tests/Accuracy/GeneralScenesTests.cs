using System;
using System.Collections.Generic;
using System.IO;
using System.Text.RegularExpressions;
using Farseer.Accuracy;
using Farseer.Accuracy.General;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>The bench of general scenes tells the truth about what it runs.</summary>
public class GeneralScenesTests
{
    [Fact]
    public void Catalogue_OfGeneralScenes_HasEveryNumberOnce()
    {
        var ids = new HashSet<string>();
        foreach (GeneralScene scene in GeneralCatalogue.Scenes)
        {
            Assert.True(ids.Add(scene.Id), scene.Id);
            Assert.NotEmpty(scene.Figures);
        }

        for (int i = 1; i <= 29; i++)
        {
            Assert.Contains($"G{i:00}", ids);
        }
    }

    [Fact]
    public void General_ChosenScene_EndsWithItsCountsAndTellsMissesByItsExitCode()
    {
        (int code, string first) = Run("general", "G22", "--seed", "3");
        (_, string second) = Run("general", "G22", "--seed", "3");
        Assert.Equal(first, second);
        Match counts = Regex.Match(first.TrimEnd().Split('\n')[^1].TrimEnd(), @"^(\d+) passed, (\d+) failed$");
        Assert.True(counts.Success, first);
        Assert.Equal(counts.Groups[2].Value == "0" ? 0 : 1, code);
    }

    [Theory]
    [InlineData("general", "G99")]
    [InlineData("general", "--seed")]
    [InlineData("truth", "--seed", "1")]
    [InlineData("energies", "--seeds", "0")]
    [InlineData("energies", "--seeds")]
    [InlineData("energies", "all")]
    [InlineData("truthful", "--csv", "nowhere/at/all.csv")]
    public void Command_Misused_SaysSo(params string[] args) => Assert.Equal(2, Run(args).Code);

    /// <summary>Of 200 boxes that fall on a corner, the moment follows from the height of the corner, the impulse from its arm.</summary>
    [Fact]
    public void FirstTouch_OfFallingBox_IsThatOfTheClosedForm()
    {
        var dice = new Dice(1, "falling");
        Vec[] outline = Outlines.Box(1, 1);
        var floor = new Flyer(
            Outlines.Box(60, 1), new Vec(0, -0.5), 0, new Vec(0, 0), 0, double.PositiveInfinity, double.PositiveInfinity);
        for (int i = 0; i < 200; i++)
        {
            double angle = dice.Between(0.01, (Math.PI / 2) - 0.01);
            double e = dice.Next();
            var box = new Flyer(outline, new Vec(0, dice.Between(1, 3)), angle, new Vec(dice.Between(-2, 2), -5), 0, 1, 1.0 / 6);
            Vec corner = new Vec(-0.5, -0.5).Turned(angle);
            Touch touch = Assert.IsType<Touch>(FirstTouch.Find(box, floor, 2));

            // The finder stops at a gap of 1e-11 m, at 5 m/s.
            Assert.Equal((box.Position.Y + corner.Y) / 5, touch.Time, 1e-10);
            (Flyer after, _) = FirstTouch.Newton(touch, e);
            double impulse = 5 * (1 + e) / (1 + (6 * corner.X * corner.X));
            Assert.Equal(-5 + impulse, after.Velocity.Y, 1e-9);
            Assert.Equal(6 * corner.X * impulse, after.Spin, 1e-9);
        }
    }

    /// <summary>Two free boxes after a blow: momentum is kept, and so is energy where restitution is 1.</summary>
    [Fact]
    public void FirstTouch_OfTwoBoxes_KeepsMomentumAndEnergy()
    {
        var dice = new Dice(2, "meeting");
        int touched = 0;
        for (int i = 0; i < 200; i++)
        {
            Vec[] outline = Outlines.Box(1, dice.Between(0.2, 2));
            var a = new Flyer(outline, new Vec(0, 0), dice.Angle(), new Vec(0, 0), dice.Between(-5, 5), 2, 0.7);
            var b = new Flyer(
                Outlines.Box(1, 1), new Vec(3, dice.Between(-0.5, 0.5)), dice.Angle(), new Vec(-4, 0), dice.Between(-5, 5), 1, 0.3);
            if (FirstTouch.Find(a, b, 2) is Touch { IsOnePoint: true } touch)
            {
                touched++;
                (Flyer afterA, Flyer afterB) = FirstTouch.Newton(touch, 1);
                Assert.Equal(a.Energy + b.Energy, afterA.Energy + afterB.Energy, 1e-9);
                Assert.Equal(0, ((2 * afterA.Velocity) + afterB.Velocity - new Vec(-4, 0)).Length, 1e-9);
            }
        }

        Assert.True(touched > 100, $"{touched} pairs touched.");
    }

    private static (int Code, string Output) Run(params string[] args)
    {
        using var output = new StringWriter();
        int code = Cli.Run(args, output, TextWriter.Null);
        return (code, output.ToString());
    }
}
