using System;
using System.IO;
using Farseer.Samples.Commands;
using Farseer.Samples.Sweeping;
using Farseer.Scenes;
using Spectre.Console;

namespace Farseer.Samples;

/// <summary>The console: lists, runs, shows, draws and checks the scenes of the library.</summary>
internal static class Program
{
    private const int Fine = 0;
    private const int WrongUse = 2;
    private static readonly string[] _verbs = ["list", "run", "watch", "draw", "advise", "learn", "sweep", "merge", "check", "help"];

    private static bool HasTerminal => !Console.IsInputRedirected && !Console.IsOutputRedirected;

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
            return Dispatch(args);
        }
        catch (UsageException e)
        {
            Console.Error.WriteLine("error: " + e.Message);
            return WrongUse;
        }
        catch (SceneFileException e)
        {
            Console.Error.WriteLine("error: " + e.Message);
            return WrongUse;
        }
        catch (IOException)
        {
            // The reader of our pipe has gone (| head): nothing is left to be said, and nobody to say it to.
            return Fine;
        }
    }

    private static int Dispatch(string[] args)
    {
        if (args.Length == 0)
        {
            return HasTerminal ? Menu.Show() : RunCommand.Execute(new RunOptions(SceneLibrary.DefaultName));
        }

        ReadOnlySpan<string> rest = args.AsSpan(1);
        switch (args[0])
        {
            case "list":
                CommandLine.None("list", rest);
                return ListCommand.Execute();
            case "run":
                return RunCommand.Execute(CommandLine.Run("run", rest));
            case "watch":
                return WatchCommand.Execute(CommandLine.Run("watch", rest), HasTerminal);
            case "draw":
                return DrawCommand.Execute(CommandLine.Run("draw", rest));
            case "advise":
                return AdviseCommand.Execute(CommandLine.Run("advise", rest));
            case "learn":
                return LearnCommand.Execute(rest);
            case "sweep":
                return SweepCommand.Execute(rest);
            case "merge":
                return MergeCommand.Execute(rest);
            case "check":
                CommandLine.None("check", rest);
                return CheckCommand.Execute();
            case "help" or "--help" or "-h" or "-?":
                return HelpCommand.Execute();
            default:
                throw Unknown(args[0]);
        }
    }

    private static UsageException Unknown(string word)
    {
        if (SceneLibrary.Find(word) is not null)
        {
            return new UsageException($"'{word}' is a scene, not a command; did you mean 'run {word}' or 'watch {word}'?");
        }

        return new UsageException($"there is no command '{word}'{Names.Suggestion(word, _verbs)}; 'help' lists the commands");
    }
}
