using System;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Interfaces;

namespace FarseerGames.FarseerPhysics;

/// <content>The threads that share an update. (Additions to the original.)</content>
public partial class PhysicsSimulator
{
    [NotState(Why.Running)]
    private int _workerCount = 1;
    [NotState(Why.Running)]
    private IStepScheduler? _stepScheduler;

    /// <summary>
    /// The number of threads that share the work of an update, the calling one included; at least 0. 0 means as many as there are
    /// processors. The motion is the same, bit for bit, whatever the number. Handlers, controllers and all other code of yours run on the
    /// calling thread alone. Only updates that take more than some tenths of a millisecond wake the other threads, which sleep between
    /// updates and end with the simulator. There are never more of them than processors. Default 1: no other threads. Set within a handler
    /// it takes effect with the next update. Where many simulators are updated at once, one worker each is best. (An addition to the
    /// original.)
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative.</exception>
    public int WorkerCount
    {
        get => _workerCount;
        set
        {
            _workerCount = Require.AtLeast(value, 0, nameof(WorkerCount));
            SetWorkers();
        }
    }

    /// <summary>
    /// The scheduler whose threads help if <see cref="WorkerCount"/> is not 1. Null, the default, uses threads of the simulator's own. With
    /// a scheduler <see cref="WorkerCount"/> may exceed the number of processors. (An addition to the original.)
    /// </summary>
    public IStepScheduler? StepScheduler
    {
        get => _stepScheduler;
        set
        {
            _stepScheduler = value;
            SetWorkers();
        }
    }

    private void SetWorkers() =>
        World.SetWorkers(_workerCount, Environment.ProcessorCount, _stepScheduler is null ? null : _stepScheduler.Start);
}
