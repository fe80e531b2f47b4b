using System;
using System.IO;
using Farseer.CommandLines;
using Farseer.Samples.Terminal;
using Farseer.Scenes;
using Spectre.Console;

namespace Farseer.Samples.Commands;

/// <summary>Runs one scene to its end and prints what came out.</summary>
internal static class RunCommand
{
    private const int StepsBeforeJudging = 20;

    /// <summary>Below this nobody waits long enough to want a bar.</summary>
    private static readonly TimeSpan _long = TimeSpan.FromSeconds(1.0);

    public static int Execute(RunOptions options)
    {
        Scene scene = SceneSelection.Find(options.Scene);
        SceneRun run = Start(scene, options);
        if (!options.Json && !Console.IsOutputRedirected)
        {
            AnsiConsole.MarkupLineInterpolated($"[yellow]{scene.Title}[/]: {run.Steps} updates");
        }

        while (!run.IsFinished && run.Done < StepsBeforeJudging)
        {
            run.Step();
        }

        if (!options.Json && !Console.IsOutputRedirected && run.Remaining > _long)
        {
            StepWithBar(run);
        }

        while (!run.IsFinished)
        {
            run.Step();
        }

        RunResult result = run.Result();
        if (options.Json)
        {
            using Stream output = Console.OpenStandardOutput();
            Report.Json(result, output);
        }
        else
        {
            Report.Tables(result);
        }

        return result.AllOk ? 0 : 1;
    }

    /// <summary>What the simulator refuses of the command line's numbers is wrong use as well.</summary>
    public static SceneRun Start(Scene scene, RunOptions options)
    {
        try
        {
            return new SceneRun(scene, options);
        }
        catch (ArgumentException e)
        {
            throw new UsageException(e.Message.ReplaceLineEndings(" "));
        }
    }

    private static void StepWithBar(SceneRun run) => ProgressBar.Show(run.Scene.Name, run.Steps, bar =>
    {
        while (!run.IsFinished)
        {
            run.Step();
            bar.Value = run.Done;
        }

        return run;
    });
}
