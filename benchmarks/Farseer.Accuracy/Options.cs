using System;
using System.Collections.Generic;
using System.Globalization;

namespace Farseer.Accuracy;

/// <summary>A scene with its parameter, as asked for.</summary>
internal sealed record SceneChoice(SceneInfo Scene, double Parameter, string Label);

/// <summary>The command line of a run.</summary>
internal sealed class Options
{
    public const int DefaultIterations = 5;
    public const double DefaultDt = 1.0 / 60;

    public List<SceneChoice> Scenes { get; } = [];

    public List<int> Iterations { get; private set; } = [DefaultIterations];

    public List<double> Dts { get; private set; } = [DefaultDt];

    public int Runs { get; private set; } = 1;

    public string? CsvPath { get; private set; }

    public static Options Parse(string[] args)
    {
        var options = new Options();
        for (int i = 0; i < args.Length; i += 2)
        {
            string name = args[i];
            if (name is not ("--scene" or "--iterations" or "--dt" or "--runs" or "--csv"))
            {
                throw new UsageException($"unknown argument '{name}'; see --help.");
            }

            if (i + 1 == args.Length)
            {
                throw new UsageException($"{name} needs a value.");
            }

            options.Set(name, args[i + 1]);
        }

        if (options.Scenes.Count == 0)
        {
            throw new UsageException("name a scene: --scene NAME=P, or see 'list'.");
        }

        return options;
    }

    public static SceneChoice ParseScene(string text)
    {
        int equals = text.IndexOf('=', StringComparison.Ordinal);
        string name = equals < 0 ? text : text[..equals];
        SceneInfo scene = Catalogue.Find(name) ?? throw new UsageException($"no scene is called '{name}'; see 'list'.");
        if (equals < 0)
        {
            throw new UsageException($"{scene.Name} needs a parameter ({scene.Parameter}), for example {scene.Name}={scene.Usual[0]}.");
        }

        string value = text[(equals + 1)..];
        double parameter = Number($"the parameter of {scene.Name}", value);
        if (!scene.Range.Contains(parameter))
        {
            throw new UsageException($"{scene.Name}={value}: {scene.Parameter} must be {scene.Range}.");
        }

        return new SceneChoice(scene, parameter, $"{scene.Name}={value}");
    }

    private void Set(string name, string value)
    {
        switch (name)
        {
            case "--scene":
                Scenes.Add(ParseScene(value));
                break;
            case "--iterations":
                Iterations = Each(value, part => WholeNumber(name, part, 1, 1000));
                break;
            case "--dt":
                Dts = Each(value, part => Duration(name, part));
                break;
            case "--runs":
                Runs = WholeNumber(name, value, 1, 1000);
                break;
            default:
                CsvPath = value.Length > 0 ? value : throw new UsageException("--csv needs a file name.");
                break;
        }
    }

    private static List<T> Each<T>(string text, Func<string, T> parse)
    {
        var values = new List<T>();
        foreach (string part in text.Split(','))
        {
            values.Add(parse(part));
        }

        return values;
    }

    internal static int WholeNumber(string what, string text, int least, int most)
    {
        if (!int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int value) || value < least || value > most)
        {
            throw new UsageException($"{what}: '{text}' is not a whole number from {least} to {most}.");
        }

        return value;
    }

    private static double Number(string what, string text)
    {
        if (!double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) || !double.IsFinite(value))
        {
            throw new UsageException($"{what}: '{text}' is not a number.");
        }

        return value;
    }

    /// <summary>Seconds, also as a fraction: 1/240.</summary>
    internal static double Duration(string what, string text)
    {
        int slash = text.IndexOf('/', StringComparison.Ordinal);
        double value = slash < 0 ? Number(what, text) : Number(what, text[..slash]) / Number(what, text[(slash + 1)..]);
        if (!(value >= 1e-5 && value <= 0.5))
        {
            throw new UsageException($"{what}: '{text}' is not a step length from 1e-5 to 0.5 seconds.");
        }

        return value;
    }
}
