using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Farseer.Accuracy.General;

/// <summary>Runs the general scenes and holds them against their limits.</summary>
internal static class GeneralCommand
{
    private const string CsvHeader = "scene,metric,value,limit,better,met,parameters";

    /// <summary>Prints the table; true if every figure is met.</summary>
    public static bool Run(string[] args, TextWriter output)
    {
        GeneralSettings settings = GeneralSettings.Default;
        string? path = null;
        var only = new List<GeneralScene>();
        for (int i = 0; i < args.Length; i++)
        {
            string Value() => ++i < args.Length ? args[i] : throw new UsageException($"general: {args[i - 1]} needs a value.");
            switch (args[i])
            {
                case "--seed":
                    settings = settings with { Seed = (uint)Options.WholeNumber("--seed", Value(), 0, int.MaxValue) };
                    break;
                case "--csv":
                    path = Value();
                    break;
                case "--iterations":
                    int iterations = Options.WholeNumber("--iterations", Value(), 1, 1000);
                    settings = settings with { Dial = settings.Dial with { Iterations = iterations } };
                    break;
                case "--dt":
                    settings = settings with { Dial = settings.Dial with { Dt = Options.Duration("--dt", Value()) } };
                    break;
                case "--full":
                    settings = settings with { IsFull = true };
                    break;
                case "--each":
                    settings = settings with { Each = output };
                    break;
                default:
                    only.Add(GeneralCatalogue.Find(args[i])
                        ?? throw new UsageException($"general: '{args[i]}' is no scene and no option; see --help."));
                    break;
            }
        }

        using StreamWriter? csv = Cli.OpenCsv(path);
        return Print(only.Count > 0 ? only : GeneralCatalogue.Scenes, settings, output, csv);
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
