using System;
using Farseer.CommandLines;

namespace Farseer.Accuracy;

/// <summary>A scene with its parameter, as asked for.</summary>
internal sealed record SceneChoice(SceneInfo Scene, double Parameter, string Label);

/// <summary>What the options of several commands have in common.</summary>
internal static class Options
{
    public const int DefaultIterations = 5;
    public const double DefaultDt = 1.0 / 60;
    public const int MostIterations = 1000;
    public const string WantedDuration = "step lengths from 1e-5 to 0.5 seconds";

    /// <exception cref="UsageException">There is no such scene, or the parameter is out of its range.</exception>
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
        if (!Values.TryNumber(value, out double parameter))
        {
            throw new UsageException($"the parameter of {scene.Name}: '{value}' is not a number.");
        }

        if (!scene.Range.Contains(parameter))
        {
            throw new UsageException($"{scene.Name}={value}: {scene.Parameter} must be {scene.Range}.");
        }

        return new SceneChoice(scene, parameter, $"{scene.Name}={value}");
    }

    public static bool TryIterations(string text, out int value) => Values.TryWhole(text, 1, MostIterations, out value);

    /// <summary>Seconds, also as a fraction: 1/240.</summary>
    public static bool TryDuration(string text, out double value)
    {
        string[] parts = text.Split('/', 2);
        double divisor = 1;
        bool isRead = Values.TryNumber(parts[0], out value) && (parts.Length == 1 || Values.TryNumber(parts[1], out divisor));
        value /= divisor;
        return isRead && value is >= 1e-5 and <= 0.5;
    }
}
