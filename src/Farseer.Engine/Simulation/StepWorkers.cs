using System;
using Farseer.Engine.Stepping;

namespace Farseer.Engine.Simulation;

/// <summary>Who works in a step: the calling thread, and others if they are wanted and the step is worth it.</summary>
internal sealed class StepWorkers : IDisposable
{
    // What a step takes one worker, nanoseconds: rough, since it only decides whether others are woken.
    private const double BodyCost = 60;
    private const double PairCost = 50;
    private const double RowSubstepCost = 12;
    private const double JointSubstepCost = 30;

    private StageRunner _runner = new StageRunner(1, null);
    private int _workers = 1;

    private Action<int, Action>? _scheduler;

    private bool _isDisposed;

    public StageRunner Runner => _runner;

    /// <summary>Sets how many threads share a step, from the next one on.</summary>
    /// <param name="workers">At least 1, or 0: as many as there are processors.</param>
    /// <param name="processors">How many there are: more threads of the runner's own would only stand in each other's way.</param>
    /// <param name="scheduler">See <see cref="StageRunner"/>; the host that brings one knows how many threads it has.</param>
    /// <param name="isStepping">A step is under way, and keeps those that it began with.</param>
    public void Set(int workers, int processors, Action<int, Action>? scheduler, bool isStepping)
    {
        int wanted = workers == 0 ? processors : scheduler == null ? Math.Min(workers, processors) : workers;
        _workers = Math.Min(wanted, StageRunner.MostWorkers);
        _scheduler = scheduler;
        if (!isStepping)
        {
            MakeRunner();
        }
    }

    /// <summary>Ends the threads. A step under way goes on alone, and so do later ones.</summary>
    public void Dispose()
    {
        _isDisposed = true;
        _runner.Dispose();
    }

    /// <summary>Decides who works in a step.</summary>
    public void Begin(WorldStores stores, int awake)
    {
        MakeRunner();
        int rows = stores.Graph.RowCount;
        double perSubstep = (RowSubstepCost * rows) + (JointSubstepCost * stores.Joints.Count);
        _runner.Begin((BodyCost * awake) + (PairCost * (stores.Contacts.IdleCount + rows)) + (perSubstep * stores.Settings.Substeps));
    }

    private void MakeRunner()
    {
        if (!_isDisposed && (_runner.Workers != _workers || !ReferenceEquals(_runner.Scheduler, _scheduler)))
        {
            _runner.Dispose();
            _runner = new StageRunner(_workers, _scheduler);
        }
    }
}
