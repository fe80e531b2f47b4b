namespace FarseerGames.FarseerPhysics;

/// <summary>
/// What the largest error of an update is an error of; see <see cref="StepReport.Cause"/>. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// simulator.EnableReport = true;
/// simulator.Update(1f / 60);
/// if (simulator.Report.Cause == ErrorCause.Separation)
/// {
///     Console.WriteLine("A joint is open by " + simulator.Report.LargestSeparation);
/// }
/// </code>
/// </example>
public enum ErrorCause
{
    /// <summary>There was no error.</summary>
    None,

    /// <summary>Two geoms that push each other apart lie in each other: <see cref="StepReport.LargestPenetration"/>.</summary>
    Overlap,

    /// <summary>A rigid joint is apart, or a limit is overrun: <see cref="StepReport.LargestSeparation"/>.</summary>
    Separation,

    /// <summary>A contact that friction holds went along its tangent: <see cref="StepReport.LargestSlip"/>.</summary>
    Slip,

    /// <summary>Impacts left another energy than their law: <see cref="StepReport.LargestImpactError"/>.</summary>
    Impact,

    /// <summary>Impulses between bodies that nothing holds do not cancel: <see cref="StepReport.MomentumError"/>.</summary>
    Momentum,

    /// <summary>A body went another way than it would with more iterations: <see cref="StepReport.MotionError"/>.</summary>
    Motion,

    /// <summary>
    /// A body's numbers left their range and it was disabled: <see cref="PhysicsSimulator.BodyQuarantined"/>. The error is infinite.
    /// </summary>
    Lost,
}
