using System;
using System.Collections.Generic;
using System.Diagnostics;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;

namespace Farseer.Samples;

/// <summary>A scene in a simulator of its own, stepped and measured.</summary>
internal sealed class SceneRun
{
    private const int MostTimes = 100_000;

    /// <summary>Bytes are counted in the last third: by then the stores have grown to what the scene needs.</summary>
    private readonly int _countFrom;

    /// <summary>Of the last updates, in ticks. The median is shown: the first updates also pay for compiling the code.</summary>
    private readonly long[] _times;
    private readonly int _steps;
    private readonly float _dt;
    private long _ticks;
    private long _bytes;

    public SceneRun(Scene scene, RunOptions options)
    {
        Scene = scene;
        Options = options;
        _steps = options.Steps ?? scene.Steps;
        _dt = options.Dt ?? scene.Dt;
        _countFrom = _steps - ((_steps + 2) / 3);
        _times = new long[Math.Clamp(_steps, 1, MostTimes)];
        Simulator = new PhysicsSimulator();
        if (options.Iterations is int iterations)
        {
            Simulator.Iterations = iterations;
        }

        scene.Build(Simulator);
        if (options.Iterations is int again)
        {
            // A scene file may bring its own number; the command line has the last word.
            Simulator.Iterations = again;
        }
    }

    public Scene Scene { get; }

    public RunOptions Options { get; }

    public PhysicsSimulator Simulator { get; }

    public int Done { get; private set; }

    public int Steps => _steps;

    public bool IsFinished => Done >= _steps;

    /// <summary>Time that the updates still to come will take, judged by those done.</summary>
    public TimeSpan Remaining =>
        Done == 0 ? TimeSpan.Zero : TimeSpan.FromSeconds((double)_ticks / Stopwatch.Frequency / Done * (_steps - Done));

    public void Step()
    {
        long bytes = GC.GetAllocatedBytesForCurrentThread();
        long start = Stopwatch.GetTimestamp();
        Scene.Step(Simulator, Done, _dt);
        long time = Stopwatch.GetTimestamp() - start;
        _ticks += time;
        _times[Done % _times.Length] = time;
        if (Done >= _countFrom)
        {
            _bytes += GC.GetAllocatedBytesForCurrentThread() - bytes;
        }

        Done++;
    }

    public RunResult Result()
    {
        IReadOnlyList<SceneOutcome> outcomes = Options.KeepsOutcome ? Scene.Check() : [];
        return new RunResult
        {
            Scene = Scene.Name,
            Title = Scene.Title,
            Steps = Done,
            Dt = _dt,
            Iterations = Simulator.Iterations,
            MicrosecondsPerStep = MedianTime() * 1e6 / Stopwatch.Frequency,
            Bodies = Simulator.BodyList.Count,
            Geoms = Simulator.GeomList.Count,
            Contacts = Simulator.ContactCount,
            LargestPenetration = Simulator.LargestPenetration,
            Energy = Measure.Energy(Simulator),
            BytesPerStep = Done <= _countFrom ? 0.0 : (double)_bytes / (Done - _countFrom),
            StateHash = Simulator.MotionHash(),
            Outcomes = outcomes,
        };
    }

    private long MedianTime()
    {
        Span<long> sorted = _times.AsSpan(0, Math.Min(Done, _times.Length)).ToArray();
        sorted.Sort();
        return sorted.IsEmpty ? 0 : sorted[sorted.Length / 2];
    }
}
