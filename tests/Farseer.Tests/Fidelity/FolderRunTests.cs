using System;
using System.IO;
using Farseer.Fidelity;
using Xunit;

namespace Farseer.Tests.Fidelity;

/// <summary>The command line: exit codes, the last line, and one clear line for bad input.</summary>
public sealed class FolderRunTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("fidelity").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData("{ \"name\": ")]
    [InlineData("[1, 2]")]
    [InlineData("{ \"name\": \"x\", \"category\": \"y\", \"gravity\": [0, 0], \"dt\": \"fast\", \"steps\": 1, \"iterations\": [5] }")]
    [InlineData("{ \"name\": \"x\", \"category\": \"y\", \"gravity\": [0, 0], \"dt\": -1, \"steps\": 1, \"iterations\": [5] }")]
    [InlineData("{ \"name\": \"x\", \"category\": \"y\", \"gravity\": [0, 0], \"dt\": 0.01, \"iterations\": [5] }")]
    [InlineData("{ \"name\": \"x\", \"category\": \"y\", \"gravity\": [0, 0], \"dt\": 0.01, \"steps\": 1, \"iterations\": [] }")]
    [InlineData("{ \"name\": 3, \"category\": \"y\", \"gravity\": [0, 0], \"dt\": 0.01, \"steps\": 1, \"iterations\": [5] }")]
    [InlineData(
        "{ \"name\": \"x\", \"category\": \"y\", \"gravity\": [0, 0], \"dt\": 0.01, \"steps\": 1, \"iterations\": [5], \"bodies\": 7 }")]
    [InlineData("{ \"name\": \"x\", \"category\": \"y\", \"gravity\": 9, \"dt\": 0.01, \"steps\": 1, \"iterations\": [5] }")]
    public void Run_BrokenFile_GivesOneLineAndCode2(string text)
    {
        File.WriteAllText(Path.Combine(_folder, "broken.json"), text);

        (int code, _, string error) = Run(_folder);

        Assert.Equal(2, code);
        Assert.Single(error.TrimEnd().Split('\n'));
        Assert.Contains("broken.json", error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("does-not-exist")]
    [InlineData("--nonsense")]
    [InlineData("--scene")]
    [InlineData("")]
    public void Run_BadArguments_GivesOneLineAndCode2(string argument)
    {
        (int code, _, string error) = argument.Length == 0 ? Run() : Run(argument);

        Assert.Equal(2, code);
        Assert.Single(error.TrimEnd().Split('\n'));
    }

    [Fact]
    public void Run_FolderWithoutScenes_GivesCode2()
        => Assert.Equal(2, Run(_folder).Code);

    [Fact]
    public void Run_UnknownScene_GivesCode2()
        => Assert.Equal(2, Run(ReferenceData.Folder, "--scene", "nowhere").Code);

    [Fact]
    public void Run_OneScene_EndsWithTheSum()
    {
        (int code, string output, _) = Run(ReferenceData.Folder, "--scene", "free_fall", "--verbose");

        Assert.Equal(0, code);
        Assert.Equal("1 passed, 0 failed, 0 skipped", output.TrimEnd().Split('\n')[^1]);
    }

    [Fact]
    public void Run_WithAFile_WritesEveryCheckWithItsLimit()
    {
        string file = Path.Combine(_folder, "checks.csv");

        Assert.Equal(0, Run(ReferenceData.Folder, "--scene", "free_fall", "--csv", file).Code);

        string[] lines = File.ReadAllLines(file);
        Assert.Equal("name,value,limit,better", lines[0]);
        Assert.Equal("free_fall ends early,0,0,less", lines[1]);
        Assert.True(lines.Length > 2);
        Assert.All(lines, line => Assert.Equal(4, line.Split(',').Length));
        Assert.Equal(2, Run(ReferenceData.Folder, "--csv", Path.Combine(_folder, "no", "where.csv")).Code);
    }

    [Fact]
    public void Run_List_NamesTheScenesOfACategory()
    {
        (int code, string output, _) = Run(ReferenceData.Folder, "--category", "vertices,query", "--list");

        Assert.Equal(0, code);
        Assert.Equal(["query collide_point", "vertices vertices"], output.TrimEnd().ReplaceLineEndings("\n").Split('\n'));
    }

    private static (int Code, string Output, string Error) Run(params string[] args)
    {
        using StringWriter output = new();
        using StringWriter error = new();
        int code = FolderRun.Run(args, output, error);
        return (code, output.ToString(), error.ToString());
    }
}
