using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.Accuracy.Truth;
using Farseer.CommandLines;

namespace Farseer.Accuracy.Energies;

/// <summary>Whether energy appears from nothing, in random worlds of several kinds.</summary>
internal static class EnergyCommand
{
    private const int DefaultSeeds = 20;
    private const int DefaultSeconds = 10;
    private const int MostSeconds = 3600;

    /// <summary>As of the general scenes with pits and ragdolls.</summary>
    private const double LargestRise = 1e-3;

    private static readonly Option<int> _seeds = Values.Whole("--seeds", "worlds of each kind", 1, 100_000, DefaultSeeds);
    private static readonly Option<int> _seconds = Values.Whole("--seconds", "of each world", 1, MostSeconds, DefaultSeconds);
    private static readonly ValueOption<string?> _csv = Values.File("--csv", "writes the figures to a file too");

    public static Command Create() => Cli.Judged(
        "energies", "Random worlds in which nothing drives: how far their energy rises again.", Run, _seeds, _seconds, _csv);

    private static bool Run(ParseResult result)
    {
        TextWriter output = result.Output();
        int seeds = result.GetValue(_seeds);
        double seconds = result.GetValue(_seconds);
        using StreamWriter? csv = Values.Open(_csv.Name, result.GetValue(_csv));
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
