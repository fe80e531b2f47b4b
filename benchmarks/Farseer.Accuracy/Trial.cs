using System;
using System.Collections.Generic;
using System.Diagnostics;
using FarseerGames.FarseerPhysics;

namespace Farseer.Accuracy;

/// <summary>The settings of a run.</summary>
/// <param name="Iterations">The accuracy dial of the simulator.</param>
/// <param name="Dt">Step length asked for, seconds.</param>
internal readonly record struct Dial(int Iterations, double Dt)
{
    /// <summary>What else is set before the world is filled; null: nothing.</summary>
    public Action<PhysicsSimulator>? Tune { get; init; }
}

/// <summary>A coordinate is not finite or beyond 3·10⁷, or the engine has put a body out of action.</summary>
internal sealed class ExplodedException : Exception
{
}

/// <summary>One run of one scene: makes its worlds, collects its metrics and its cost.</summary>
internal sealed class Trial
{
    private readonly List<(string Name, double Value)> _metrics = [];
    private readonly List<long> _stepTicks = [];
    private double _bodySteps;

    public Trial(double parameter, Dial dial)
    {
        Parameter = parameter;
        Dial = dial;
    }

    public double Parameter { get; }

    public Dial Dial { get; }

    public IReadOnlyList<(string Name, double Value)> Metrics => _metrics;

    public double NanosecondsPerBodyStep
    {
        get
        {
            long ticks = 0;
            foreach (long step in _stepTicks)
            {
                ticks += step;
            }

            return _bodySteps == 0 ? 0 : 1e9 * ticks / Stopwatch.Frequency / _bodySteps;
        }
    }

    /// <summary>
    /// Takes over what another run of the same scene needed less time for, step by step: the runs repeat bit for bit, and what else runs
    /// on the machine can only add to a time.
    /// </summary>
    public void TakeQuickerSteps(Trial other)
    {
        for (int i = 0; i < _stepTicks.Count; i++)
        {
            _stepTicks[i] = Math.Min(_stepTicks[i], other._stepTicks[i]);
        }
    }

    public void Record(string metric, double value) => _metrics.Add((metric, value));

    /// <summary>Builds and plays a world and books its cost.</summary>
    /// <param name="play">Fills the world and runs it.</param>
    /// <param name="gravity">Acceleration downwards.</param>
    public void World(Action<Rig> play, double gravity = 10)
    {
        using var rig = new Rig(Dial, gravity);
        try
        {
            play(rig);
        }
        finally
        {
            _stepTicks.AddRange(rig.StepTicks);
            _bodySteps += rig.BodySteps;
        }
    }

    /// <summary>Plays a world with another dial, to compare with; its cost is not the scene's.</summary>
    public static void Reference(Dial dial, Action<Rig> play, double gravity = 10)
    {
        using var rig = new Rig(dial, gravity);
        play(rig);
    }
}
