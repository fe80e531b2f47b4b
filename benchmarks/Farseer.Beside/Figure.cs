using System.Collections.Generic;

namespace Farseer.Beside;

/// <summary>A figure of a build, with what it is held against.</summary>
/// <param name="Name">The scene and the metric.</param>
/// <param name="Value">As measured; infinite if it was no number.</param>
/// <param name="Limit">The largest value that is right; with <paramref name="AtLeast"/> the smallest.</param>
/// <param name="AtLeast">More is better.</param>
internal sealed record Figure(string Name, double Value, double Limit, bool AtLeast)
{
    /// <summary>What a metric is given when its scene exploded.</summary>
    private const double Exploded = 1e9;

    public bool IsMet => Value < Exploded && (AtLeast ? Value >= Limit : Value <= Limit);

    public bool IsWorseThan(Figure other) => AtLeast ? Value < other.Value : Value > other.Value;

    /// <summary>
    /// Reads a file with the columns name (or survey and variation), value (or figure), limit and, if more may be better,
    /// better.
    /// </summary>
    /// <exception cref="System.FormatException">It is no such file.</exception>
    public static List<Figure> Read(string path)
    {
        CsvTable table = CsvTable.Read(path);
        int name = table.Column("name", "survey");
        int variation = table.Has("name") ? -1 : table.Column("variation");
        int value = table.Column("value", "figure");
        int limit = table.Column("limit");
        int better = table.Has("better") ? table.Column("better") : -1;
        var figures = new List<Figure>();
        for (int row = 0; row < table.Rows.Count; row++)
        {
            string[] cells = table.Rows[row];
            bool atLeast = better >= 0 && cells[better] == "more";
            double number = table.Number(row, value);
            double worst = atLeast ? double.NegativeInfinity : double.PositiveInfinity;
            figures.Add(new Figure(
                variation < 0 ? cells[name] : $"{cells[name]}: {cells[variation]}",
                double.IsNaN(number) ? worst : number,
                table.Number(row, limit),
                atLeast));
        }

        return figures;
    }
}
