using System;

namespace FarseerGames.FarseerPhysics;

/// <summary>One setting that an <see cref="AccuracyAdvisor"/> tried. (An addition to the original.)</summary>
/// <example>
/// <code>
/// foreach (AccuracyPoint point in AccuracyAdvisor.Advise(MakeScene, seconds: 5, maximumError: 0.001f).Curve)
/// {
///     Console.WriteLine($"{point.Iterations} iterations at {1 / point.Dt} Hz: off by {point.RmsError}");
/// }
/// </code>
/// </example>
public readonly struct AccuracyPoint
{
    /// <summary>Finding pairs and contacts costs about as much as this many iterations.</summary>
    internal const int CollisionShare = 3;

    internal AccuracyPoint(int iterations, float dt, AccuracyErrors errors, double milliseconds)
    {
        Iterations = iterations;
        Dt = dt;
        ConstraintError = errors.Constraint;
        MotionError = errors.Motion;
        RmsError = errors.Rms;
        EndError = errors.End;
        MillisecondsPerSecond = milliseconds;
    }

    /// <summary>Value of <see cref="PhysicsSimulator.Iterations"/>.</summary>
    public int Iterations { get; }

    /// <summary>Seconds of an update.</summary>
    public float Dt { get; }

    /// <summary>
    /// Constraint error: the largest <see cref="StepReport.ConstraintError"/> of all updates, a length. Overlaps, open joints, slip, and
    /// impacts against their law; it says nothing of where the bodies are. Infinite if a body left the range of numbers.
    /// </summary>
    public double ConstraintError { get; }

    /// <summary>
    /// Motion error: the largest distance, at any thirtieth of a second, of a body from where the same body is in the reference run, a
    /// length. Infinite if a body left the range of numbers, or the runs have not the same bodies.
    /// </summary>
    public double MotionError { get; }

    /// <summary>The larger of <see cref="ConstraintError"/> and <see cref="MotionError"/>.</summary>
    public double PeakError => Math.Max(ConstraintError, MotionError);

    /// <summary>Root of the mean square of the constraint errors of all updates, a length.</summary>
    public double RmsError { get; }

    /// <summary>Largest constraint error in the last quarter of the run, a length.</summary>
    public double EndError { get; }

    /// <summary>Milliseconds that a second of the scene took; measured, so not the same in two runs.</summary>
    public double MillisecondsPerSecond { get; }

    /// <summary>
    /// Work for a second of the scene, in iterations, with three more an update for finding the contacts. Settings are compared by it: it
    /// is the same in every run.
    /// </summary>
    public double Work => (Iterations + CollisionShare) / (double)Dt;
}

/// <summary>What a run of an <see cref="AccuracyAdvisor"/> found.</summary>
internal struct AccuracyErrors
{
    public double Constraint;
    public double Motion;
    public double Rms;
    public double End;
}
