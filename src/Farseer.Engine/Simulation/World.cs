using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Continuous;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Queries;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Solver;
using Farseer.Engine.Springs;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Owns the stores of one simulation. The facades create it, fill it and step it.</summary>
internal sealed partial class World
{
    private readonly ContactStore _contacts;
    private readonly ConstraintGraph _graph = new ConstraintGraph();
    private readonly LightenedBodies _lightened = new LightenedBodies();
    private readonly BounceBound _bounceBound = new BounceBound();
    private bool _makesEnergy;
    private readonly IslandStore _islands = new IslandStore();
    private readonly FeedForwardSettings _feedForward = new FeedForwardSettings();
    private readonly SagForecast _sagForecast = new SagForecast();
    private readonly SubstepSolver _solver = new SubstepSolver();
    private readonly ContactStage _contactStage = new ContactStage();
    private readonly ContactEvents _events = new ContactEvents();
    private readonly BoxStage _boxes = new BoxStage();
    private readonly BodyLists _lists = new BodyLists();
    private readonly SpringStore _springs = new SpringStore();

    /// <summary>
    /// Bodies were enabled, disabled, made static or kinematic, or no longer so, since the bodies were sorted; and such a thing happened
    /// within the step.
    /// </summary>
    private bool _bodiesSwitched;
    private bool _switchedWithin;
    private float _lastSubstep;

    /// <summary>
    /// The substep at whose rate depths are taken back: the longest of late. The sag under a load goes by the square of the substep; a short one after a
    /// long one would close it at a speed larger by their ratio. It stays for as long as such a sag takes to go, and then comes down as fast.
    /// </summary>
    private float _recovery;

    /// <summary>Seconds since a substep was as long.</summary>
    private float _recoveryAge;

    /// <exception cref="PlatformNotSupportedException">The runtime was told to make vectors longer than a stored bundle.</exception>
    public World()
    {
        WideLanes.RequireFit();
        _contacts = new ContactStore(Shapes);
        Queries = new WorldQueries(Shapes, Bodies);
        _pairFlight = new PairFlight(_sweep, _secondSweep);

        // Body 0 is the dummy that empty lanes point at; it never moves and has no mass.
        Bodies.Ids.Take();
        EnsureBodies(1);
        _graph.Weigh(Bodies);
        Bodies.State[0] = new BodyState { DeltaCos = 1 };
        Bodies.Pose[0] = new BodyPose { Cos = 1 };
        Bodies.Drive[0].Keep(1, 1);
        Bodies.Flags[0] = BodyFlags.Static;
    }

    public WorldSettings Settings { get; } = new WorldSettings();

    public StepProfile Profile { get; } = new StepProfile();

    public ShapeStore Shapes { get; } = new ShapeStore();

    public BodyStore Bodies { get; } = new BodyStore();

    public ProxyStore Proxies { get; } = new ProxyStore();

    /// <summary>Memory of the phases of a step, which all that is taken is given back to at its end.</summary>
    private Scratch Scratch => Proxies.Scratch;

    [NotState(Why.Fixed)]
    public IStepHooks? Hooks { get; set; }

    /// <summary>Swappable between steps: pairs already found are kept, and the new one starts with all proxies.</summary>
    public IBroadPhase BroadPhase { get; private set; } = new LevelGrid();

    /// <summary>True while a step runs: removals then wait for the next one.</summary>
    [NotState(Why.Calm)]
    public bool IsStepping { get; private set; }

    /// <summary>Substeps of the last step.</summary>
    public int Substeps => _substeps;

    /// <summary>Islands told apart in the last step; 0: nothing asked for them.</summary>
    public int IslandCount => _islands.Count;

    /// <summary>Pairs of pieces in contact.</summary>
    public int ContactCount
    {
        get
        {
            Purge();
            int count = 0;
            for (int i = 0; i < _contacts.End; i++)
            {
                ref ContactRecord record = ref _contacts.Records[i];
                if (record.PieceA >= 0 && (record.Flags & ContactFlags.Touching) != 0)
                {
                    count++;
                }
            }

            return count;
        }
    }

    /// <param name="broadPhase">The new one.</param>
    /// <param name="always">True: it is asked in every step, also if no box has changed.</param>
    public void SetBroadPhase(IBroadPhase broadPhase, bool always = false)
    {
        _alwaysCollect = always;
        BroadPhase = broadPhase;
        for (int i = 0; i < Proxies.End; i++)
        {
            if ((Proxies.Info[i].Flags & ProxyFlags.Alive) != 0)
            {
                broadPhase.Added(Proxies, i);
            }
        }
    }

    /// <summary>
    /// Advances by <paramref name="dt"/> seconds, above 0 and finite. What the step forgets at its end lies in memory that worlds stepped by one thread
    /// share: it is in the cache already, and thousands of small worlds have none of their own.
    /// </summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="shared">The first of the thread's pieces of memory; null: there is none yet, or all are in use by worlds that step each other.</param>
    public void Step(float dt, ref Scratch? shared)
    {
        if (IsStepping || Proxies.HasScratch)
        {
            Step(dt);
            return;
        }

        Scratch lent = shared ?? new Scratch();
        int before = lent.Capacity;
        shared = lent.Next;
        Proxies.Lend(lent);
        try
        {
            Step(dt);
        }
        finally
        {
            // If the world keeps it, the thread's other worlds are to find as much as they had.
            Scratch back = Proxies.GiveBack() ?? Scratch.Of(before);
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

        IsStepping = true;
        try
        {
            BeginWork();
            RunStages(dt);
        }
        finally
        {
            _runner.End();
            _lists.Fast.End();
            Scratch.Release(0);
            IsStepping = false;
            Queries.Version++;
        }

        MemoryGuard.Verify();
        _runner.ThrowSchedulerError();
    }
}
