using System.Numerics;
using System.Threading;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using FarseerGames.FarseerPhysics.Porting;

// The manual's own names, which say what they are called today.
#pragma warning disable CS0618

namespace Farseer.Tests.Porting;

/// <summary>
/// What the listings of the manual do, with its names, under nothing but the <c>using</c> lines above. A method is a listing, by the
/// heading under which it stands.
/// </summary>
public static class ManualListings
{
    public static void Overview_TheLoop()
    {
        var physicsSimulator = new PhysicsSimulator(new Vector2(0, 100));
        var body = BodyFactory.Instance.CreateRectangleBody(128, 128, 1);
        physicsSimulator.Add(body);
        for (int frame = 0; frame < 10; frame++)
        {
            body.ApplyForce(new Vector2(10, 0));
            body.ApplyTorque(100);
            physicsSimulator.Update(0.01f);
        }
    }

    public static void Body_ByHand()
    {
        var physicsSimulator = new PhysicsSimulator(new Vector2(0, 0));
        Body rectBody = new Body();
        rectBody.Mass = 1;
        rectBody.MomentOfInertia = 1f * ((128f * 128f) + (128f * 128f)) / 12f;
        rectBody.Position = new Vector2(100, 100);
        physicsSimulator.Add(rectBody);
    }

    public static void BodyFactory_AddedAtOnce()
    {
        var physicsSimulator = new PhysicsSimulator(new Vector2(0, 0));
        Body rectBody = BodyFactory.Instance.CreateRectangleBody(physicsSimulator, 128, 128, 1);
        Body circleBody = BodyFactory.Instance.CreateCircleBody(physicsSimulator, 64, 1);
        Body polygonBody = BodyFactory.Instance.CreatePolygonBody(physicsSimulator, Vertices.CreateRectangle(128, 128), 1);
        Body body = BodyFactory.Instance.CreateBody(physicsSimulator, 1, 100);
        Body clone = BodyFactory.Instance.CreateBody(physicsSimulator, rectBody);
        physicsSimulator.Update(0.01f);
    }

    public static void BodyFactory_AddedLater()
    {
        var physicsSimulator = new PhysicsSimulator(new Vector2(0, 0));
        physicsSimulator.Add(BodyFactory.Instance.CreateRectangleBody(128, 128, 1));
        physicsSimulator.Add(BodyFactory.Instance.CreateCircleBody(64, 1));
        physicsSimulator.Add(BodyFactory.Instance.CreatePolygonBody(Vertices.CreateRectangle(128, 128), 1));
        physicsSimulator.Add(BodyFactory.Instance.CreateBody(1, 100));
    }

    public static void Geometry_ByVertices()
    {
        var physicsSimulator = new PhysicsSimulator(new Vector2(0, 0));
        Body rectBody = BodyFactory.Instance.CreateRectangleBody(physicsSimulator, 128, 128, 1);
        Vertices vertices = new Vertices();
        vertices.Add(new Vector2(-64, -64));
        vertices.Add(new Vector2(64, -64));
        vertices.Add(new Vector2(64, 64));
        vertices.Add(new Vector2(-64, 64));
        Geom rectGeom = new Geom(rectBody, vertices, 11);
        physicsSimulator.Add(rectGeom);
    }

    public static void GeomFactory_Shapes()
    {
        var physicsSimulator = new PhysicsSimulator(new Vector2(0, 0));
        Body rectBody = BodyFactory.Instance.CreateRectangleBody(physicsSimulator, 128, 128, 1);
        Geom rectGeom = GeomFactory.Instance.CreateRectangleGeom(physicsSimulator, rectBody, 128, 128);
        Geom circleGeom = GeomFactory.Instance.CreateCircleGeom(physicsSimulator, rectBody, 64, 20);
        Geom ellipseGeom = GeomFactory.Instance.CreateEllipseGeom(physicsSimulator, rectBody, 64, 32, 20);
        Geom polygonGeom = GeomFactory.Instance.CreatePolygonGeom(physicsSimulator, rectBody, Vertices.CreateRectangle(128, 128), 10);
    }

    public static void Joints_ByFactory()
    {
        (PhysicsSimulator physicsSimulator, Body body1, Body body2) = Pair();
        RevoluteJoint revolute = JointFactory.Instance.CreateRevoluteJoint(physicsSimulator, body1, body2, new Vector2(100, 0));
        AngleJoint angle = JointFactory.Instance.CreateAngleJoint(physicsSimulator, body1, body2, 0, 0.2f);
        AngleLimitJoint limit = JointFactory.Instance.CreateAngleLimitJoint(physicsSimulator, body1, body2, -1, 1);
        PinJoint pin = JointFactory.Instance.CreatePinJoint(physicsSimulator, body1, new Vector2(0, 0), body2, new Vector2(0, 0));
        SliderJoint slider =
            JointFactory.Instance.CreateSliderJoint(physicsSimulator, body1, new Vector2(0, 0), body2, new Vector2(0, 0), 150, 250);
        physicsSimulator.Update(0.01f);
        Vector2 anchor = revolute.CurrentAnchor;
        revolute.Broke += (sender, args) => { };
        revolute.Breakpoint = float.MaxValue;
        revolute.BiasFactor = 0.2f;
        revolute.Softness = 0;
        limit.LowerLimit = -0.5f;
        limit.UpperLimit = 0.5f;
        limit.Slop = 0.01f;
        pin.TargetDistance = 200;
        slider.TargetDistance = 200;
        slider.Min = 150;
        slider.Max = 250;
        angle.TargetAngle = 0;
        angle.MaxImpulse = 100;
    }

    public static void Joints_Fixed()
    {
        (PhysicsSimulator physicsSimulator, Body body, _) = Pair();
        FixedRevoluteJoint revolute = JointFactory.Instance.CreateFixedRevoluteJoint(physicsSimulator, body, new Vector2(0, 0));
        FixedAngleJoint angle = JointFactory.Instance.CreateFixedAngleJoint(physicsSimulator, body);
        FixedAngleLimitJoint limit = JointFactory.Instance.CreateFixedAngleLimitJoint(physicsSimulator, body, -1, 1);
        revolute.SetInitialAnchor(new Vector2(10, 0));
        angle.TargetAngle = 0.5f;
        physicsSimulator.Update(0.01f);
        Vector2 anchor = revolute.CurrentAnchor;
        limit.Dispose();
    }

    public static void Joints_Gear()
    {
        (PhysicsSimulator physicsSimulator, Body body1, Body body2) = Pair();
        GearJoint gear = new GearJoint(body1, body2, 2);
        gear.Ratio = 3;
        gear.MaxImpulse = 100;
        physicsSimulator.Add(gear);
        physicsSimulator.Update(0.01f);
    }

    public static void Springs_ByFactory()
    {
        (PhysicsSimulator physicsSimulator, Body body1, Body body2) = Pair();
        LinearSpring linear = SpringFactory.Instance.CreateLinearSpring(
            physicsSimulator: physicsSimulator,
            body1: body1,
            anchor1: new Vector2(0, 0),
            body2: body2,
            anchor2: new Vector2(0, 0),
            springConstant: 50,
            dampningConstant: 2);
        AngleSpring angle =
            SpringFactory.Instance.CreateAngleSpring(physicsSimulator, body1, body2, springConstant: 50, dampningConstant: 2);
        linear.DampningConstant = 3;
        linear.SpringConstant = 60;
        linear.Anchor1 = new Vector2(1, 0);
        linear.Anchor2 = new Vector2(-1, 0);
        linear.Breakpoint = 1000;
        linear.Broke += (sender, args) => { };
        physicsSimulator.Update(0.01f);
        float error = linear.SpringError;
        angle.Dispose();
    }

    public static void Springs_Fixed()
    {
        (PhysicsSimulator physicsSimulator, Body body, _) = Pair();
        FixedLinearSpring linear = SpringFactory.Instance.CreateFixedLinearSpring(
            physicsSimulator, body, anchor1: new Vector2(0, 0), anchor2: new Vector2(0, 50), springConstant: 50, dampningConstant: 2);
        FixedAngleSpring angle =
            SpringFactory.Instance.CreateFixedAngleSpring(physicsSimulator, body, springConstant: 50, dampningConstant: 2);
        linear.WorldAttachPoint = new Vector2(10, 50);
        physicsSimulator.Update(0.01f);
    }

    public static void Springs_NotAdded()
    {
        (PhysicsSimulator physicsSimulator, Body body1, Body body2) = Pair();
        physicsSimulator.Add(SpringFactory.Instance.CreateLinearSpring(
            body1, anchor1: new Vector2(0, 0), body2: body2, anchor2: new Vector2(0, 0), springConstant: 50, dampningConstant: 2));
        physicsSimulator.Add(SpringFactory.Instance.CreateAngleSpring(body1, body2, springConstant: 50, dampningConstant: 2));
        physicsSimulator.Add(SpringFactory.Instance.CreateFixedAngleSpring(body1, springConstant: 50, dampningConstant: 2));
        physicsSimulator.Add(SpringFactory.Instance.CreateFixedLinearSpring(
            body2, anchor1: new Vector2(0, 0), anchor2: new Vector2(0, 50), springConstant: 50, dampningConstant: 2));
        physicsSimulator.Update(0.01f);
    }

    public static void BroadPhase_Chosen()
    {
        var physicsSimulator = new PhysicsSimulator(new Vector2(0, 0));
        physicsSimulator.BroadPhaseCollider = new SweepAndPruneCollider(physicsSimulator);
        physicsSimulator.BroadPhaseCollider = new BruteForceCollider(physicsSimulator);
        physicsSimulator.BroadPhaseCollider = new SelectiveSweepCollider(physicsSimulator);
        physicsSimulator.Update(0.01f);
    }

    public static void Aabb_AndGrid()
    {
        (PhysicsSimulator physicsSimulator, Body body1, Body body2) = Pair();
        Geom geom1 = GeomFactory.Instance.CreateRectangleGeom(physicsSimulator, body1, 128, 128);
        Geom geom2 = GeomFactory.Instance.CreateRectangleGeom(physicsSimulator, body2, 128, 128);
        physicsSimulator.Update(0.01f);
        bool overlap = AABB.Intersect(geom1.AABB, geom2.AABB);
        Grid grid = geom1.Grid;
    }

    public static void Group_OfTwo()
    {
        (PhysicsSimulator physicsSimulator, Body body1, Body body2) = Pair();
        Geom geom1 = GeomFactory.Instance.CreateRectangleGeom(physicsSimulator, body1, 128, 128);
        Geom geom2 = GeomFactory.Instance.CreateRectangleGeom(physicsSimulator, body2, 128, 128);
        geom1.CollisionGroup = 10;
        geom2.CollisionGroup = 10;
        physicsSimulator.Update(0.01f);
    }

    public static void Categories_OfTwo()
    {
        (PhysicsSimulator physicsSimulator, Body body1, Body body2) = Pair();
        Geom rectGeom = GeomFactory.Instance.CreateRectangleGeom(physicsSimulator, body1, 128, 128);
        Geom circleGeom = GeomFactory.Instance.CreateCircleGeom(physicsSimulator, body2, 64, 20);
        rectGeom.CollisionCategory = CollisionCategories.Cat5;
        rectGeom.CollidesWith = CollisionCategories.All & ~CollisionCategories.Cat4;
        circleGeom.CollisionCategories = CollisionCategory.Cat4;
        circleGeom.CollidesWith = CollisionCategory.All & ~CollisionCategory.Cat5;
        physicsSimulator.Update(0.01f);
    }

    public static void Events_Handlers()
    {
        (PhysicsSimulator physicsSimulator, Body body1, Body body2) = Pair();
        Geom rectGeom = GeomFactory.Instance.CreateRectangleGeom(physicsSimulator, body1, 128, 128);
        GeomFactory.Instance.CreateRectangleGeom(physicsSimulator, body2, 128, 128);
        rectGeom.OnCollision += OnCollision;
        rectGeom.OnSeparation += OnSeparation;
        physicsSimulator.BroadPhaseCollider.OnBroadPhaseCollision += OnBroadPhaseCollision;
        physicsSimulator.Update(0.01f);
    }

    public static void Impulses_Calls()
    {
        (PhysicsSimulator physicsSimulator, Body body, _) = Pair();
        body.ApplyForce(new Vector2(0, 10));
        body.ApplyForceAtLocalPoint(new Vector2(0, 10), new Vector2(5, 0));
        body.ApplyForceAtWorldPoint(new Vector2(0, 10), new Vector2(5, 0));
        body.ApplyImpulse(new Vector2(0, 10));
        body.ApplyAngularImpulse(10);
        body.ApplyTorque(10);
        body.ClearForce();
        body.ClearImpulse();
        body.ClearTorque();
        physicsSimulator.Update(0.01f);
    }

    public static void Performance_Pool()
    {
        Pool<Body> pool = new Pool<Body>();
        Body body = pool.Fetch();
        body.Enabled = false;
        pool.Insert(body);
    }

    public static void Performance_ByReference()
    {
        (PhysicsSimulator physicsSimulator, Body body, _) = Pair();
        Vector2 force = new Vector2(1, 0);
        for (int i = 0; i < 100; i++)
        {
            body.ApplyForce(ref force);
        }

        Vector2 a = new Vector2(5, 5);
        Vector2 b = Vector2.Zero;
        Vector2 difference;
        Vector2.Subtract(ref a, ref b, out difference);
        difference.X = a.X - b.X;
        difference.Y = a.Y - b.Y;
    }

    public static void Performance_Thread()
    {
        (PhysicsSimulator physicsSimulator, _, _) = Pair();
        var thread = new Thread(() => physicsSimulator.Update(0.01f));
        thread.Start();
        thread.Join();
    }

    public static void Performance_Inactivity()
    {
        (PhysicsSimulator physicsSimulator, Body body, _) = Pair();
        physicsSimulator.InactivityController.Enabled = true;
        physicsSimulator.InactivityController.MaxIdleTime = 3000;
        body.IsAutoIdle = true;
        physicsSimulator.Update(0.01f);
    }

    public static void KnownIssues_SubDividedEdges()
    {
        var physicsSimulator = new PhysicsSimulator(new Vector2(0, 0));
        Vertices vertices = Vertices.CreateRectangle(128, 128);
        vertices.SubDivideEdges(10);
        Body body = BodyFactory.Instance.CreatePolygonBody(physicsSimulator, vertices, 1);
        Geom geom = GeomFactory.Instance.CreatePolygonGeom(physicsSimulator, body, vertices, 11);
    }

    public static void KnownIssues_Offset()
    {
        var physicsSimulator = new PhysicsSimulator(new Vector2(0, 0));
        Vertices vertices = Vertices.CreateRectangle(128, 128);
        Body body = BodyFactory.Instance.CreatePolygonBody(physicsSimulator, vertices, 1);
        Geom geom = GeomFactory.Instance.CreatePolygonGeom(physicsSimulator, body, vertices, new Vector2(10, 0), 0, 11);
    }

    private static bool OnCollision(Geom geometry1, Geom geometry2, ContactList contactList) => true;

    private static void OnSeparation(Geom geometry1, Geom geometry2)
    {
    }

    private static bool OnBroadPhaseCollision(Geom geometry1, Geom geometry2) => true;

    private static (PhysicsSimulator Simulator, Body Body1, Body Body2) Pair()
    {
        var physicsSimulator = new PhysicsSimulator(new Vector2(0, 0));
        Body body1 = BodyFactory.Instance.CreateRectangleBody(physicsSimulator, 128, 128, 1);
        Body body2 = BodyFactory.Instance.CreateRectangleBody(physicsSimulator, 128, 128, 1);
        body2.Position = new Vector2(200, 0);
        return (physicsSimulator, body1, body2);
    }
}
