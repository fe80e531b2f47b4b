namespace Farseer.Engine.Stepping;

/// <summary>
/// A phase that can be cut into ranges which are done in any order, on any thread, and leave the same bits: no range writes what
/// another one reads or writes. A long-lived object holds what the phase needs, so that handing it out allocates nothing.
/// </summary>
internal interface IStageWork
{
    /// <param name="worker">From 0, below <see cref="StageRunner.Workers"/>; two calls at a time never share it, so it may index a
    /// scratch.</param>
    /// <param name="from">First item.</param>
    /// <param name="to">One past the last.</param>
    void Run(int worker, int from, int to);
}
