using System;
using System.Globalization;

namespace FarseerGames.FarseerPhysics.Serialization;

/// <summary>A file cannot be loaded. Nothing of it has been made then.</summary>
/// <example>
/// <code>
/// try
/// {
///     simulator = SceneFile.LoadSimulator(stream);
/// }
/// catch (SceneFileException exception)
/// {
///     Console.Error.WriteLine(exception.Message); // line 12, position 66: bodies[1].mass must be above 0: -3
/// }
/// </code>
/// </example>
public sealed class SceneFileException : Exception
{
    /// <summary>Makes an exception without a place.</summary>
    public SceneFileException()
        : this("The file cannot be loaded.")
    {
    }

    /// <summary>Makes an exception without a place.</summary>
    /// <param name="message">What is wrong.</param>
    public SceneFileException(string message)
        : this(message, null)
    {
    }

    /// <summary>Makes an exception without a place.</summary>
    /// <param name="message">What is wrong.</param>
    /// <param name="innerException">What led to it.</param>
    public SceneFileException(string message, Exception? innerException)
        : base(message, innerException)
    {
        ItemPath = "";
        Value = "";
    }

    internal SceneFileException(string problem, string path, string value, long offset, long line, long position, Exception? cause = null)
        : base(Text(problem, path, value, offset, line, position), cause)
    {
        ItemPath = path;
        Value = value;
        Offset = offset;
        Line = line;
        Position = position;
    }

    /// <summary>Which item it is, for example <c>bodies[1].mass</c>; empty if it is the file itself.</summary>
    public string ItemPath { get; }

    /// <summary>What stands there, cut after 60 characters; empty if it is no single value.</summary>
    public string Value { get; }

    /// <summary>Bytes before it in the file.</summary>
    public long Offset { get; }

    /// <summary>The line, from 1; 0 of a binary file.</summary>
    public long Line { get; }

    /// <summary>The place in the line in bytes, from 1; 0 of a binary file.</summary>
    public long Position { get; }

    private static string Text(string problem, string path, string value, long offset, long line, long position)
    {
        string place = line > 0
            ? string.Format(CultureInfo.InvariantCulture, "line {0}, position {1}: ", line, position)
            : string.Format(CultureInfo.InvariantCulture, "byte {0}: ", offset);
        return place + (path.Length > 0 ? path + " " : "") + problem + (value.Length > 0 ? ": " + value : "");
    }
}
