using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.CommandLines;
using Farseer.Scenes.Performance;

namespace Farseer.Benchmarks.Scenes;

/// <summary>The verb <c>scenes</c>: times whole steps of the performance scenes.</summary>
internal static class SceneCommand
{
    private const int DefaultRuns = 5;
    private const int MostRuns = 1000;

    private static readonly ValuesOption<(PerformanceScene Scene, int Size)> _scenes = new(
        "--scene", "NAME[=SIZE]", "the name of a scene, with or without a size", "a scene; may be repeated; by default all", TryScene);

    private static readonly Option<int> _workers =
        Values.Whole("--workers", "threads that share an update; 0: one a processor", 0, MostRuns, 1);
    private static readonly Option<int> _runs = Values.Whole("--runs", "runs after one that warms up", 1, MostRuns, DefaultRuns);
    private static readonly ValueOption<int?> _steps = Values.Whole("--steps", "updates instead of the scene's own number", 2, 1_000_000);
    private static readonly ValueOption<string?> _csv = Values.File("--csv", "writes the times to a file too");

    public static Command Create() =>
        Verb.Of("scenes", "Times of whole steps of the performance scenes.", Run, _scenes, _workers, _runs, _steps, _csv);

    private static int Run(ParseResult result)
    {
        var chosen = new List<(PerformanceScene Scene, int Size)>(result.GetRequiredValue(_scenes));
        if (chosen.Count == 0)
        {
            foreach (PerformanceScene scene in PerformanceScenes.All)
            {
                chosen.Add((scene, scene.DefaultSize));
            }
        }

        TextWriter output = result.Output();
        int workers = result.GetValue(_workers);
        int runs = result.GetValue(_runs);
        using StreamWriter? csv = Values.Open(_csv.Name, result.GetValue(_csv));
        csv?.WriteLine(SceneTiming.CsvHeader);
        output.WriteLine($"{Asset.Name}, {Asset.Lanes} lanes, {Workers(workers)}, {runs} runs after one that warms up; the first step of a "
            + $"run is not timed");
        foreach ((PerformanceScene scene, int size) in chosen)
        {
            var timing = new SceneTiming(scene, size, result.GetValue(_steps) ?? scene.Steps, workers);
            timing.Run(runs);
            Print(output, $"{scene.Name}={size}", timing, workers);
            csv?.WriteLine(timing.ToCsv());
        }

        return 0;
    }

    private static void Print(TextWriter output, string name, SceneTiming timing, int workers)
    {
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{name}: {timing.DynamicBodies} bodies, {timing.Contacts} contacts, {timing.Joints} joints"));
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"  ms a step: {timing.LeastMilliseconds:F3} (best run), {timing.MedianMilliseconds:F3} (median run); {timing.TimedSteps} "
                + $"steps {timing.MedianTotal:F0} ms; {timing.NanosecondsPerBodyStep:F1} ns a body-step"));
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"  {timing.BytesPerStep:F1} bytes a step, {timing.BytesPerBody:F0} bytes kept a body, hash {timing.StateHash:x16}, largest "
                + $"penetration {timing.LargestPenetration:G4}, largest joint error {timing.LargestSeparation:G4}"));
        if (workers != 1)
        {
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"  of the time of one worker, in turns: {timing.BesideOneWorker.Run:F3} (best runs), {timing.BesideOneWorker.Steps:F3} "
                    + $"(best of each step)"));
        }

        var parts = new List<string>();
        foreach ((string phase, double milliseconds) in timing.Phases)
        {
            parts.Add(string.Create(CultureInfo.InvariantCulture, $"{phase} {milliseconds:F3}"));
        }

        output.WriteLine($"  by phase: {string.Join(", ", parts)}");
    }

    private static bool TryScene(string text, out (PerformanceScene Scene, int Size) choice)
    {
        string[] parts = text.Split('=', 2);
        PerformanceScene scene = Verb.Scene(parts[0]);
        int size = scene.DefaultSize;
        if (parts.Length == 2 && !Values.TryWhole(parts[1], 1, scene.LargestSize, out size))
        {
            throw new UsageException(
                $"{scene.Name} ({scene.SizeMeaning}): '{parts[1]}' is not a whole number from 1 to {scene.LargestSize}.");
        }

        choice = (scene, size);
        return true;
    }

    private static string Workers(int count) => count switch
    {
        0 => "all workers",
        1 => "1 worker",
        _ => $"{count} workers",
    };
}
