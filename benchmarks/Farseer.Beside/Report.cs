using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Farseer.Beside;

/// <summary>The tables, as Markdown, and the verdict.</summary>
internal sealed class Report
{
    /// <summary>So many lines of what is no loss are enough to see what changed.</summary>
    private const int FewLines = 20;

    private readonly string _before;
    private readonly string _after;
    private readonly IReadOnlyList<Result> _results;
    private readonly List<string> _faults = [];

    /// <param name="before">What the earlier build is, for people.</param>
    /// <param name="after">What the later build is.</param>
    /// <param name="results">In the order of the report.</param>
    /// <param name="limit">The largest geometric mean of times that is not slower.</param>
    public Report(string before, string after, IReadOnlyList<Result> results, double limit)
    {
        _before = before;
        _after = after;
        _results = results;
        foreach (Result result in results)
        {
            double mean = result.Times?.GeometricMean ?? 1;
            AddFault(result.Figures is { HasLost: true }, $"{result.Name}: {result.Figures?.Of(Change.Lost).Count} lost");
            AddFault(result.HasEnded, $"{result.Name}: no longer there");
            AddFault(result.Times is { Pairs.Count: 0 }, $"{result.Name}: no scene in common");
            AddFault(mean > limit, $"{result.Name}: {mean:F3} times as long, {limit} is the limit");
        }
    }

    /// <summary>1 if something is lost or slower.</summary>
    public int ExitCode => _faults.Count > 0 ? 1 : 0;

    /// <param name="output">Where it goes.</param>
    /// <param name="isFull">Every figure that differs; else few of each kind besides all that are lost.</param>
    public void Write(TextWriter output, bool isFull)
    {
        output.WriteLine("# Two builds side by side");
        output.WriteLine();
        output.WriteLine($"- before: {_before}");
        output.WriteLine($"- after: {_after}");
        WriteCounts(output);
        foreach (Change change in (ReadOnlySpan<Change>)[Change.Lost, Change.Worse, Change.Gained, Change.Better])
        {
            WriteFigures(output, change, isFull || change == Change.Lost ? int.MaxValue : FewLines);
        }

        WriteGone(output, isFull ? int.MaxValue : FewLines);
        WriteTimes(output);
        output.WriteLine();
        output.WriteLine(_faults.Count == 0 ? "Nothing is lost, nothing is slower." : $"**{string.Join("; ", _faults)}.**");
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    private static string Limit(Figure figure) => Text($"{(figure.AtLeast ? "≥" : "≤")} {figure.Limit:G4}");

    private void AddFault(bool isThere, FormattableString fault)
    {
        if (isThere)
        {
            _faults.Add(Text(fault));
        }
    }

    private void WriteCounts(TextWriter output)
    {
        bool isFirst = true;
        foreach (Result result in _results)
        {
            if (result.Times is not null)
            {
                continue;
            }

            if (isFirst)
            {
                output.WriteLine();
                output.Write("| part | met: before | after | missed: before | after |");
                output.WriteLine(" lost | worse | gained | better | same | gone | new |");
                output.WriteLine("|---|---|---|---|---|---|---|---|---|---|---|---|");
                isFirst = false;
            }

            if (result.Figures is not { } figures)
            {
                output.WriteLine($"| {result.Name} | {Told(result.FaultBefore)} | {Told(result.FaultAfter)} | | | | | | | | | |");
                continue;
            }

            output.Write(Text($"| {result.Name} | {figures.MetBefore} | {figures.MetAfter} |"));
            output.Write(Text($" {figures.MissedBefore} | {figures.MissedAfter} |"));
            foreach (Change change in Enum.GetValues<Change>())
            {
                output.Write(Text($" {figures.Of(change).Count} |"));
            }

            output.WriteLine(Text($" {figures.Gone.Count} | {figures.New} |"));
        }
    }

    private static string Told(string fault) => fault.Length > 0 ? fault : "–";

    private void WriteFigures(TextWriter output, Change change, int most)
    {
        var pairs = new List<(string Part, FigurePair Pair)>();
        foreach (Result result in _results)
        {
            foreach (FigurePair pair in result.Figures?.Of(change) ?? [])
            {
                pairs.Add((result.Name, pair));
            }
        }

        if (pairs.Count == 0)
        {
            return;
        }

        output.WriteLine();
        output.WriteLine($"| {change.ToString().ToLowerInvariant()} | before | after | limit |");
        output.WriteLine("|---|---|---|---|");
        foreach ((string part, FigurePair pair) in pairs.GetRange(0, Math.Min(most, pairs.Count)))
        {
            bool isOneLimit = pair.Before.Limit == pair.After.Limit;
            string limit = isOneLimit ? Limit(pair.After) : $"{Limit(pair.Before)}, then {Limit(pair.After)}";
            output.WriteLine(Text($"| {part}: {pair.After.Name} | {pair.Before.Value:G4} | {pair.After.Value:G4} | {limit} |"));
        }

        WriteRest(output, pairs.Count - most);
    }

    private void WriteGone(TextWriter output, int most)
    {
        var lines = new List<string>();
        foreach (Result result in _results)
        {
            foreach (Figure figure in result.Figures?.Gone ?? [])
            {
                lines.Add(Text($"| {result.Name}: {figure.Name} | {figure.Value:G4} | {Limit(figure)} |"));
            }
        }

        if (lines.Count > 0)
        {
            output.WriteLine();
            output.WriteLine("| gone | before | limit |");
            output.WriteLine("|---|---|---|");
            lines.GetRange(0, Math.Min(most, lines.Count)).ForEach(output.WriteLine);
            WriteRest(output, lines.Count - most);
        }
    }

    private static void WriteRest(TextWriter output, int count)
    {
        if (count > 0)
        {
            output.WriteLine();
            output.WriteLine(Text($"{count} more; --out FILE.md has them all."));
        }
    }

    private void WriteTimes(TextWriter output)
    {
        foreach (Result result in _results)
        {
            if (result.Times is not { } times)
            {
                continue;
            }

            output.WriteLine();
            output.WriteLine($"| {result.Name}, ms a step | before | after | after / before | again | bits |");
            output.WriteLine("|---|---|---|---|---|---|");
            foreach (TimePair pair in times.Pairs)
            {
                string bits = pair.IsSame ? "same" : "other";
                string again = double.IsFinite(pair.Again) ? Text($"{pair.Again:F3}") : "–";
                output.Write(Text($"| {pair.Scene} | {pair.Before:G4} | {pair.After:G4} | "));
                output.WriteLine(Text($"{pair.Ratio:F3} | {again} | {bits} |"));
            }

            output.WriteLine(Text($"| **geometric mean** | | | **{times.GeometricMean:F3}** | | |"));
        }
    }
}
