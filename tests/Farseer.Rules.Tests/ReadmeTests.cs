using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Rules.Tests;

public sealed class ReadmeTests
{
    private static readonly string _text = File.ReadAllText(Path.Combine(Repository.Root, "README.md"));

    [Fact]
    public void Commands_NameWhatExists()
    {
        List<string> commands = [.. Regex.Matches(_text, "^dotnet .*$", RegexOptions.Multiline).Select(m => m.Value.Trim())];

        Assert.Contains("dotnet run -c Release --project samples/Farseer.Samples", commands);
        Assert.Contains("dotnet test -c Release Farseer.sln", commands);
        Assert.True(File.Exists(Path.Combine(Repository.Root, "samples", "Farseer.Samples", "Farseer.Samples.csproj")));
    }

    [Fact]
    public void Code_CompilesAndLetsTheBoxRestOnTheFloor()
    {
        string output = string.Concat(Snippet.Blocks(_text).Select(b => Snippet.Run(b, "README.md")));

        // The floor's top is at 0.5 and half the box is 0.5; what it sags by does not show in two digits.
        Match y = Regex.Match(output, @"^the box rests at y = (-?\d+\.\d+)\s*$");
        Assert.True(y.Success, output);
        Assert.Equal("1.00", y.Groups[1].Value);
    }
}
