using System.Globalization;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Package.Tests;

/// <summary>Fresh projects that have the package and nothing else of this repository.</summary>
[Collection(PackageCollection.Name)]
public sealed class ConsumerTests(PackedLibrary library)
{
    [Fact]
    public void Console_OfNet10_RestoresThePackageAndRestsABall()
    {
        string output = library.RunConsumer("Console", "App");

        // The floor's top is at 0.5, the radius is 0.5; a contact rests at most AllowedPenetration = 0.05 deep.
        Match line = Regex.Match(output, @"^y (-?\d+\.\d+) touched True$", RegexOptions.Multiline);
        Assert.True(line.Success, output);
        Assert.InRange(double.Parse(line.Groups[1].Value, CultureInfo.InvariantCulture), 0.945, 1.005);
    }

    [Fact]
    public void Library_OfNetStandard20_InANet10Console_FollowsTheParabola()
    {
        string output = library.RunConsumer("Library", "App");

        // Free flight is exact: x = 3 · 2, y = 20 · 2 − 10 · 2² / 2; three decimals are printed.
        Match line = Regex.Match(output, @"^x (-?\d+\.\d+) y (-?\d+\.\d+)$", RegexOptions.Multiline);
        Assert.True(line.Success, output);
        Assert.Equal(6.0, double.Parse(line.Groups[1].Value, CultureInfo.InvariantCulture), 0.002);
        Assert.Equal(20.0, double.Parse(line.Groups[2].Value, CultureInfo.InvariantCulture), 0.002);
    }

    [Fact]
    public void HelloWorldOfBox2DFlash_RestoresItsPackageWithTheEngine_AndRestsTheBox()
    {
        string output = library.RunConsumer("Flash", "App");

        // The ground's top is at 0, the half side is 1; a contact rests half a slop of 5 mm deep.
        Match line = Regex.Match(output, @"^y (-?\d+\.\d+) angle (-?\d+\.\d+)$", RegexOptions.Multiline);
        Assert.True(line.Success, output);
        Assert.InRange(double.Parse(line.Groups[1].Value, CultureInfo.InvariantCulture), 0.995, 1.001);
        Assert.Equal(0, double.Parse(line.Groups[2].Value, CultureInfo.InvariantCulture), 0.001);
    }

    [Fact]
    public void Saver_OfNet10_RestoresItsPackageWithTheOthers_AndGoesOnWithTheSameBits()
    {
        string output = library.RunConsumer("Saving", "App");

        Assert.Contains("True\n", output);
    }

    [Fact]
    public void PortedSource_WithTheAliasesOfThePackage_Compiles()
    {
        string output = library.RunConsumer("Ported", "App");

        // Free flight is exact: y = 100 · 1² / 2.
        Assert.Contains("50.00\n", output);
    }

    [Fact]
    public void PortedSource_BesideAFrameworkWithTheSameNames_Compiles()
    {
        string output = library.RunConsumer("Beside", "App");

        // A quarter of a turn takes the x axis to (0, 1).
        Assert.Contains("faller 50.00 1.00 7 3 OfTheFramework\n", output);
    }
}
