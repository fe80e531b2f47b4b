using System;
using System.Collections.Generic;
using Farseer.CommandLines;

namespace Farseer.Beside;

/// <summary>What a part is, and by what it is judged.</summary>
internal enum PartKind
{
    /// <summary>Figures with limits, none of which may be lost.</summary>
    Figures,

    /// <summary>Figures of chaotic worlds: no more may be lost, less those gained, than by chance.</summary>
    Draws,

    /// <summary>Times, of one process after the other: their geometric mean counts.</summary>
    Times,
}

/// <summary>What a program of a build measures and writes to a file.</summary>
/// <param name="Name">Its word on the command line.</param>
/// <param name="Program">The project's name.</param>
/// <param name="Kind">Figures or times.</param>
/// <param name="Batches">What the program is asked, one after the other; the name of the file follows.</param>
internal sealed record Part(string Name, string Program, PartKind Kind, IReadOnlyList<IReadOnlyList<string>> Batches)
{
    public bool IsTimed => Kind == PartKind.Times;
}

/// <summary>All that is set side by side.</summary>
internal static class Parts
{
    public const string AccuracyGroup = "accuracy";
    public const string SpeedGroup = "speed";

    private const string Accuracy = "Farseer.Accuracy";
    private const string Fidelity = "Farseer.Fidelity";
    private const string Benchmarks = "Farseer.Benchmarks";
    private const string File = "--csv";

    /// <summary>The scenes of the published comparison; boxes at rest have a part of their own.</summary>
    private static readonly string[] _scenes =
    [
        "large_pyramid", "many_pyramids", "joint_grid", "smash", "tumbler", "washer", "junkyard", "compounds", "spinner", "circle_pile",
    ];

    /// <param name="scenes">Timing scenes, with or without a size; none: the ten.</param>
    /// <param name="runs">Timed runs of a scene.</param>
    public static IReadOnlyList<Part> All(IReadOnlyList<string> scenes, int runs)
    {
        string count = FormattableString.Invariant($"{runs}");
        var batches = new List<IReadOnlyList<string>>();
        foreach (string scene in scenes.Count > 0 ? scenes : _scenes)
        {
            batches.Add(["scenes", "--scene", scene, "--runs", count, File]);
        }

        return
        [
            new("goals", Accuracy, PartKind.Figures, [["truth", "goals", File]]),
            new("aims", Accuracy, PartKind.Figures, [["truth", "aims", File]]),
            new("general", Accuracy, PartKind.Figures, [["truth", "general", File]]),
            new("recordings", Fidelity, PartKind.Figures, [["tests/data/fidelity", File]]),
            new("recordings-box2d", Fidelity, PartKind.Figures, [["tests/data/fidelity-box2d", File]]),
            new("surveys", Accuracy, PartKind.Figures, [["surveys", File]]),
            new("truthful", Accuracy, PartKind.Figures, [["truthful", File]]),
            new("energies", Accuracy, PartKind.Draws, [["energies", File]]),
            new("trees", Benchmarks, PartKind.Times, [["trees", "--lanes", File]]),
            new("scenes", Benchmarks, PartKind.Times, batches),
            new("resting", Benchmarks, PartKind.Times, [["resting", File]]),
        ];
    }

    /// <summary>The parts that words stand for, in the order of the report.</summary>
    /// <exception cref="UsageException">A word is neither a part nor a group.</exception>
    public static IReadOnlyList<Part> Choose(IReadOnlyList<Part> all, IReadOnlyList<string> words)
    {
        var chosen = new HashSet<Part>();
        foreach (string word in words)
        {
            int before = chosen.Count;
            foreach (Part part in all)
            {
                if (word == part.Name || word == (part.IsTimed ? SpeedGroup : AccuracyGroup))
                {
                    chosen.Add(part);
                }
            }

            if (chosen.Count == before)
            {
                string names = string.Join(", ", Names(all, false)) + ", " + string.Join(", ", Names(all, true));
                throw new UsageException($"--only: '{word}' is none of {AccuracyGroup}, {SpeedGroup}, {names}, or named twice.");
            }
        }

        return [.. ((List<Part>)[.. all]).FindAll(chosen.Contains)];
    }

    public static IReadOnlyList<string> Names(IReadOnlyList<Part> parts, bool areTimed)
    {
        var names = new List<string>();
        foreach (Part part in parts)
        {
            if (part.IsTimed == areTimed)
            {
                names.Add(part.Name);
            }
        }

        return names;
    }
}
