using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;

namespace Farseer.Benchmarks.Scenes;

/// <summary>
/// The verb <c>compare</c>: two result files of <c>scenes --csv</c> side by side, as ratios. A file needs the columns scene, size,
/// ms_step_min and ms_step_median; those of another engine may leave out all others.
/// </summary>
internal static class ResultComparison
{
    private static readonly Argument<string> _first = new("file") { Description = "a file of results" };
    private static readonly Argument<string?> _second = Verb.Maybe("file2", "another one; without, a run made now");

    public static Command Create() =>
        Verb.Of("compare", "Two result files of scenes --csv side by side; one: beside a run made now.", Run, _first, _second);

    private static int Run(ParseResult result)
    {
        string first = result.GetRequiredValue(_first);
        string? second = result.GetValue(_second);
        List<Result> before = Read(first);
        List<Result> after = second is null ? RunAgain(before) : Read(second);
        Print(result.Output(), first, second ?? "now", before, after);
        return 0;
    }

    private static void Print(TextWriter output, string firstName, string secondName, List<Result> first, List<Result> second)
    {
        output.WriteLine($"{firstName} against {secondName}: ms a step and the ratio first / second");
        output.WriteLine($"{"scene",-24} {"least",9} {"least",9} {"ratio",7} {"median",9} {"median",9} {"ratio",7}");
        double leastLog = 0;
        double medianLog = 0;
        int count = 0;
        foreach (Result a in first)
        {
            foreach (Result b in second)
            {
                if (a.Name != b.Name)
                {
                    continue;
                }

                output.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{a.Name,-24} {a.Least,9:F4} {b.Least,9:F4} {a.Least / b.Least,7:F3} {a.Median,9:F4} {b.Median,9:F4} "
                        + $"{a.Median / b.Median,7:F3}"));
                leastLog += Math.Log(a.Least / b.Least);
                medianLog += Math.Log(a.Median / b.Median);
                count++;
            }
        }

        if (count == 0)
        {
            throw new FormatException("The files have no scene of one size in common.");
        }

        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{"geometric mean",-24} {"",9} {"",9} {Math.Exp(leastLog / count),7:F3} {"",9} {"",9} {Math.Exp(medianLog / count),7:F3}"));
    }

    private static List<Result> Read(string path)
    {
        string[] lines = File.ReadAllLines(path);
        if (lines.Length == 0)
        {
            throw new FormatException($"{path} is empty.");
        }

        string[] header = lines[0].Split(',');
        int scene = Column(header, "scene", path);
        int size = Column(header, "size", path);
        int least = Column(header, "ms_step_min", path);
        int median = Column(header, "ms_step_median", path);
        int steps = Array.IndexOf(header, "steps");
        var results = new List<Result>();
        for (int i = 1; i < lines.Length; i++)
        {
            string[] cells = lines[i].Split(',');
            if (cells.Length != header.Length)
            {
                throw new FormatException($"{path}, line {i + 1}: {cells.Length} values under {header.Length} names.");
            }

            results.Add(new Result(
                cells[scene],
                (int)Number(cells[size], path, i),
                steps < 0 ? 0 : (int)Number(cells[steps], path, i),
                Number(cells[least], path, i),
                Number(cells[median], path, i)));
        }

        return results;
    }

    private static List<Result> RunAgain(List<Result> known)
    {
        var results = new List<Result>();
        foreach (Result result in known)
        {
            Farseer.Scenes.Performance.PerformanceScene scene = Farseer.Scenes.Performance.PerformanceScenes.Find(result.Scene)
                ?? throw new FormatException($"no scene is called '{result.Scene}'.");
            var timing = new SceneTiming(scene, result.Size, result.Steps == 0 ? scene.Steps : result.Steps, 1);
            timing.Run(5);
            results.Add(result with { Least = timing.LeastMilliseconds, Median = timing.MedianMilliseconds });
        }

        return results;
    }

    private static int Column(string[] header, string name, string path)
    {
        int index = Array.IndexOf(header, name);
        return index >= 0 ? index : throw new FormatException($"{path} has no column {name}.");
    }

    private static double Number(string text, string path, int line) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            ? value
            : throw new FormatException($"{path}, line {line + 1}: '{text}' is no number.");

    private sealed record Result(string Scene, int Size, int Steps, double Least, double Median)
    {
        public string Name => $"{Scene}={Size}";
    }
}
