using System;
using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.CommandLine.Parsing;
using System.IO;
using System.Linq;

namespace Farseer.CommandLines;

/// <summary>Runs a command line. Whatever is wrong with it is told in one line, and the exit code is 2.</summary>
public static class CommandLine
{
    /// <summary>The exit code of a command line that is misused.</summary>
    public const int Misused = 2;

    private const int Fine = 0;

    /// <summary>Where output goes that is no terminal.</summary>
    private const int NarrowestWidth = 80;

    private static readonly ParserConfiguration _parsing = new() { EnablePosixBundling = false, ResponseFileTokenReplacer = null };

    /// <summary>Reads the words and does what they ask.</summary>
    /// <param name="root">The commands. Without an action of its own it prints its help.</param>
    /// <param name="words">The arguments of the program.</param>
    /// <param name="output">Where results go.</param>
    /// <param name="errors">Where the line about a mistake goes.</param>
    /// <param name="explain">Knows more about a word that is no command, or returns null.</param>
    public static int Run(
        RootCommand root, IReadOnlyList<string> words, TextWriter output, TextWriter errors, Func<string, string?>? explain = null)
    {
        Complete(root);
        var invocation = new InvocationConfiguration
        {
            Output = output,
            Error = errors,
            EnableDefaultExceptionHandler = false,
            ProcessTerminationTimeout = null,
        };
        try
        {
            ParseResult result = root.Parse(words, _parsing);
            bool isHelp = result.Action is HelpAction;
            string? mistake = isHelp ? null : Mistake(result, explain);
            return mistake is null ? result.Invoke(invocation) : throw new UsageException(mistake);
        }
        catch (UsageException mistake)
        {
            errors.WriteLine("error: " + mistake.Message);
            return Misused;
        }
    }

    /// <summary>What every root has: help by word as well as by option, and for all commands at once.</summary>
    private static void Complete(RootCommand root)
    {
        foreach (VersionOption version in root.Options.OfType<VersionOption>().ToList())
        {
            root.Options.Remove(version);
        }

        foreach (HelpAction help in root.Options.OfType<HelpOption>().Select(o => (HelpAction)o.Action!))
        {
            help.MaxWidth = Console.IsOutputRedirected ? NarrowestWidth : Math.Max(NarrowestWidth, Console.WindowWidth);
        }

        if (root.Subcommands.Count > 0)
        {
            var word =
                new Argument<string?>("command") { Description = "one command; without, all of them", Arity = ArgumentArity.ZeroOrOne };
            var command = new Command("help", "What the commands do, with all their options.") { word };
            command.SetAction(result => Help(root, result.GetValue(word), result.InvocationConfiguration));
            root.Add(command);
        }

        if (root.Action is null)
        {
            root.SetAction(result => Help(root, null, result.InvocationConfiguration));
        }
    }

    private static int Help(RootCommand root, string? word, InvocationConfiguration invocation)
    {
        if (word is not null)
        {
            Command command = root.Subcommands.FirstOrDefault(c => c.Name == word)
                ?? throw new UsageException(NoCommand(root, word));
            return root.Parse([command.Name, "--help"], _parsing).Invoke(invocation);
        }

        root.Parse(["--help"], _parsing).Invoke(invocation);
        foreach (Command command in root.Subcommands.Where(c => c.Name != "help" && (c.Options.Count > 0 || c.Arguments.Count > 0)))
        {
            invocation.Output.WriteLine($"-- {command.Name}");
            root.Parse([command.Name, "--help"], _parsing).Invoke(invocation);
        }

        return Fine;
    }

    private static string? Mistake(ParseResult result, Func<string, string?>? explain)
    {
        Command command = result.CommandResult.Command;
        string? stray =
            result.UnmatchedTokens.Concat(command.Arguments.SelectMany(a => result.GetResult(a)?.Tokens ?? []).Select(t => t.Value))
            .FirstOrDefault(t => t.StartsWith("--", StringComparison.Ordinal));
        if (stray is not null)
        {
            return $"'{command.Name}' has no option '{stray}'{Names.Suggestion(stray, AllOptions(result).Select(o => o.Name))}";
        }

        if (result.Errors.Count == 0)
        {
            return null;
        }

        ParseError error = result.Errors[0];
        if (error.SymbolResult is OptionResult { Tokens.Count: 0, Option: IValueOption option } missing)
        {
            return $"{missing.Option.Name} needs {option.Wanted}";
        }

        if (result.UnmatchedTokens.Count > 0)
        {
            string word = result.UnmatchedTokens[0];
            return command.Subcommands.Count > 0
                ? explain?.Invoke(word) ?? NoCommand(command, word)
                : command.Arguments.Count switch
                {
                    0 => $"'{command.Name}' takes no arguments, not '{word}'",
                    1 => $"'{command.Name}' takes one {command.Arguments[0].Name}, not "
                        + $"'{result.GetValue<string>(command.Arguments[0].Name)}' and '{word}'",
                    _ => $"'{command.Name}' takes {string.Join(" and ", command.Arguments.Select(a => a.Name))}, not '{word}' besides",
                };
        }

        return error.SymbolResult is ArgumentResult { Tokens.Count: 0 } empty && command.Arguments.Contains(empty.Argument)
            ? $"'{command.Name}' needs {empty.Argument.Description}"
            : error.Message.ReplaceLineEndings(" ");
    }

    private static IEnumerable<Option> AllOptions(ParseResult result)
    {
        for (SymbolResult? at = result.CommandResult; at is not null; at = at.Parent)
        {
            foreach (Option option in (at as CommandResult)?.Command.Options ?? [])
            {
                yield return option;
            }
        }
    }

    private static string NoCommand(Command parent, string word) =>
        $"there is no command '{word}'{Names.Suggestion(word, parent.Subcommands.Select(c => c.Name))}; 'help' lists the commands";
}
