using System;
using System.Runtime.InteropServices;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// How large the error of an update may be, and how much work may be spent on it; see <see cref="PhysicsSimulator.ErrorBudget"/>. The
/// default value has no bound on the error. (An addition to the original.)
/// </summary>
/// <remarks>
/// The bound on the work is a number of iterations: the same scene then gives the same bits on every machine. A bound on the time can be
/// added (<see cref="WithTimeLimit"/>) and costs that: a clock has a say, and two runs of one scene may differ.
/// </remarks>
/// <example>
/// <code>
/// simulator.ErrorBudget = ErrorBudget.OfLength(0.001f, mostIterations: 40);
/// simulator.Update(1f / 60);
/// bool kept = simulator.Report.IsWithinBudget;
/// </code>
/// </example>
[StructLayout(LayoutKind.Sequential, Pack = 4)]
public readonly struct ErrorBudget
{
    /// <summary>The most iterations of a budget that names no number.</summary>
    public const int DefaultMostIterations = 64;

    private readonly int _mostIterations;

    private ErrorBudget(float length, float share, int mostIterations, TimeSpan timeLimit = default)
    {
        Length = length;
        Share = share;
        _mostIterations = mostIterations;
        TimeLimit = timeLimit;
    }

    /// <summary>No bound on the error.</summary>
    public static ErrorBudget None => default;

    /// <summary>
    /// Largest <see cref="StepReport.Error"/> of an update, a length of the scene; 0: no such bound. It bounds each update by itself;
    /// errors of many updates add up.
    /// </summary>
    public float Length { get; }

    /// <summary>
    /// Largest error as a share of the shorter side of the smaller geom in contact, or of a joint's arms; 0: no such bound.
    /// </summary>
    public float Share { get; }

    /// <summary>
    /// Most iterations of an update, at least 1; <see cref="PhysicsSimulator.Iterations"/> are done in any case. Default 64.
    /// </summary>
    public int MostIterations => _mostIterations == 0 ? DefaultMostIterations : _mostIterations;

    /// <summary>Longest time that the step of an update should take on this machine; zero, the default: no such bound.</summary>
    public TimeSpan TimeLimit { get; }

    /// <summary>True if there is a bound on the error.</summary>
    public bool IsBounded => Length > 0 || Share > 0;

    /// <summary>A bound as a length.</summary>
    /// <param name="length">Largest error, a length of the scene; finite and above 0.</param>
    /// <param name="mostIterations">Most iterations of an update; at least 1.</param>
    /// <returns>The budget.</returns>
    /// <exception cref="ArgumentOutOfRangeException">An argument is out of its range.</exception>
    public static ErrorBudget OfLength(float length, int mostIterations = DefaultMostIterations) =>
        new ErrorBudget(Require.Positive(length, nameof(length)), 0, Require.AtLeast(mostIterations, 1, nameof(mostIterations)));

    /// <summary>A bound relative to the bodies: the same for pixels, metres and kilometres.</summary>
    /// <param name="share">Largest error as a share of the shorter side of the smaller geom, or of a joint's arms, for example 0.001;
    /// finite and above 0.</param>
    /// <param name="mostIterations">Most iterations of an update; at least 1.</param>
    /// <returns>The budget.</returns>
    /// <exception cref="ArgumentOutOfRangeException">An argument is out of its range.</exception>
    public static ErrorBudget OfShare(float share, int mostIterations = DefaultMostIterations) =>
        new ErrorBudget(0, Require.Positive(share, nameof(share)), Require.AtLeast(mostIterations, 1, nameof(mostIterations)));

    /// <summary>
    /// The same budget with a bound on the time: iterations beyond <see cref="PhysicsSimulator.Iterations"/> are taken only as far as the
    /// time of the last updates says that they fit. A step that took longer all the same says so in
    /// <see cref="StepReport.IsWithinTimeLimit"/>, and an error that is missed for want of time in <see cref="StepReport.IsWithinBudget"/>.
    /// </summary>
    /// <param name="timeLimit">Longest time of a step; above zero.</param>
    /// <returns>The budget.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="timeLimit"/> is zero or negative.</exception>
    public ErrorBudget WithTimeLimit(TimeSpan timeLimit)
    {
        if (timeLimit <= TimeSpan.Zero)
        {
            throw new ArgumentOutOfRangeException(nameof(timeLimit), timeLimit, "The time must be above zero.");
        }

        return new ErrorBudget(Length, Share, _mostIterations, timeLimit);
    }
}
