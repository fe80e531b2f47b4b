using System;
using System.Collections.Generic;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

public sealed class WorldTests
{
    [Fact]
    [ManualRow("B001", "B008", "B017", "B020", "B033", "B066")]
    public void Worlds_SeveralAtOnce_GoTheirOwnWays()
    {
        b2World down = Bench.World(-10);
        b2World up = Bench.World(10);
        b2Body a = Bench.Ball(down, 0, 0);
        b2Body b = Bench.Ball(up, 0, 0);
        Bench.Step(down, 60);
        Bench.Step(up, 60);

        Assert.Equal(-5, a.GetPosition().y, 1e-4);
        Assert.Equal(5, b.GetPosition().y, 1e-4);
    }

    [Fact]
    [ManualRow("B009-B016")]
    public void Vectors_AndBoxes_AreSetByTheirMembers()
    {
        b2AABB box = new();
        box.lowerBound.Set(-100, -100);
        box.upperBound.Set(100, 100);
        b2Vec2 v = new(3, 4);

        Assert.Equal(-100, box.lowerBound.x);
        Assert.Equal(100, box.upperBound.y);
        Assert.Equal((0f, 0f), (new b2Vec2().x, new b2Vec2().y));
        Assert.Equal(5, v.Length());
        v.Set(1, 2);
        Assert.Equal((1f, 2f), (v.x, v.y));
    }

    [Fact]
    [ManualRow("B018", "B019", "B106", "B298", "B299", "B301", "B300", "B302")]
    public void Body_ThatLeavesTheWorld_IsFrozenForGood()
    {
        b2World world = Bench.World(-10, 5);
        Boundary listener = new();
        world.SetBoundaryListener(listener);
        b2Body ball = Bench.Ball(world, 0, 0);
        Bench.Step(world, 90);

        Assert.True(ball.IsFrozen());
        Assert.Same(ball, Assert.Single(listener.Left));
        Assert.Equal(0, ball.GetLinearVelocity().y);
        float y = ball.GetPosition().y;
        Bench.Step(world, 10);
        Assert.Equal(y, ball.GetPosition().y);
        Assert.False(ball.SetXForm(new b2Vec2(0, 0), 0));
        Assert.Single(listener.Left);
    }

    [Fact]
    [ManualRow("B022-B027", "B030", "B031", "B032")]
    public void Definition_UsedTwice_MakesTwoBodies()
    {
        b2World world = Bench.World();
        b2BodyDef def = new();
        def.position.Set(1, 2);
        b2Body first = world.CreateBody(def);
        def.position.Set(5, 6);
        b2Body second = world.CreateBody(def);
        b2PolygonDef shape = Bench.BoxDef(1, 1, 0);
        first.CreateShape(shape);
        shape.SetAsBox(2, 2);
        b2Shape larger = second.CreateShape(shape);

        Assert.Equal((1f, 2f), (first.GetPosition().x, first.GetPosition().y));
        Assert.True(first.IsStatic());
        Assert.Equal(1, ((b2PolygonShape)first.GetShapeList()!).GetVertices()[2].x);
        Assert.Same(second, larger.GetBody());
        Bench.Step(world, 30);
        Assert.Equal((5f, 6f), (second.GetPosition().x, second.GetPosition().y));
    }

    [Fact]
    [ManualRow("B027", "B151")]
    public void StaticBodies_Overlapping_DoNotCollide()
    {
        b2World world = Bench.World();
        Listener listener = new();
        world.SetContactListener(listener);
        Bench.Static(world, 0, 0, 1, 1);
        Bench.Static(world, 0.5f, 0, 1, 1);
        Bench.Step(world, 5);

        Assert.Equal(0, listener.Added);
        Assert.Equal(0, world.GetContactCount());
    }

    [Fact]
    [ManualRow("B039", "B042", "B043", "B067", "B068")]
    public void Step_MovesBodies_MadeBeforeIt()
    {
        b2World world = Bench.World();
        Bench.Static(world, 0, -1, 10, 1);
        b2Body box = Bench.Dynamic(world, 0, 0.499f);
        box.SetAngularVelocity(0);
        world.Step(Bench.Dt, 10);

        Assert.Equal(0.499, box.GetPosition().y, 0.005);
        Assert.Equal(0, box.GetAngle(), 1e-3);
        Assert.Throws<ArgumentOutOfRangeException>(() => world.Step(-1, 10));
        Assert.Throws<ArgumentOutOfRangeException>(() => world.Step(float.NaN, 10));
        Assert.Throws<ArgumentOutOfRangeException>(() => world.Step(Bench.Dt, 0));
    }

    [Fact]
    [ManualRow("B046-B050", "B240")]
    public void Factories_MakeAndDestroy()
    {
        b2World world = Bench.World();
        b2Body a = Bench.Ball(world, 0, 0);
        b2Body b = Bench.Ball(world, 2, 0);
        b2DistanceJointDef def = new();
        def.Initialize(a, b, a.GetPosition(), b.GetPosition());
        b2Joint joint = world.CreateJoint(def);
        b2Shape shape = a.GetShapeList()!;

        Assert.Equal(1, world.GetJointCount());
        world.DestroyJoint(joint);
        a.DestroyShape(shape);
        world.DestroyBody(b);
        Assert.Equal(0, world.GetJointCount());
        Assert.Null(a.GetShapeList());
        Assert.Null(shape.GetBody());
        Assert.Equal(2, world.GetBodyCount());
        Assert.Throws<ArgumentException>(() => world.DestroyBody(b));
        Assert.Throws<ArgumentException>(() => world.DestroyJoint(joint));
        Assert.Throws<ArgumentException>(() => a.DestroyShape(shape));
        Assert.Empty(typeof(b2Body).GetConstructors());
        Assert.Empty(typeof(b2RevoluteJoint).GetConstructors());
    }

    [Fact]
    [ManualRow("B052-B054", "B061", "B127", "B246")]
    public void UserData_IsHandedThrough()
    {
        b2World world = Bench.World();
        object tag = new();
        b2Body a = world.CreateBody(new b2BodyDef { userData = tag });
        b2Shape shape = a.CreateShape(new b2CircleDef { userData = "shape" });
        b2Body b = Bench.Ball(world, 2, 0);
        b2RevoluteJointDef def = new() { userData = 7 };
        def.Initialize(a, b, new b2Vec2());
        b2Joint joint = world.CreateJoint(def);

        Assert.Same(tag, a.GetUserData());
        Assert.Equal("shape", shape.GetUserData());
        Assert.Equal(7, joint.GetUserData());
        joint.SetUserData("other");
        Assert.Equal("other", joint.GetUserData());
    }

    [Fact]
    [ManualRow("B055", "B056", "B058-B060", "B097")]
    public void Lists_RunFromTheNewest_AndTheGroundBodyIsTheLast()
    {
        b2World world = Bench.World();
        b2Body a = Bench.Ball(world, 0, 0);
        b2Body b = Bench.Ball(world, 5, 0);
        b2RevoluteJointDef def = new();
        def.Initialize(world.GetGroundBody(), a, new b2Vec2());
        b2Joint first = world.CreateJoint(def);
        def.Initialize(world.GetGroundBody(), b, new b2Vec2());
        b2Joint second = world.CreateJoint(def);
        List<b2Body> bodies = [];
        for (b2Body? body = world.GetBodyList(); body is not null;)
        {
            b2Body? next = body.GetNext();
            bodies.Add(body);
            if (ReferenceEquals(body, a))
            {
                world.DestroyBody(body);
            }

            body = next;
        }

        Assert.Equal([b, a, world.GetGroundBody()], bodies);
        Assert.True(world.GetGroundBody().IsStatic());
        Assert.Same(second, world.GetJointList());
        Assert.Null(second.GetNext());
        Assert.Throws<ArgumentException>(() => world.DestroyJoint(first));
        Assert.Throws<ArgumentException>(() => world.DestroyBody(world.GetGroundBody()));
    }

    [Fact]
    [ManualRow("B062-B065")]
    public void Query_FindsShapesByTheirBoxes_UpToACount()
    {
        b2World world = Bench.World(0);
        b2Body ball = Bench.Ball(world, 0, 0, 1);
        Bench.Ball(world, 10, 0);
        b2AABB corner = new() { lowerBound = new b2Vec2(0.9f, 0.9f), upperBound = new b2Vec2(0.95f, 0.95f) };
        b2Shape[] shapes = new b2Shape[10];
        List<b2Shape> list = [];

        Assert.Equal(1, world.Query(corner, shapes, 10));
        Assert.Same(ball, shapes[0].GetBody());
        Assert.Equal(1, world.Query(Bench.Box(50), list, 1));
        Assert.Equal(2, world.Query(Bench.Box(50), shapes, 10));
        Assert.Equal(0, world.Query(Bench.Box(50), shapes, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => world.Query(corner, shapes, 11));
        Assert.Throws<ArgumentException>(() => world.Query(new b2AABB { lowerBound = new b2Vec2(1, 0) }, shapes, 1));
    }

    [Fact]
    [ManualRow("B076", "B164", "B310-B325")]
    public void Settings_AreThoseOfTheOriginal()
    {
        Assert.Equal(Math.PI, b2Settings.b2_pi, 1e-6);
        Assert.Equal(8, b2Settings.b2_maxPolygonVertices);
        Assert.Equal(0.005f, b2Settings.b2_linearSlop);
        Assert.Equal(2.0 / 180 * Math.PI, b2Settings.b2_angularSlop, 1e-7);
        Assert.Equal(1, b2Settings.b2_velocityThreshold);
        Assert.Equal(0.2f, b2Settings.b2_maxLinearCorrection);
        Assert.Equal(8.0 / 180 * Math.PI, b2Settings.b2_maxAngularCorrection, 1e-7);
        Assert.Equal(200, b2Settings.b2_maxLinearVelocity);
        Assert.Equal(250, b2Settings.b2_maxAngularVelocity);
        Assert.Equal(0.2f, b2Settings.b2_contactBaumgarte);
        Assert.Equal(0.5f, b2Settings.b2_timeToSleep);
        Assert.Equal(0.01f, b2Settings.b2_linearSleepTolerance);
        Assert.Equal(2.0 / 180, b2Settings.b2_angularSleepTolerance, 1e-7);
        Assert.Equal(0.04f, b2Settings.b2_toiSlop);
        Assert.Equal((512, 4096), (b2Settings.b2_maxProxies, b2Settings.b2_maxPairs));
        Assert.Throws<InvalidOperationException>(() => b2Settings.b2Assert(false));
    }

    [Fact]
    [ManualRow("B045", "B163", "B204", "B205", "B309", "B326")]
    public void Names_ThatTheSourcesLack_AreNotThere()
    {
        Type[] types = typeof(b2World).Assembly.GetExportedTypes();

        Assert.DoesNotContain(types, t => t.Name is "b2PolyDef" or "b2WorldListener" or "b2Alloc" or "Testbed");
        Assert.Null(typeof(b2RevoluteJointDef).GetProperty("anchorPoint"));
        Assert.Null(typeof(b2Body).GetMethod("GetCenterPosition"));
    }

    private sealed class Boundary : b2BoundaryListener
    {
        public List<b2Body> Left { get; } = [];

        public override void Violation(b2Body body) => Left.Add(body);
    }

    private sealed class Listener : b2ContactListener
    {
        public int Added { get; private set; }

        public override void Add(b2ContactPoint point) => Added++;
    }
}
