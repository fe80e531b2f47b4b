using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Farseer.Hunt.Calls;

namespace Farseer.Hunt.Flash;

/// <summary>The names of Box2DFlash 2.0.2: what a number is by its name, in metres, kilograms and seconds.</summary>
internal sealed class FlashNames : Names
{
    private const string IsMethod = "another member by its old name";

    private static readonly Span _place = new(-6, 6, 1e-6f, 1e7f);
    private static readonly Span _strength = new(0, 50, 1e-6f, 1e9f);
    private static readonly Dictionary<Type, Type> _made = new()
    {
        [typeof(b2CircleDef)] = typeof(b2CircleShape),
        [typeof(b2PolygonDef)] = typeof(b2PolygonShape),
        [typeof(b2DistanceJointDef)] = typeof(b2DistanceJoint),
        [typeof(b2GearJointDef)] = typeof(b2GearJoint),
        [typeof(b2MouseJointDef)] = typeof(b2MouseJoint),
        [typeof(b2PrismaticJointDef)] = typeof(b2PrismaticJoint),
        [typeof(b2PulleyJointDef)] = typeof(b2PulleyJoint),
        [typeof(b2RevoluteJointDef)] = typeof(b2RevoluteJoint),
    };

    public override IReadOnlyList<Type> Types { get; } = typeof(b2Body).Assembly.GetExportedTypes()
        .Where(t => typeof(b2Joint).IsAssignableFrom(t) || typeof(b2Shape).IsAssignableFrom(t)
            || typeof(b2JointDef).IsAssignableFrom(t) || typeof(b2ShapeDef).IsAssignableFrom(t))
        .Concat(new[]
        {
            typeof(b2World), typeof(b2WorldState), typeof(b2RollbackBuffer),
            typeof(b2Body), typeof(b2BodyDef), typeof(b2FilterData), typeof(b2MassData), typeof(b2AABB), typeof(b2OBB),
                typeof(b2Segment), typeof(b2XForm),
            typeof(b2ContactListener), typeof(b2ContactFilter), typeof(b2DestructionListener), typeof(b2BoundaryListener),
            typeof(OwnContacts), typeof(OwnFilter), typeof(OwnGoodbyes), typeof(OwnBoundary),
        }).ToList();

    public override IReadOnlyCollection<Type> Ways { get; } = Array.Empty<Type>();

    public override IReadOnlyDictionary<string, string> LeftOut { get; } = new Dictionary<string, string>(StringComparer.Ordinal)
    {
        ["*.SetUserData"] = "nobody looks at it",
        ["*.userData"] = "nobody looks at it",
        ["*.m_userData"] = "nobody looks at it",
        ["b2World.WarmUp"] = "makes worlds of its own",
        ["b2World.SetListener"] = "SetBoundaryListener and SetDestructionListener stand for it",
        ["b2RevoluteJointDef.anchorPoint"] = "Initialize stands for it",
        ["b2World.Step"] = "the step",
        ["b2World.SetDebugDraw"] = "draws",
        ["b2World.m_debugDraw"] = "draws",
        ["b2World.DrawDebugData"] = "draws",
        ["b2ContactListener.new"] = "the own one stands for it",
        ["*.Compare"] = "goes back and forth to find names: the state hunt calls it",
        ["b2ContactFilter.new"] = "the own one stands for it",
        ["b2DestructionListener.new"] = "the own one stands for it",
        ["b2BoundaryListener.new"] = "the own one stands for it",
        ["b2ContactListener.Add"] = "a step calls it",
        ["b2ContactListener.Persist"] = "a step calls it",
        ["b2ContactListener.Remove"] = "a step calls it",
        ["b2ContactListener.Result"] = "a step calls it",
        ["b2ContactFilter.ShouldCollide"] = "a step calls it",
        ["b2DestructionListener.SayGoodbyeJoint"] = "a step calls it",
        ["b2DestructionListener.SayGoodbyeShape"] = "a step calls it",
        ["b2BoundaryListener.Violation"] = "a step calls it",
        ["b2World.m_contactListener"] = IsMethod,
        ["b2World.m_contactFilter"] = IsMethod,
        ["b2World.m_destructionListener"] = IsMethod,
        ["b2World.m_boundaryListener"] = IsMethod,
        ["b2XForm.new"] = "body.GetXForm stands for it",
        ["b2XForm.R"] = "body.GetXForm stands for it",
        ["b2XForm.Initialize"] = "body.GetXForm stands for it",
        ["b2XForm.position"] = "body.GetXForm is a view: what is written there is nobody's",
        ["b2XForm.Set"] = "body.GetXForm is a view: what is written there is nobody's",
        ["b2XForm.SetIdentity"] = "body.GetXForm is a view: what is written there is nobody's",
        ["b2OBB.R"] = "a result",
        ["b2PolygonShape.ComputeCentroid"] = "works on arrays alone",
        ["b2PolygonShape.ComputeOBB"] = "works on arrays alone",
    };

    protected override IReadOnlyDictionary<string, Span> Spans { get; } = new (Span Span, string Names)[]
    {
        (new Span(0.1f, 0.7f, 1e-6f, 1e6f), "radius hx hy length length1 length2 maxLength1 maxLength2 extents m_length"),
        (new Span(-0.6f, 0.6f, 1e-6f, 1e6f), "localPosition localAnchor1 localAnchor2 localPoint localVector center localCenter"),
        (_place, "position target p p1 p2 anchor anchor1 anchor2 groundAnchor1 groundAnchor2 ga1 ga2 point worldPoint worldVector "
            + "m_target"),
        (new Span(-100, 100, 1e-6f, 1e7f), "lowerBound upperBound"),
        (new Span(-10, 10, 1e-6f, 1e6f), "v linearVelocity motorSpeed speed w omega angularVelocity impulse axis localAxis1 normal "
            + "gravity m_gravity d m_linearVelocity m_angularVelocity m_motorSpeed dX dY"),
        (new Span(-3, 3, 1e-6f, 1e4f), "angle referenceAngle"),
        (new Span(0.1f, 10, 1e-6f, 1e9f), "mass i m_density"),
        (new Span(0, 5, 1e-6f, 1e6f), "density"),
        (new Span(0, 0.9f, 1e-6f, 10), "restitution m_restitution dampingRatio m_dampingRatio ratio r lambda maxLambda timeStep"),
        (new Span(0, 2, 1e-6f, 1e3f), "friction m_friction"),
        (new Span(-50, 50, 1e-6f, 1e9f), "force torque"),
        (_strength, "maxForce maxMotorForce maxMotorTorque m_maxMotorForce m_maxMotorTorque"),
        (new Span(0.5f, 8, 1e-6f, 1e6f), "frequencyHz frequency m_frequencyHz hz"),
        (new Span(0, 1, 1e-6f, 1e6f), "damping linearDamping angularDamping m_linearDamping m_angularDamping scale"),
        (new Span(0, 2, 1e-6f, 1e6f), "upper upperAngle upperTranslation m_upperAngle m_upperTranslation"),
        (new Span(-2, 0, 1e-6f, 1e6f), "lower lowerAngle lowerTranslation m_lowerAngle m_lowerTranslation"),
    }.SelectMany(r => r.Names.Split(' ').Select(n => (Name: n, r.Span))).ToDictionary(r => r.Name, r => r.Span, StringComparer.Ordinal);

    protected override IReadOnlyDictionary<string, (int Low, int High, int Least, int Most)> Integers { get; } = new Dictionary<string,
        (int, int, int, int)>(StringComparer.Ordinal)
    {
        ["count"] = (0, 4, -1, 8),
        ["maxCount"] = (0, 10, -1, 100),
        ["groupIndex"] = (-1, 1, -1000, 1000),
        ["categoryBits"] = (0, 15, 0, 65535),
        ["maskBits"] = (0, 65535, 0, 65535),
        ["vertexCount"] = (3, 8, -1, 10),
        ["frames"] = (1, 20, -1, 100),
        ["frame"] = (0, 4, -1, 200),
        ["bytes"] = (1, 1_000_000, -1, 10_000_000),
    };

    public override Func<IReadOnlyList<object>, Func<int, Type?>, Type?>? ResultOf(MethodBase method) =>
        method.Name is "CreateShape" or "CreateJoint" ? (arguments, typeOf) => typeOf((int)arguments[1]) is { } def
            ? _made.GetValueOrDefault(def) : null : null;

    protected override bool IsOptional(Type owner, string name) => name is "listener" or "filter" && owner == typeof(b2World);

    protected override Kind? Special(Type owner, string name, Type type) =>
        type == typeof(b2Vec2) ? SpanOf(owner, name) is { } span ? new PointKind(span, "b2Vec2", p => new b2Vec2(p.X, p.Y)) : null
        : type == typeof(b2Vec2[]) ? new OutlineKind(
            new Span(0.2f, 0.7f, 1e-6f, 1e6f),
            points => $"new b2Vec2[] {{ {points} }}",
            points => points.Select(p => new b2Vec2(p.X, p.Y)).ToArray())
        : type == typeof(float[]) ? new FreshKind("new float[1]", () => new float[1])
        : type == typeof(b2Shape[]) ? new FreshKind("new b2Shape[8]", () => new b2Shape[8])
        : type == typeof(List<b2Shape>) ? new FreshKind("new List<b2Shape>()", () => new List<b2Shape>())
        : null;
}
