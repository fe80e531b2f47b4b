using System.Collections.Generic;
using Farseer.Scenes;

namespace Farseer.Samples;

/// <summary>What a run came to.</summary>
internal sealed record RunResult
{
    public required string Scene { get; init; }

    public required string Title { get; init; }

    public required int Steps { get; init; }

    public required float Dt { get; init; }

    public required int Iterations { get; init; }

    public required double MicrosecondsPerStep { get; init; }

    public required int Bodies { get; init; }

    public required int Geoms { get; init; }

    public required int Contacts { get; init; }

    public required float LargestPenetration { get; init; }

    public required double Energy { get; init; }

    public required double BytesPerStep { get; init; }

    public required ulong StateHash { get; init; }

    public required IReadOnlyList<SceneOutcome> Outcomes { get; init; }

    public bool AllOk
    {
        get
        {
            foreach (SceneOutcome outcome in Outcomes)
            {
                if (!outcome.Ok)
                {
                    return false;
                }
            }

            return true;
        }
    }
}
