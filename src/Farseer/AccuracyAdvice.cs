using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics;

/// <summary>What an <see cref="AccuracyAdvisor"/> found. (An addition to the original.)</summary>
public sealed class AccuracyAdvice
{
    internal AccuracyAdvice(float maximumError, List<AccuracyPoint> curve)
    {
        MaximumError = maximumError;
        Curve = curve.AsReadOnly();
        foreach (AccuracyPoint point in curve)
        {
            if (point.PeakError <= maximumError && (Cheapest is null || point.Work < Cheapest.Value.Work))
            {
                Cheapest = point;
            }
        }
    }

    /// <summary>The error that was asked for, a length.</summary>
    public float MaximumError { get; }

    /// <summary>All settings that were tried, by rising <see cref="AccuracyPoint.Work"/>.</summary>
    public IReadOnlyList<AccuracyPoint> Curve { get; }

    /// <summary>The setting with the least work whose error stays within <see cref="MaximumError"/> all the time; null if none does.</summary>
    public AccuracyPoint? Cheapest { get; }
}
