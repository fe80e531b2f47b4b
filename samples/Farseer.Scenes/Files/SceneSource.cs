using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text.Json;

namespace Farseer.Scenes;

/// <summary>The bytes of a scene file and the way from a JSON path back to line and column.</summary>
internal sealed class SceneSource
{
    private static readonly JsonReaderOptions _readerOptions =
        new() { CommentHandling = JsonCommentHandling.Skip, AllowTrailingCommas = true };
    private readonly string _file;
    private readonly byte[] _bytes;

    public SceneSource(string file)
    {
        _file = file;
        try
        {
            _bytes = File.ReadAllBytes(file);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new SceneFileException(e is FileNotFoundException or DirectoryNotFoundException
                ? $"{file}: no such file"
                : $"{file}: {OneLine(e.Message)}");
        }

        if (_bytes.AsSpan().StartsWith("\uFEFF"u8))
        {
            _bytes = _bytes[3..];
        }
    }

    public SceneNode Root()
    {
        try
        {
            JsonDocument document = JsonDocument.Parse(
                _bytes, new JsonDocumentOptions { CommentHandling = JsonCommentHandling.Skip, AllowTrailingCommas = true });
            return new SceneNode(this, document.RootElement, string.Empty);
        }
        catch (JsonException e)
        {
            // The reader's own text repeats the place in its own words; what stays in front of it is the reason.
            string reason = OneLine(e.Message);
            int place = reason.IndexOf(" LineNumber:", StringComparison.Ordinal);
            throw Located((e.LineNumber ?? 0) + 1, (e.BytePositionInLine ?? 0) + 1, place > 0 ? reason[..place] : reason);
        }
    }

    public SceneFileException Fault(string path, string complaint)
    {
        (long line, long column) = Place(path);
        return Located(line, column, $"{(path.Length == 0 ? "the file" : path)} {complaint}");
    }

    private static string OneLine(string text) => text.ReplaceLineEndings(" ");

    private SceneFileException Located(long line, long column, string text) =>
        new(string.Create(CultureInfo.InvariantCulture, $"{_file}, line {line}, position {column}: {text}"));

    /// <summary>Reads the file again, which costs nothing that matters once there is something to complain about.</summary>
    private (long Line, long Column) Place(string path)
    {
        Utf8JsonReader reader = new(_bytes, _readerOptions);
        Stack<(string Path, int Index)> open = new();
        string property = string.Empty;
        while (reader.Read())
        {
            if (reader.TokenType == JsonTokenType.PropertyName)
            {
                string name = reader.GetString()!;
                property = open.Peek().Path.Length == 0 ? name : open.Peek().Path + "." + name;
                continue;
            }

            if (reader.TokenType is JsonTokenType.EndObject or JsonTokenType.EndArray)
            {
                open.Pop();
                continue;
            }

            string here = property;
            if (open.Count > 0 && open.Peek().Index >= 0)
            {
                (string parent, int index) = open.Pop();
                here = string.Create(CultureInfo.InvariantCulture, $"{parent}[{index}]");
                open.Push((parent, index + 1));
            }

            if (here == path)
            {
                return LineOf(reader.TokenStartIndex);
            }

            if (reader.TokenType is JsonTokenType.StartObject or JsonTokenType.StartArray)
            {
                open.Push((here, reader.TokenType == JsonTokenType.StartArray ? 0 : -1));
            }
        }

        return (1, 1);
    }

    private (long Line, long Column) LineOf(long offset)
    {
        long line = 1;
        long start = 0;
        for (int i = 0; i < offset; i++)
        {
            if (_bytes[i] == (byte)'\n')
            {
                line++;
                start = i + 1;
            }
        }

        return (line, offset - start + 1);
    }
}
