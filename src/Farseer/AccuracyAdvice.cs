using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics;

/// <summary>What an <see cref="AccuracyAdvisor"/> found. (An addition to the original.)</summary>
/// <example>
/// <code>
/// AccuracyAdvice advice = AccuracyAdvisor.Advise(MakeScene, seconds: 5, maximumError: 0.001f);
/// if (advice.Cheapest is AccuracyPoint setting)
/// {
///     simulator.Iterations = setting.Iterations;
/// }
/// </code>
/// </example>
public sealed class AccuracyAdvice
{
    internal AccuracyAdvice(float maximumError, double referenceError, List<AccuracyPoint> curve)
    {
        MaximumError = maximumError;
        ReferenceError = referenceError;
        Curve = curve.AsReadOnly();
        foreach (AccuracyPoint point in curve)
        {
            if (referenceError <= maximumError && point.PeakError <= maximumError && (Cheapest is null || point.Work < Cheapest.Value.Work))
            {
                Cheapest = point;
            }
        }
    }

    /// <summary>The error that was asked for, a length.</summary>
    public float MaximumError { get; }

    /// <summary>
    /// How far the finest setting of the curve is from the reference run that motions are compared with, a length. Above
    /// <see cref="MaximumError"/> nobody knows the motion that closely: small differences decide it, and no setting is named.
    /// </summary>
    public double ReferenceError { get; }

    /// <summary>All settings that were tried, by rising <see cref="AccuracyPoint.Work"/>.</summary>
    public IReadOnlyList<AccuracyPoint> Curve { get; }

    /// <summary>
    /// The setting with the least work whose constraint error and motion error both stay within <see cref="MaximumError"/> all the time;
    /// null if none does.
    /// </summary>
    public AccuracyPoint? Cheapest { get; }
}
