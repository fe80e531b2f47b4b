using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Queries;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Springs;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>What all phases of a step share: the stores, the settings, who listens and who works.</summary>
internal sealed class WorldStores
{
    private JointSolver? _jointSolver;

    public WorldStores()
    {
        Contacts = new ContactStore(Shapes);
        Queries = new WorldQueries(Shapes, Bodies);
    }

    public WorldSettings Settings { get; } = new WorldSettings();

    public StepProfile Profile { get; } = new StepProfile();

    [NotState(Why.Running)]
    public StepWorkers Workers { get; } = new StepWorkers();

    public BodyStore Bodies { get; } = new BodyStore();

    public ShapeStore Shapes { get; } = new ShapeStore();

    public ColliderLists Colliders { get; } = new ColliderLists();

    public ProxyStore Proxies { get; } = new ProxyStore();

    public ContactStore Contacts { get; }

    public ConstraintGraph Graph { get; } = new ConstraintGraph();

    public IslandStore Islands { get; } = new IslandStore();

    public JointStore Joints { get; } = new JointStore();

    /// <summary>None before there is a joint.</summary>
    public JointSolver? JointSolver => _jointSolver;

    /// <summary>The one that there is, or that is made now.</summary>
    public JointSolver MadeJointSolver => _jointSolver ??= new JointSolver(new JointWork(Joints));

    public SpringStore Springs { get; } = new SpringStore();

    /// <summary>The bodies of a step, by what is done with them.</summary>
    public BodyLists Lists { get; } = new BodyLists();

    /// <summary>Rays, boxes, shapes and points against all colliders, at any time.</summary>
    public WorldQueries Queries { get; }

    public IBroadPhase BroadPhase { get; set; } = new LevelGrid();

    [NotState(Why.Fixed)]
    public IStepHooks? Hooks { get; set; }

    /// <summary>Who hears of broken joints and solves those that a user wrote.</summary>
    [NotState(Why.Fixed)]
    public IUserJoints? UserJoints { get; set; }

    /// <summary>True while a step runs: removals then wait for the next one.</summary>
    [NotState(Why.Calm)]
    public bool IsStepping { get; set; }

    /// <summary>Some restitution is above 1.</summary>
    public bool MakesEnergy { get; set; }

    /// <summary>Of the step under way, or of the last one.</summary>
    public int Substeps { get; set; } = 1;

    /// <summary>Seconds of a substep of the last step; 0 before the first.</summary>
    public float LastSubstep { get; set; }

    /// <summary>Shares the work of a step out.</summary>
    public StageRunner Runner => Workers.Runner;

    /// <summary>Memory of the phases of a step, which all that is taken is given back to at its end.</summary>
    public Scratch Scratch => Proxies.Scratch;

    /// <summary>What the phases work with while a step runs.</summary>
    [NotState(Why.OfOneStep)]
    public StepTools Tools { get; private set; } = null!;

    /// <summary>Joints that a user wrote act, which may hold any body: only they know.</summary>
    public bool AnyUserJoints => UserJoints != null && UserJoints.Any;

    public DrivenBound DrivenBoundOf(float dt) => new DrivenBound(dt, Substeps, Settings.MostDrivenSpeed, Settings.MostDrivenSpin);

    /// <summary>Whether something besides contacts may move a body.</summary>
    public bool IsHeldApart(int body) => Joints.Degree(body) > 0 || Springs.Touches(body) || AnyUserJoints;

    /// <summary>Takes up the tools of a step.</summary>
    public void TakeTools()
    {
        Tools = StepTools.Of(Scratch);
        Lists.Work = Tools.Bodies;
        Graph.Use(Tools.Ranges);
    }

    /// <summary>Memory that was needed only once is to be given back when the step is over.</summary>
    [NotState(Why.Room)]
    public bool TrimIsDue { get; set; }

    /// <summary>Gives memory back that steps have not needed of late.</summary>
    public void Trim()
    {
        TrimIsDue = false;
        Scratch.Trim();
        StepTools.Of(Scratch).Pairs.Trim(Shapes.PieceIds.Count / 4);
    }

    /// <summary>Lays them down.</summary>
    /// <param name="isWhole">False: the step has thrown, and who knows what it has left in them.</param>
    public void LeaveTools(bool isWhole)
    {
        Lists.Work = null!;
        Graph.Use(null);
        Tools = null!;
        if (!isWhole)
        {
            Scratch.Tools = null;
        }
    }

    /// <summary>Makes room for more bodies.</summary>
    public void EnsureBodies(int end)
    {
        Bodies.Set.EnsureCapacity(end);
        Graph.EnsureBodies(end);
        Colliders.EnsureBodies(end);
    }

    /// <summary>Makes room for more colliders.</summary>
    public void EnsureColliders(int end)
    {
        Shapes.Colliders.EnsureCapacity(end);
        Shapes.Order.EnsureCapacity(end);
        Colliders.EnsureColliders(end);
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        Settings.Visit(s.Of(nameof(Settings)));
        Bodies.Visit(s.Of(nameof(Bodies)));
        Shapes.Visit(s.Of(nameof(Shapes)));
        Colliders.Visit(s.Of(nameof(Colliders)));
        Proxies.Visit(s.Of(nameof(Proxies)));
        Contacts.Visit(s.Of(nameof(Contacts)));
        Graph.Visit(s.Of(nameof(Graph)));
        Islands.Visit(s.Of(nameof(Islands)));
        Joints.Visit(s.Of(nameof(Joints)));
        s.Of(nameof(WorldStores)).Reference(ref _jointSolver);
        _jointSolver?.Visit(s.Of(nameof(JointSolver)));
        Springs.Visit(s.Of(nameof(Springs)));
        Lists.Visit(s.Of(nameof(Lists)));
        BroadPhase = s.Of(nameof(WorldStores)).Reference(BroadPhase)!;
        BroadPhase.Visit(s.Of(nameof(BroadPhase)));
        Queries.Visit(s.Of(nameof(Queries)));
        MakesEnergy = s.Of(nameof(WorldStores)).Value(MakesEnergy);
        Substeps = s.Value(Substeps);
        LastSubstep = s.Value(LastSubstep);
    }
}
