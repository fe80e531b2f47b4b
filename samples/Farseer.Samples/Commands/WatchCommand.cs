using System;
using Farseer.CommandLines;
using Farseer.Samples.Terminal;
using Farseer.Scenes;
using Spectre.Console;

namespace Farseer.Samples.Commands;

/// <summary>Shows a scene live in the terminal.</summary>
internal static class WatchCommand
{
    public static int Execute(RunOptions options, bool hasTerminal)
    {
        Scene scene = SceneSelection.Find(options.Scene);
        if (!hasTerminal || !AnsiConsole.Profile.Capabilities.Ansi)
        {
            throw new UsageException($"'watch' needs a terminal; 'run {options.Scene}' prints the results instead");
        }

        try
        {
            new WatchSession(scene, options).Run();
        }
        catch (ArgumentException e)
        {
            throw new UsageException(e.Message.ReplaceLineEndings(" "));
        }

        return 0;
    }
}
