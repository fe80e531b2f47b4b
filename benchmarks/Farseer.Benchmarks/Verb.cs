using System;
using System.CommandLine;
using System.IO;
using System.Linq;
using Farseer.CommandLines;
using Farseer.Scenes.Performance;

namespace Farseer.Benchmarks;

/// <summary>Makes the verbs of the command line.</summary>
internal static class Verb
{
    public static Command Plain(string name, string description, Func<TextWriter, int> run, params Symbol[] parts) =>
        Of(name, description, result => run(result.Output()), parts);

    /// <exception cref="UsageException">Out of the command: a file cannot be read or written, or does not hold what it should.</exception>
    public static Command Of(string name, string description, Func<ParseResult, int> run, params Symbol[] parts)
    {
        var command = new Command(name, description);
        foreach (Argument argument in parts.OfType<Argument>())
        {
            command.Add(argument);
        }

        foreach (Option option in parts.OfType<Option>())
        {
            command.Add(option);
        }

        command.SetAction(result =>
        {
            try
            {
                return run(result);
            }
            catch (Exception mistake) when (mistake is FormatException or IOException or UnauthorizedAccessException)
            {
                throw new UsageException(mistake.Message.ReplaceLineEndings(" "));
            }
        });
        return command;
    }

    /// <summary>A word that may be left out.</summary>
    public static Argument<string?> Maybe(string name, string description) =>
        new(name) { Description = description, Arity = ArgumentArity.ZeroOrOne };

    /// <summary>A whole number that may be left out.</summary>
    public static Argument<int> Maybe(string name, string description, int preset)
    {
        var argument =
            new Argument<int>(name) { Description = description, Arity = ArgumentArity.ZeroOrOne, DefaultValueFactory = _ => preset };
        argument.Validators.Add(result =>
        {
            if (result.Tokens.Count > 0 && !Values.TryWhole(result.Tokens[0].Value, 0, int.MaxValue, out _))
            {
                result.AddError($"{name} needs a whole number, not '{result.Tokens[0].Value}'");
            }
        });
        return argument;
    }

    /// <exception cref="UsageException">There is no such scene.</exception>
    public static PerformanceScene Scene(string name) => PerformanceScenes.Find(name)
        ?? throw new UsageException(
            $"no scene is called '{name}'; there are {string.Join(", ", PerformanceScenes.All.Select(s => s.Name))}.");

    /// <summary>Where a command writes.</summary>
    public static TextWriter Output(this ParseResult result) => result.InvocationConfiguration.Output;
}
