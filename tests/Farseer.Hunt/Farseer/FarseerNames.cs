using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;
using Farseer.Hunt.Calls;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;

namespace Farseer.Hunt.Farseer;

/// <summary>The names of Farseer Physics 2.0: what a number is by its name, in metres, kilograms and seconds.</summary>
internal sealed class FarseerNames : Names
{
    private static readonly Span _size = new(0.2f, 1.4f, 1e-6f, 1e6f);
    private static readonly Span _place = new(-6, 6, 1e-6f, 1e7f);
    private static readonly Span _near = new(-0.6f, 0.6f, 1e-6f, 1e6f);
    private static readonly Span _speed = new(-10, 10, 1e-6f, 1e6f);
    private static readonly Span _angle = new(-3, 3, 1e-6f, 1e4f);
    private static readonly Span _mass = new(0.1f, 10, 1e-6f, 1e9f);
    private static readonly Span _share = new(0, 1, 1e-6f, 10);
    private static readonly Span _force = new(-50, 50, 1e-6f, 1e9f);
    private static readonly Span _strength = new(0, 50, 1e-6f, 1e9f);
    private static readonly Span _time = new(0, 1, 1e-6f, 1e6f);
    private static readonly Span _drag = new(0, 1, 1e-6f, 1e6f);
    private static readonly Span _upper = new(0, 2, 1e-6f, 1e6f);
    private static readonly Span _lower = new(-2, 0, 1e-6f, 1e6f);
    private static readonly Span _cell = new(0.2f, 2, 1e-3f, 1e6f);

    public override IReadOnlyList<Type> Types { get; } = typeof(Body).Assembly.GetExportedTypes()
        .Where(t => !t.IsNested && (typeof(Joint).IsAssignableFrom(t) || typeof(Spring).IsAssignableFrom(t)
            || typeof(Controller).IsAssignableFrom(t)
            || typeof(LibraryCollider).IsAssignableFrom(t) || t.Name.EndsWith("List", StringComparison.Ordinal)))
        .Concat(new[]
        {
            typeof(PhysicsSimulator), typeof(PhysicsSimulatorState), typeof(RollbackBuffer), typeof(Body), typeof(Geom),
                typeof(BodyFactory), typeof(GeomFactory), typeof(JointFactory),
                typeof(SpringFactory),
            typeof(ComplexFactory), typeof(Path), typeof(QueryFilter), typeof(AABB), typeof(AABBFluidContainer), typeof(Scaling),
                typeof(ErrorBudget),
            typeof(IBroadPhaseCollider), typeof(IFluidContainer), typeof(IStepScheduler), typeof(OwnJoint), typeof(OwnSpring),
                typeof(OwnController), typeof(OwnScheduler),
        })
        .Where(t => t != typeof(ContactList)).ToList();

    public override IReadOnlyCollection<Type> Ways { get; } = new[] { typeof(PhysicsSimulator) };

    public override IReadOnlyDictionary<Type, object> Singletons { get; } = new Dictionary<Type, object>
    {
        [typeof(BodyFactory)] = BodyFactory.Instance,
        [typeof(GeomFactory)] = GeomFactory.Instance,
        [typeof(JointFactory)] = JointFactory.Instance,
        [typeof(SpringFactory)] = SpringFactory.Instance,
        [typeof(ComplexFactory)] = ComplexFactory.Instance,
    };

    public override IReadOnlyDictionary<string, string> LeftOut { get; } = new Dictionary<string, string>(StringComparer.Ordinal)
    {
        ["*.Tag"] = "nobody looks at it",
        ["*.Name"] = "nobody looks at it",
        ["*.Validate"] = "an update calls it",
        ["*.PreStep"] = "an update calls it",
        ["*.Compare"] = "goes back and forth to find names: the state hunt calls it",
        ["*.StateSize"] = "a capture asks it",
        ["*.SaveState"] = "a capture calls it",
        ["*.RestoreState"] = "a restore calls it",
        ["Joint.Update"] = "an update calls it",
        ["Spring.Update"] = "an update calls it",
        ["Controller.Update"] = "an update calls it",
        ["OwnScheduler.Start"] = "an update calls it",
        ["IStepScheduler.Start"] = "an update calls it",
        ["BodyFactory.Quirks"] = "shared by all worlds",
        ["ComplexFactory.Quirks"] = "shared by all worlds",
        ["ComplexFactory.Min"] = "shared by all worlds",
        ["ComplexFactory.Max"] = "shared by all worlds",
        ["ComplexFactory.SpringConstant"] = "shared by all worlds",
        ["ComplexFactory.DampingConstant"] = "shared by all worlds",
        ["GeomFactory.GridCellSizeAABBFactor"] = "shared by all worlds",
        ["Geom.GetNextId"] = "shared by all worlds",
        ["PhysicsSimulator.WarmUp"] = "makes worlds of its own",
        ["PhysicsSimulator.Update"] = "the step",
        ["PhysicsSimulator.RayCastEach"] = "takes spans; RayCast, which it repeats, stands for it",
        ["PhysicsSimulator.MixMaterials"] = "asks a delegate of the user's",
        ["PhysicsSimulator.EnableDiagnostics"] = "measures time, which is never the same",
        ["ErrorBudget.WithTimeLimit"] = "measures time, which is never the same",
        ["InactivityController.new"] = "the simulator has its own",
        ["ArbiterList.RemoveContactCountEqualsZero"] = "takes a pool that no user has",
        ["ArbiterList.RemoveContainsDisposedBody"] = "takes a pool that no user has",
        ["ArbiterList.ForEachSafe"] = "reads, with a delegate",
        ["ArbiterList.RemoveAllSafe"] = "ArbiterList.Clear of the list's base stands for it",
        ["ArbiterList.new"] = "a list of nobody",
        ["BodyList.new"] = "a list of nobody",
        ["GeomList.new"] = "a list of nobody",
        ["JointList.new"] = "a list of nobody",
        ["SpringList.new"] = "a list of nobody",
        ["ControllerList.new"] = "a list of nobody",
        ["WaveController.CurrentWave"] = "an array that the wave writes",
        ["WaveController.PreviousWave"] = "an array that the wave writes",
        ["WaveController.VectorPoint"] = "a result",
        ["WaveController.VectorNearWaveEdge"] = "a result",
        ["WaveController.VectorFarWaveEdge"] = "a result",
        ["WaveController.XPosition"] = "an array that the wave writes",
    };

    protected override IReadOnlyDictionary<string, Span> Spans { get; } = Expand(new (Span Span, string Names)[]
    {
        (_size, "width height radius xRadius yRadius targetDistance length maxLength totalLength restLength activationDistance minRadius"),
        (new Span(1, 8, 1e-6f, 1e6f), "maxRadius distance maximumDistance linkWidth linkHeight"),
        (_near, "offset worldVertex localVertex firstVector secondVector anchor1 anchor2 attachPoint1 attachPoint2 bodyAttachPoint "
            + "localPosition localPoint localVector localAnchor1 localAnchor2"),
        (_place, "position positionX positionY x y anchor anchorPosition initialAnchorPosition worldAnchor1 worldAnchor2 groundAnchor1 "
            + "groundAnchor2 target start end center point "
            + "worldPoint worldPosition worldAttachPoint initialAnchor worldOffset min max translation vector controlPoint location "
            + "worldVector fixedPoint from to intersectPoint contact epicenter"),
        (_speed, "linearVelocity velocity motorSpeed angularVelocity impulse angularImpulse axis amount normal uvector localNormal "
            + "surfaceSpeed oneWayDirection"),
        (_angle, "rotation rotationOffset angle targetAngle totalRotation"),
        (_mass, "mass momentOfInertia"),
        (_share, "restitutionCoefficient biasFactor softness coefficient dampingCoefficient dampingRatio sleepTolerance minimumVelocity "
            + "allowedPenetration slop jointError springError share alpha rollingResistance"),
        (new Span(0, 2, 1e-6f, 1e3f), "frictionCoefficient ratio gravityScale"),
        (_force, "force torque"),
        (_strength, "maxForce maxTorque maxMotorForce maxMotorTorque maxImpulse breakForce breakpoint springConstant dampingConstant "
            + "dampningConstant strength torqueMultiplier "
            + "maxLinearVelocity maxAngularVelocity hitSpeed"),
        (new Span(0.5f, 8, 1e-6f, 1e6f), "frequency"),
        (_drag, "linearDragCoefficient rotationalDragCoefficient quadraticDragCoefficient density fluidDensity"),
        (_time, "idleTime maxIdleTime timeToSleep updateInterval maximumUpdateInterval preferredUpdateInterval dt dtReal"),
        (_upper, "upperLimit"),
        (_lower, "lowerLimit"),
        (_cell, "collisionGridCellSize"),
        (new Span(0, 1.5f, 1e-6f, 1e6f), "AngleLimitJoint.upperLimit FixedAngleLimitJoint.upperLimit SliderJoint.max AngleLimitJoint.max "
            + "FixedAngleLimitJoint.max JointFactory.max"),
        (new Span(-1.5f, 0, 1e-6f, 1e6f), "AngleLimitJoint.lowerLimit FixedAngleLimitJoint.lowerLimit AngleLimitJoint.min "
            + "FixedAngleLimitJoint.min JointFactory.min"),
        (new Span(0, 0.5f, 1e-6f, 1e6f), "SliderJoint.min DistanceJoint.lowerLimit"),
        (new Span(0, 10, 1e-6f, 1e6f), "gravity waveGeneratorMax waveGeneratorMin waveGeneratorStep"),
        (new Span(-10, 10, 1e-6f, 1e6f), "PhysicsSimulator.gravity"),

        // A path has a link for each width of its length: no more than some hundred.
        (new Span(-6, 6, 1e-3f, 20), "ComplexFactory.start ComplexFactory.end Path.point"),
        (new Span(0.5f, 1.4f, 0.2f, 1e3f), "ComplexFactory.width ComplexFactory.linkWidth Path.width"),
    });

    protected override IReadOnlyDictionary<string, (int Low, int High, int Least, int Most)> Integers { get; } = new Dictionary<string,
        (int, int, int, int)>(StringComparer.Ordinal)
    {
        ["iterations"] = (1, 12, -1, 50),
        ["mostIterations"] = (1, 12, -1, 50),
        ["maxContactsToDetect"] = (1, 10, -1, 100),
        ["maxContactsToResolve"] = (1, 10, -1, 100),
        ["workerCount"] = (1, 4, -1, 8),
        ["iterationFactor"] = (0, 4, -1, 64),
        ["collisionGroup"] = (-1, 2, -1000, 1000),
        ["numberOfEdges"] = (4, 16, -1, 200),
        ["nodeCount"] = (2, 20, -1, 200),
        ["links"] = (2, 8, -1, 20),
        ["index"] = (0, 4, -1, 20),
        ["count"] = (0, 2, -1, 20),
        ["segment"] = (0, 2, -1, 20),
        ["node"] = (0, 10, -1, 200),
        ["frames"] = (1, 20, -1, 100),
        ["frame"] = (0, 4, -1, 200),
        ["bytes"] = (1, 1_000_000, -1, 10_000_000),
    };

    protected override bool IsOptional(Type owner, string name) => name is "ignoredBody" or "area";

    protected override Kind? Special(Type owner, string name, Type type) =>
        type == typeof(Vector2) ? SpanOf(owner, name) is { } span ? new PointKind(span) : null
        : type == typeof(Vertices) ? new OutlineKind(owner == typeof(ComplexFactory) ? new Span(1, 4, 1e-3f, 20) : _size, points
            => $"new Vertices(new Vector2[] {{ {points} }})", points => new Vertices(points))
        : type == typeof(List<Geom>) ? new FreshKind("new List<Geom>()", () => new List<Geom>())
        : type == typeof(List<RayCastHit>) ? new FreshKind("new List<RayCastHit>()", () => new List<RayCastHit>())
        : type == typeof(List<Arbiter>) ? new FreshKind("new List<Arbiter>()", () => new List<Arbiter>())
        : type == typeof(SurfaceMaterial)
            ? new FreshKind("new SurfaceMaterial { Friction = 0.3f, Speed = 1 }", () => new SurfaceMaterial { Friction = 0.3f, Speed = 1 })
        : type == typeof(Pose) ? new FreshKind("new Pose(1, 2, 3)", () => new Pose(1, 2, 3))
        : type == typeof(Matrix4x4) ? new FreshKind("Matrix4x4.Identity", () => Matrix4x4.Identity)
        : null;

    private static Dictionary<string, Span> Expand(IEnumerable<(Span Span, string Names)> rows)
    {
        var spans = new Dictionary<string, Span>(StringComparer.Ordinal);
        foreach ((Span span, string names) in rows)
        {
            foreach (string name in names.Split(' '))
            {
                spans[name] = span;
            }
        }

        return spans;
    }
}
