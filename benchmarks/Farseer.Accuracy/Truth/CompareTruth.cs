using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Farseer.Accuracy.Truth;

/// <summary>Sets the figures of two builds side by side.</summary>
internal static class CompareTruth
{
    /// <summary>Figures that differ by no more than this share of the larger are the same.</summary>
    private const double Tenth = 0.1;

    /// <summary>A difference below this share of the limit is rounding: zero and 1e-16 m are no news where 1e-6 m is asked.</summary>
    private const double Rounding = 1e-3;

    /// <summary>In the order of the table.</summary>
    private enum Change
    {
        Lost,
        Worse,
        Gained,
        Better,
        Same,
    }

    /// <summary>Prints what differs; true if no met limit was lost.</summary>
    public static bool Run(string[] args, TextWriter output)
    {
        if (args.Length != 2)
        {
            throw new UsageException("compare-truth needs two files: BEFORE.csv AFTER.csv.");
        }

        var before = new Dictionary<string, TruthFigure>();
        foreach (TruthFigure figure in TruthFigure.Read(args[0]))
        {
            before[figure.Name] = figure;
        }

        var pairs = new List<(Change Change, TruthFigure Before, TruthFigure After)>();
        int added = 0;
        foreach (TruthFigure after in TruthFigure.Read(args[1]))
        {
            if (before.Remove(after.Name, out TruthFigure? figure))
            {
                pairs.Add((Judge(figure, after), figure, after));
            }
            else
            {
                added++;
            }
        }

        output.WriteLine($"{"change",-7} {"figure",-70} {"before",12} {"after",12} {"limit",13}");
        foreach (Change change in Enum.GetValues<Change>())
        {
            if (change != Change.Same)
            {
                Print(pairs.FindAll(pair => pair.Change == change), output);
            }
        }

        foreach (string name in before.Keys)
        {
            output.WriteLine($"{"gone",-7} {name}");
        }

        int Count(Change change) => pairs.FindAll(pair => pair.Change == change).Count;
        output.WriteLine(
            $"{Count(Change.Lost)} lost, {Count(Change.Worse)} worse, {Count(Change.Gained)} gained, {Count(Change.Better)} better, "
            + $"{Count(Change.Same)} the same, {before.Count} gone, {added} new");
        return Count(Change.Lost) == 0;
    }

    private static Change Judge(TruthFigure before, TruthFigure after)
    {
        // By the limit of the later file: a limit that was tightened meanwhile is no loss.
        bool wasMet = (before with { Limit = after.Limit }).IsMet;
        if (wasMet != after.IsMet)
        {
            return after.IsMet ? Change.Gained : Change.Lost;
        }

        double difference = Math.Abs(after.Value - before.Value);
        bool same = difference <= Tenth * Math.Max(Math.Abs(before.Value), Math.Abs(after.Value))
            || difference <= Rounding * Math.Abs(after.Limit);
        return same ? Change.Same : after.IsWorseThan(before) ? Change.Worse : Change.Better;
    }

    private static void Print(List<(Change Change, TruthFigure Before, TruthFigure After)> pairs, TextWriter output)
    {
        foreach ((Change change, TruthFigure before, TruthFigure after) in pairs)
        {
            string limit = (after.AtLeast ? ">= " : "<= ") + after.Limit.ToString("G4", CultureInfo.InvariantCulture);
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{change.ToString().ToLowerInvariant(),-7} {after.Name,-70} {before.Value,12:G4} {after.Value,12:G4} {limit,13}"));
        }
    }
}
