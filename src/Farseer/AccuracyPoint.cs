namespace FarseerGames.FarseerPhysics;

/// <summary>One setting that an <see cref="AccuracyAdvisor"/> tried. (An addition to the original.)</summary>
public readonly struct AccuracyPoint
{
    /// <summary>Finding pairs and contacts costs about as much as this many iterations.</summary>
    private const int CollisionShare = 3;

    internal AccuracyPoint(int iterations, float dt, double peak, double rms, double end, double milliseconds)
    {
        Iterations = iterations;
        Dt = dt;
        PeakError = peak;
        RmsError = rms;
        EndError = end;
        MillisecondsPerSecond = milliseconds;
    }

    /// <summary>Value of <see cref="PhysicsSimulator.Iterations"/>.</summary>
    public int Iterations { get; }

    /// <summary>Seconds of an update.</summary>
    public float Dt { get; }

    /// <summary>Largest <see cref="StepReport.Error"/> of the run, a length; infinite if a body left the range of numbers.</summary>
    public double PeakError { get; }

    /// <summary>Root of the mean square of the errors of all updates, a length.</summary>
    public double RmsError { get; }

    /// <summary>Largest error in the last quarter of the run, a length.</summary>
    public double EndError { get; }

    /// <summary>Milliseconds that a second of the scene took; measured, so not the same in two runs.</summary>
    public double MillisecondsPerSecond { get; }

    /// <summary>
    /// Work for a second of the scene, in iterations, with three more an update for finding the contacts. Settings are compared by it: it
    /// is the same in every run.
    /// </summary>
    public double Work => (Iterations + CollisionShare) / (double)Dt;
}
