using System;
using System.Collections.Generic;
using System.Numerics;
using System.Threading;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes;

/// <summary>
/// Physics on a thread of its own. While it computes the next update, the game draws the last one from copies. The rule is short:
/// between <see cref="PhysicsProcessor.Start"/> and <see cref="PhysicsProcessor.Wait"/> only the thread touches the simulator.
/// </summary>
public sealed class PhysicsThread : Scene
{
    private const int Base = 8;
    private readonly List<Body> _bodies = [];
    private Pose[] _drawn = [];
    private PhysicsProcessor? _processor;
    private PhysicsSimulator? _simulator;
    private double _lowest;
    private int _frames;

    public override string Name => "physics-thread";

    public override string Title => "Physics on another thread";

    public override string Description =>
        "A thread computes the next update while the game draws the last; the end is, bit for bit, that of one thread.";

    public override int Steps => 300;

    public override SceneView View => new(new Vector2(-8f, -1f), new Vector2(8f, 11f));

    public override void Build(PhysicsSimulator simulator)
    {
        _processor?.Dispose();
        _processor = null;
        _simulator = simulator;
        _frames = 0;
        _lowest = double.MaxValue;
        _bodies.Clear();
        AddWorld(simulator, _bodies);
        _drawn = new Pose[_bodies.Count];
        CopyPoses();
    }

    /// <summary>A frame of the game.</summary>
    public override void Step(PhysicsSimulator simulator, int step, float dt)
    {
        _processor ??= new PhysicsProcessor(simulator);

        // 1. The simulator is ours: read input, apply forces, add and remove.
        Push(_bodies, step);

        // 2. Let the thread compute the next update, and draw meanwhile what was copied after the last.
        _processor.Start(dt);
        Draw();

        // 3. Wait for the thread; then the simulator is ours again. What a handler threw comes out here.
        _processor.Wait();
        CopyPoses();
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        ulong threaded = _simulator!.MotionHash();
        _processor?.Dispose();
        _processor = null;

        // The same on one thread.
        PhysicsSimulator single = new();
        List<Body> bodies = [];
        AddWorld(single, bodies);
        for (int step = 0; step < Steps; step++)
        {
            Push(bodies, step);
            single.Update(Dt);
        }

        return
        [
            SceneOutcome.Exactly("frames drawn", _frames, Steps),
            SceneOutcome.Exactly(
                "bits of the state that differ from one thread", BitOperations.PopCount(threaded ^ single.MotionHash()), 0),

            // A frame drawn while the bodies move would show some at places of two updates, or inside the floor.
            SceneOutcome.AtLeast("lowest place ever drawn (m)", _lowest, 0.49),
        ];
    }

    private static void AddWorld(PhysicsSimulator simulator, List<Body> bodies)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 40f);
        for (int row = 0; row < Base; row++)
        {
            for (int i = 0; i < Base - row; i++)
            {
                Geom box = Make.Box(simulator, new Vector2(1.1f * (i - (0.5f * (Base - row - 1))), row + 0.6f), 1f, 1f);
                bodies.Add(box.Body);
            }
        }
    }

    /// <summary>The player shoves the top box.</summary>
    private static void Push(List<Body> bodies, int step)
    {
        if (step is >= 100 and < 160)
        {
            bodies[^1].ApplyForce(new Vector2(8f, 0f));
        }
    }

    private void Draw()
    {
        foreach (Pose pose in _drawn)
        {
            _lowest = Math.Min(_lowest, pose.Position.Y);
        }

        _frames++;
    }

    private void CopyPoses()
    {
        for (int i = 0; i < _bodies.Count; i++)
        {
            _drawn[i] = new Pose(_bodies[i].Position, _bodies[i].Rotation);
        }
    }

    private readonly record struct Pose(Vector2 Position, float Rotation);
}

/// <summary>A thread that updates a simulator when it is told to.</summary>
public sealed class PhysicsProcessor : IDisposable
{
    private readonly PhysicsSimulator _simulator;
    private readonly Thread _thread;
    private readonly SemaphoreSlim _start = new(0);
    private readonly SemaphoreSlim _done = new(0);
    private float _dt;
    private bool _ends;
    private Exception? _fault;

    public PhysicsProcessor(PhysicsSimulator simulator)
    {
        _simulator = simulator;

        // A background thread does not keep the program alive.
        _thread = new Thread(Run) { IsBackground = true, Name = "physics" };
        _thread.Start();
    }

    /// <summary>Begins an update. From here to the end of <see cref="Wait"/> the simulator belongs to the thread.</summary>
    public void Start(float dt)
    {
        _dt = dt;
        _start.Release();
    }

    /// <summary>Waits for the update to end, and throws what a handler in it threw.</summary>
    public void Wait()
    {
        _done.Wait();
        if (_fault is not null)
        {
            throw new InvalidOperationException("A handler failed on the physics thread.", _fault);
        }
    }

    public void Dispose()
    {
        _ends = true;
        _start.Release();
        _thread.Join();
        _start.Dispose();
        _done.Dispose();
    }

    // The semaphores also order the reads and writes of both threads: what was written before a Release is seen after the Wait.
    private void Run()
    {
        while (true)
        {
            _start.Wait();
            if (_ends)
            {
                return;
            }

            try
            {
                _simulator.Update(_dt);
            }
            catch (Exception e)
            {
                _fault = e;
            }

            _done.Release();
        }
    }
}
