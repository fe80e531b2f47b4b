using System;
using System.CommandLine;
using System.Globalization;
using System.IO;

namespace Farseer.CommandLines;

/// <summary>Makes the usual options and opens the files that they name.</summary>
public static class Values
{
    public static Option<bool> Flag(string name, string description) => new(name) { Description = description };

    /// <summary>A whole number that has a value without being given.</summary>
    public static ValueOption<int> Whole(string name, string description, int least, int most, int preset) =>
        new(name, "N", WantedWhole(least, most), description, (string text, out int value) => TryWhole(text, least, most, out value))
        {
            DefaultValueFactory = _ => preset,
        };

    /// <summary>A whole number, or null if it is not given.</summary>
    public static ValueOption<int?> Whole(string name, string description, int least, int most = int.MaxValue) =>
        new(name, "N", WantedWhole(least, most), description, (string text, out int? value) =>
        {
            bool isRead = TryWhole(text, least, most, out int number);
            value = number;
            return isRead;
        });

    /// <summary>A number above 0, or null if it is not given.</summary>
    public static ValueOption<double?> Positive(string name, string help, string wanted, string description) =>
        new(name, help, wanted, description, (string text, out double? value) =>
        {
            bool isRead = TryNumber(text, out double number) && number > 0;
            value = number;
            return isRead;
        });

    /// <summary>The name of a file, or null if it is not given.</summary>
    public static ValueOption<string?> File(string name, string description, string help = "FILE") =>
        new(name, help, "the name of a file", description, TryText!);

    /// <summary>Any word, or null if it is not given.</summary>
    public static ValueOption<string?> Word(string name, string help, string wanted, string description) =>
        new(name, help, wanted, description, TryText!);

    public static bool TryText(string text, out string value)
    {
        value = text;
        return text.Length > 0;
    }

    public static bool TryWhole(string text, int least, int most, out int value) =>
        int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out value) && value >= least && value <= most;

    /// <summary>A finite number.</summary>
    public static bool TryNumber(string text, out double value) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && double.IsFinite(value);

    /// <summary>Opens the file that an option names, before anything runs, so that a name that cannot be written is told at once.</summary>
    /// <returns>Null without a name.</returns>
    /// <exception cref="UsageException">The file cannot be written.</exception>
    public static StreamWriter? Open(string option, string? path)
    {
        try
        {
            return path is null ? null : new StreamWriter(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new UsageException($"{option}: {e.Message.ReplaceLineEndings(" ")}");
        }
    }

    private static string WantedWhole(int least, int most) => most == int.MaxValue
        ? FormattableString.Invariant($"a whole number of at least {least}")
        : FormattableString.Invariant($"a whole number from {least} to {most}");
}
