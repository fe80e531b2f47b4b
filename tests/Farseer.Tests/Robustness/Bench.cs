using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using FarseerGames.FarseerPhysics.Mathematics;
using FarseerGames.FarseerPhysics.Views;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>A small scene in full swing, with an object of every public type to call and a valid argument of every type.</summary>
internal sealed class Bench
{
    private const float Dt = 0.01f;

    public Bench()
    {
        Simulator = new PhysicsSimulator(new Vector2(0, 100));
        Body floor = BodyFactory.Instance.CreateRectangleBody(Simulator, 400, 20, 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(Simulator, floor, 400, 20);
        Box = BodyFactory.Instance.CreateRectangleBody(Simulator, 20, 20, 1);
        Box.Position = new Vector2(0, -20);
        BoxGeom = GeomFactory.Instance.CreateRectangleGeom(Simulator, Box, 20, 20);
        BoxGeom.FrictionCoefficient = 0.5f;
        Ball = BodyFactory.Instance.CreateCircleBody(Simulator, 5, 2);
        Ball.Position = new Vector2(3, -44);
        Ball.LinearVelocity = new Vector2(1, 120);
        GeomFactory.Instance.CreateCircleGeom(Simulator, Ball, 5, 12);
        Step(5);
    }

    public PhysicsSimulator Simulator { get; }

    /// <summary>Rests on the floor.</summary>
    public Body Box { get; }

    public Geom BoxGeom { get; }

    /// <summary>Falls onto the box.</summary>
    public Body Ball { get; }

    public static Vertices Outline() => new Vertices { new Vector2(0, 0), new Vector2(0, 2), new Vector2(3, 2), new Vector2(3, 0) };

    private static Curve Slope()
    {
        var curve = new Curve();
        for (int i = 0; i < 6; i++)
        {
            curve.Keys.Add(new CurveKey(i, i * i));
        }

        return curve;
    }

    /// <summary>A row of links with geoms and hinges, in no simulator.</summary>
    private static Path Chain() =>
        ComplexFactory.Instance.CreateChain(new Vector2(100, 0), new Vector2(140, 0), 10, 4, 1, 1, LinkType.RevoluteJoint);

    private static SvgDebugDraw Picture() => new SvgDebugDraw(Vector2.Zero, Vector2.One, 10, 10);

    private static WaveController Wave()
    {
        var wave = new WaveController { NodeCount = 10, Width = 20, Height = 5 };
        wave.Initialize();
        return wave;
    }

    private RollbackBuffer Frames()
    {
        var buffer = new RollbackBuffer(Simulator, 4);
        buffer.Push();
        return buffer;
    }

    public void Step(int count)
    {
        for (int i = 0; i < count; i++)
        {
            Simulator.Update(Dt);
        }
    }

    /// <summary>The state after some more steps: long enough for the ball to hit the box.</summary>
    public ulong HashLater()
    {
        Step(12);
        return Simulator.MotionHash();
    }

    public void AssertSound()
    {
        foreach (Body body in Simulator.BodyList)
        {
            Assert.True(float.IsFinite(body.Position.X) && float.IsFinite(body.Position.Y) && float.IsFinite(body.Rotation));
            Assert.True(
                float.IsFinite(body.LinearVelocity.X) && float.IsFinite(body.LinearVelocity.Y) && float.IsFinite(body.AngularVelocity));
        }
    }

    /// <summary>The object whose members of <paramref name="type"/> are called; null if they are static or make one.</summary>
    public object? Target(Type type)
    {
        if (type.IsValueType)
        {
            return Activator.CreateInstance(type);
        }

        return type.Name switch
        {
            nameof(PhysicsSimulator) => Simulator,
            nameof(Body) => Box,
            nameof(Geom) => BoxGeom,
            nameof(BodyList) => Simulator.BodyList,
            nameof(GeomList) => Simulator.GeomList,
            nameof(JointList) => Simulator.JointList,
            "ItemList`1" => OwnList(),
            nameof(ArbiterList) => Simulator.ArbiterList,
            nameof(Arbiter) => Simulator.ArbiterList[0],
            nameof(BodyFactory) => BodyFactory.Instance,
            nameof(GeomFactory) => GeomFactory.Instance,
            nameof(JointFactory) => JointFactory.Instance,
            nameof(SpringFactory) => SpringFactory.Instance,
            nameof(ControllerFactory) => ControllerFactory.Instance,
            nameof(ComplexFactory) => ComplexFactory.Instance,
            nameof(Spring) => new FixedLinearSpring(new Body(), Vector2.Zero, Vector2.One, 1, 1),
            nameof(Controller) => new ExplosionController(),
            nameof(BodyController) or nameof(GravityController) => new GravityController(Vector2.Zero, 1, 1),
            nameof(WindController) => new WindController(Vector2.One, 1),
            nameof(VelocityLimitController) => new VelocityLimitController(1, 1),
            nameof(WaveController) => Wave(),
            nameof(Curve) => Slope(),
            nameof(CurveKeyCollection) => Slope().Keys,
            nameof(CurveKey) => new CurveKey(1, 2),
            nameof(SvgDebugDraw) => Picture(),
            nameof(PhysicsSimulatorView) => new PhysicsSimulatorView(Simulator, Picture()),
            nameof(RollbackBuffer) => Frames(),
            nameof(WorldBatch) => new WorldBatch(4, 1, 1, _ => new StillWorld(), 1),
            nameof(Grid) => BoxGeom.Grid,
            nameof(BilinearInterpolator) => new BilinearInterpolator(Vector2.Zero, Vector2.One),
            nameof(CircularInterpolator) => new CircularInterpolator(1, 2, 3, 4, 0, 5),
            _ => type.GetMethods().Length > 0 && !(type.IsAbstract && type.IsSealed) ? Valid(type, "") : null,
        };
    }

    /// <summary>An argument that is fine.</summary>
    public object? Valid(Type type, string name)
    {
        if (type == typeof(float) || type == typeof(double))
        {
            return Convert.ChangeType(name is "maxValue" or "max" ? 2 : 1, type);
        }

        if (type == typeof(Vector2))
        {
            return name is "end" or "max" or "point" or "axis" ? new Vector2(3, 4) : new Vector2(1, 2);
        }

        if (type == typeof(int))
        {
            return name == "index" ? 1 : 4;
        }

        if (type == typeof(long))
        {
            return 4L;
        }

        if (type.IsValueType)
        {
            return type == typeof(Matrix4x4) ? Matrix4x4.Identity : Activator.CreateInstance(type);
        }

        object? made = type.Name switch
        {
            nameof(PhysicsSimulator) => Simulator,
            nameof(Body) => new Body(),
            nameof(Geom) => GeomFactory.Instance.CreateRectangleGeom(new Body(), 2, 3),
            nameof(Vertices) => Outline(),
            nameof(AABB) => new AABB(Vector2.Zero, Vector2.One),
            nameof(ContactList) => new ContactList(4),
            nameof(Scaling) => new Scaling(0.01f, 0.1f),
            nameof(IBroadPhaseCollider) or nameof(LibraryCollider) => new BruteForceCollider(Simulator),
            nameof(Joint) or nameof(PairJoint) => new AngleJoint(new Body(), new Body()),
            nameof(AnchoredJoint) => new PinJoint(new Body(), Vector2.Zero, new Body(), Vector2.Zero),
            nameof(AxisJoint) => new WheelJoint(new Body(), new Body(), Vector2.Zero, Vector2.One),
            nameof(DrivenPairJoint) => new RevoluteJoint(new Body(), new Body(), Vector2.Zero),
            nameof(DrivenWorldJoint) => new FixedRevoluteJoint(new Body(), Vector2.Zero),
            nameof(WorldJoint) => new FixedAngleJoint(new Body()),
            nameof(Object) or nameof(String) => "something",
            nameof(IFluidContainer) => new AABBFluidContainer(new AABB(Vector2.Zero, Vector2.One)),
            nameof(Spring) => new FixedLinearSpring(),
            nameof(SpringFactory) => SpringFactory.Instance,
            nameof(Path) => Chain(),
            nameof(CurveKey) => new CurveKey(1, 2),
            nameof(SimulatorDefaults) => Simulator.Defaults,
            nameof(FixedStepDriver) => new FixedStepDriver(Simulator),
            nameof(CharacterMover) => new CharacterMover(new PhysicsSimulator(), Vector2.Zero, 4, 1),
            nameof(Vehicle) => Vehicle.Create(new PhysicsSimulator(), Vector2.Zero, 4, 10),
            nameof(Ragdoll) => Ragdoll.Create(new PhysicsSimulator(), Vector2.Zero, 4, 10),
            nameof(InspectionFinding) => null,
            nameof(StepEvents) => Simulator.Events,
            nameof(IStepScheduler) => new Behavior.HostThreads(0),
            nameof(IDebugDraw) => Picture(),
            nameof(Controller) => new ExplosionController(),
            _ => null,
        };
        return made ?? (type == typeof(uint[]) ? Enumerable.Repeat(uint.MaxValue, 16).ToArray()
            : type == typeof(CurveKey[]) ? new CurveKey[12]
            : type == typeof(Vector2[]) ? new[] { Vector2.Zero, Vector2.One }
            : type == typeof(Action<Arbiter>) ? (Action<Arbiter>)(_ => { })
            : type == typeof(Func<int, BatchedWorld>) ? (Func<int, BatchedWorld>)(_ => new StillWorld())
            : type == typeof(Func<PhysicsSimulator>) ? (Func<PhysicsSimulator>)(() => new PhysicsSimulator())
            : type == typeof(Action<PhysicsSimulator, int, float>) ? (Action<PhysicsSimulator, int, float>)((_, _, _) => { })
            : type == typeof(IEnumerable<Body>) ? Array.Empty<Body>()
            : type == typeof(IProgress<double>) ? new Progress<double>()
            : type == typeof(Predicate<Arbiter>) ? (Predicate<Arbiter>)(_ => false)
            : type.GetConstructor(new[] { typeof(PhysicsSimulator) }) is { } forSimulator ? forSimulator.Invoke(new object[] { Simulator })
            : type.GetConstructor(Type.EmptyTypes) is { } plain ? plain.Invoke(null)
            : typeof(Joint).IsAssignableFrom(type) ? NewJoint(type)
            : typeof(Delegate).IsAssignableFrom(type) ? null
            : throw new NotSupportedException("No valid " + type + " for " + name + ": add one."));
    }

    private static BodyList OwnList() =>
        new BodyList { new Body(), new Body(), new Body(), new Body(), new Body(), new Body(), new Body(), new Body() };

    private object NewJoint(Type type)
    {
        ConstructorInfo constructor = type.GetConstructors()[0];
        return constructor.Invoke(constructor.GetParameters().Select(p => Valid(p.ParameterType, p.Name!)).ToArray());
    }

    /// <summary>A world in which nothing is.</summary>
    private sealed class StillWorld : BatchedWorld
    {
        public StillWorld()
            : base(new PhysicsSimulator())
        {
        }

        public override void Act(ReadOnlySpan<float> action)
        {
        }

        public override void Observe(Span<float> observation) => observation.Clear();
    }
}
