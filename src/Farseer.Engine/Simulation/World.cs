using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Queries;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>One simulation: its stores, and the phases of a step. The facades create it, fill it and step it.</summary>
internal sealed partial class World : IDisposable
{
    private readonly WorldStores _stores = new WorldStores();
    private readonly ContactEvents _events;
    private readonly ContactStage _contactStage = new ContactStage();
    private readonly BoxStage _boxes;
    private readonly SweepStage _sweeps;
    private readonly ContactRoom _room;
    private readonly Removals _removals;
    private readonly LightenedBodies _lightened = new LightenedBodies();

    /// <exception cref="PlatformNotSupportedException">The runtime was told to make vectors longer than a stored bundle.</exception>
    public World()
    {
        WideLanes.RequireFit();
        _events = new ContactEvents(_stores);
        Surfaces = new SurfaceStage(_stores);
        _boxes = new BoxStage(_stores);
        Accuracy = new AccuracyStage(_stores);
        Pushes = new PushReport(_stores);
        Sleep = new SleepStage(_stores, _events, _contactStage);
        _removals = new Removals(_stores, Sleep);
        Pairs = new PairFinder(_stores, Sleep, _removals, Surfaces);
        BodyStage = new BodyStage(_stores, _removals);
        Solver = new SolveStage(_stores, BodyStage, Sleep, _contactStage, Accuracy, Pushes);
        _sweeps = new SweepStage(_stores, _boxes, Pairs, _contactStage, _events, Pushes, Accuracy);
        _room = new ContactRoom(_stores, Sleep, _contactStage, Pairs, _sweeps, Solver);
        Reader = new ContactReader(_stores, _removals, _contactStage, Pushes);

        // Body 0 is the dummy that empty lanes point at; it never moves and has no mass.
        Bodies.Ids.Take();
        _stores.EnsureBodies(1);
        _stores.Graph.Weigh(Bodies);
        Bodies.State[0] = new BodyState { DeltaCos = 1 };
        Bodies.Pose[0] = new BodyPose { Cos = 1 };
        Bodies.Drive[0].Keep(1, 1);
        Bodies.Flags[0] = BodyFlags.Static;
    }

    public WorldSettings Settings => _stores.Settings;

    public StepProfile Profile => _stores.Profile;

    public ShapeStore Shapes => _stores.Shapes;

    public BodyStore Bodies => _stores.Bodies;

    public ColliderLists Colliders => _stores.Colliders;

    public ContactStore Contacts => _stores.Contacts;

    public JointStore Joints => _stores.Joints;

    /// <summary>Rays, boxes, shapes and points against all colliders, at any time.</summary>
    public WorldQueries Queries => _stores.Queries;

    /// <summary>What a step reports of itself.</summary>
    public AccuracyStage Accuracy { get; }

    /// <summary>Who pushed whom in a step.</summary>
    public PushReport Pushes { get; }

    /// <summary>Which bodies sleep.</summary>
    public SleepStage Sleep { get; }

    /// <summary>Which pieces are near each other.</summary>
    public PairFinder Pairs { get; }

    /// <summary>What touches.</summary>
    public ContactReader Reader { get; }

    /// <summary>Islands, and the substeps that solve their rows, joints and springs.</summary>
    public SolveStage Solver { get; }

    /// <summary>What the surfaces of pairs are, where it is not what their colliders say.</summary>
    public SurfaceStage Surfaces { get; }

    /// <summary>Which bodies take part in a step, and which it took out.</summary>
    public BodyStage BodyStage { get; }

    public IStepHooks? Hooks
    {
        get => _stores.Hooks;
        set => _stores.Hooks = value;
    }

    /// <summary>Who hears of broken joints and solves those that a user wrote.</summary>
    public IUserJoints? UserJoints
    {
        get => _stores.UserJoints;
        set => _stores.UserJoints = value;
    }

    /// <summary>Swappable between steps: pairs already found are kept, and the new one starts with all proxies.</summary>
    public IBroadPhase BroadPhase => _stores.BroadPhase;

    /// <summary>Substeps of the last step.</summary>
    public int Substeps => _stores.Substeps;

    /// <summary>Islands told apart in the last step; 0: nothing asked for them.</summary>
    public int IslandCount => _stores.Islands.Count;

    /// <summary>True while a step runs: removals then wait for the next one.</summary>
    public bool IsStepping => _stores.IsStepping;

    /// <param name="broadPhase">The new one.</param>
    /// <param name="always">True: it is asked in every step, also if no box has changed.</param>
    public void SetBroadPhase(IBroadPhase broadPhase, bool always = false)
    {
        ProxyStore proxies = _stores.Proxies;
        Pairs.AlwaysCollects = always;
        _stores.BroadPhase = broadPhase;
        for (int i = 0; i < proxies.End; i++)
        {
            if ((proxies.Info[i].Flags & ProxyFlags.Alive) != 0)
            {
                broadPhase.Added(proxies, i);
            }
        }
    }

    /// <summary>See <see cref="StepWorkers.Set"/>.</summary>
    public void SetWorkers(int workers, int processors, Action<int, Action>? scheduler) =>
        _stores.Workers.Set(workers, processors, scheduler, IsStepping);

    /// <summary>Ends the threads. A step under way goes on alone, and so do later ones.</summary>
    public void Dispose() => _stores.Workers.Dispose();

    /// <summary>
    /// Advances by <paramref name="dt"/> seconds, above 0 and finite. What the step forgets at its end lies in memory that worlds stepped
    /// by one thread share: it is in the cache already, and thousands of small worlds have none of their own.
    /// </summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="shared">
    /// The first of the thread's pieces of memory; null: there is none yet, or all are in use by worlds that step each other.
    /// </param>
    public void Step(float dt, ref Scratch? shared)
    {
        ProxyStore proxies = _stores.Proxies;
        if (IsStepping || proxies.HasScratch)
        {
            Step(dt);
            return;
        }

        Scratch lent = shared ?? new Scratch();
        int before = lent.Capacity;
        shared = lent.Next;
        proxies.Lend(lent);
        try
        {
            Step(dt);
        }
        finally
        {
            (lent.Tools as StepTools)?.Forget();

            // If the world keeps it, the thread's other worlds are to find as much as they had.
            Scratch back = proxies.GiveBack() ?? Scratch.Of(before);
            back.Next = shared;
            shared = back;
        }
    }

    /// <summary>Advances by <paramref name="dt"/> seconds, above 0 and finite.</summary>
    public void Step(float dt)
    {
        if (!(dt > 0) || float.IsInfinity(dt))
        {
            throw new ArgumentOutOfRangeException(nameof(dt), dt, "A step must be a finite time above 0.");
        }

        if (IsStepping)
        {
            throw new InvalidOperationException("The world is already in a step: a callback must not start another.");
        }

        _stores.IsStepping = true;
        bool isWhole = false;
        try
        {
            _stores.TakeTools();
            _stores.Workers.Begin(_stores, Bodies.Ids.End - Sleep.AsleepCount);
            RunPhases(dt);
            isWhole = true;
        }
        finally
        {
            _stores.Runner.End();
            _stores.Lists.Fast.End();
            _stores.LeaveTools(isWhole);
            _stores.Scratch.Release(0);
            if (_stores.TrimIsDue)
            {
                _stores.Trim();
            }

            _stores.IsStepping = false;
            Queries.Version++;
        }

        MemoryGuard.Verify();
        _stores.Runner.ThrowSchedulerError();
    }

    /// <summary>The table of contents of a step: one line a phase.</summary>
    private void RunPhases(float dt)
    {
        Profile.Begin();
        TakeChanges(dt);
        FindPairs(dt);
        UpdateContacts(dt);
        Solver.BeginIslands(dt);
        Profile.End(StepStage.GraphAndIslands);
        ApplyForces(dt);
        Solve(dt);
        EndMotion();
        SweepFastBodies(dt);
        Report(dt);
        FallAsleep(dt);
    }

    private void TakeChanges(float dt)
    {
        _removals.PurgeNow();
        Accuracy.Begin();
        Pushes.Begin();
        Sleep.WakeWhatChanged(dt);
        BodyStage.Collect();
        Sleep.WakeByDriven();
        _stores.Lists.Foresee(_stores.Runner, Bodies, dt);
        Profile.End(StepStage.DeferredChanges);
    }

    private void FindPairs(float dt)
    {
        Pairs.ForgetMoves();
        _boxes.Update(Pairs, _stores.Runner, dt);
        Pairs.Find();
        Surfaces.RefreshAll();
        Profile.End(StepStage.BroadPhase);
    }

    private void UpdateContacts(float dt)
    {
        Solver.SortRows();
        _lightened.ScaleImpulses(_stores.Graph, Bodies.Ids.End);
        _stores.Runner.Call();
        _contactStage.Update(
            _stores.Runner, _stores.Tools, Sleep, Solver.BeginContacts(dt), _stores.Graph, Joints, _stores.AnyUserJoints);
        _events.Raise(_stores.Contacts, _stores.Graph, _contactStage.AnyHeard);
        _room.MakeAhead();
        Pushes.MakeRoom();
        Profile.End(StepStage.NarrowPhase);
    }

    private void ApplyForces(float dt)
    {
        _stores.Springs.Clear();
        Hooks?.ApplyForces(dt);
        Solver.UpdateAfterCallbacks(dt);
        if (_contactStage.AnyHeard)
        {
            BodyStage.CollectStatics();
        }

        Profile.End(StepStage.Forces);
    }

    private unsafe void Solve(float dt)
    {
        if (_stores.MakesEnergy)
        {
            _stores.Tools.BounceBound.Begin(Bodies, _stores.Lists.Moves);
        }

        _stores.Graph.RecallShared(_stores.Contacts.Records);
        Solver.Solve(dt);
        _contactStage.Lone.PutBack(_stores.Contacts, _stores.Graph);
        Profile.End(StepStage.Solve);
    }

    private void EndMotion()
    {
        BodyStage.Finish();
        _stores.LastSubstep = Solver.Substep;
        Profile.End(StepStage.Finish);
    }

    private unsafe void SweepFastBodies(float dt)
    {
        _sweeps.Begin();
        if (_contactStage.Lone.Count > 0)
        {
            _sweeps.FlyLonePairs(dt, Solver.Substep);
            Profile.End(StepStage.Continuous);
        }

        if (Settings.Continuous && _stores.Lists.Fast.Count > 0)
        {
            _sweeps.Sweep(dt, Solver.Substep);
        }

        if (_stores.MakesEnergy)
        {
            _stores.Tools.BounceBound.End(Bodies, _stores.Lists.Moves, Settings.Gravity, dt, _stores.DrivenBoundOf(dt));
        }

        Profile.End(StepStage.Continuous);
    }

    private void Report(float dt)
    {
        BodyStage.StopSwitched();
        Accuracy.End(dt);
        Pushes.Raise(Solver.Substep);
        Profile.End(StepStage.Finish);
    }

    private void FallAsleep(float dt)
    {
        Sleep.FallAsleep(dt);
        _stores.Lists.UseUpForces(_stores.Runner, Bodies);
        Profile.End(StepStage.Sleep);
    }

    /// <summary>
    /// Writes the state, or sets it to what was written of this world. Who hears of its steps, and what is only memory of one
    /// step, is no part of it.
    /// </summary>
    /// <exception cref="InvalidOperationException">A step runs.</exception>
    public void Visit(StateStream s)
    {
        if (IsStepping)
        {
            throw new InvalidOperationException("The world is in a step: its state can be saved and restored only between steps.");
        }

        _stores.Visit(s);
        _lightened.Visit(s.Of(nameof(_lightened)));
        _contactStage.Visit(s.Of(nameof(_contactStage)));
        _events.Visit(s.Of(nameof(_events)));
        _boxes.Visit(s.Of(nameof(_boxes)));
        _removals.Visit(s);
        Pairs.Visit(s);
        BodyStage.Visit(s);
        Solver.Visit(s);
        _sweeps.Visit(s);
        _room.Visit(s);
        Sleep.Visit(s);
        Accuracy.Visit(s);
        Pushes.Visit(s);
        s.Of(nameof(World)).Value(ref _colliderOrder);
    }
}
