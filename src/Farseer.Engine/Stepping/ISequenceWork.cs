namespace Farseer.Engine.Stepping;

/// <summary>Phases in a row, each as of <see cref="IStageWork"/>: no range of one begins before all of the one before is done.</summary>
internal interface ISequenceWork
{
    /// <param name="worker">From 0, below <see cref="StageRunner.Workers"/>; two calls at a time never share it.</param>
    /// <param name="stage">Which phase of the row.</param>
    /// <param name="from">First item of it.</param>
    /// <param name="to">One past the last.</param>
    void Run(int worker, int stage, int from, int to);
}
