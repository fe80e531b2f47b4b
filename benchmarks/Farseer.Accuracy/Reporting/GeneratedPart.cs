using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using Farseer.CommandLines;

namespace Farseer.Accuracy.Reporting;

/// <summary>The parts of documents that commands write, each between two marks; the prose around them is kept.</summary>
internal static class GeneratedPart
{
    private const string UsualFolder = "docs";

    public static ValueOption<string?> FolderOption() =>
        Values.Word("--docs", "FOLDER", "the name of a folder", "where the documents are; docs by default");

    /// <summary>The document of a folder with its text.</summary>
    /// <exception cref="UsageException">There is no such document.</exception>
    public static (string Folder, string Path, string Text) Open(string command, string document, string? folder)
    {
        folder ??= UsualFolder;
        string path = Path.Combine(folder, document);
        return File.Exists(path)
            ? (folder, path, File.ReadAllText(path))
            : throw new UsageException($"{command}: there is no {path}; run it from the repository's root or name the folder with --docs.");
    }

    /// <summary>What stands between the marks of a part.</summary>
    /// <exception cref="UsageException">The text has no such part.</exception>
    public static string Read(string text, string part)
    {
        (int start, int end) = Find(text, part);
        return text[start..end];
    }

    /// <summary>The text with other lines between the marks of a part.</summary>
    /// <exception cref="UsageException">The text has no such part.</exception>
    public static string Replaced(string text, string part, IEnumerable<string> lines)
    {
        (int start, int end) = Find(text, part);
        var middle = new StringBuilder("\n");
        foreach (string line in lines)
        {
            middle.Append(line).Append('\n');
        }

        middle.Append('\n');
        return text[..start] + middle + text[end..];
    }

    private static (int Start, int End) Find(string text, string part)
    {
        string from = $"<!-- {part}: generated -->\n";
        int start = text.IndexOf(from, StringComparison.Ordinal);
        int end = text.IndexOf($"<!-- {part}: end -->", StringComparison.Ordinal);
        return start >= 0 && end >= start
            ? (start + from.Length, end)
            : throw new UsageException($"the document has no part '{part}' between its two marks.");
    }
}
