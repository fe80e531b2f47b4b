using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Extremes;

/// <summary>A quantity that is driven until a scene stops holding.</summary>
/// <param name="Word">Its name on the command line.</param>
/// <param name="Quantity">What is driven, with its unit.</param>
/// <param name="Criterion">What has to hold.</param>
/// <param name="Asked">How far it has to hold.</param>
/// <param name="Steps">Values, each harder than the one before.</param>
/// <param name="Holds">Runs the scene at a value, at the default dial.</param>
internal sealed record Extreme(string Word, string Quantity, string Criterion, double Asked, double[] Steps, Func<double, bool> Holds);

/// <summary>How far a quantity could be driven.</summary>
/// <param name="Extreme">The quantity.</param>
/// <param name="Last">The hardest value that holds, with all before it; null if even the first fails.</param>
/// <param name="Failed">The first that fails; null if none of those tried.</param>
internal sealed record ExtremeResult(Extreme Extreme, double? Last, double? Failed)
{
    public bool IsMet => Last is double last && Array.IndexOf(Extreme.Steps, last) >= Array.IndexOf(Extreme.Steps, Extreme.Asked);
}

/// <summary>Runs extremes.</summary>
internal static class ExtremeRun
{
    public static ExtremeResult Drive(Extreme extreme)
    {
        double? last = null;
        foreach (double value in extreme.Steps)
        {
            if (!extreme.Holds(value))
            {
                return new ExtremeResult(extreme, last, value);
            }

            last = value;
        }

        return new ExtremeResult(extreme, last, null);
    }

    public static IReadOnlyList<Extreme> All { get; } = [.. MassExtremes.All, .. MotionExtremes.All, .. CrowdExtremes.All];
}
