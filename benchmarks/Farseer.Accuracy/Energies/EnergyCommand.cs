using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Farseer.Accuracy.Truth;

namespace Farseer.Accuracy.Energies;

/// <summary>Whether energy appears from nothing, in random worlds of several kinds.</summary>
internal static class EnergyCommand
{
    private const int DefaultSeeds = 20;
    private const double DefaultSeconds = 10;
    private const int MostSeconds = 3600;

    /// <summary>As of the general scenes with pits and ragdolls.</summary>
    private const double LargestRise = 1e-3;

    /// <summary>Prints a line a kind; true if no world exceeds the limit.</summary>
    /// <param name="args">--seeds N, --seconds S, --csv FILE.</param>
    /// <param name="output">Where the table goes.</param>
    public static bool Run(string[] args, TextWriter output)
    {
        int seeds = DefaultSeeds;
        double seconds = DefaultSeconds;
        string? path = null;
        for (int i = 0; i < args.Length; i += 2)
        {
            string value = i + 1 < args.Length ? args[i + 1] : throw new UsageException($"energies: {args[i]} needs a value.");
            switch (args[i])
            {
                case "--seeds":
                    seeds = Options.WholeNumber("--seeds", value, 1, 100_000);
                    break;
                case "--seconds":
                    seconds = Options.WholeNumber("--seconds", value, 1, MostSeconds);
                    break;
                case "--csv":
                    path = value;
                    break;
                default:
                    throw new UsageException($"energies: '{args[i]}' is no option; see --help.");
            }
        }

        using StreamWriter? csv = Cli.OpenCsv(path);
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"rise of energy above its running minimum, of the start's; {seeds} worlds of each kind, {seconds} s; limit {LargestRise:G3}"));
        output.WriteLine($"{"kind",-8} {"median",10} {"90 %",10} {"worst",10} {"of world",9} {"over",5}");
        var figures = new List<TruthFigure>();
        foreach (EnergyKind kind in EnergyWorlds.Kinds)
        {
            List<TruthFigure> worlds = Measure(kind, seeds, seconds);
            Print(kind, worlds, output);
            output.Flush();
            figures.AddRange(worlds);
        }

        if (csv is not null)
        {
            TruthFigure.Write(csv, figures);
        }

        int missed = figures.FindAll(figure => !figure.IsMet).Count;
        output.WriteLine($"{figures.Count - missed} passed, {missed} failed");
        return missed == 0;
    }

    private static List<TruthFigure> Measure(EnergyKind kind, int seeds, double seconds)
    {
        var worlds = new List<TruthFigure>();
        for (int seed = 1; seed <= seeds; seed++)
        {
            string name = FormattableString.Invariant($"{kind.Name} {seed} energy_rise");
            worlds.Add(new(name, EnergyWorlds.Rise(kind, seed, seconds), LargestRise, false));
        }

        return worlds;
    }

    private static void Print(EnergyKind kind, List<TruthFigure> worlds, TextWriter output)
    {
        var rises = worlds.ConvertAll(world => world.Value);
        int worst = rises.IndexOf(Largest(rises)) + 1;
        int over = worlds.FindAll(world => !world.IsMet).Count;
        rises.Sort();
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{kind.Name,-8} {rises[rises.Count / 2],10:G3} {rises[rises.Count * 9 / 10],10:G3} {rises[^1],10:G3} {worst,9} {over,5}"));
    }

    private static double Largest(List<double> values)
    {
        double largest = values[0];
        foreach (double value in values)
        {
            largest = Math.Max(largest, value);
        }

        return largest;
    }
}
