using System;
using System.Collections.Generic;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity;

/// <summary>The command line.</summary>
public sealed record Options(string Folder, IReadOnlyCollection<string> Categories, string? Scene, bool Verbose, bool List, string? CsvPath = null)
{
    public const string Usage = "Farseer.Fidelity <folder> [--category a,b] [--scene name] [--verbose] [--list] [--csv file]";

    public static Options Parse(IReadOnlyList<string> args)
    {
        string? folder = null;
        string? scene = null;
        string? csv = null;
        string[] categories = [];
        bool verbose = false;
        bool list = false;
        for (int i = 0; i < args.Count; i++)
        {
            switch (args[i])
            {
                case "--category":
                    categories = Value(args, ref i).Split(',', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
                    break;
                case "--scene":
                    scene = Value(args, ref i);
                    break;
                case "--csv":
                    csv = Value(args, ref i);
                    break;
                case "--verbose":
                    verbose = true;
                    break;
                case "--list":
                    list = true;
                    break;
                default:
                    if (args[i].StartsWith("--", StringComparison.Ordinal) || folder is not null)
                    {
                        throw new BadSceneException($"'{args[i]}' is not understood. Usage: {Usage}");
                    }

                    folder = args[i];
                    break;
            }
        }

        return new Options(folder ?? throw new BadSceneException("No folder is given. Usage: " + Usage), categories, scene, verbose, list, csv);
    }

    private static string Value(IReadOnlyList<string> args, ref int i)
        => ++i < args.Count ? args[i] : throw new BadSceneException($"{args[i - 1]} needs a value. Usage: {Usage}");
}
