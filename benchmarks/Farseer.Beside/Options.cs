using System;
using System.Collections.Generic;
using System.Globalization;

namespace Farseer.Beside;

/// <summary>The command line of a comparison.</summary>
internal sealed class Options
{
    public const int DefaultTurns = 3;
    public const int DefaultRuns = 3;
    public const double DefaultLimit = 1.02;

    private readonly List<string> _builds = [];
    private readonly List<string> _scenes = [];
    private string[] _only = [Parts.AccuracyGroup, Parts.SpeedGroup];
    private int _runs = DefaultRuns;

    private Options()
    {
    }

    public string Before => _builds[0];

    public string After => _builds[1];

    /// <summary>How often each build is timed.</summary>
    public int Turns { get; private set; } = DefaultTurns;

    /// <summary>The largest geometric mean of times, after / before, that is not slower.</summary>
    public double Limit { get; private set; } = DefaultLimit;

    public string? OutPath { get; private set; }

    public IReadOnlyList<Part> Chosen { get; private set; } = [];

    public static Options Parse(string[] args)
    {
        var options = new Options();
        for (int i = 0; i < args.Length; i++)
        {
            string name = args[i];
            if (name.StartsWith("--", StringComparison.Ordinal))
            {
                options.Set(name, ++i < args.Length ? args[i] : throw new UsageException($"{name} needs a value."));
            }
            else
            {
                options._builds.Add(name);
            }
        }

        if (options._builds.Count != 2)
        {
            throw new UsageException($"two builds are compared, BEFORE and AFTER; {options._builds.Count} are named; see --help.");
        }

        options.Chosen = Parts.Choose(Parts.All(options._scenes, options._runs), options._only);
        return options;
    }

    private void Set(string name, string value)
    {
        switch (name)
        {
            case "--only":
                _only = value.Split(',');
                break;
            case "--turns":
                Turns = WholeNumber(name, value);
                break;
            case "--runs":
                _runs = WholeNumber(name, value);
                break;
            case "--scene":
                _scenes.Add(value);
                break;
            case "--limit":
                Limit = double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out double limit) && limit > 0
                    ? limit
                    : throw new UsageException($"--limit: '{value}' is not a number above 0.");
                break;
            case "--out":
                OutPath = value;
                break;
            default:
                throw new UsageException($"unknown argument '{name}'; see --help.");
        }
    }

    private static int WholeNumber(string what, string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int value) && value is >= 1 and <= 1000
            ? value
            : throw new UsageException($"{what}: '{text}' is not a whole number from 1 to 1000.");
}
