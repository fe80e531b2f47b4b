using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Benchmarks.Scenes;

/// <summary>
/// Times whole runs of one performance scene: build, one untimed step, then the steps on the clock; the first run is not timed at all.
/// </summary>
internal sealed class SceneTiming
{
    public const string CsvHeader =
        "scene,size,bodies,contacts,joints,workers,asset,lanes,steps,ms_step_min,ms_step_median,ms_total_median,ns_per_body_step,"
        + "bytes_per_step,state_hash,largest_penetration,largest_joint_separation,bytes_per_body,ms_step_quiet";

    private readonly PerformanceScene _scene;
    private readonly int _size;
    private readonly int _steps;
    private readonly int _workers;
    private readonly StepTimes _times;
    private readonly StepTimes _alone;

    public SceneTiming(PerformanceScene scene, int size, int steps, int workers)
    {
        _scene = scene;
        _size = size;
        _steps = steps;
        _workers = workers;
        _times = new StepTimes(TimedSteps);
        _alone = new StepTimes(TimedSteps);
    }

    public int TimedSteps => _steps - 1;

    public double LeastMilliseconds => _times.LeastRun / TimedSteps;

    /// <summary>Of a run made of the fastest of each step.</summary>
    public double BestOfSteps => _times.Quiet / TimedSteps;

    public double MedianTotal => _times.MedianRun;

    public double MedianMilliseconds => MedianTotal / TimedSteps;

    /// <summary>
    /// With several workers each run is followed by one with one worker. Ratio of the best runs; of the best of each step.
    /// </summary>
    public (double Run, double Steps) BesideOneWorker => (_times.LeastRun / _alone.LeastRun, _times.Quiet / _alone.Quiet);

    public double NanosecondsPerBodyStep => 1e6 * MedianMilliseconds / DynamicBodies;

    public int DynamicBodies { get; private set; }

    public int Contacts { get; private set; }

    public double BytesPerStep { get; private set; }

    /// <summary>
    /// All that the simulator and its items keep after the last step, a dynamic body; the world's own part does not shrink.
    /// </summary>
    public double BytesPerBody { get; private set; }

    public int Joints { get; private set; }

    /// <summary>Largest <c>JointError</c> after the last step.</summary>
    public float LargestSeparation { get; private set; }

    public ulong StateHash { get; private set; }

    public float LargestPenetration { get; private set; }

    /// <summary>Milliseconds a step by phase, from one run of its own: reading the clock within steps costs time too.</summary>
    public IReadOnlyList<(string Phase, double Milliseconds)> Phases { get; private set; } = [];

    /// <summary>
    /// Times so many runs, after one of which nothing counts: in a process's first second the compiler takes as long as the steps.
    /// </summary>
    public void Run(int runs)
    {
        Time(new StepTimes(TimedSteps), _workers);
        for (int i = 0; i < runs; i++)
        {
            Time(_times, _workers);
            if (_workers != 1)
            {
                ulong hash = StateHash;
                Time(_alone, 1);
                if (hash != StateHash)
                {
                    throw new InvalidOperationException($"{_scene.Name}: {_workers} workers end at {hash:x16}, one at {StateHash:x16}.");
                }
            }
        }

        Profile();
    }

    public string ToCsv() => string.Create(
        CultureInfo.InvariantCulture,
        $"{_scene.Name},{_size},{DynamicBodies},{Contacts},{Joints},{_workers},{Asset.Name},{Asset.Lanes},"
        + $"{_steps},{LeastMilliseconds:F4},{MedianMilliseconds:F4},{MedianTotal:F1},{NanosecondsPerBodyStep:F1},"
        + $"{BytesPerStep:F1},{StateHash:x16},{LargestPenetration:G4},{LargestSeparation:G4},{BytesPerBody:F0},{BestOfSteps:F4}");

    private PhysicsSimulator Start(int workers)
    {
        var simulator = new PhysicsSimulator { WorkerCount = workers };
        _scene.Build(simulator, _size);
        _scene.Drive(0);
        simulator.Update(_scene.Dt);
        return simulator;
    }

    private void Time(StepTimes times, int workers)
    {
        using PhysicsSimulator simulator = Start(workers);
        long bytes = GC.GetTotalAllocatedBytes(precise: true);
        for (int i = 0; i < TimedSteps; i++)
        {
            long start = Stopwatch.GetTimestamp();
            _scene.Drive(i + 1);
            simulator.Update(_scene.Dt);
            times.Add(i, Stopwatch.GetElapsedTime(start).TotalMilliseconds);
        }

        times.EndRun();
        if (workers == _workers)
        {
            BytesPerStep = (GC.GetTotalAllocatedBytes(precise: true) - bytes) / (double)TimedSteps;
        }

        DynamicBodies = 0;
        foreach (Body body in simulator.BodyList)
        {
            DynamicBodies += body.IsStatic || body.IsKinematic ? 0 : 1;
        }

        Joints = simulator.JointList.Count;
        LargestSeparation = 0f;
        foreach (Joint joint in simulator.JointList)
        {
            LargestSeparation = Math.Max(LargestSeparation, Math.Abs(joint.JointError));
        }

        Contacts = simulator.ContactCount;
        StateHash = simulator.MotionHash();
        LargestPenetration = simulator.LargestPenetration;
    }

    private void Profile()
    {
        long before = GC.GetTotalMemory(forceFullCollection: true);
        using PhysicsSimulator simulator = Start(_workers);
        simulator.EnableDiagnostics = true;
        double cleanUp = 0;
        double broadPhase = 0;
        double narrowPhase = 0;
        double forces = 0;
        double impulses = 0;
        double positions = 0;
        for (int i = 0; i < TimedSteps; i++)
        {
            _scene.Drive(i + 1);
            simulator.Update(_scene.Dt);
            cleanUp += simulator.CleanUpTime;
            broadPhase += simulator.BroadPhaseCollisionTime;
            narrowPhase += simulator.NarrowPhaseCollisionTime;
            forces += simulator.ApplyForcesTime;
            impulses += simulator.ApplyImpulsesTime;
            positions += simulator.UpdatePositionsTime;
        }

        BytesPerBody = (GC.GetTotalMemory(forceFullCollection: true) - before) / (double)Math.Max(1, DynamicBodies);
        Phases =
        [
            ("clean-up", cleanUp / TimedSteps), ("broad phase", broadPhase / TimedSteps), ("narrow phase", narrowPhase / TimedSteps),
            ("forces", forces / TimedSteps), ("impulses", impulses / TimedSteps), ("positions", positions / TimedSteps),
        ];
    }
}
