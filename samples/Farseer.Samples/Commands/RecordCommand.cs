using System;
using System.CommandLine;
using System.IO;
using Farseer.CommandLines;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics.Viewer;

namespace Farseer.Samples.Commands;

/// <summary>Records a run, or two beside each other, and writes the page that shows it.</summary>
internal static class RecordCommand
{
    private static readonly Argument<string> _scene =
        new("scene") { Description = "the name of a scene or a scene file; 'list' shows the names" };
    private static readonly ValueOption<string?> _html = Values.File("--html", "the page's file; by default the scene's name");
    private static readonly ValueOption<int?> _steps = Values.Whole("--steps", "updates instead of the scene's own number", 1);
    private static readonly ValueOption<int?> _iterations =
        Values.Whole("--iterations", "the accuracy dial of the simulator, 5 by default", 1);
    private static readonly ValueOption<double?> _dt = Values.Positive("--dt", "S", "a number of seconds above 0", "seconds an update");
    private static readonly Option<string?> _beside =
        new("--beside") { Description = "a second scene to show beside the first, with their first difference" };
    private static readonly ValueOption<int?> _besideIterations = Values.Whole("--beside-iterations", "the dial of the second run", 1);
    private static readonly ValueOption<int?> _megabytes =
        Values.Whole("--most-megabytes", "largest data of a run in the file, 20 by default", 1);

    public static Command Create()
    {
        Command command = new("record", "Writes a run as one HTML file that any browser shows.")
        {
            _scene, _html, _steps, _iterations, _dt, _beside, _besideIterations, _megabytes,
        };
        command.SetAction(Record);
        return command;
    }

    private static int Record(ParseResult words)
    {
        string name = words.GetValue(_scene)!;
        int? iterations = words.GetValue(_iterations);
        int? besideIterations = words.GetValue(_besideIterations);
        string? beside = words.GetValue(_beside) ?? (besideIterations is null ? null : name);
        RunRecorder first = Run(name, iterations, words);
        RunRecorder? second = beside is null ? null : Run(beside, besideIterations ?? iterations, words);
        string path = words.GetValue(_html) ?? SceneSelection.Find(name).Name + ".html";
        try
        {
            if (second is null)
            {
                first.Save(path);
            }
            else
            {
                first.Save(path, second);
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new UsageException($"cannot write '{path}': {e.Message.ReplaceLineEndings(" ")}");
        }

        Console.WriteLine(FormattableString.Invariant($"{first.FrameCount} updates, {new FileInfo(path).Length / 1e6:0.0} MB: {path}"));
        if (second is not null)
        {
            Console.WriteLine(RunRecorder.Compare(first, second) is { } difference
                ? "first difference: " + difference
                : "both runs are the same, bit for bit");
        }

        return 0;
    }

    private static RunRecorder Run(string name, int? iterations, ParseResult words)
    {
        Scene scene = SceneSelection.Find(name);
        float? dt = (float?)words.GetValue(_dt);
        SceneRun run = RunCommand.Start(scene, new RunOptions(name) { Steps = words.GetValue(_steps), Iterations = iterations, Dt = dt });
        RunRecorder recorder = new(run.Simulator, new RunRecorderOptions
        {
            Title = FormattableString.Invariant($"{scene.Title}, {run.Simulator.Iterations} iterations"),
            MostBytes = 1_000_000L * (words.GetValue(_megabytes) ?? 20),
            ViewMin = scene.View.Min,
            ViewMax = scene.View.Max,
        });
        while (!run.IsFinished)
        {
            run.Step();
            recorder.Record(dt ?? scene.Dt);
        }

        return recorder;
    }
}
