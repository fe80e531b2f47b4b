using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.CommandLines;

namespace Farseer.Accuracy.General;

/// <summary>Runs the general scenes and holds them against their limits.</summary>
internal static class GeneralCommand
{
    private const string CsvHeader = "scene,metric,value,limit,better,met,parameters";

    private static readonly Argument<string[]> _only = new("scene") { Description = "numbers of scenes, such as G01; none: all" };
    private static readonly Option<int> _seed = Values.Whole("--seed", "draws the parameters", 0, int.MaxValue, 1);
    private static readonly ValueOption<string?> _csv = Values.File("--csv", "writes the figures to a file too");
    private static readonly Option<int> _iterations =
        Values.Whole("--iterations", "the dial", 1, Options.MostIterations, Options.DefaultIterations);
    private static readonly ValueOption<double> _dt = new(
        "--dt", "S", Options.WantedDuration, "seconds an update, also as a fraction; 1/60 by default", Options.TryDuration);

    private static readonly Option<bool> _full =
        Values.Flag("--full", "runs G19 and G27 for their stated 10 minutes instead of 60 and 30 s");
    private static readonly Option<bool> _each = Values.Flag("--each", "tells every sample");

    public static Command Create() => Cli.Judged(
        "general",
        "Scenes that must hold for a whole range of parameters: the worst of each figure beside its limit.",
        Run, _only, _seed, _csv, _iterations, _dt, _full, _each);

    private static bool Run(ParseResult result)
    {
        double dt = result.GetValue(_dt);
        GeneralSettings usual = GeneralSettings.Default;
        GeneralSettings settings = usual with
        {
            Seed = (uint)result.GetValue(_seed),
            Dial = usual.Dial with { Iterations = result.GetValue(_iterations), Dt = dt > 0 ? dt : usual.Dial.Dt },
            IsFull = result.GetValue(_full),
            Each = result.GetValue(_each) ? result.Output() : null,
        };
        var only = new List<GeneralScene>();
        foreach (string word in result.GetValue(_only) ?? [])
        {
            only.Add(GeneralCatalogue.Find(word) ?? throw new UsageException($"general: '{word}' is no scene."));
        }

        using StreamWriter? csv = Values.Open(_csv.Name, result.GetValue(_csv));
        return Print(only.Count > 0 ? only : GeneralCatalogue.Scenes, settings, result.Output(), csv);
    }

    private static bool Print(
        IReadOnlyList<GeneralScene> scenes, GeneralSettings settings, TextWriter output, StreamWriter? csv)
    {
        output.WriteLine(Cli.Settings);
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"Iterations {settings.Dial.Iterations}, dt {settings.Dial.Dt:G6}, seed {settings.Seed}; the worst of each figure"));
        output.WriteLine($"{"id",-4} {"metric",-28} {"figure",12} {"limit",10}  {"result",-6}  parameters");
        csv?.WriteLine(CsvHeader);
        int passed = 0;
        int failed = 0;
        foreach (GeneralScene scene in scenes)
        {
            foreach (Outcome outcome in GeneralRun.Of(scene, settings))
            {
                passed += outcome.IsMet ? 1 : 0;
                failed += outcome.IsMet ? 0 : 1;
                string result = outcome.IsMet ? "met" : "MISSED";
                output.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{scene.Id,-4} {outcome.Figure.Name,-28} {outcome.Value,12:G4} {Bound(outcome.Figure),10}  {result,-6}  ")
                    + outcome.Parameters);
                output.Flush();
                csv?.WriteLine(ToCsv(outcome));
            }
        }

        output.WriteLine($"{passed} passed, {failed} failed");
        return failed == 0;
    }

    private static string Bound(Figure figure) =>
        (figure.AtLeast ? ">= " : "<= ") + figure.Limit.ToString("G4", CultureInfo.InvariantCulture);

    private static string ToCsv(Outcome outcome)
    {
        string better = outcome.Figure.AtLeast ? "more" : "less";
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{outcome.Scene.Id},{outcome.Figure.Name},{outcome.Value:G6},{outcome.Figure.Limit:G6},{better},{(outcome.IsMet ? 1 : 0)},")
            + $"\"{outcome.Parameters}\"";
    }
}
