using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Serialization.Tests;

/// <summary>A small scene with every shape, joint, spring and controller, and settings that are not the usual ones.</summary>
internal static class Everything
{
    public static PhysicsSimulator Build() => Build(out _);

    public static PhysicsSimulator Build(out FarseerGames.FarseerPhysics.Dynamics.Path path)
    {
        var simulator = new PhysicsSimulator(new Vector2(0.125f, -9.81f))
        {
            Iterations = 6, AdaptIterations = false, AllowedPenetration = 0.01f, BiasFactor = 0.7f, FrictionType = FrictionType.Minimum,
            RestitutionType = RestitutionType.Maximum, MaxContactsToDetect = 8, MaxContactsToResolve = 3, AllowSleep = true,
            TimeToSleep = 0.75f,
            SleepTolerance = 1f / 8192, EnableReport = true, RecordedEvents = StepEventKinds.Breaks | StepEventKinds.Sleep, HitSpeed = 2,
            KeepsPoses = true,
            SumImpulses = true, Quirks = Farseer201Quirks.SpringBreaksLate | Farseer201Quirks.JointBreaksLate,
            ErrorBudget = ErrorBudget.OfShare(0.01f, 8),
            Scaling = new Scaling(0.002f, 0.02f),
        };
        AddShapes(simulator);
        AddJoints(simulator);
        AddSprings(simulator);
        AddControllers(simulator);
        path = ComplexFactory.Instance.CreateChain(
            simulator, new Vector2(-40, 30), new Vector2(-30, 30), 1, 0.5f, 1, true, false, 2, LinkType.RevoluteJoint);

        // What is there keeps its own.
        simulator.Defaults.FrictionCoefficient = 0.25f;
        simulator.Defaults.RestitutionCoefficient = 0.125f;
        simulator.Defaults.LinearDragCoefficient = 0.5f;
        simulator.Defaults.RotationalDragCoefficient = 2;
        return simulator;
    }

    private static void AddShapes(PhysicsSimulator simulator)
    {
        Body floor = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        floor.IsStatic = true;
        floor.Name = "floor";
        GeomFactory.Instance.CreateChainGeom(simulator, floor, new Vertices(new Vector2[] { new(200, 0), new(0, 0), new(-200, 0) }), false)
            .SetSegmentMaterial(1, new SurfaceMaterial { Friction = 0.5f, Restitution = 0.1f, Speed = 1, RollingResistance = 0.01f });
        GeomFactory.Instance.CreateSegmentGeom(simulator, floor, new Vector2(-5, 9), new Vector2(-1, 8)).OneWayDirection = Vector2.UnitY;
        Body mixed = At(simulator, 0);
        GeomFactory.Instance.CreateCircleGeom(simulator, mixed, 0.5f, 24, new Vector2(0.25f, 0), 0.5f).Tag = "a tag with \"quotes\"\n";
        GeomFactory.Instance.CreateEllipseGeom(simulator, mixed, 0.5f, 0.25f, 16).CollisionCategories =
            CollisionCategory.Cat1 | CollisionCategory.Cat4;
        mixed.LinearVelocity = new Vector2(1, -0f);
        mixed.SetTotalRotation(20.123456789);
        mixed.SetPosition(1e7 + 0.123456789, 3);
        mixed.ApplyForce(new Vector2(1, 2));
        mixed.ApplyImpulseAtLocalPoint(new Vector2(0.1f, 0), new Vector2(0, 1));
        GeomFactory.Instance.CreateCapsuleGeom(
            simulator, At(simulator, 3), new Vector2(-1, 0), new Vector2(1, 0), 0.25f).RollingResistance = 0.1f;
        GeomFactory.Instance.CreateRoundedRectangleGeom(simulator, At(simulator, 6), 1, 0.5f, 0.1f).SurfaceSpeed = 0.5f;
        Geom l = GeomFactory.Instance.CreatePolygonGeom(
            simulator,
            At(simulator, 9),
            new Vertices(new Vector2[] { new(0, 0), new(2, 0), new(2, 1), new(1, 1), new(1, 2), new(0, 2) }),
            0.2f);
        l.IsSensor = true;
        Body locked = At(simulator, 12);
        locked.MotionLocks = MotionLocks.Rotation | MotionLocks.X;
        locked.GravityScale = 0.5f;
        locked.IterationFactor = 4;
        GeomFactory.Instance.CreateRectangleGeom(simulator, locked, 1, 1).CollisionGroup = 3;
        Body sleeper = At(simulator, 15);
        GeomFactory.Instance.CreateRectangleGeom(simulator, sleeper, 1, 2).FrictionCoefficient = 0.25f;
        sleeper.Position = new Vector2(15, 1);
        sleeper.Awake = false;

        // One that is in no simulator: its geom stands in the way of others.
        var still = new Body { Position = new Vector2(20, 1) };
        still.LinearVelocity = new Vector2(3, 0);
        GeomFactory.Instance.CreateRectangleGeom(simulator, still, 1, 1);
    }

    private static void AddJoints(PhysicsSimulator simulator)
    {
        float x = 30;
        (Body, Body) Two()
        {
            x += 6;
            return (Square(simulator, x), Square(simulator, x + 2));
        }

        void Add(Joint joint)
        {
            joint.Tag = joint.GetType().Name;
            joint.Softness = 0.001f;
            joint.BiasFactor = 0.3f;
            joint.Breakpoint = 1000;
            simulator.Add(joint);
        }

        (Body a, Body b) = Two();
        Add(new AngleJoint(a, b, 0.1f) { MaxImpulse = 5 });
        (a, b) = Two();
        Add(new AngleLimitJoint(a, b, -0.5f, 0.5f) { Slop = 0.02f });
        (a, b) = Two();
        Add(new DistanceJoint(
            a,
            new Vector2(0.1f, 0),
            b,
            Vector2.Zero) { Frequency = 2, DampingRatio = 0.3f, AreLimitsEnabled = true, LowerLimit = 1, UpperLimit = 3 });
        Add(new FixedAngleJoint(Square(simulator, x += 6), 0.2f));
        Add(new FixedAngleLimitJoint(Square(simulator, x += 6), -0.1f, 0.1f));
        b = Square(simulator, x += 6);
        b.Rotation = 0.3f;
        Add(new FixedPrismaticJoint(
            b, b.Position + new Vector2(0.3f, 0.1f), new Vector2(3, 1)) { IsMotorEnabled = true, MotorSpeed = 1, MaxMotorForce = 10 });
        b = Square(simulator, x += 6);
        Add(new FixedRevoluteJoint(b, b.Position + new Vector2(0.3f, 0.1f)) { AreLimitsEnabled = true, LowerLimit = -1, UpperLimit = 1 });
        (a, b) = Two();
        a.Rotation = 0.7f;
        Add(new GearJoint(a, b, 2));
        (a, b) = Two();
        Add(new MotorJoint(a, b) { MaxForce = 20, MaxTorque = 10, Offset = new Vector2(2, 0.5f) });
        (a, b) = Two();
        Add(new PinJoint(a, Vector2.Zero, b, new Vector2(0, 0.2f)));
        (a, b) = Two();
        a.Rotation = 0.2f;
        Add(new PrismaticJoint(
            a, b, new Vector2(x + 1, 5), new Vector2(1, 2)) { AreLimitsEnabled = true, LowerLimit = -1, UpperLimit = 1 });
        (a, b) = Two();
        Add(new PulleyJoint(a, new Vector2(x, 12), Vector2.Zero, b, new Vector2(x + 2, 12), Vector2.Zero, 1.5f));
        (a, b) = Two();
        b.Rotation = -0.4f;
        Add(new RevoluteJoint(
            a, b, new Vector2(x + 1, 5.1f)) { IsMotorEnabled = true, MotorSpeed = 3, MaxMotorTorque = 7, CollideConnected = false });
        (a, b) = Two();
        Add(new RopeJoint(a, Vector2.Zero, b, Vector2.Zero, 2.5f));
        (a, b) = Two();
        Add(new SliderJoint(a, Vector2.Zero, b, Vector2.Zero, 1, 2.25f));
        b = Square(simulator, x += 6);
        Add(new TargetJoint(b, b.Position + new Vector2(0.1f, 0.1f)) { MaxForce = 100, Target = b.Position + Vector2.One });
        (a, b) = Two();
        b.Rotation = 0.25f;
        Add(new WeldJoint(a, b, new Vector2(x + 1, 5)) { Frequency = 4, DampingRatio = 0.5f });
        (a, b) = Two();
        Add(new WheelJoint(
            a,
            b,
            b.Position,
            new Vector2(0, 1)) { Frequency = 3, MaxMotorTorque = 2, IsMotorEnabled = true, MotorSpeed = -1, Enabled = false });
    }

    private static void AddSprings(PhysicsSimulator simulator)
    {
        Body a = Square(simulator, -10);
        Body b = Square(simulator, -13);
        simulator.Add(
            new LinearSpring(a, new Vector2(0.1f, 0), b, Vector2.Zero, 20, 1) { RestLength = 2, Breakpoint = 50, Tag = "spring" });
        simulator.Add(new AngleSpring(
            a, b, 10, 0.5f) { TargetAngle = 0.3f, MaxTorque = 5, TorqueMultiplier = 0.9f, Anchor1 = Vector2.One, Tag = "turn" });
        simulator.Add(new FixedLinearSpring(a, Vector2.Zero, new Vector2(-10, 9), 15, 1) { Tag = "fixed" });
        simulator.Add(new FixedAngleSpring(b, 5, 0.2f) { TargetAngle = 0.1f, Tag = "fixed turn" });
    }

    private static void AddControllers(PhysicsSimulator simulator)
    {
        var wave = new WaveController
        {
            Position = new Vector2(-60, -2), Width = 20, Height = 4, NodeCount = 21, Frequency = 0.02f, WaveGeneratorMax = 1,
            WaveGeneratorMin = -1,
            WaveGeneratorStep = 0.3f, Tag = "wave",
        };
        wave.Initialize();
        wave.Disturb(10, 0.5f);
        Body floater = Square(simulator, -50);
        floater.Position = new Vector2(-50, 0.5f);
        var fluid = new FluidDragController { Tag = "fluid" };
        fluid.Initialize(wave, 1.5f, 0.5f, 0.25f, simulator.Gravity);
        fluid.AddGeom(floater.Geoms[0]);
        simulator.Add(fluid);
        simulator.Add(wave);
        var basin = new FluidDragController();
        basin.Initialize(new AABBFluidContainer(new AABB(new Vector2(-80, -5), new Vector2(-70, 2))), 1, 1, 1, simulator.Gravity);
        simulator.Add(basin);
        var blast = new ExplosionController { Tag = "blast" };
        blast.Explode(new Vector2(-12, 4), 10, 0.5f);
        simulator.Add(blast);
        simulator.Add(new GravityController(new Vector2(0, 100), 3, 1) { MaxRadius = 500, Tag = "pull" });
        simulator.Add(new VelocityLimitController(50, 20) { Tag = "limit" });
        simulator.Add(
            new WindController(new Vector2(1, 0), 0.1f) { Area = new AABB(new Vector2(-100, 0), new Vector2(100, 50)), Tag = "wind" });
        simulator.InactivityController.MaxIdleTime = 2000;
    }

    private static Body At(PhysicsSimulator simulator, float x)
    {
        Body body = BodyFactory.Instance.CreateBody(simulator, 1.5f, 0.75f);
        body.Position = new Vector2(x, 4);
        return body;
    }

    private static Body Square(PhysicsSimulator simulator, float x)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 2);
        body.Position = new Vector2(x, 5);
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1).RestitutionCoefficient = 0.2f;
        return body;
    }
}
