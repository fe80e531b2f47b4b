using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Farseer.Accuracy.General;
using Farseer.Accuracy.Reporting;

namespace Farseer.Accuracy.Truth;

/// <summary>Writes the figures of promises, aims and general scenes, one a line with its limit, to be set beside another build's.</summary>
internal static class TruthCommand
{
    private static readonly (string Name, Action<List<TruthFigure>, GeneralSettings> Add)[] _parts =
    [
        ("goals", (figures, _) => AddGoals(figures)),
        ("aims", (figures, _) => AddAims(figures)),
        ("general", AddGeneral),
    ];

    public static void Run(string[] args, TextWriter output)
    {
        string? path = null;
        GeneralSettings settings = GeneralSettings.Default;
        var only = new List<string>();
        for (int i = 0; i < args.Length; i++)
        {
            string Value() => ++i < args.Length ? args[i] : throw new UsageException($"truth: {args[i - 1]} needs a value.");
            switch (args[i])
            {
                case "--csv":
                    path = Value();
                    break;
                case "--seed":
                    settings = settings with { Seed = (uint)Options.WholeNumber("--seed", Value(), 0, int.MaxValue) };
                    break;
                default:
                    only.Add(Array.Exists(_parts, part => part.Name == args[i])
                        ? args[i]
                        : throw new UsageException($"truth: '{args[i]}' is no part and no option; see --help."));
                    break;
            }
        }

        using StreamWriter csv = Cli.OpenCsv(path) ?? throw new UsageException("truth: name a file with --csv FILE.");
        var figures = new List<TruthFigure>();
        foreach ((string name, Action<List<TruthFigure>, GeneralSettings> add) in _parts)
        {
            if (only.Count == 0 || only.Contains(name))
            {
                int before = figures.Count;
                add(figures, settings);
                output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{name}: {figures.Count - before} figures"));
                output.Flush();
            }
        }

        TruthFigure.Write(csv, figures);
        int met = 0;
        foreach (TruthFigure figure in figures)
        {
            met += figure.IsMet ? 1 : 0;
        }

        output.WriteLine($"{figures.Count} figures, {met} met, {figures.Count - met} missed");
    }

    private static void AddGoals(List<TruthFigure> figures) => Goals.Measure(
        [], goal => figures.Add(new($"goal {goal.Scene} {goal.Metric}", goal.Value, goal.Limit, false)));

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
