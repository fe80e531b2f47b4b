using Farseer.Scenes;
using Spectre.Console;

namespace Farseer.Samples.Commands;

/// <summary>Prints the scenes with what they show.</summary>
internal static class ListCommand
{
    public static int Execute()
    {
        Table table = Report.Grid();
        table.AddColumn(new TableColumn("Scene").NoWrap());
        table.AddColumn("What it shows");
        foreach (Scene scene in SceneLibrary.All)
        {
            table.AddRow(new Markup($"[yellow]{Markup.Escape(scene.Name)}[/]"), new Text(scene.Description));
        }

        AnsiConsole.Write(table);
        return 0;
    }
}
