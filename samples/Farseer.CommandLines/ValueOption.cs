using System;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Linq;

namespace Farseer.CommandLines;

/// <summary>Reads the text of a value; false if it is none.</summary>
public delegate bool Reading<T>(string text, out T value);

/// <summary>An option that can say what it needs.</summary>
public interface IValueOption
{
    /// <summary>What a value is, in words that go on after "needs".</summary>
    string Wanted { get; }
}

/// <summary>An option with one value; the last one counts if it is given more than once.</summary>
public sealed class ValueOption<T> : Option<T>, IValueOption
{
    /// <param name="name">With its dashes.</param>
    /// <param name="help">What stands for the value in the help.</param>
    /// <param name="wanted">What a value is, in words that go on after "needs".</param>
    /// <param name="description">What the option does.</param>
    /// <param name="read">Reads a value.</param>
    public ValueOption(string name, string help, string wanted, string description, Reading<T> read)
        : base(name)
    {
        Wanted = wanted;
        HelpName = help;
        Description = description;

        // One value each time, as often as it is given.
        Arity = ArgumentArity.OneOrMore;
        CustomParser = result => ValueReading.Read(result, result.Tokens[^1].Value, name, wanted, read);
    }

    public string Wanted { get; }
}

/// <summary>An option that may be given several times, once for each value.</summary>
public sealed class ValuesOption<T> : Option<T[]>, IValueOption
{
    /// <param name="name">With its dashes.</param>
    /// <param name="help">What stands for a value in the help.</param>
    /// <param name="wanted">What a value is, in words that go on after "needs".</param>
    /// <param name="description">What the option does.</param>
    /// <param name="read">Reads a value.</param>
    public ValuesOption(string name, string help, string wanted, string description, Reading<T> read)
        : base(name)
    {
        Wanted = wanted;
        HelpName = help;
        Description = description;
        Arity = ArgumentArity.OneOrMore;
        DefaultValueFactory = _ => [];
        CustomParser = result => [.. result.Tokens.Select(token => ValueReading.Read(result, token.Value, name, wanted, read)!)];
    }

    public string Wanted { get; }
}

internal static class ValueReading
{
    public static T? Read<T>(ArgumentResult result, string text, string name, string wanted, Reading<T> read)
    {
        try
        {
            if (read(text, out T value))
            {
                return value;
            }

            result.AddError($"{name} needs {wanted}, not '{text}'");
        }
        catch (UsageException mistake)
        {
            result.AddError(mistake.Message);
        }

        return default;
    }
}
