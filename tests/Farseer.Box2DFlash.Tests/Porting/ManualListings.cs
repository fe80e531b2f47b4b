using System;
using System.Collections.Generic;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using b2Vec = Box2D.Common.Math.b2Vec2;

// The manual's own names, which say what they are called today.
#pragma warning disable CS0618
#nullable disable

namespace Farseer.Box2DFlash.Tests.Porting;

/// <summary>
/// What the listings of the manual do, with its names, under nothing but the <c>using</c> lines above. A method is a listing, by the
/// heading under which it stands; Hello Box2D is in <see cref="HelloWorld"/>.
/// </summary>
public static class ManualListings
{
    public static void HelloBox2D() => HelloWorld.Run();

    public static void ApiDesign_UserData()
    {
        var actor = new GameActor();
        var bodyDef = new b2BodyDef();
        bodyDef.userData = actor;
        actor.body = World().CreateBody(bodyDef);
    }

    public static void World_Simulation()
    {
        var myWorld = World();
        var timeStep = 1.0f / 60.0f;
        var iterationCount = 10;
        myWorld.Step(timeStep, iterationCount);
    }

    public static void World_WakeAllBodies()
    {
        var myWorld = World();
        Box(myWorld, 0, 4);
        for (var b = myWorld.GetBodyList(); b; b = b.GetNext())
        {
            b.WakeUp();
        }
    }

    public static void World_DestroyWhileWalking()
    {
        var myWorld = World();
        Box(myWorld, 0, 4).SetUserData(new GameActor { isDead = true });
        var node = myWorld.GetBodyList();
        while (node)
        {
            var b = node;
            node = node.GetNext();
            if (b.GetUserData() is GameActor { isDead: true })
            {
                myWorld.DestroyBody(b);
            }
        }
    }

    public static void World_AabbQuery()
    {
        var myWorld = World();
        Box(myWorld, 0, 0);
        myWorld.Step(1 / 60f, 10);
        var aabb = new b2AABB();
        aabb.lowerBound.Set(-1.0f, -1.0f);
        aabb.upperBound.Set(1.0f, 1.0f);
        var k_bufferSize = 10;
        var buffer = new b2Shape[k_bufferSize];
        var count = myWorld.Query(aabb, buffer, k_bufferSize);
        for (var i = 0; i < count; ++i)
        {
            buffer[i].GetBody().WakeUp();
        }
    }

    public static void Bodies_Definition()
    {
        var bodyDef = new b2BodyDef();
        bodyDef.massData.mass = 2.0f;
        bodyDef.massData.center.SetZero();
        bodyDef.massData.I = 3.0f;
        bodyDef.position.Set(0.0f, 2.0f);
        bodyDef.angle = 0.25f * (float)Math.PI;
        bodyDef.linearDamping = 0.0f;
        bodyDef.angularDamping = 0.1f;
        bodyDef.allowSleep = true;
        bodyDef.isSleeping = false;
        bodyDef.fixedRotation = true;
        bodyDef.isBullet = true;
        World().CreateBody(bodyDef);
    }

    public static void Bodies_Factory()
    {
        var myWorld = World();
        var bodyDef = new b2BodyDef();
        var dynamicBody = myWorld.CreateBody(bodyDef);
        myWorld.DestroyBody(dynamicBody);
        dynamicBody = null;
        var ground = myWorld.GetGroundBody();
    }

    public static void Bodies_Using()
    {
        var body = Box(World(), 0, 4);
        body.SetMassFromShapes();
        body.SetMass(new b2MassData { mass = 2, I = 1 });
        var mass = body.GetMass() + body.GetInertia();
        b2Vec center = body.GetLocalCenter();
        body.SetBullet(body.IsBullet());
        bool any = body.IsStatic() || body.IsDynamic() || body.IsFrozen() || body.IsSleeping();
        body.AllowSleeping(true);
        body.WakeUp();
        body.SetXForm(new b2Vec2(1, 5), 0.5f);
        b2XForm xf = body.GetXForm();
        b2Vec2 place = body.GetPosition();
        float angle = body.GetAngle();
        b2Vec2 middle = body.GetWorldCenter();
        body.SetLinearVelocity(new b2Vec2(1, 0));
        b2Vec2 velocity = body.GetLinearVelocity();
        body.SetAngularVelocity(1);
        float spin = body.GetAngularVelocity();
        body.ApplyForce(new b2Vec2(1, 0), middle);
        body.ApplyTorque(1);
        body.ApplyImpulse(new b2Vec2(1, 0), middle);
        b2Vec2 point = body.GetLocalPoint(body.GetWorldPoint(new b2Vec2(1, 0)));
        b2Vec2 vector = body.GetLocalVector(body.GetWorldVector(new b2Vec2(1, 0)));
    }

    public static void Bodies_Shapes()
    {
        var body = Box(World(), 0, 4);
        for (var s = body.GetShapeList(); s; s = s.GetNext())
        {
            var data = s.GetUserData();
        }
    }

    public static void Shapes_Definition()
    {
        var shapeDef = new b2CircleDef();
        shapeDef.friction = 0.3f;
        shapeDef.restitution = 0.5f;
        shapeDef.density = 1;
        shapeDef.isSensor = true;
        var body = World().CreateBody(new b2BodyDef());
        body.CreateShape(shapeDef);
        body.SetMassFromShape();
    }

    public static void Shapes_Filtering()
    {
        var playerShapeDef = new b2CircleDef();
        var monsterShapeDef = new b2CircleDef();
        playerShapeDef.filter.categoryBits = 0x0002;
        monsterShapeDef.filter.categoryBits = 0x0004;
        playerShapeDef.filter.maskBits = 0x0004;
        monsterShapeDef.filter.maskBits = 0x0002;
        playerShapeDef.filter.groupIndex = 2;
        monsterShapeDef.filter.groupIndex = -8;
    }

    public static void Shapes_Refilter()
    {
        var world = World();
        var shape = Box(world, 0, 4).GetShapeList();
        var filter = shape.GetFilterData();
        filter.groupIndex = -1;
        shape.SetFilterData(filter);
        world.Refilter(shape);
    }

    public static void Shapes_Circle()
    {
        var def = new b2CircleDef();
        def.radius = 1.5f;
        def.localPosition.Set(1.0f, 0.0f);
        World().CreateBody(new b2BodyDef()).CreateShape(def);
    }

    public static void Shapes_Triangle()
    {
        var triangleDef = new b2PolygonDef();
        triangleDef.vertexCount = 3;
        triangleDef.vertices[0].Set(-1.0f, 0.0f);
        triangleDef.vertices[1].Set(1.0f, 0.0f);
        triangleDef.vertices[2].Set(0.0f, 2.0f);
        World().CreateBody(new b2BodyDef()).CreateShape(triangleDef);
    }

    public static void Shapes_Boxes()
    {
        var def = new b2PolygonDef();
        def.SetAsBox(1, 2);
        def.SetAsOrientedBox(1, 2, new b2Vec2(1, 0), 0.5f);
        World().CreateBody(new b2BodyDef()).CreateShape(def);
    }

    public static void Shapes_FactoryAndPoint()
    {
        var myBody = World().CreateBody(new b2BodyDef());
        var circleDef = new b2CircleDef();
        circleDef.radius = 3.0f;
        circleDef.density = 2.5f;
        var myShape = myBody.CreateShape(circleDef);
        bool hit = myShape.TestPoint(b2Math.b2XForm_identity, new b2Vec2(5.0f, 2.0f));
        bool isCircle = myShape.GetType() == b2Shape.e_circleShape;
        myBody.DestroyShape(myShape);
    }

    public static void Joints_Distance()
    {
        (b2World world, b2Body myBody1, b2Body myBody2) = Pair();
        var jointDef = new b2DistanceJointDef();
        jointDef.Initialize(myBody1, myBody2, myBody1.GetPosition(), myBody2.GetPosition());
        jointDef.collideConnected = true;
        world.CreateJoint(jointDef);
    }

    public static void Joints_Revolute()
    {
        (b2World world, b2Body myBody1, b2Body myBody2) = Pair();
        var jointDef = new b2RevoluteJointDef();
        jointDef.Initialize(myBody1, myBody2, myBody1.GetWorldCenter());
        jointDef.lowerAngle = -0.5f * b2Settings.b2_pi;
        jointDef.upperAngle = 0.25f * b2Settings.b2_pi;
        jointDef.enableLimit = true;
        jointDef.maxMotorTorque = 10.0f;
        jointDef.motorSpeed = 0.0f;
        jointDef.enableMotor = true;
        world.CreateJoint(jointDef);
    }

    public static void Joints_Prismatic()
    {
        (b2World world, b2Body myBody1, b2Body myBody2) = Pair();
        var jointDef = new b2PrismaticJointDef();
        var worldAxis = new b2Vec2(1.0f, 0.0f);
        jointDef.Initialize(myBody1, myBody2, myBody1.GetWorldCenter(), worldAxis);
        jointDef.lowerTranslation = -5.0f;
        jointDef.upperTranslation = 2.5f;
        jointDef.enableLimit = true;
        jointDef.maxMotorForce = 1.0f;
        jointDef.motorSpeed = 0.0f;
        jointDef.enableMotor = true;
        var joint = (b2PrismaticJoint)world.CreateJoint(jointDef);
        joint.SetMotorForce(2);
        joint.SetMotorSpeed(1);
        float translation = joint.GetJointTranslation() + joint.GetJointSpeed() + joint.GetMotorForce();
    }

    public static void Joints_Pulley()
    {
        (b2World world, b2Body myBody1, b2Body myBody2) = Pair();
        var anchor1 = myBody1.GetWorldCenter();
        var anchor2 = myBody2.GetWorldCenter();
        var groundAnchor1 = new b2Vec2(anchor1.x, anchor1.y + 10.0f);
        var groundAnchor2 = new b2Vec2(anchor2.x, anchor2.y + 12.0f);
        var ratio = 1.0f;
        var jointDef = new b2PulleyJointDef();
        jointDef.Initialize(myBody1, myBody2, groundAnchor1, groundAnchor2, anchor1, anchor2, ratio);
        jointDef.maxLength1 = 18.0f;
        jointDef.maxLength2 = 20.0f;
        var joint = (b2PulleyJoint)world.CreateJoint(jointDef);
        float length = joint.GetLength1() + joint.GetLength2();
    }

    public static void Joints_Gear()
    {
        (b2World world, b2Body myBody1, b2Body myBody2) = Pair();
        var revolute = new b2RevoluteJointDef();
        revolute.Initialize(world.GetGroundBody(), myBody1, myBody1.GetWorldCenter());
        var prismatic = new b2PrismaticJointDef();
        prismatic.Initialize(world.GetGroundBody(), myBody2, myBody2.GetWorldCenter(), new b2Vec2(1, 0));
        var jointDef = new b2GearJointDef();
        jointDef.body1 = myBody1;
        jointDef.body2 = myBody2;
        jointDef.joint1 = world.CreateJoint(revolute);
        jointDef.joint2 = world.CreateJoint(prismatic);
        jointDef.ratio = 2.0f * b2Settings.b2_pi / 5;
        world.CreateJoint(jointDef);
    }

    public static void Joints_Mouse()
    {
        (b2World world, b2Body myBody, _) = Pair();
        var jointDef = new b2MouseJointDef();
        jointDef.body1 = world.GetGroundBody();
        jointDef.body2 = myBody;
        jointDef.target = myBody.GetWorldCenter();
        jointDef.maxForce = 1000 * myBody.GetMass();
        var joint = (b2MouseJoint)world.CreateJoint(jointDef);
        joint.SetTarget(new b2Vec2(1, 5));
    }

    public static void Joints_Lifetime()
    {
        (b2World myWorld, b2Body myBody1, b2Body myBody2) = Pair();
        var jointDef = new b2RevoluteJointDef();
        jointDef.body1 = myBody1;
        jointDef.body2 = myBody2;
        jointDef.anchorPoint = myBody1.GetCenterPosition();
        var joint = (b2RevoluteJoint)myWorld.CreateJoint(jointDef);
        myWorld.DestroyJoint(joint);
        joint = null;
    }

    public static void Joints_MotorControl()
    {
        (b2World world, b2Body myBody1, b2Body myBody2) = Pair();
        var jointDef = new b2RevoluteJointDef();
        jointDef.Initialize(myBody1, myBody2, myBody1.GetWorldCenter());
        jointDef.enableMotor = true;
        jointDef.maxMotorTorque = 100;
        var myJoint = (b2RevoluteJoint)world.CreateJoint(jointDef);
        var angleTarget = 0.5f;
        for (var time = 0f; time < 1; time += 1 / 60f)
        {
            myJoint.SetMotorSpeed((float)Math.Cos(0.5f * time));
            world.Step(1 / 60f, 10);
            var angleError = myJoint.GetJointAngle() - angleTarget;
            var gain = 0.1f;
            myJoint.SetMotorSpeed(-gain * angleError);
        }

        myJoint.SetMaxMotorTorque(50);
        float torque = myJoint.GetMotorTorque() + myJoint.GetJointSpeed() + myJoint.GetReactionTorque();
        b2Vec2 force = myJoint.GetReactionForce();
        b2Vec2 anchor = myJoint.GetBody1() == myBody1 ? myJoint.GetAnchor1() : myJoint.GetAnchor2();
    }

    public static void Contacts_Listener()
    {
        b2World world = Falling();
        var listener = new MyContactListener();
        world.SetContactListener(listener);
        for (var i = 0; i < 60; i++)
        {
            world.Step(1 / 60f, 10);
        }

        var seen = new HashSet<b2Body>();
        foreach (b2Shape shape in listener.Touched)
        {
            if (shape.GetBody() is { } body && body.IsDynamic() && seen.Add(body) && seen.Count <= 6)
            {
                world.DestroyBody(body);
            }
        }
    }

    public static void Contacts_Filter()
    {
        b2World world = Falling();
        world.SetContactFilter(new MyContactFilter());
        world.Step(1 / 60f, 10);
    }

    public static void LooseEnds_Boundary()
    {
        b2World world = World();
        world.SetListener(new MyBoundaryListener());
        Box(world, 0, 4).SetLinearVelocity(new b2Vec2(1000, 0));
        for (var i = 0; i < 60; i++)
        {
            world.Step(1 / 60f, 10);
        }
    }

    public static void LooseEnds_Destruction()
    {
        (b2World world, b2Body myBody1, b2Body myBody2) = Pair();
        world.SetListener(new MyDestructionListener());
        var jointDef = new b2DistanceJointDef();
        jointDef.Initialize(myBody1, myBody2, myBody1.GetPosition(), myBody2.GetPosition());
        world.CreateJoint(jointDef);
        world.DestroyBody(myBody1);
    }

    public static void Rendering_DebugDraw()
    {
        b2World world = Falling();
        var dbgDraw = new b2DebugDraw();
        dbgDraw.m_sprite = null;
        dbgDraw.m_drawScale = 30.0f;
        dbgDraw.m_fillAlpha = 0.3f;
        dbgDraw.m_lineThickness = 1.0f;
        dbgDraw.m_drawFlags = b2DebugDraw.e_shapeBit | b2DebugDraw.e_jointBit;
        world.SetDebugDraw(dbgDraw);
    }

    private static b2World World()
    {
        var worldAABB = new b2AABB();
        worldAABB.lowerBound.Set(-100, -100);
        worldAABB.upperBound.Set(100, 100);
        return new b2World(worldAABB, new b2Vec2(0, -10), true);
    }

    private static b2World Falling()
    {
        b2World world = World();
        Box(world, 0, 0, density: 0);
        Box(world, 0, 2.1f);
        return world;
    }

    private static (b2World World, b2Body Body1, b2Body Body2) Pair()
    {
        b2World world = World();
        return (world, Box(world, 0, 4), Box(world, 5, 4));
    }

    private static b2Body Box(b2World world, float x, float y, float density = 1)
    {
        var bodyDef = new b2BodyDef();
        bodyDef.position.Set(x, y);
        var body = world.CreateBody(bodyDef);
        var shapeDef = new b2PolygonDef();
        shapeDef.SetAsBox(1, 1);
        shapeDef.density = density;
        body.CreateShape(shapeDef);
        body.SetMassFromShapes();
        return body;
    }

    private sealed class GameActor
    {
        public b2Body body;
        public bool isDead;
    }

    private sealed class MyContactListener : b2ContactListener
    {
        public List<b2Shape> Touched { get; } = [];

        public override void Add(b2ContactPoint point)
        {
            Touched.Add(point.shape1);
            Touched.Add(point.shape2);
        }

        public override void Persist(b2ContactPoint point)
        {
        }

        public override void Remove(b2ContactPoint point)
        {
        }

        public override void Result(b2ContactResult point)
        {
        }
    }

    private sealed class MyContactFilter : b2ContactFilter
    {
        public override bool ShouldCollide(b2Shape shape1, b2Shape shape2) => base.ShouldCollide(shape1, shape2);
    }

    private sealed class MyBoundaryListener : b2BoundaryListener
    {
        public override void Violation(b2Body body) => body.SetUserData("gone");
    }

    private sealed class MyDestructionListener : b2WorldListener
    {
        public override void SayGoodbyeJoint(b2Joint joint)
        {
        }
    }
}
