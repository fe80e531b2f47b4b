using System;
using System.Collections.Generic;
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

namespace Farseer.Accuracy;

/// <summary>The command line: runs scenes, lists them, or prints the table of goals.</summary>
internal static class Cli
{
    private const int Failed = 1;
    private const int Misused = 2;

    private const string Help = """
        Accuracy of the simulator against closed forms and exact statics.

          --scene NAME=P        a scene and its parameter; may be repeated
          --iterations N[,N..]  values of PhysicsSimulator.Iterations (default 5)
          --dt S[,S..]          step lengths, seconds or fractions such as 1/240 (default 1/60)
          --runs N              runs for the clock: the first warms up, the least of the others counts (default 1)
          --csv FILE            writes the rows to a file too
          list                  the scenes, their parameters and metrics
          sweep [--out FILE] [--runs N]
                                the dials of ten scenes: error against cost, hypervolume, time to 1 %, floors
          aims                  the figures that were aimed at, beside those reached and the best of other engines
          costs                 nanoseconds a body-step of the aims' scenes at the default dial, beside another engine's
          neighbours [SCENE..] [--seed N] [--count N]
                                the aims at parameters that nobody published: ends of ranges and random values between
          extremes [WORD..]     how far masses, sizes, steps, speeds can be driven until a scene stops holding
          surveys [K1 K3 ..] [--seed N] [--count N] [--csv FILE]
                                kinds of faults found before, each in a grid of variations and N random ones; exit code 1 if one fails
          general [G01 ..] [--seed N] [--csv FILE] [--iterations N] [--dt S] [--full] [--each]
                                scenes that must hold for a whole range of parameters, with parameters drawn by the seed
                                (default 1): the worst of each figure beside its limit; exit code 1 if one is missed.
                                --full runs G19 and G27 for their stated 10 minutes instead of 60 and 30 s; --each tells every sample
          truth --csv FILE [goals aims general] [--seed N]
                                writes every figure of goals, aims and general scenes with its limit, one a line
          energies [--seeds N] [--seconds S] [--csv FILE]
                                random worlds in which nothing drives: how far their energy rises again; exit code 1 if one exceeds the limit
          truthful [--count N] [--seed N] [--csv FILE]
                                whether reports and budgets tell the truth, on random scenes against 64 times the iterations
          report [--plots] [--docs FOLDER]
                                writes the tables and plots of docs/Accuracy.md from the stored sweep and fresh runs; --plots:
                                the plots alone
          dials [--docs FOLDER] writes docs/Dials.md: what Iterations, 1/dt and other settings give and take in a dozen kinds of scene
          goals [SCENE..]       the figures at the default dial beside their limits; exit code 1 if one fails
        """;

    public static int Run(string[] args, TextWriter output, TextWriter errors)
    {
        try
        {
            if (args.Length == 0 || args[0] is "--help" or "-h" or "help")
            {
                output.WriteLine(Help);
                return 0;
            }

            switch (args[0])
            {
                case "list":
                    List(output);
                    return 0;
                case "goals":
                    return Goals.Print(args[1..], output) ? 0 : Failed;
                case "aims":
                    AimTable.Print(output);
                    return 0;
                case "costs":
                    Costs.Print(output);
                    return 0;
                case "neighbours":
                    return Neighbours.Run(args[1..], output) ? 0 : Failed;
                case "extremes":
                    return ExtremesCommand.Run(args[1..], output) ? 0 : Failed;
                case "surveys":
                    return SurveyCommand.Run(args[1..], output) ? 0 : Failed;
                case "general":
                    return GeneralCommand.Run(args[1..], output) ? 0 : Failed;
                case "truth":
                    TruthCommand.Run(args[1..], output);
                    return 0;
                case "energies":
                    return EnergyCommand.Run(args[1..], output) ? 0 : Failed;
                case "truthful":
                    return TruthfulCommand.Run(args[1..], output) ? 0 : Failed;
                case "report":
                    ReportCommand.Run(args[1..], output);
                    return 0;
                case "dials":
                    DialsCommand.Run(args[1..], output);
                    return 0;
                case "sweep":
                    SweepCommand.Run(args[1..], output);
                    return 0;
                default:
                    RunScenes(Options.Parse(args), output);
                    return 0;
            }
        }
        catch (UsageException mistake)
        {
            errors.WriteLine(mistake.Message);
            return Misused;
        }
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

    private static void RunScenes(Options options, TextWriter output)
    {
        using StreamWriter? csv = OpenCsv(options.CsvPath);
        csv?.WriteLine(Row.CsvHeader);
        output.WriteLine(Settings);
        output.WriteLine($"{"scene",-26} {"iterations",10} {"dt",10} {"metric",-27} {"value",13} {"ns/body-step",13}  note");
        foreach (SceneChoice choice in options.Scenes)
        {
            foreach (double dt in options.Dts)
            {
                foreach (int iterations in options.Iterations)
                {
                    List<Row> rows = Runner.Run(choice, new Dial(iterations, dt), options.Runs);
                    foreach (Row row in rows)
                    {
                        output.WriteLine(string.Create(
                            CultureInfo.InvariantCulture,
                            $"{row.Scene,-26} {row.Iterations,10} {row.Dt,10:G6} {row.Metric,-27} {row.Value,13:G6} {row.NanosecondsPerBodyStep,13:G6}  {row.Note}"));
                        csv?.WriteLine(row.ToCsv());
                    }
                }
            }
        }
    }

    internal static StreamWriter? OpenCsv(string? path)
    {
        try
        {
            return path is null ? null : new StreamWriter(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new UsageException($"--csv: {e.Message}");
        }
    }
}
