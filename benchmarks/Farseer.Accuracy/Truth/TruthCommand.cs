using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.Accuracy.General;
using Farseer.Accuracy.Reporting;
using Farseer.CommandLines;

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

    private static readonly Argument<string[]> _only = new("part") { Description = "goals, aims or general; none: all" };
    private static readonly ValueOption<string?> _csv = Values.File("--csv", "the file");
    private static readonly Option<int> _seed = Values.Whole("--seed", "draws the parameters of general scenes", 0, int.MaxValue, 1);

    public static Command Create() => Cli.Plain(
        "truth", "Writes every figure of goals, aims and general scenes with its limit, one a line.", Run, _only, _csv, _seed);

    private static void Run(ParseResult result)
    {
        TextWriter output = result.Output();
        string[] only = result.GetValue(_only) ?? [];
        GeneralSettings settings = GeneralSettings.Default with { Seed = (uint)result.GetValue(_seed) };
        foreach (string word in only)
        {
            if (!Array.Exists(_parts, part => part.Name == word))
            {
                throw new UsageException($"truth: '{word}' is none of goals, aims, general.");
            }
        }

        using StreamWriter csv =
            Values.Open(_csv.Name, result.GetValue(_csv)) ?? throw new UsageException("truth: name a file with --csv FILE.");
        var figures = new List<TruthFigure>();
        foreach ((string name, Action<List<TruthFigure>, GeneralSettings> add) in _parts)
        {
            if (only.Length == 0 || Array.IndexOf(only, name) >= 0)
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
