using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Xunit;

namespace Farseer.Samples.Tests;

/// <summary>Sweeps cut into shards, each a process of its own, and their merge.</summary>
public sealed class SweepTests : IDisposable
{
    private const string Specification = """
        { "scenes": ["pyramid", "dominoes"], "iterations": [4, 8], "steps": 40, "seeds": 2, "jitter": 0.01 }
        """;

    private const int Runs = 8;

    private readonly string _folder = Directory.CreateTempSubdirectory("farseer-sweep").FullName;

    public SweepTests() => File.WriteAllText(PathOf("spec.json"), Specification);

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public async Task Merge_OfTwoShards_IsTheSweepInOne()
    {
        await Succeed("sweep", PathOf("spec.json"), "--shard", "0/2", "--out", PathOf("0.jsonl"));
        await SucceedIn(
            new() { ["JOB_COMPLETION_INDEX"] = "1" }, "sweep", PathOf("spec.json"), "--shards", "2", "--out", PathOf("1.jsonl"));
        string whole = await Succeed("sweep", PathOf("spec.json"), "--out", PathOf("all.jsonl"));

        string merged = await Succeed("merge", PathOf("1.jsonl"), PathOf("0.jsonl"), "--out", PathOf("a.jsonl"));
        string repeated = await Succeed("merge", PathOf("all.jsonl"), PathOf("0.jsonl"), "--out", PathOf("b.jsonl"));

        Assert.Contains($"{Runs} runs", whole, StringComparison.Ordinal);
        Assert.Contains("0 repeats", merged, StringComparison.Ordinal);
        Assert.Contains($"{Runs / 2} repeats that agree", repeated, StringComparison.Ordinal);
        Assert.Equal(File.ReadAllText(PathOf("a.jsonl")), File.ReadAllText(PathOf("b.jsonl")));
        string[] lines = File.ReadAllLines(PathOf("a.jsonl"));
        Assert.Equal(Runs, lines.Length);
        Assert.Equal(Runs, lines.Select(l => l.Split("\"state\":\"")[1][..16]).Distinct().Count());
    }

    [Fact]
    public async Task Sweep_CutOff_GoesOnWhereItStopped()
    {
        string[] sweep = ["sweep", PathOf("spec.json"), "--shard", "0/2", "--out", PathOf("0.jsonl")];
        await Succeed(sweep);
        string text = File.ReadAllText(PathOf("0.jsonl"));
        File.WriteAllText(PathOf("0.jsonl"), text[..(text.Length / 2)]);

        string again = await Succeed(sweep);

        Assert.DoesNotContain(", 0 of them done before", again, StringComparison.Ordinal);
        Assert.Equal(text, File.ReadAllText(PathOf("0.jsonl")));
    }

    [Fact]
    public async Task Merge_OfFaultyShards_TellsWhatIsMissingOrDiffers()
    {
        await Succeed("sweep", PathOf("spec.json"), "--shard", "0/2", "--out", PathOf("0.jsonl"));
        string text = File.ReadAllText(PathOf("0.jsonl"));
        string state = text.Split("\"state\":\"")[1][..16];
        File.WriteAllText(PathOf("other.jsonl"), text.Replace(state, "0123456789abcdef", StringComparison.Ordinal));
        File.WriteAllText(PathOf("cut.jsonl"), text[..^5]);

        (int code, string error) = await Fail("merge", PathOf("0.jsonl"), "--out", PathOf("m.jsonl"));
        Assert.Equal(1, code);
        Assert.Contains("run 1 is in no file", error, StringComparison.Ordinal);
        (code, error) = await Fail("merge", PathOf("0.jsonl"), PathOf("other.jsonl"), "--out", PathOf("m.jsonl"));
        Assert.Equal(1, code);
        Assert.Contains("has the state 0123456789abcdef", error, StringComparison.Ordinal);
        (code, error) = await Fail("merge", PathOf("cut.jsonl"), "--out", PathOf("m.jsonl"));
        Assert.Equal(1, code);
        Assert.Contains("ends within a line", error, StringComparison.Ordinal);
        Assert.False(File.Exists(PathOf("m.jsonl")));
    }

    [Theory]
    [InlineData("--shard 2/2", "there is no shard 2 of 2")]
    [InlineData("--shard 1", "--shard needs a number of a shard and how many there are")]
    [InlineData("--shards 2", "the shard is not known")]
    [InlineData("--piece 2", "has no option '--piece'")]
    public async Task Sweep_WrongUse_SaysOneLineAndExitsWith2(string options, string expected)
    {
        (int code, string error) = await Fail(["sweep", PathOf("spec.json"), .. options.Split(' ')]);

        Assert.Equal(2, code);
        Assert.Contains(expected, error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Learn_OfAFewTurns_DrawsTheSamePoleAgain()
    {
        string one = await Succeed("learn", "--turns", "3", "--workers", "1", "--out", PathOf("1.svg"));
        string two = await Succeed("learn", "--turns", "3", "--workers", "2", "--out", PathOf("2.svg"));

        Assert.Contains("turn   1", one, StringComparison.Ordinal);
        Assert.Equal(Turns(one), Turns(two));
        Assert.Equal(File.ReadAllText(PathOf("1.svg")), File.ReadAllText(PathOf("2.svg")));

        static string[] Turns(string text) => text.Split('\n').Where(l => l.StartsWith("turn ", StringComparison.Ordinal)).ToArray();
    }

    private static Task<string> Succeed(params string[] arguments) => SucceedIn([], arguments);

    private static async Task<string> SucceedIn(Dictionary<string, string> environment, params string[] arguments)
    {
        (int code, string output, string error) = await Run(environment, arguments);
        Assert.True(code == 0, error + output);
        return output;
    }

    private static async Task<(int Code, string Error)> Fail(params string[] arguments)
    {
        (int code, _, string error) = await Run([], arguments);
        return (code, error);
    }

    private static async Task<(int Code, string Output, string Error)> Run(Dictionary<string, string> environment, string[] arguments)
    {
        ProcessStartInfo start = new("dotnet") { RedirectStandardOutput = true, RedirectStandardError = true };
        start.ArgumentList.Add(Path.Combine(AppContext.BaseDirectory, "Farseer.Samples.dll"));
        foreach (string argument in arguments)
        {
            start.ArgumentList.Add(argument);
        }

        foreach ((string name, string value) in environment)
        {
            start.Environment[name] = value;
        }

        using Process process = Process.Start(start)!;
        Task<string> output = process.StandardOutput.ReadToEndAsync();
        Task<string> error = process.StandardError.ReadToEndAsync();
        await process.WaitForExitAsync();
        return (process.ExitCode, await output, await error);
    }

    private string PathOf(string name) => Path.Combine(_folder, name);
}
