using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Samples.Tests;

/// <summary>The first update of a new process waits for the compiler, unless that was done before.</summary>
public sealed partial class StartupTests
{
    /// <summary>It takes a second.</summary>
    private static readonly TimeSpan _limit = TimeSpan.FromMinutes(2);

    /// <summary>
    /// Methods, and not milliseconds: those are the same on a busy machine. Without <c>WarmUp</c> 700 to 1,000 fall to the first update;
    /// with it 3 to 7, which are those of the scene itself and what no warm-up comes to. A kernel that was left out would bring a dozen
    /// along.
    /// </summary>
    [Theory]
    [InlineData("resting_boxes=10")]
    [InlineData("large_pyramid=10")]
    [InlineData("circle_pile=100")]
    [InlineData("joint_grid=10")]
    [InlineData("tumbler=5")]
    public void FirstUpdate_AfterWarmUp_FindsNearlyAllCompiled(string scene)
    {
        const int Most = 15;
        int without = MethodsOfTheFirstUpdate(scene);
        int with = MethodsOfTheFirstUpdate(scene, "--warm-up");

        Assert.True(without > 400, $"{without} methods were compiled in the first update without WarmUp.");
        Assert.True(with <= Most, $"{with} methods were compiled in the first update after WarmUp.");
    }

    private static int MethodsOfTheFirstUpdate(params string[] arguments)
    {
        string program =
            Path.Combine(Clone.Root, "benchmarks", "Farseer.Startup", "bin", Clone.Configuration, "net10.0", "Farseer.Startup.dll");
        IEnumerable<string> all = new[] { "exec", program }.Concat(arguments).Append("1");
        (int code, string output) = Command.Dotnet(Clone.Root, all, new Dictionary<string, string>(), _limit);
        Assert.True(code == 0, output);
        return int.Parse(FirstStep().Match(output).Groups[1].Value, CultureInfo.InvariantCulture);
    }

    [GeneratedRegex(@"step 1 .* (\d+) methods compiled")]
    private static partial Regex FirstStep();
}
