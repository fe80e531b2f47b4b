using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Farseer.Accuracy.General;
using Farseer.Accuracy.Reporting;

namespace Farseer.Accuracy.Truth;

/// <summary>Writes all that is known of a build's accuracy, one line a figure, to be set beside another build's.</summary>
internal static class TruthCommand
{
    public static void Run(string[] args, TextWriter output)
    {
        string? path = null;
        GeneralSettings settings = GeneralSettings.Default;
        for (int i = 0; i < args.Length; i += 2)
        {
            string value = i + 1 < args.Length ? args[i + 1] : throw new UsageException($"truth: {args[i]} needs a value.");
            switch (args[i])
            {
                case "--csv":
                    path = value;
                    break;
                case "--seed":
                    settings = settings with { Seed = (uint)Options.WholeNumber("--seed", value, 0, int.MaxValue) };
                    break;
                default:
                    throw new UsageException($"truth: unknown argument '{args[i]}'; --csv FILE and --seed N are known.");
            }
        }

        using StreamWriter csv = Cli.OpenCsv(path) ?? throw new UsageException("truth: name a file with --csv FILE.");
        var figures = new List<TruthFigure>();
        Part("goals", () => Goals.Measure([], goal => figures.Add(new($"goal {goal.Scene} {goal.Metric}", goal.Value, goal.Limit, false))));
        Part("aims", () => AddAims(figures));
        Part("general scenes", () => AddGeneral(figures, settings));
        Part("random worlds", () => RandomWorlds.Add(figures, settings.Seed));
        Part("recorded scenes", () => Recordings.Add(figures));
        TruthFigure.Write(csv, figures);
        int met = 0;
        foreach (TruthFigure figure in figures)
        {
            met += figure.IsMet ? 1 : 0;
        }

        output.WriteLine($"{figures.Count} figures, {met} met, {figures.Count - met} missed");

        void Part(string name, Action measure)
        {
            int before = figures.Count;
            measure();
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{name}: {figures.Count - before} figures"));
            output.Flush();
        }
    }

    private static void AddAims(List<TruthFigure> figures)
    {
        foreach (AimResult result in AimTable.Measure())
        {
            figures.Add(new($"aim {result.Aim.Scene} {result.Aim.Metric}", result.Value, result.Limit, result.Aim.AtLeast));
        }
    }

    private static void AddGeneral(List<TruthFigure> figures, GeneralSettings settings)
    {
        foreach (GeneralScene scene in GeneralCatalogue.Scenes)
        {
            foreach (Outcome outcome in GeneralRun.Of(scene, settings))
            {
                figures.Add(new($"general {scene.Id} {outcome.Figure.Name}", outcome.Value, outcome.Figure.Limit, outcome.Figure.AtLeast));
            }
        }
    }
}
