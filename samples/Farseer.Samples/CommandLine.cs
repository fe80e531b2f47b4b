using System;
using System.Globalization;

namespace Farseer.Samples;

/// <summary>Reads the words after a command.</summary>
internal static class CommandLine
{
    private static readonly string[] _runOptions = ["--steps", "--iterations", "--dt", "--json"];
    private static readonly string[] _watchOptions = ["--iterations", "--dt"];
    private static readonly string[] _drawOptions = ["--step", "--out", "--show", "--iterations", "--dt"];
    private static readonly string[] _adviseOptions = ["--error", "--steps"];

    public static void None(string verb, ReadOnlySpan<string> words)
    {
        if (words.Length > 0)
        {
            throw new UsageException($"'{verb}' takes no arguments, not '{words[0]}'");
        }
    }

    public static RunOptions Run(string verb, ReadOnlySpan<string> words)
    {
        string[] known = verb switch
        {
            "watch" => _watchOptions,
            "draw" => _drawOptions,
            "advise" => _adviseOptions,
            _ => _runOptions,
        };
        RunOptions options = new(string.Empty);
        for (int i = 0; i < words.Length; i++)
        {
            string word = words[i];
            if (!word.StartsWith('-'))
            {
                options = options.Scene.Length == 0
                    ? options with { Scene = word }
                    : throw new UsageException($"'{verb}' takes one scene, not '{options.Scene}' and '{word}'");
                continue;
            }

            if (Array.IndexOf(known, word) < 0)
            {
                throw new UsageException($"'{verb}' has no option '{word}'{Names.Suggestion(word, known)}");
            }

            if (word == "--json")
            {
                options = options with { Json = true };
                continue;
            }

            string? value = ++i < words.Length ? words[i] : null;
            options = word switch
            {
                "--steps" => options with { Steps = Whole(word, value, 1) },
                "--step" => options with { Steps = Whole(word, value, 0) },
                "--out" => options with { Out = value ?? throw Bad(word, "the name of a file", null) },
                "--show" => options with { Show = Parts(word, value) },
                "--error" => options with { Error = Length(word, value) },
                "--iterations" => options with { Iterations = Whole(word, value, 1) },
                _ => options with { Dt = Seconds(word, value) },
            };
        }

        return options.Scene.Length > 0
            ? options
            : throw new UsageException($"'{verb}' needs the name of a scene or a scene file; 'list' shows the names");
    }

    private static int Whole(string option, string? text, int least) =>
        int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value) && value >= least
            ? value
            : throw Bad(option, FormattableString.Invariant($"a whole number of at least {least}"), text);

    private static float Seconds(string option, string? text) =>
        float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out float value) && value > 0f && float.IsFinite(value)
            ? value
            : throw Bad(option, "a number of seconds above 0", text);

    private static float Length(string option, string? text) =>
        float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out float value) && value > 0f && float.IsFinite(value)
            ? value
            : throw Bad(option, "a length above 0", text);

    private static ShownParts Parts(string option, string? text)
    {
        ShownParts parts = ShownParts.None;
        foreach (string name in (text ?? string.Empty).Split(','))
        {
            parts |= name switch
            {
                "vertices" => ShownParts.Vertices,
                "grids" => ShownParts.Grids,
                "boxes" => ShownParts.Boxes,
                "axes" => ShownParts.Axes,
                "all" => ShownParts.All,
                _ => throw Bad(option, "vertices, grids, boxes, axes, joined by commas, or all", text),
            };
        }

        return parts;
    }

    private static UsageException Bad(string option, string wanted, string? text) =>
        new(text is null ? $"{option} needs {wanted}" : $"{option} needs {wanted}, not '{text}'");
}
