using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// Many worlds of one recipe, stepped side by side: for learning, searching and sweeping. Each worker has one world at a time, actions come
/// in and observations go out as rows of numbers, and a world begins anew from its first state without being built again. (An addition to
/// the original.)
/// </summary>
/// <remarks>
/// <para>A world sees nothing of the others, so the same actions give the same bits whatever the number of workers and whoever comes first.
/// Once warm, neither steps nor resets allocate.</para>
/// <para>Worlds in turn find the caches full of each other. With several updates a step a world stays in the cache for all of them.</para>
/// <para>A batch is to be used by one thread at a time. Disposing it ends its threads; the simulators stay as they are.</para>
/// </remarks>
/// <example>
/// <code>
/// using var batch = new WorldBatch(64, actionSize: 1, observationSize: 2, index =&gt; new PushedBox());
/// var actions = new float[64 * batch.ActionSize];
/// var observations = new float[64 * batch.ObservationSize];
/// for (int step = 0; step &lt; 100; step++)
/// {
///     batch.Step(1f / 60, actions, observations);
/// }
///
/// batch.ResetAll();
/// </code>
/// </example>
public sealed unsafe class WorldBatch : IBatchWork, IDisposable
{
    private readonly BatchedWorld[] _worlds;
    private readonly PhysicsSimulatorState[] _states;
    private readonly BatchCrew _crew;
    private readonly object _gate = new object();

    // Of the call that runs; spans cannot be handed to other threads.
    private float* _actions;
    private float* _observations;
    private bool* _chosen;
    private Part _part;
    private float _dt;
    private int _updates;
    private bool _runs;
    private bool _isDisposed;
    private int _failed;
    private ExceptionDispatchInfo? _failure;

    private enum Part
    {
        Step,
        Reset,
    }

    /// <summary>
    /// Makes the worlds, one after the other, and captures the state that each begins with. All processors take part in steps.
    /// </summary>
    /// <param name="count">The number of worlds, 1 or more.</param>
    /// <param name="actionSize">Numbers of the action of one world, 0 or more.</param>
    /// <param name="observationSize">Numbers that are seen of one world, 0 or more.</param>
    /// <param name="make">Makes the world of an index, from 0 on. Each has a simulator of its own.</param>
    /// <exception cref="ArgumentNullException"><paramref name="make"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is too small.</exception>
    /// <exception cref="ArgumentException"><paramref name="make"/> returned null, or two worlds with one simulator.</exception>
    /// <exception cref="InvalidOperationException">A state cannot be captured: see
    /// <see cref="PhysicsSimulator.Capture(PhysicsSimulatorState)"/>.</exception>
    public WorldBatch(int count, int actionSize, int observationSize, Func<int, BatchedWorld> make)
        : this(count, actionSize, observationSize, make, Environment.ProcessorCount)
    {
    }

    /// <summary>Makes the worlds, one after the other, and captures the state that each begins with.</summary>
    /// <param name="count">The number of worlds, 1 or more.</param>
    /// <param name="actionSize">Numbers of the action of one world, 0 or more.</param>
    /// <param name="observationSize">Numbers that are seen of one world, 0 or more.</param>
    /// <param name="make">Makes the world of an index, from 0 on. Each has a simulator of its own.</param>
    /// <param name="workers">Threads that step worlds, the calling one with them, 1 or more; no bit depends on it.</param>
    /// <exception cref="ArgumentNullException"><paramref name="make"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is too small.</exception>
    /// <exception cref="ArgumentException"><paramref name="make"/> returned null, or two worlds with one simulator.</exception>
    /// <exception cref="InvalidOperationException">A state cannot be captured: see
    /// <see cref="PhysicsSimulator.Capture(PhysicsSimulatorState)"/>.</exception>
    public WorldBatch(int count, int actionSize, int observationSize, Func<int, BatchedWorld> make, int workers)
    {
        _worlds = new BatchedWorld[Require.AtLeast(count, 1, nameof(count))];
        ActionSize = Require.AtLeast(actionSize, 0, nameof(actionSize));
        ObservationSize = Require.AtLeast(observationSize, 0, nameof(observationSize));
        Require.NotNull(make, nameof(make));
        Workers = Math.Min(Require.AtLeast(workers, 1, nameof(workers)), count);
        _states = new PhysicsSimulatorState[count];
        var simulators = new HashSet<PhysicsSimulator>();
        for (int i = 0; i < count; i++)
        {
            _worlds[i] = make(i) ?? throw new ArgumentException($"It returned null for world {i}.", nameof(make));
            if (!simulators.Add(_worlds[i].Simulator))
            {
                throw new ArgumentException($"It gave world {i} the simulator of another one.", nameof(make));
            }

            // What was added is in it from now on, and need not be taken in after each reset.
            _worlds[i].Simulator.Update(0);
            _states[i] = _worlds[i].Simulator.Capture();
        }

        _crew = new BatchCrew(Workers);
    }

    /// <summary>Ends the threads of a batch that was dropped.</summary>
    ~WorldBatch() => _crew?.Stop();

    /// <summary>The number of worlds, at least 1.</summary>
    public int Count => _worlds.Length;

    /// <summary>Numbers of the action of one world.</summary>
    public int ActionSize { get; }

    /// <summary>Numbers that are seen of one world.</summary>
    public int ObservationSize { get; }

    /// <summary>Threads that step worlds, the calling one with them; at most <see cref="Count"/>.</summary>
    public int Workers { get; }

    /// <summary>One of the worlds.</summary>
    /// <param name="index">From 0, below <see cref="Count"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="index"/> is not one of a world.</exception>
    public BatchedWorld this[int index] => _worlds[Require.Within(index, 0, _worlds.Length - 1, nameof(index))];

    /// <summary>Lets each world act, updates it, and observes it.</summary>
    /// <param name="dt">Seconds of each update; finite and above 0.</param>
    /// <param name="actions">The actions of all worlds, one behind the other: <see cref="Count"/> times <see cref="ActionSize"/>
    /// numbers.</param>
    /// <param name="observations">Where to write what is seen of all: <see cref="Count"/> times <see cref="ObservationSize"/>
    /// numbers.</param>
    /// <param name="updates">Updates with the same action, 1 or more. Default 1.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> or <paramref name="updates"/> is out of range.</exception>
    /// <exception cref="ArgumentException">A span has another length.</exception>
    /// <exception cref="InvalidOperationException">A call runs already: worlds must not call their batch.</exception>
    /// <exception cref="ObjectDisposedException">The batch is disposed.</exception>
    /// <remarks>
    /// If a world throws, the others are stepped all the same, and what the one of the lowest index threw is thrown here.
    /// </remarks>
    public void Step(float dt, ReadOnlySpan<float> actions, Span<float> observations, int updates = 1)
    {
        Require.Positive(dt, nameof(dt));
        Require.AtLeast(updates, 1, nameof(updates));
        RequireLength(actions.Length, ActionSize, nameof(actions));
        RequireLength(observations.Length, ObservationSize, nameof(observations));
        Enter();
        _dt = dt;
        _updates = updates;
        fixed (float* first = actions, seen = observations)
        {
            _actions = first;
            _observations = seen;
            Run(Part.Step);
        }
    }

    /// <summary>Observes all worlds as they are.</summary>
    /// <param name="observations">Where to write what is seen: <see cref="Count"/> times <see cref="ObservationSize"/> numbers.</param>
    /// <exception cref="ArgumentException">The span has another length.</exception>
    /// <exception cref="InvalidOperationException">A call runs already: worlds must not call their batch.</exception>
    /// <exception cref="ObjectDisposedException">The batch is disposed.</exception>
    public void Observe(Span<float> observations)
    {
        RequireLength(observations.Length, ObservationSize, nameof(observations));
        Enter();
        fixed (float* seen = observations)
        {
            _observations = seen;
            _updates = 0;
            Run(Part.Step);
        }
    }

    /// <summary>Takes a world back to the state that it had when the batch was made.</summary>
    /// <param name="index">From 0, below <see cref="Count"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="index"/> is not one of a world.</exception>
    /// <exception cref="InvalidOperationException">A call runs already: worlds must not call their batch.</exception>
    /// <exception cref="ObjectDisposedException">The batch is disposed.</exception>
    public void Reset(int index)
    {
        Require.Within(index, 0, _worlds.Length - 1, nameof(index));
        Enter();
        try
        {
            Restore(index);
        }
        finally
        {
            _runs = false;
        }
    }

    /// <summary>Takes some worlds back to the state that they had when the batch was made.</summary>
    /// <param name="which">True for those that go back; <see cref="Count"/> of them.</param>
    /// <exception cref="ArgumentException">The span has another length.</exception>
    /// <exception cref="InvalidOperationException">A call runs already: worlds must not call their batch.</exception>
    /// <exception cref="ObjectDisposedException">The batch is disposed.</exception>
    public void Reset(ReadOnlySpan<bool> which)
    {
        RequireLength(which.Length, 1, nameof(which));
        Enter();
        fixed (bool* chosen = which)
        {
            _chosen = chosen;
            Run(Part.Reset);
        }
    }

    /// <summary>Takes all worlds back to the state that they had when the batch was made.</summary>
    /// <exception cref="InvalidOperationException">A call runs already: worlds must not call their batch.</exception>
    /// <exception cref="ObjectDisposedException">The batch is disposed.</exception>
    public void ResetAll()
    {
        Enter();
        Run(Part.Reset);
    }

    /// <summary>Ends the threads. The simulators are not disposed. A second call does nothing.</summary>
    public void Dispose()
    {
        if (_runs)
        {
            throw new InvalidOperationException("A call of the batch runs: worlds must not call it.");
        }

        if (!_isDisposed)
        {
            _isDisposed = true;
            _crew.Stop();
            GC.SuppressFinalize(this);
        }
    }

    void IBatchWork.Run(int index)
    {
        try
        {
            if (_part == Part.Reset)
            {
                if (_chosen == null || _chosen[index])
                {
                    Restore(index);
                }

                return;
            }

            BatchedWorld world = _worlds[index];
            for (int i = 0; i < _updates; i++)
            {
                world.Act(new ReadOnlySpan<float>(_actions + ((long)index * ActionSize), ActionSize));
                world.Simulator.Update(_dt);
            }

            world.Observe(new Span<float>(_observations + ((long)index * ObservationSize), ObservationSize));
        }
        catch (Exception exception)
        {
            Note(index, exception);
        }
    }

    // Of several the lowest, so that it does not depend on who was first.
    private void Note(int index, Exception exception)
    {
        lock (_gate)
        {
            if (_failure == null || index < _failed)
            {
                _failed = index;
                _failure = ExceptionDispatchInfo.Capture(exception);
            }
        }
    }

    private void Restore(int index)
    {
        _worlds[index].Simulator.Restore(_states[index]);
        _worlds[index].OnReset();
    }

    private void Enter()
    {
        if (_isDisposed)
        {
            throw new ObjectDisposedException(nameof(WorldBatch));
        }

        if (_runs)
        {
            throw new InvalidOperationException("A call of the batch runs already: worlds must not call it.");
        }

        _runs = true;
    }

    private void Run(Part part)
    {
        _part = part;
        _crew.Run(this, _worlds.Length);
        _actions = null;
        _observations = null;
        _chosen = null;
        _runs = false;
        ExceptionDispatchInfo? failure = _failure;
        _failure = null;
        failure?.Throw();
    }

    private void RequireLength(int length, int size, string name)
    {
        if (length != (long)Count * size)
        {
            throw new ArgumentException($"{length} numbers are given for {Count} worlds of {size}.", name);
        }
    }
}
