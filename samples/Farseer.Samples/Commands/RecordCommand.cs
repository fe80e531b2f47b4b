using System;
using System.CommandLine;
using System.IO;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics.Viewer;

namespace Farseer.Samples.Commands;

/// <summary>Records a run, or two beside each other, and writes the page that shows it.</summary>
internal static class RecordCommand
{
    private static readonly Argument<string> _scene = new("scene") { Description = "name of a scene, or a scene file" };
    private static readonly Option<string?> _html = new("--html") { Description = "the file to write (default: the scene's name)" };
    private static readonly Option<int?> _steps = AtLeast("--steps", 1, "updates instead of the scene's own number");
    private static readonly Option<int?> _iterations = AtLeast("--iterations", 1, "the accuracy dial of the simulator");
    private static readonly Option<float?> _dt = new("--dt") { Description = "seconds an update" };
    private static readonly Option<string?> _beside = new("--beside") { Description = "a second scene to show beside the first; its own name for the same" };
    private static readonly Option<int?> _besideIterations = AtLeast("--beside-iterations", 1, "the dial of the second run");
    private static readonly Option<int?> _megabytes = AtLeast("--most-megabytes", 1, "largest data of a run in the file (default 20)");

    /// <param name="words">The command line, "record" included.</param>
    public static int Execute(string[] words)
    {
        RootCommand root = new("Farseer samples");
        Command record = new("record", "writes a run as one HTML file that any browser shows")
        {
            _scene, _html, _steps, _iterations, _dt, _beside, _besideIterations, _megabytes,
        };
        root.Subcommands.Add(record);
        ParseResult result = root.Parse(words);
        if (result.Errors.Count > 0)
        {
            throw new UsageException(result.Errors[0].Message.ReplaceLineEndings(" "));
        }

        record.SetAction(Record);
        return result.Invoke(new InvocationConfiguration { EnableDefaultExceptionHandler = false });
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
            Console.WriteLine(RunRecorder.Compare(first, second) is { } difference ? "first difference: " + difference : "both runs are the same, bit for bit");
        }

        return 0;
    }

    private static RunRecorder Run(string name, int? iterations, ParseResult words)
    {
        Scene scene = SceneSelection.Find(name);
        float? dt = words.GetValue(_dt);
        if (dt is { } seconds && !(seconds > 0f && float.IsFinite(seconds)))
        {
            throw new UsageException(FormattableString.Invariant($"--dt needs a number of seconds above 0, not '{seconds}'"));
        }

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

    private static Option<int?> AtLeast(string name, int least, string description)
    {
        Option<int?> option = new(name) { Description = description };
        option.Validators.Add(result =>
        {
            if (result.Tokens.Count == 1 && int.TryParse(result.Tokens[0].Value, out int value) && value < least)
            {
                result.AddError(FormattableString.Invariant($"{name} needs a whole number of at least {least}, not '{value}'"));
            }
        });
        return option;
    }
}
