using System.Collections.Generic;
using System.CommandLine;
using Farseer.CommandLines;

namespace Farseer.Fidelity;

/// <summary>The command line.</summary>
public sealed record Options(string Folder, IReadOnlyCollection<string> Categories, string? Scene, bool Verbose, bool List, string? CsvPath)
{
    private static readonly Argument<string> _folder = new("folder") { Description = "the folder of recorded scenes" };
    private static readonly ValueOption<string?> _categories =
        Values.Word("--category", "A,B", "names of categories, joined by commas", "only scenes of these");
    private static readonly ValueOption<string?> _scene = Values.Word("--scene", "NAME", "the name of a scene", "only this scene");
    private static readonly Option<bool> _verbose = Values.Flag("--verbose", "tells every check");
    private static readonly Option<bool> _list = Values.Flag("--list", "names the scenes and runs none");
    private static readonly ValueOption<string?> _csv = Values.File("--csv", "writes every check with its limit to a file too");

    /// <summary>The command with these options.</summary>
    public static RootCommand Root() => new(
        "Compares scenes with recordings of the original. Exit code 0: no scene failed; 1: one failed; 2: the input cannot be used.")
    {
        _folder, _categories, _scene, _verbose, _list, _csv,
    };

    public static Options Read(ParseResult result) => new(
        result.GetRequiredValue(_folder),
        result.GetValue(_categories)?.Split(',', System.StringSplitOptions.RemoveEmptyEntries | System.StringSplitOptions.TrimEntries)
        ?? [],
        result.GetValue(_scene),
        result.GetValue(_verbose),
        result.GetValue(_list),
        result.GetValue(_csv));
}
