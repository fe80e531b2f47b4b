using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Settings;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Interfaces;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// The world that bodies and geoms are added to and that is updated each frame. Disposing it is optional: it holds no unmanaged
/// resources, and threads of <see cref="WorkerCount"/> end with it in any case. A simulator is not safe for use by several threads at once;
/// several simulators are independent of each other. Queries are the exception: while nobody changes or updates it, any number of threads
/// may call <see cref="RayCast"/>, <see cref="RayCastEach"/>, <see cref="RayCastAll"/>,
/// <see cref="Query"/>, <see cref="QueryPoint"/>, <see cref="QueryCircle"/>, <see cref="QueryGeom"/>, <see cref="CircleCast"/>,
/// <see cref="ShapeCast"/> and <see cref="ClosestPoint"/>
/// at once, each with lists of its own, and get the answers that one would get. A filter's <see cref="QueryFilter.Accept"/> is called by
/// the asking thread.
/// </summary>
/// <example>
/// <code>
/// using var simulator = new PhysicsSimulator(new Vector2(0, -10));
/// Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, 1);
/// GeomFactory.Instance.CreateCircleGeom(simulator, ball, 0.5f, 24);
/// simulator.Update(1f / 60);
/// </code>
/// </example>
public partial class PhysicsSimulator : IDisposable
{
    [NotState(Why.Derived)]
    private readonly ObjectTable _table = new ObjectTable();
    private readonly EventRelay _relay;
    private readonly ArbiterView _arbiters;
    private readonly SurfaceRelay _surfaces;
    private float _biasFactor = 0.8f;
    private int _maxContactsToDetect = 10;
    private int _maxContactsToResolve = 4;
    private Scaling _scaling = new Scaling(0.001f, 0.01f);
    private IBroadPhaseCollider _broadPhaseCollider;
    private Farseer201Quirks _quirks;
    [NotState(Why.Calm)]
    private bool _isDisposed;

    /// <summary>A handler of the update under way has called <see cref="Dispose"/>.</summary>
    [NotState(Why.Calm)]
    private bool _disposeWaits;

    /// <summary>Makes a simulator without gravity.</summary>
    /// <exception cref="PlatformNotSupportedException"><c>DOTNET_MaxVectorTBitWidth</c> asks for vectors of 512 bits, and the processor has
    /// them.</exception>
    public PhysicsSimulator()
        : this(Vector2.Zero)
    {
    }

    /// <summary>Makes a simulator.</summary>
    /// <param name="gravity">Acceleration of all bodies, length/s²; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="gravity"/> is not finite.</exception>
    /// <exception cref="PlatformNotSupportedException"><c>DOTNET_MaxVectorTBitWidth</c> asks for vectors of 512 bits, and the processor has
    /// them.</exception>
    public PhysicsSimulator(Vector2 gravity)
    {
        _relay = new EventRelay(this, _table);
        _arbiters = new ArbiterView(this, _table);
        _queries = new QueryCrowd(this, World, _table);
        _surfaces = new SurfaceRelay(this, _table);
        World.Surfaces.Judge = _surfaces;
        BodyList = new BodyList { Owner = this };
        GeomList = new GeomList { Owner = this };
        JointList = new JointList { Owner = this };
        ControllerList = new ControllerList { Owner = this };
        SpringList = new SpringList { Owner = this };
        _joints = new ItemQueue<Joint>(this, JointList, TakeIn, JointList.TakeOut, () => JointList.Removed is not null, LetGo);
        _controllers = new ItemQueue<Controller>(
            this, ControllerList, ControllerList.TakeIn, ControllerList.TakeOut, () => ControllerList.Removed is not null);
        _springs =
            new ItemQueue<Spring>(this, SpringList, SpringList.TakeIn, SpringList.TakeOut, () => SpringList.Removed is not null, LetGo);
        InactivityController = new InactivityController(this);
        _controllers.Add(InactivityController, nameof(InactivityController));
        World.Hooks = _relay;
        _jointRelay = new JointRelay(_relay, World);
        Gravity = Require.Finite(gravity, nameof(gravity));
        _broadPhaseCollider = new SelectiveSweepCollider(this);
        UseCollider(_broadPhaseCollider);
    }

    /// <summary>The geoms in the simulator: a view; see <see cref="Collisions.GeomList"/>.</summary>
    public GeomList GeomList { get; }

    /// <summary>The bodies in the simulator: a view; see <see cref="Dynamics.BodyList"/>.</summary>
    public BodyList BodyList { get; }

    /// <summary>The pairs in contact after the last update. Filled when asked for; during an update it is as it was before.</summary>
    public ArbiterList ArbiterList => World.IsStepping ? _arbiters.List : _arbiters.Fresh(World);

    /// <summary>Acceleration of all bodies that do not ignore it, length/s². Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Gravity
    {
        get => World.Settings.Gravity;
        set => World.Settings.Gravity = Require.Finite(value, nameof(Gravity));
    }

    /// <summary>
    /// Friction, restitution and drag of the geoms and bodies that factories make for the simulator from now on. (An addition to the
    /// original.)
    /// </summary>
    public SimulatorDefaults Defaults { get; } = new SimulatorDefaults();

    /// <summary>
    /// The accuracy dial, at least 1. Each iteration is a substep of the update. Doubling the number divides most errors by about four, for
    /// less than twice the time. Default 5.
    /// </summary>
    /// <remarks>
    /// Bodies that hang together may take more of them: see <see cref="AdaptIterations"/> and <see cref="Dynamics.Body.IterationFactor"/>.
    /// </remarks>
    /// <exception cref="ArgumentOutOfRangeException">The value is below 1.</exception>
    public int Iterations
    {
        get => World.Settings.Substeps;
        set => World.Settings.Substeps = Require.AtLeast(value, 1, nameof(Iterations));
    }

    /// <summary>
    /// True lets bodies that hang together by contacts or joints take up to 16 times <see cref="Iterations"/> where they need it: tall
    /// piles and heavy bodies on light ones while they rest, and light trees of joints that pass on heavy loads. It follows from masses and
    /// contacts, not from a clock, so the same scene gives the same bits. False keeps all bodies to <see cref="Iterations"/>, except where
    /// <see cref="Dynamics.Body.IterationFactor"/> says otherwise: each update of a body costs the same, and such piles sink and such loads
    /// dip deeper. <see cref="StepReport.MostIterations"/> tells what was taken. Default true. (An addition to the original.)
    /// </summary>
    public bool AdaptIterations
    {
        get => World.Settings.AdaptSubsteps;
        set => World.Settings.AdaptSubsteps = value;
    }

    /// <summary>
    /// The depth to which geoms of the original sink into each other at rest, a length; at least 0. Default 0.05. It is kept for old
    /// programs and changes nothing: surfaces rest at each other, in pixels, metres and kilometres alike. What they still sink in by is an
    /// error that <see cref="Iterations"/> lessens.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float AllowedPenetration
    {
        get => World.Settings.AllowedPenetration;
        set => World.Settings.AllowedPenetration = Require.Depth(value, nameof(AllowedPenetration));
    }

    /// <summary>
    /// True keeps bodies that move or turn by more than their own size in an update from passing through others: the impact is
    /// found on the way that they take. Nothing is done, and no time taken, where nothing is so fast. A geom whose
    /// <see cref="Collisions.Geom.CollisionResponseEnabled"/> is false is told of what passes it. Default true. See
    /// <see cref="Dynamics.Body.IsBullet"/> and <see cref="Dynamics.Body.IsContinuousCollisionEnabled"/>. (An addition to the
    /// original.)
    /// </summary>
    public bool IsContinuousCollisionEnabled
    {
        get => World.Settings.Continuous;
        set => World.Settings.Continuous = value;
    }

    /// <summary>
    /// The share of a deep overlap that one update takes away, without giving the bodies speed; at least 0. 1 and more take away all of it.
    /// Default 0.8.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float BiasFactor
    {
        get => _biasFactor;
        set
        {
            _biasFactor = Require.NotNegative(value, nameof(BiasFactor));
            World.Settings.Recovery = Math.Min(1, value);
        }
    }

    /// <summary>How the friction coefficients of a pair combine. Default <see cref="FrictionType.Average"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not a member of the enum.</exception>
    public FrictionType FrictionType
    {
        get => World.Settings.FrictionMix switch
        {
            FrictionMix.Minimum => FrictionType.Minimum,
            FrictionMix.GeometricMean => FrictionType.GeometricMean,
            FrictionMix.Maximum => FrictionType.Maximum,
            FrictionMix.Product => FrictionType.Product,
            _ => FrictionType.Average,
        };
        set => World.Settings.FrictionMix = value switch
        {
            FrictionType.Average => FrictionMix.Average,
            FrictionType.Minimum => FrictionMix.Minimum,
            FrictionType.GeometricMean => FrictionMix.GeometricMean,
            FrictionType.Maximum => FrictionMix.Maximum,
            FrictionType.Product => FrictionMix.Product,
            _ => throw Require.Range(nameof(FrictionType), value, "must be a member of the enum FrictionType"),
        };
    }

    /// <summary>
    /// How the restitution coefficients of a pair combine. Default <see cref="RestitutionType.Average"/>. (An addition to the original.)
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not a member of the enum.</exception>
    public RestitutionType RestitutionType
    {
        get => World.Settings.RestitutionMix switch
        {
            RestitutionMix.Minimum => RestitutionType.Minimum,
            RestitutionMix.Maximum => RestitutionType.Maximum,
            RestitutionMix.Product => RestitutionType.Product,
            _ => RestitutionType.Average,
        };
        set => World.Settings.RestitutionMix = value switch
        {
            RestitutionType.Average => RestitutionMix.Average,
            RestitutionType.Minimum => RestitutionMix.Minimum,
            RestitutionType.Maximum => RestitutionMix.Maximum,
            RestitutionType.Product => RestitutionMix.Product,
            _ => throw Require.Range(nameof(RestitutionType), value, "must be a member of the enum RestitutionType"),
        };
    }

    /// <summary>Largest number of contacts of a pair that events and arbiters look at; at least 1. Default 10.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is below 1.</exception>
    public int MaxContactsToDetect
    {
        get => _maxContactsToDetect;
        set => _maxContactsToDetect = Require.AtLeast(value, 1, nameof(MaxContactsToDetect));
    }

    /// <summary>
    /// Largest number of contacts in the list of a pair, deepest first; at least 1. The solver does not go by it: it uses one or two points
    /// for each pair of convex pieces. Default 4.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is below 1.</exception>
    public int MaxContactsToResolve
    {
        get => _maxContactsToResolve;
        set => _maxContactsToResolve = Require.AtLeast(value, 1, nameof(MaxContactsToResolve));
    }

    /// <summary>Lets updates become rarer under load; off by default.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    public Scaling Scaling
    {
        get => _scaling;
        set => _scaling = Require.NotNull(value, nameof(Scaling));
    }

    /// <summary>
    /// Finds the pairs that may touch. Default <see cref="SelectiveSweepCollider"/>. It can be changed only while no geom is in
    /// the simulator or waiting to be taken in.
    /// </summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    /// <exception cref="ArgumentException">The value is a collider of the library made for another simulator.</exception>
    /// <exception cref="InvalidOperationException">There are geoms.</exception>
    public IBroadPhaseCollider BroadPhaseCollider
    {
        get => _broadPhaseCollider;
        set
        {
            Require.NotNull(value, nameof(BroadPhaseCollider));
            if (GeomList.Count > 0 || _geomsWaiting > 0)
            {
                throw new InvalidOperationException(
                    "BroadPhaseCollider can be changed only while the simulator has no geoms; it has "
                    + (GeomList.Count + _geomsWaiting).ToString(System.Globalization.CultureInfo.InvariantCulture) + ".");
            }

            if (value is LibraryCollider own && !ReferenceEquals(own.Core.Owner, this))
            {
                throw new ArgumentException("The collider was made for another simulator.", nameof(BroadPhaseCollider));
            }

            _broadPhaseCollider = value;
            UseCollider(value);
        }
    }

    /// <summary>False pauses: items are taken in and out, but nothing moves and forces given meanwhile are dropped. Default true.</summary>
    public bool Enabled { get; set; } = true;

    /// <summary>
    /// True lets bodies that rest fall asleep: a body and all that it is connected with by contacts, joints and springs stop together, cost
    /// nothing from then on, and wake when something awake touches or pulls one of them, or when one of them, its geoms or joints
    /// or what it stands on is changed. Their geoms stay in contact without events. Where nothing rests it changes nothing. Default
    /// false: nothing sleeps, as in the original. (An addition to the original, whose <see cref="InactivityController"/> disables
    /// bodies instead.)
    /// </summary>
    public bool AllowSleep
    {
        get => World.Settings.AllowSleep;
        set => World.Settings.AllowSleep = value;
    }

    /// <summary>
    /// Seconds that a body, and all that it is connected with, must rest before they fall asleep; above 0. Default 0.5. (An addition to the
    /// original.)
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or not above 0.</exception>
    public float TimeToSleep
    {
        get => World.Settings.TimeToSleep;
        set => World.Settings.TimeToSleep = Require.Positive(value, nameof(TimeToSleep));
    }

    /// <summary>
    /// A body rests as long as it does not move by more than this share of its size; above 0. A larger one lets bodies sleep sooner,
    /// and stops those that still creep; a tall pile may never rest within a small one. What trembles or rolls within 64 times as much, and
    /// at most 1/256 of its size, falls asleep after eight times <see cref="TimeToSleep"/>. No body in free flight rests, whatever its
    /// size. Default 1/16384. (An addition to the original.)
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or not above 0.</exception>
    public float SleepTolerance
    {
        get => World.Settings.RestShare;
        set => World.Settings.RestShare = Require.Positive(value, nameof(SleepTolerance));
    }

    /// <summary>Number of bodies asleep. (An addition to the original.)</summary>
    public int SleepingBodyCount => World.Sleep.AsleepCount;

    /// <summary>
    /// Behaviours of version 2.0.1 to bring back. Set it before anything is added. Default <see cref="Farseer201Quirks.None"/>.
    /// (An addition to the original.)
    /// </summary>
    /// <exception cref="InvalidOperationException">There are geoms in the simulator or waiting to be taken in.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The value has a bit that is no member of the enum.</exception>
    public Farseer201Quirks Quirks
    {
        get => _quirks;
        set
        {
            if ((value & ~Farseer201Quirks.All) != 0)
            {
                throw Require.Range(nameof(Quirks), value, "must be made of members of the enum Farseer201Quirks");
            }

            if (GeomList.Count > 0 || _geomsWaiting > 0)
            {
                throw new InvalidOperationException("Quirks can be changed only while the simulator has no geoms.");
            }

            _quirks = value;
            World.Settings.FreezePairFriction = (value & Farseer201Quirks.PairFrictionFrozen) != 0;
            World.Settings.OneSidedFilter = (value & Farseer201Quirks.OneSidedCategoryFilter) != 0;
            World.Settings.SeparateUntouchedPairs = (value & Farseer201Quirks.SeparationWithoutContact) != 0;
            World.Settings.JointsBreakLate = (value & Farseer201Quirks.JointBreaksLate) != 0;
        }
    }

    internal World World { get; } = new World();

    internal EventRelay Relay => _relay;

    /// <summary>Removes everything and refuses further use; from within a handler, at the end of the update. Again: does nothing.</summary>
    public void Dispose()
    {
        if (_isUpdating)
        {
            _disposeWaits = true;
        }
        else if (!_isDisposed)
        {
            _disposeWaits = false;
            try
            {
                Clear();
            }
            finally
            {
                _isDisposed = true;
                World.Dispose();
            }
        }

        GC.SuppressFinalize(this);
    }

    /// <summary>
    /// The first geom, in the order of <see cref="GeomList"/> and then of those that wait for the next update, that a world point is in.
    /// </summary>
    /// <param name="x">x of the point.</param>
    /// <param name="y">y of the point.</param>
    /// <returns>The geom, or null.</returns>
    public Geom? Collide(float x, float y) => Collide(new Vector2(x, y));

    /// <summary>
    /// The first geom, in the order of <see cref="GeomList"/> and then of those that wait for the next update, that a world point is in.
    /// </summary>
    /// <param name="point">The point.</param>
    /// <returns>The geom, or null.</returns>
    public Geom? Collide(Vector2 point)
    {
        List<Geom> present = ListPresent();
        for (int i = 0; i < present.Count; i++)
        {
            if (present[i].Collide(point))
            {
                return present[i];
            }
        }

        return null;
    }

    /// <summary>All geoms that a world point is in.</summary>
    /// <param name="x">x of the point.</param>
    /// <param name="y">y of the point.</param>
    /// <returns>A new list, in the order of <see cref="GeomList"/> and then of those that wait for the next update.</returns>
    public List<Geom> CollideAll(float x, float y) => CollideAll(new Vector2(x, y));

    /// <summary>All geoms that a world point is in.</summary>
    /// <param name="point">The point.</param>
    /// <returns>A new list, in the order of <see cref="GeomList"/> and then of those that wait for the next update.</returns>
    public List<Geom> CollideAll(Vector2 point)
    {
        var found = new List<Geom>();
        List<Geom> present = ListPresent();
        for (int i = 0; i < present.Count; i++)
        {
            if (present[i].Collide(point))
            {
                found.Add(present[i]);
            }
        }

        return found;
    }

    internal void ThrowIfDisposed()
    {
        if (_isDisposed)
        {
            throw new ObjectDisposedException(nameof(PhysicsSimulator));
        }
    }

    private void UseCollider(IBroadPhaseCollider collider)
    {
        _relay.Collider = (collider as LibraryCollider)?.Core;
        World.SetBroadPhase(_relay.Collider?.Engine ?? new UserBroadPhase(this), always: _relay.Collider is null);
    }
}
