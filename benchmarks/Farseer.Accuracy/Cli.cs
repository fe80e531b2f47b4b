using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.Accuracy.Dials;
using Farseer.Accuracy.Energies;
using Farseer.Accuracy.Extremes;
using Farseer.Accuracy.General;
using Farseer.Accuracy.Reporting;
using Farseer.Accuracy.Surveys;
using Farseer.Accuracy.Sweeping;
using Farseer.Accuracy.Truth;
using Farseer.CommandLines;

namespace Farseer.Accuracy;

/// <summary>The command line: runs scenes by themselves, or one of the commands.</summary>
internal static class Cli
{
    private const int Failed = 1;

    private const string About = "Accuracy of the simulator against closed forms and exact statics.";

    private static readonly ValuesOption<SceneChoice> _scenes = new(
        "--scene", "NAME=P", "a scene and its parameter; 'list' shows them", "a scene and its parameter; may be repeated", TryScene);

    private static readonly ValueOption<List<int>> _iterations = new(
        "--iterations", "N,N,..", "whole numbers from 1 to 1000, joined by commas", "values of PhysicsSimulator.Iterations; 5 by default",
        (string text, out List<int> values) => TryEach(text, Options.TryIterations, out values))
    {
        DefaultValueFactory = _ => [Options.DefaultIterations],
    };

    private static readonly ValueOption<List<double>> _dts = new(
        "--dt", "S,S,..", Options.WantedDuration, "step lengths, seconds or fractions such as 1/240; 1/60 by default",
        (string text, out List<double> values) => TryEach(text, Options.TryDuration, out values))
    {
        DefaultValueFactory = _ => [Options.DefaultDt],
    };

    private static readonly Option<int> _runs = Values.Whole(
        "--runs", "runs for the clock: the first warms up, the least of the others counts", 1, 1000, 1);

    private static readonly ValueOption<string?> _csv = Values.File("--csv", "writes the rows to a file too");

    public static int Run(string[] args, TextWriter output, TextWriter errors) => CommandLine.Run(Root(), args, output, errors);

    /// <summary>A command that says by its exit code whether all was met.</summary>
    public static Command Judged(string name, string description, Func<ParseResult, bool> run, params Symbol[] parts)
    {
        var command = new Command(name, description);
        foreach (Symbol part in parts)
        {
            if (part is Option option)
            {
                command.Add(option);
            }
            else
            {
                command.Add((Argument)part);
            }
        }

        command.SetAction(result => run(result) ? 0 : Failed);
        return command;
    }

    /// <summary>A command that only measures.</summary>
    public static Command Plain(string name, string description, Action<ParseResult> run, params Symbol[] parts) => Judged(
        name,
        description,
        result =>
        {
            run(result);
            return true;
        },
        parts);

    /// <summary>Where a command writes.</summary>
    public static TextWriter Output(this ParseResult result) => result.InvocationConfiguration.Output;

    private static RootCommand Root()
    {
        RootCommand root = new(About)
        {
            _scenes, _iterations, _dts, _runs, _csv,
            Plain("list", "The scenes, their parameters and metrics.", result => List(result.Output())),
            SweepCommand.Create(),
            Plain(
                "aims",
                "The figures that were aimed at, beside those reached and the best of other engines.",
                result => AimTable.Print(result.Output())),
            Plain(
                "costs",
                "Nanoseconds a body-step of the aims' scenes at the default dial, beside another engine's.",
                result => Costs.Print(result.Output())),
            Neighbours.Create(),
            ExtremesCommand.Create(),
            SurveyCommand.Create(),
            GeneralCommand.Create(),
            TruthCommand.Create(),
            EnergyCommand.Create(),
            TruthfulCommand.Create(),
            ReportCommand.Create(),
            DialsCommand.Create(),
            Goals.Create(),
        };
        root.SetAction(result =>
        {
            if (result.Tokens.Count == 0)
            {
                return root.Parse(["help"]).Invoke(result.InvocationConfiguration);
            }

            RunScenes(result);
            return 0;
        });
        return root;
    }

    /// <summary>What every run states before its figures.</summary>
    public static string Settings => "settings: the defaults, but drag coefficients 0; "
        + "references at t = steps × the float step that Update receives.";

    private static void List(TextWriter output)
    {
        foreach (SceneInfo scene in Catalogue.Scenes)
        {
            output.WriteLine($"{scene.Name}=P");
            output.WriteLine($"    P: {scene.Parameter}, {scene.Range}; usual: {string.Join(' ', scene.Usual)}");
            output.WriteLine($"    metrics: {string.Join(' ', scene.Metrics)}");
        }
    }

    private static void RunScenes(ParseResult result)
    {
        SceneChoice[] scenes = result.GetRequiredValue(_scenes);
        if (scenes.Length == 0)
        {
            throw new UsageException("name a scene: --scene NAME=P, or see 'list'.");
        }

        TextWriter output = result.Output();
        using StreamWriter? csv = Values.Open(_csv.Name, result.GetValue(_csv));
        csv?.WriteLine(Row.CsvHeader);
        output.WriteLine(Settings);
        output.WriteLine($"{"scene",-26} {"iterations",10} {"dt",10} {"metric",-27} {"value",13} {"ns/body-step",13}  note");
        foreach (SceneChoice choice in scenes)
        {
            foreach (double dt in result.GetRequiredValue(_dts))
            {
                foreach (int iterations in result.GetRequiredValue(_iterations))
                {
                    List<Row> rows = Runner.Run(choice, new Dial(iterations, dt), result.GetValue(_runs));
                    foreach (Row row in rows)
                    {
                        output.WriteLine(string.Create(
                            CultureInfo.InvariantCulture,
                            $"{row.Scene,-26} {row.Iterations,10} {row.Dt,10:G6} {row.Metric,-27} {row.Value,13:G6} "
                                + $"{row.NanosecondsPerBodyStep,13:G6}  {row.Note}"));
                        csv?.WriteLine(row.ToCsv());
                    }
                }
            }
        }
    }

    private static bool TryScene(string text, out SceneChoice choice)
    {
        choice = Options.ParseScene(text);
        return true;
    }

    private static bool TryEach<T>(string text, Reading<T> read, out List<T> values)
    {
        values = [];
        foreach (string part in text.Split(','))
        {
            if (!read(part, out T value))
            {
                return false;
            }

            values.Add(value);
        }

        return true;
    }
}
