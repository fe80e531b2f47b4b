using System.Collections.Generic;
using Farseer.Samples.Commands;
using Farseer.Scenes;
using Spectre.Console;

namespace Farseer.Samples;

/// <summary>What a person sees who types no arguments: choose a scene, then watch it or run it.</summary>
internal static class Menu
{
    private const string CheckAll = "Check all scenes";
    private const string Quit = "Quit";
    private const string Watch = "Watch it live";
    private const string Run = "Run it and print the results";
    private const string Back = "Back";

    public static int Show()
    {
        while (true)
        {
            string choice = Ask("[yellow]Farseer[/]: choose a scene", SceneTitles());
            if (choice == Quit)
            {
                return 0;
            }

            if (choice == CheckAll)
            {
                CheckCommand.Execute();
                continue;
            }

            Scene scene = Titled(choice);
            AnsiConsole.MarkupLineInterpolated($"[yellow]{scene.Title}[/]: {scene.Description}");
            switch (Ask("What now?", [Watch, Run, Back]))
            {
                case Watch:
                    WatchCommand.Execute(new RunOptions(scene.Name), hasTerminal: true);
                    break;
                case Run:
                    RunCommand.Execute(new RunOptions(scene.Name));
                    break;
            }
        }
    }

    private static List<string> SceneTitles()
    {
        List<string> titles = [];
        foreach (Scene scene in SceneLibrary.All)
        {
            titles.Add(scene.Title);
        }

        titles.Add(CheckAll);
        titles.Add(Quit);
        return titles;
    }

    private static Scene Titled(string title)
    {
        foreach (Scene scene in SceneLibrary.All)
        {
            if (scene.Title == title)
            {
                return scene;
            }
        }

        throw new UsageException($"there is no scene '{title}'");
    }

    private static string Ask(string title, IEnumerable<string> choices) =>
        AnsiConsole.Prompt(new SelectionPrompt<string>()
            .Title(title)
            .PageSize(22)
            .MoreChoicesText("[grey](more below)[/]")
            .AddChoices(choices));
}
