namespace Farseer.Accuracy.Sweeping;

/// <summary>Which dial a point belongs to.</summary>
internal enum SweepKind
{
    /// <summary>The engine's own dial at 1/60 s, and lower settings of it at shorter outer steps.</summary>
    Dial,

    /// <summary>The default dial at other step lengths.</summary>
    StepLength,

    /// <summary>
    /// Longer outer steps with few iterations. The comparison has none of other engines, so they count in nothing but in what it takes to
    /// be as exact as another engine at its default.
    /// </summary>
    LongStep,
}

/// <summary>One setting of one engine on one scene.</summary>
/// <param name="Engine">Its name.</param>
/// <param name="Scene">Name and parameter.</param>
/// <param name="Kind">What was varied.</param>
/// <param name="Dial">Iterations or substeps.</param>
/// <param name="Dt">Step, seconds.</param>
/// <param name="Error">Main error as a share of the failure scale; 1 for a run that failed.</param>
/// <param name="Cost">Nanoseconds for a body and 1/60 s of simulated time.</param>
/// <param name="Failed">Exploded, collapsed or fell.</param>
internal sealed record SweepPoint(
    string Engine, string Scene, SweepKind Kind, int Dial, double Dt, double Error, double Cost, bool Failed)
{
    public const string Own = "Farseer";

    /// <summary>Simulated time that costs are given for.</summary>
    public const double Frame = 1.0 / 60;
}
