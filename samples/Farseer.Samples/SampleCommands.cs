using System;
using System.CommandLine;
using Farseer.CommandLines;
using Farseer.Samples.Commands;
using Farseer.Samples.Sweeping;
using Farseer.Scenes;

namespace Farseer.Samples;

/// <summary>The commands of the console with their options.</summary>
internal static class SampleCommands
{
    private const string About = """
        Farseer samples: small worlds with a known outcome.
        A scene is one of those that 'list' names, or a file as docs/SceneFormat.md describes it.
        Without a command: a menu in a terminal, otherwise the scene falling-stack.
        Exit code: 0 fine, 1 a check failed or no setting was found, 2 wrong use or a broken file.
        """;

    private static readonly ValueOption<int?> _steps = Values.Whole("--steps", "updates instead of the scene's own number", 1);
    private static readonly ValueOption<int?> _iterations =
        Values.Whole("--iterations", "the accuracy dial of the simulator, 5 by default", 1);
    private static readonly ValueOption<double?> _dt = Values.Positive("--dt", "S", "a number of seconds above 0", "seconds an update");
    private static readonly Option<bool> _json = Values.Flag("--json", "one JSON object instead of tables");
    private static readonly ValueOption<int?> _step = Values.Whole("--step", "after so many updates; by default the scene's last", 0);
    private static readonly ValueOption<string?> _out = Values.File("--out", "the picture's file; by default the scene's name");
    private static readonly ValueOption<double?> _error =
        Values.Positive("--error", "E", "a length above 0", "the largest error; by default 1/10000 of the view");

    private static readonly ValueOption<int?> _share =
        Values.Whole("--steps", "how much of the scene; by default all of it, at most 10 s", 1);

    private static readonly ValueOption<ShownParts> _show = new(
        "--show",
        "LIST",
        "vertices, grids, boxes, axes, joined by commas, or all",
        "what to draw besides: vertices,grids,boxes,axes or all",
        TryParts);

    private static readonly Argument<string> _scene = new("scene")
    {
        Description = "the name of a scene or a scene file; 'list' shows the names",
    };

    private static bool HasTerminal => !Console.IsInputRedirected && !Console.IsOutputRedirected;

    public static RootCommand Root()
    {
        RootCommand root = new(About)
        {
            Command("list", "The scenes and what they show.", _ => ListCommand.Execute()),
            Scene("run", "Runs a scene to its end and prints the results.", RunCommand.Execute, _steps, _iterations, _dt, _json),
            Scene("watch", WatchText(), options => WatchCommand.Execute(options, HasTerminal), _iterations, _dt),
            Scene("draw", "Draws one step of a scene into a picture (SVG).", DrawCommand.Execute, _step, _out, _show, _iterations, _dt),
            RecordCommand.Create(),
            Scene("advise", "Finds the cheapest setting for an error, with the curve.", AdviseCommand.Execute, _error, _share),
            LearnCommand.Create(),
            SweepCommand.Create(),
            MergeCommand.Create(),
            Command("check", "Runs all scenes and compares them with what must come out.", _ => CheckCommand.Execute()),
        };
        root.SetAction(_ => HasTerminal ? Menu.Show() : RunCommand.Execute(new RunOptions(SceneLibrary.DefaultName)));
        return root;
    }

    private static string WatchText() => "Shows a scene live in the terminal. Keys: " + Terminal.WatchSession.KeyText + ".";

    private static Command Command(string name, string description, Func<ParseResult, int> action)
    {
        Command command = new(name, description);
        command.SetAction(action);
        return command;
    }

    private static Command Scene(string name, string description, Func<RunOptions, int> action, params Option[] options)
    {
        Command command = Command(name, description, result => action(Read(result, options)));
        command.Add(_scene);
        foreach (Option option in options)
        {
            command.Add(option);
        }

        return command;
    }

    private static RunOptions Read(ParseResult result, Option[] known)
    {
        T? Value<T>(Option<T> option) => Array.IndexOf(known, option) < 0 ? default : result.GetValue(option);
        return new RunOptions(result.GetRequiredValue(_scene))
        {
            Steps = Value(_steps) ?? Value(_step) ?? Value(_share),
            Iterations = Value(_iterations),
            Dt = (float?)Value(_dt),
            Json = Value(_json),
            Error = (float?)Value(_error),
            Out = Value(_out),
            Show = Value(_show),
        };
    }

    private static bool TryParts(string text, out ShownParts parts)
    {
        parts = ShownParts.None;
        foreach (string name in text.Split(','))
        {
            ShownParts part = name switch
            {
                "vertices" => ShownParts.Vertices,
                "grids" => ShownParts.Grids,
                "boxes" => ShownParts.Boxes,
                "axes" => ShownParts.Axes,
                "all" => ShownParts.All,
                _ => ShownParts.None,
            };
            if (part == ShownParts.None)
            {
                return false;
            }

            parts |= part;
        }

        return true;
    }
}
