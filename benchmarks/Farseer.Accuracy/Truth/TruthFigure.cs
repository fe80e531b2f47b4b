using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Farseer.Accuracy.Truth;

/// <summary>A figure of a build, with what it is held against.</summary>
/// <param name="Name">Where it is from, the scene and the metric.</param>
/// <param name="Value">As measured.</param>
/// <param name="Limit">The largest value that is right; with <paramref name="AtLeast"/> the smallest.</param>
/// <param name="AtLeast">More is better.</param>
internal sealed record TruthFigure(string Name, double Value, double Limit, bool AtLeast)
{
    private const string Header = "name,value,limit,better";
    private const string More = "more";
    private const string Less = "less";

    public bool IsMet => Value < Runner.Exploded && (AtLeast ? Value >= Limit : Value <= Limit);

    public bool IsWorseThan(TruthFigure other) => AtLeast ? Value < other.Value : Value > other.Value;

    public static void Write(TextWriter csv, IEnumerable<TruthFigure> figures)
    {
        csv.WriteLine(Header);
        foreach (TruthFigure figure in figures)
        {
            csv.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{figure.Name.Replace(',', ';')},{figure.Value:G9},{figure.Limit:G9},{(figure.AtLeast ? More : Less)}"));
        }
    }

    public static List<TruthFigure> Read(string path)
    {
        string[] lines;
        try
        {
            lines = File.ReadAllLines(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new UsageException($"compare-truth: {e.Message}");
        }

        if (lines.Length == 0 || lines[0] != Header)
        {
            throw new UsageException($"compare-truth: {path} does not begin with '{Header}'.");
        }

        var figures = new List<TruthFigure>();
        for (int i = 1; i < lines.Length; i++)
        {
            string[] fields = lines[i].Split(',');
            if (fields.Length != 4
                || !double.TryParse(fields[1], NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
                || !double.TryParse(fields[2], NumberStyles.Float, CultureInfo.InvariantCulture, out double limit)
                || fields[3] is not (More or Less))
            {
                throw new UsageException($"compare-truth: {path}, line {i + 1}: '{lines[i]}' is no figure.");
            }

            figures.Add(new TruthFigure(fields[0], value, limit, fields[3] == More));
        }

        return figures;
    }
}
