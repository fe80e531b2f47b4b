using System;
using System.Collections.Generic;
using Farseer.Samples.Commands;
using Farseer.Samples.Terminal;
using Farseer.Scenes;
using Spectre.Console;

namespace Farseer.Samples;

/// <summary>What a person sees who types no arguments: choose a scene by moving or by typing, then watch it or run it.</summary>
internal static class Menu
{
    /// <summary>Enough of a title to tell it from the others, so that a row stays a row.</summary>
    private const int TitleWidth = 40;

    /// <param name="Text">The row, as it is searched.</param>
    /// <param name="Act">What choosing it does.</param>
    private sealed record Choice(string Text, Action Act);

    private static readonly Choice _leave = new(string.Empty, () => { });

    /// <summary>Returns when the user leaves.</summary>
    /// <param name="console">The terminal; null: the program's.</param>
    public static int Show(IAnsiConsole? console = null)
    {
        IAnsiConsole terminal = new LeavingConsole(console ?? AnsiConsole.Console);
        terminal.MarkupLine("[yellow]Farseer[/] samples: type to search, enter chooses, [yellow]q[/] or [yellow]esc[/] leaves.");
        for (Choice choice; (choice = Ask(terminal, "Choose a scene", Scenes(terminal))) != _leave;)
        {
            choice.Act();
        }

        return 0;
    }

    private static List<Choice> Scenes(IAnsiConsole terminal)
    {
        List<Choice> choices = [];
        foreach (Scene scene in SceneLibrary.All)
        {
            string text = FormattableString.Invariant($"{choices.Count + 1,2}  {scene.Title.PadRight(TitleWidth)}  {scene.Name}");
            choices.Add(new Choice(text, () => Play(terminal, scene)));
        }

        choices.Add(new Choice(" c  Check all scenes", () => CheckCommand.Execute()));
        return choices;
    }

    private static void Play(IAnsiConsole terminal, Scene scene)
    {
        terminal.MarkupLineInterpolated($"[yellow]{scene.Title}[/]: {scene.Description}");
        List<Choice> choices =
        [
            new("Watch it live", () => WatchCommand.Execute(new RunOptions(scene.Name), hasTerminal: true)),
            new("Run it and print the results", () => RunCommand.Execute(new RunOptions(scene.Name))),
        ];
        Ask(terminal, "What now?", choices).Act();
    }

    private static Choice Ask(IAnsiConsole terminal, string title, List<Choice> choices) =>
        terminal.Prompt(new SelectionPrompt<Choice>()
            .Title(title)
            .PageSize(22)
            .EnableSearch()
            .SearchPlaceholderText("[grey](type to search)[/]")
            .MoreChoicesText("[grey](more below)[/]")
            .UseConverter(choice => Markup.Escape(choice.Text))
            .AddCancelResult(_leave)
            .AddChoices(choices));
}
