using System;

namespace FarseerGames.FarseerPhysics.Interfaces;

/// <summary>
/// Lets the threads of a host, for example the job system of a game, help with updates instead of threads of the simulator's own. See
/// <see cref="PhysicsSimulator.StepScheduler"/>. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// public sealed class PoolScheduler : IStepScheduler
/// {
///     public void Start(int count, Action help)
///     {
///         for (int i = 0; i &lt; count; i++)
///         {
///             ThreadPool.QueueUserWorkItem(_ =&gt; help());
///         }
///     }
/// }
/// </code>
/// </example>
public interface IStepScheduler
{
    /// <summary>
    /// Has <paramref name="help"/> called <paramref name="count"/> times, each time on another thread than the caller's, and returns
    /// without waiting for it. It is called on the thread that calls <see cref="PhysicsSimulator.Update(float)"/>, within the update
    /// and a few times at most. A call of <paramref name="help"/> returns when there is no more to do for it, at the latest when the
    /// update ends; one that comes too late returns at once. The update waits for no call that has not begun, so it is
    /// correct, if slower, to make fewer calls than were asked for. What this method throws comes out of the update when the step is
    /// complete.
    /// </summary>
    /// <param name="count">The number of calls, at least 1.</param>
    /// <param name="help">The same delegate each time while <see cref="PhysicsSimulator.WorkerCount"/> stays the same. It throws
    /// nothing.</param>
    void Start(int count, Action help);
}
