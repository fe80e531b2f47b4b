namespace Farseer.Samples;

/// <summary>What to run and how; null leaves the scene's or the library's own value.</summary>
internal sealed record RunOptions(string Scene)
{
    public int? Steps { get; init; }

    public int? Iterations { get; init; }

    public float? Dt { get; init; }

    public bool Json { get; init; }

    /// <summary>The file to draw into.</summary>
    public string? Out { get; init; }

    /// <summary>A scene's outcomes are meant for its own steps and time step; more iterations must not harm them.</summary>
    public bool KeepsOutcome => Steps is null && Dt is null;
}
