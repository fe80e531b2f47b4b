using System;
using System.IO;
using Farseer.CommandLines;
using Farseer.Scenes;
using Spectre.Console;

namespace Farseer.Samples;

/// <summary>The console: lists, runs, shows, draws and checks the scenes of the library.</summary>
internal static class Program
{
    private const int Fine = 0;

    private static int Main(string[] args)
    {
        if (Console.IsOutputRedirected)
        {
            // A pipe has no width; tables are laid out for the narrowest common terminal. And no colours: some build
            // servers announce that they show them, but a file or another program does not want them.
            AnsiConsole.Profile.Width = 80;
            AnsiConsole.Profile.Capabilities.Ansi = false;
            AnsiConsole.Profile.Capabilities.ColorSystem = ColorSystem.NoColors;
            AnsiConsole.Profile.Capabilities.Interactive = false;
        }

        try
        {
            return CommandLine.Run(SampleCommands.Root(), args, Console.Out, Console.Error, Explain);
        }
        catch (SceneFileException e)
        {
            Console.Error.WriteLine("error: " + e.Message);
            return CommandLine.Misused;
        }
        catch (IOException)
        {
            // The reader of our pipe has gone (| head): nothing is left to be said, and nobody to say it to.
            return Fine;
        }
    }

    private static string? Explain(string word) => SceneLibrary.Find(word) is null
        ? null
        : $"'{word}' is a scene, not a command; did you mean 'run {word}' or 'watch {word}'?";
}
