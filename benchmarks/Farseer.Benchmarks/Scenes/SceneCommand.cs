using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Farseer.Scenes.Performance;

namespace Farseer.Benchmarks.Scenes;

/// <summary>The verb <c>scenes</c>: times whole steps of the performance scenes.</summary>
internal static class SceneCommand
{
    public const string Usage = "scenes [--scene NAME[=SIZE]] [--workers N] [--runs N] [--steps N] [--csv FILE]";
    private const int Misused = 2;

    public static int Run(ReadOnlySpan<string> args, TextWriter output, TextWriter errors)
    {
        try
        {
            Execute(args, output);
            return 0;
        }
        catch (Exception mistake) when (mistake is FormatException or IOException or UnauthorizedAccessException)
        {
            errors.WriteLine(mistake.Message);
            return Misused;
        }
    }

    private static void Execute(ReadOnlySpan<string> args, TextWriter output)
    {
        var chosen = new List<(PerformanceScene Scene, int Size)>();
        int runs = 5;
        int steps = 0;
        int workers = 1;
        string? csvPath = null;
        for (int i = 0; i < args.Length; i += 2)
        {
            string value = i + 1 < args.Length ? args[i + 1] : string.Empty;
            switch (args[i])
            {
                case "--scene":
                    chosen.Add(Choose(value));
                    break;
                case "--runs":
                    runs = WholeNumber(args[i], value, 1, 1000);
                    break;
                case "--steps":
                    steps = WholeNumber(args[i], value, 2, 1_000_000);
                    break;
                case "--workers":
                    workers = WholeNumber(args[i], value, 0, 1000);
                    break;
                case "--csv":
                    csvPath = value.Length > 0 ? value : throw new FormatException("--csv needs a file name.");
                    break;
                default:
                    throw new FormatException($"unknown argument '{args[i]}'; usage: {Usage}");
            }
        }

        if (chosen.Count == 0)
        {
            foreach (PerformanceScene scene in PerformanceScenes.All)
            {
                chosen.Add((scene, scene.DefaultSize));
            }
        }

        using StreamWriter? csv = csvPath is null ? null : new StreamWriter(csvPath);
        csv?.WriteLine(SceneTiming.CsvHeader);
        output.WriteLine($"{Asset.Name}, {Asset.Lanes} lanes, {Workers(workers)}, {runs} runs after one that warms up; the first step of a run is not timed");
        foreach ((PerformanceScene scene, int size) in chosen)
        {
            var timing = new SceneTiming(scene, size, steps == 0 ? scene.Steps : steps, workers);
            timing.Run(runs);
            Print(output, $"{scene.Name}={size}", timing, workers);
            csv?.WriteLine(timing.ToCsv());
        }
    }

    private static void Print(TextWriter output, string name, SceneTiming timing, int workers)
    {
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{name}: {timing.DynamicBodies} bodies, {timing.Contacts} contacts, {timing.Joints} joints"));
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"  ms a step: {timing.LeastMilliseconds:F3} (best run), {timing.MedianMilliseconds:F3} (median run); {timing.TimedSteps} steps {timing.MedianTotal:F0} ms; {timing.NanosecondsPerBodyStep:F1} ns a body-step"));
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"  {timing.BytesPerStep:F1} bytes a step, {timing.BytesPerBody:F0} bytes kept a body, hash {timing.StateHash:x16}, largest penetration {timing.LargestPenetration:G4}, largest joint error {timing.LargestSeparation:G4}"));
        if (workers != 1)
        {
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"  of the time of one worker, in turns: {timing.BesideOneWorker.Run:F3} (best runs), {timing.BesideOneWorker.Steps:F3} (best of each step)"));
        }

        var parts = new List<string>();
        foreach ((string phase, double milliseconds) in timing.Phases)
        {
            parts.Add(string.Create(CultureInfo.InvariantCulture, $"{phase} {milliseconds:F3}"));
        }

        output.WriteLine($"  by phase: {string.Join(", ", parts)}");
    }

    private static (PerformanceScene Scene, int Size) Choose(string text)
    {
        string[] parts = text.Split('=', 2);
        PerformanceScene scene = PerformanceScenes.Find(parts[0]) ?? throw new FormatException(
            $"no scene is called '{parts[0]}'; there are {Names()}.");
        int size = parts.Length == 1 ? scene.DefaultSize : WholeNumber($"{scene.Name} ({scene.SizeMeaning})", parts[1], 1, scene.LargestSize);
        return (scene, size);
    }

    private static string Workers(int count) => count switch
    {
        0 => "all workers",
        1 => "1 worker",
        _ => $"{count} workers",
    };

    private static string Names()
    {
        var names = new List<string>();
        foreach (PerformanceScene scene in PerformanceScenes.All)
        {
            names.Add(scene.Name);
        }

        return string.Join(", ", names);
    }

    private static int WholeNumber(string what, string text, int least, int most)
    {
        if (!int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int value) || value < least || value > most)
        {
            throw new FormatException($"{what}: '{text}' is not a whole number from {least} to {most}.");
        }

        return value;
    }
}
