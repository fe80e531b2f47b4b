using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Farseer.Samples.Terminal;
using Farseer.Scenes;
using Spectre.Console;

namespace Farseer.Samples.Commands;

/// <summary>Runs every scene and compares what came out with what must come out.</summary>
internal static class CheckCommand
{
    public static int Execute()
    {
        List<RunResult> results = [];
        IReadOnlyList<Scene> scenes = SceneLibrary.All;
        if (Console.IsOutputRedirected)
        {
            results.AddRange(scenes.Select(Run));
        }
        else
        {
            ProgressBar.Show("checking", scenes.Count, bar =>
            {
                foreach (Scene scene in scenes)
                {
                    bar.Description = Markup.Escape(scene.Name);
                    results.Add(Run(scene));
                    bar.Value = results.Count;
                }

                return results;
            });
        }

        AnsiConsole.Write(Summary(results));
        foreach (RunResult result in results.Where(r => !r.AllOk))
        {
            Table table = Report.Outcomes(result);
            table.Title = new TableTitle(Markup.Escape(result.Scene));
            AnsiConsole.Write(table);
        }

        int failed = results.Count(r => !r.AllOk);
        AnsiConsole.MarkupLine(
            failed == 0 ? $"[green]{results.Count} passed[/]" : $"{results.Count - failed} passed, [red]{failed} failed[/]");
        return failed == 0 ? 0 : 1;
    }

    private static RunResult Run(Scene scene)
    {
        SceneRun run = new(scene, new RunOptions(scene.Name));
        while (!run.IsFinished)
        {
            run.Step();
        }

        return run.Result();
    }

    private static Table Summary(List<RunResult> results)
    {
        Table table = Report.Grid();
        table.AddColumn(new TableColumn("Scene").NoWrap());
        table.AddColumn(new TableColumn("Bodies").RightAligned());
        table.AddColumn(new TableColumn("Steps").RightAligned());
        table.AddColumn(new TableColumn("us a step").RightAligned());
        table.AddColumn(new TableColumn("Bytes").RightAligned());
        table.AddColumn(new TableColumn("Checks").RightAligned());
        table.AddColumn(string.Empty);
        foreach (RunResult result in results)
        {
            table.AddRow(
                Markup.Escape(result.Scene),
                result.Bodies.ToString(CultureInfo.InvariantCulture),
                result.Steps.ToString(CultureInfo.InvariantCulture),
                result.MicrosecondsPerStep.ToString("0.0", CultureInfo.InvariantCulture),
                result.BytesPerStep.ToString("0.#", CultureInfo.InvariantCulture),
                FormattableString.Invariant($"{result.Outcomes.Count(o => o.Ok)}/{result.Outcomes.Count}"),
                Report.Verdict(result.AllOk));
        }

        return table;
    }
}
