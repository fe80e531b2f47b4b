using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
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
    [ManualRow("B020")]
    public void Gravity_OfAnyDirection_PullsThatWay()
    {
        for (int i = 0; i < 16; i++)
        {
            float angle = i * b2Settings.b2_pi / 8;
            b2World world = new(Bench.Box(100), new b2Vec2(10 * MathF.Cos(angle), 10 * MathF.Sin(angle)), true);
            b2Body ball = Bench.Ball(world, 0, 0);
            Bench.Step(world, 60);

            // g/2 after a second.
            Assert.Equal(5 * MathF.Cos(angle), ball.GetPosition().x, 1e-3);
            Assert.Equal(5 * MathF.Sin(angle), ball.GetPosition().y, 1e-3);
        }
    }

    [Fact]
    [ManualRow("B066")]
    public void World_ThatNobodyHolds_IsFreedWithAllItHolds()
    {
        WeakReference[] dropped = MakeAndDrop();
        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();

        Assert.All(dropped, reference => Assert.False(reference.IsAlive));
    }

    /// <summary>In a method of its own, so that no local variable of the test holds anything.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static WeakReference[] MakeAndDrop()
    {
        b2World world = Bench.World();
        world.SetContactListener(new Listener());
        Bench.Static(world, 0, -1, 10, 1);
        b2Body a = Bench.Dynamic(world, 0, 0.5f);
        b2Body b = Bench.Ball(world, 2, 0.5f);
        b2RevoluteJointDef def = new();
        def.Initialize(a, b, new b2Vec2(1, 0.5f));
        b2Joint joint = world.CreateJoint(def);
        Bench.Step(world, 60);
        return [new(world), new(a), new(b), new(a.GetShapeList()), new(joint), new(world.GetContactList())];
    }

    [Fact]
    [ManualRow("B001", "B008", "B017", "B033")]
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
    [ManualRow("B032")]
    public void StaticShapes_OfOneBody_HaveItForParent_AndAllHold()
    {
        b2World world = Bench.World();
        b2Body ground = world.CreateBody(new b2BodyDef());
        List<b2Shape> shapes = [];
        for (int i = 0; i < 6; i++)
        {
            b2PolygonDef def = new();
            def.SetAsOrientedBox(1, 0.5f, new b2Vec2(3 * i, -0.5f), 0);
            shapes.Add(ground.CreateShape(def));
        }

        // One on each, one beside them.
        b2Body[] boxes = [.. Enumerable.Range(0, 6).Select(i => Bench.Dynamic(world, 3 * i, 0.6f))];
        b2Body beside = Bench.Dynamic(world, -3, 0.6f);
        Bench.Step(world, 90);

        Assert.All(shapes, shape => Assert.Same(ground, shape.GetBody()));
        Assert.All(boxes, box => Assert.Equal(0.5, box.GetPosition().y, 0.005));
        Assert.True(beside.GetPosition().y < -5);
        ground.DestroyShape(shapes[2]);
        boxes[2].WakeUp();
        boxes[3].WakeUp();
        Bench.Step(world, 60);
        Assert.Null(shapes[2].GetBody());
        Assert.True(boxes[2].GetPosition().y < -2);
        Assert.Equal(0.5, boxes[3].GetPosition().y, 0.005);
    }

    [Fact]
    [ManualRow("B022-B027", "B030", "B031")]
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
    [ManualRow("B043")]
    public void Angle_IsInRadians_AndCountsWholeTurns()
    {
        for (int i = -12; i <= 12; i++)
        {
            float spin = 2.5f * i;
            b2World world = Bench.World(0);
            b2BodyDef def = new() { angle = 0.25f * i };
            b2Body body = world.CreateBody(def);
            body.CreateShape(Bench.BoxDef(1, 0.5f, 1));
            body.SetMassFromShapes();
            Assert.Equal(0.25f * i, body.GetAngle());
            body.SetAngularVelocity(spin);
            Bench.Step(world, 60);

            // A second at so many radians a second; a corner of it says the same.
            float angle = (0.25f * i) + spin;
            Assert.Equal(angle, body.GetAngle(), 1e-3);
            Assert.Equal(MathF.Cos(angle), body.GetWorldVector(new b2Vec2(1, 0)).x, 1e-3);
            Assert.Equal(MathF.Sin(angle), body.GetWorldVector(new b2Vec2(1, 0)).y, 1e-3);
        }
    }

    [Fact]
    [ManualRow("B039", "B042", "B067", "B068")]
    public void Step_MovesBodies_MadeBeforeIt()
    {
        b2World world = Bench.World();
        Bench.Static(world, 0, -1, 10, 1);
        b2Body box = Bench.Dynamic(world, 0, 0.499f);
        box.SetAngularVelocity(0);
        world.Step(Bench.Dt, 10);

        Assert.Equal(0.499, box.GetPosition().y, 0.005);
        Assert.Equal(0, box.GetAngle(), 1e-3);
        Assert.Throws<ArgumentOutOfRangeException>(() => world.Step(-1f, 10));
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
    [ManualRow("B076", "B164", "B310", "B312-B325")]
    public void Settings_AreThoseOfTheOriginal()
    {
        // Read from the assembly: the compiler would put its own copy of a constant here.
        Dictionary<string, double> values = typeof(b2Settings).GetFields(BindingFlags.Public | BindingFlags.Static)
            .ToDictionary(f => f.Name, f => Convert.ToDouble(f.GetRawConstantValue(), CultureInfo.InvariantCulture));
        string[][] rows = [.. TestData.Table("manual-box2dflash.tsv").Where(r => r[1] == "Settings" && r[2] == "constant")];

        Assert.Equal(14, rows.Length);
        Assert.Equal(Math.PI, values["b2_pi"], 1e-6);
        Assert.Equal(8, values["b2_maxPolygonVertices"]);
        Assert.All(rows, row =>
        {
            double expected = Value(row[7], values);
            Assert.Equal(expected, values[row[4]], 1e-6 * expected);
        });
        Assert.Throws<InvalidOperationException>(() => b2Settings.b2Assert(false));
    }

    /// <summary>The value of numbers and constants joined by * and /.</summary>
    private static double Value(string expression, Dictionary<string, double> names)
    {
        double value = 1;
        string sign = "*";
        foreach (string word in expression.Split(' '))
        {
            if (word is "*" or "/")
            {
                sign = word;
                continue;
            }

            double factor = names.TryGetValue(word, out double known) ? known : double.Parse(word, CultureInfo.InvariantCulture);
            value = sign == "*" ? value * factor : value / factor;
        }

        return value;
    }

    [Fact]
    [ManualRow("B311", "B312", "B314", "B320")]
    public void Tolerances_ActInMetresAndSeconds()
    {
        foreach (float half in new[] { 0.4f, 0.5f, 1, 3 })
        {
            b2World world = Bench.World();
            Bench.Static(world, 0, -1, 10, 1);
            b2Body box = Bench.Dynamic(world, 0, half, half, half);
            Bench.Step(world, 60);

            // Half a slop of 5 mm deep, whatever the size from 0.64 m on, of which that is 1/256; a tenth of a millimetre is what it gives
            // with its weight.
            Assert.Equal(half - 0.0025, box.GetPosition().y, 1e-4);
        }

        b2World still = Bench.World();
        Bench.Static(still, 0, -1, 10, 1);
        b2Body sleeper = Bench.Dynamic(still, 0, 0.4975f);
        int steps = 0;
        while (!sleeper.IsSleeping() && steps < 100)
        {
            still.Step(Bench.Dt, 10);
            steps++;
        }

        // Half a second, and the steps in which it is seen to rest and falls asleep.
        Assert.InRange(steps, 30, 33);
        foreach (float speed in new[] { 0.5f, 0.98f, 1.02f, 3 })
        {
            b2World wall = Bench.World(0);
            Bench.Static(wall, 5, 0, 0.5f, 20);
            b2Body ball = Bench.Ball(wall, 3.5f, 0, 0.5f, 0.5f);
            ball.SetLinearVelocity(new b2Vec2(speed, 0));
            Bench.Step(wall, 150);

            // What is slower than a metre a second does not bounce.
            Assert.Equal(speed < 1 ? 0 : -0.5 * speed, ball.GetLinearVelocity().x, 0.01 * speed);
        }
    }

    [Fact]
    [ManualRow("B317", "B318")]
    public void GreatestSpeeds_CutWithTheQuirk_AndBoundWhatBouncesDrive()
    {
        b2World world = Bench.World(0, 1e5f);
        world.Quirks = Box2DFlash202Quirks.SpeedLimits;
        b2Body body = Bench.Dynamic(world, 0, 0);
        body.SetLinearVelocity(new b2Vec2(300, 400));
        body.SetAngularVelocity(-300);
        world.Step(Bench.Dt, 10);
        Assert.Equal((120f, 160f, -250f), (body.GetLinearVelocity().x, body.GetLinearVelocity().y, body.GetAngularVelocity()), Near);
        body.SetLinearVelocity(new b2Vec2(0, 199));
        body.SetAngularVelocity(249);
        world.Step(Bench.Dt, 10);
        Assert.Equal((0f, 199f, 249f), (body.GetLinearVelocity().x, body.GetLinearVelocity().y, body.GetAngularVelocity()), Near);

        // A large ball between two walls that give back more than they get, every time.
        b2World room = Bench.World(0, 1e4f);
        foreach (float x in new[] { -60f, 60 })
        {
            Bench.Static(room, x, 0, 20, 500);
        }

        b2Body ball = Bench.Ball(room, 0, 0, 10, 1.5f);
        ball.SetLinearVelocity(new b2Vec2(20, 0));
        float fastest = 0;
        for (int step = 0; step < 600; step++)
        {
            room.Step(Bench.Dt, 10);
            fastest = Math.Max(fastest, ball.GetLinearVelocity().Length());
        }

        Assert.Equal(200, fastest, 0.01);

        static bool Near((float X, float Y, float W) a, (float X, float Y, float W) b) =>
            Math.Abs(a.X - b.X) + Math.Abs(a.Y - b.Y) + Math.Abs(a.W - b.W) < 1e-3f;
    }

    [Fact]
    [ManualRow("B045", "B163", "B204", "B205", "B309", "B326")]
    public void Names_ThatTheSourcesLack_AreNotThereOrSayTheOther()
    {
        Type[] types = typeof(b2World).Assembly.GetExportedTypes();

        Assert.DoesNotContain(types, t => t.Name is "b2PolyDef" or "b2Alloc" or "Testbed");
        Bench.AssertOldName(types.Single(t => t.Name == "b2WorldListener"), "b2DestructionListener");
        Bench.AssertOldName(typeof(b2RevoluteJointDef).GetProperty("anchorPoint"), "Initialize");
        Bench.AssertOldName(typeof(b2Body).GetMethod("GetCenterPosition"), "GetWorldCenter");
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
