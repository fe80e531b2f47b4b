using System;

namespace Farseer.Samples;

/// <summary>Parts of the debug view that are off until asked for.</summary>
[Flags]
internal enum ShownParts
{
    None = 0,
    Vertices = 1,
    Grids = 2,
    Boxes = 4,
    Axes = 8,
    All = 15,
}

/// <summary>What to run and how; null leaves the scene's or the library's own value.</summary>
internal sealed record RunOptions(string Scene)
{
    public int? Steps { get; init; }

    public int? Iterations { get; init; }

    public float? Dt { get; init; }

    public bool Json { get; init; }

    /// <summary>The error to be kept, a length of the scene.</summary>
    public float? Error { get; init; }

    /// <summary>The file to draw into.</summary>
    public string? Out { get; init; }

    /// <summary>What else to draw than geoms, contacts, joints and springs.</summary>
    public ShownParts Show { get; init; }

    /// <summary>A scene's outcomes are meant for its own steps and time step; more iterations must not harm them.</summary>
    public bool KeepsOutcome => Steps is null && Dt is null;
}
