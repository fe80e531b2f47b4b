using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;

namespace Farseer.Beside;

/// <summary>A file of comma-separated values whose first line names the columns; a value with commas stands in quotes.</summary>
internal sealed class CsvTable
{
    private readonly string _path;
    private readonly string[] _names;

    private CsvTable(string path, string[] names, List<string[]> rows)
    {
        _path = path;
        _names = names;
        Rows = rows;
    }

    public IReadOnlyList<string[]> Rows { get; }

    /// <exception cref="FormatException">The file is empty, or a line has more or fewer values than names.</exception>
    public static CsvTable Read(string path)
    {
        string[] lines = File.ReadAllLines(path);
        if (lines.Length == 0)
        {
            throw new FormatException($"{path} is empty.");
        }

        string[] names = Split(lines[0]);
        var rows = new List<string[]>();
        for (int i = 1; i < lines.Length; i++)
        {
            string[] cells = Split(lines[i]);
            rows.Add(cells.Length == names.Length
                ? cells
                : throw new FormatException($"{path}, line {i + 1}: {cells.Length} values under {names.Length} names."));
        }

        return new CsvTable(path, names, rows);
    }

    /// <summary>Where a column is, by the first of these names that there is.</summary>
    /// <exception cref="FormatException">There is none.</exception>
    public int Column(params ReadOnlySpan<string> names)
    {
        foreach (string name in names)
        {
            if (Has(name))
            {
                return Array.IndexOf(_names, name);
            }
        }

        throw new FormatException($"{_path} has no column {names[0]}.");
    }

    public bool Has(string name) => Array.IndexOf(_names, name) >= 0;

    /// <exception cref="FormatException">It is no number.</exception>
    public double Number(int row, int column) =>
        double.TryParse(Rows[row][column], NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            ? value
            : throw new FormatException($"{_path}, line {row + 2}: '{Rows[row][column]}' is no number.");

    private static string[] Split(string line)
    {
        var cells = new List<string>();
        var cell = new StringBuilder();
        bool isQuoted = false;
        foreach (char letter in line)
        {
            if (letter == '"')
            {
                isQuoted = !isQuoted;
            }
            else if (letter == ',' && !isQuoted)
            {
                cells.Add(cell.ToString());
                cell.Clear();
            }
            else
            {
                cell.Append(letter);
            }
        }

        cells.Add(cell.ToString());
        return [.. cells];
    }
}
