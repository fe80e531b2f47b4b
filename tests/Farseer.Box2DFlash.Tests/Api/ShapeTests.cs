using System;
using System.Linq;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

public sealed class ShapeTests
{
    [Fact]
    [ManualRow("B003", "B129", "B131", "B173")]
    public void Shape_BelongsToItsBody_AndGoesWithIt()
    {
        b2World world = Bench.World();
        b2Body body = Bench.Ball(world, 0, 0);
        b2Shape shape = body.GetShapeList()!;
        Assert.Same(body, shape.GetBody());
        world.DestroyBody(body);

        Assert.Null(shape.GetBody());
        Assert.True(typeof(b2Shape).IsAbstract);
        Assert.True(typeof(b2CircleDef).IsSubclassOf(typeof(b2ShapeDef)));
    }

    [Fact]
    [ManualRow("B132-B134")]
    public void Friction_StopsASlidingBox_ByTheRootOfTheProduct()
    {
        b2World world = Bench.World(-10, 1000);
        b2Body ground = world.CreateBody(new b2BodyDef());
        b2PolygonDef floor = Bench.BoxDef(500, 1, 0);
        floor.friction = 0.4f;
        ground.CreateShape(floor);
        b2PolygonDef def = Bench.BoxDef(0.5f, 0.5f, 1);
        def.friction = 0.9f;
        b2Body box = Bench.Body(world, 0, 1.4975f, def);
        box.SetLinearVelocity(new b2Vec2(6, 0));
        Bench.Step(world, 120);

        // v²/(2 μ g) with μ = √(0.4·0.9) = 0.6.
        Assert.Equal(36 / (2 * 0.6 * 10), box.GetPosition().x, 0.05);
        Assert.Equal(0.2f, new b2CircleDef().friction);
    }

    [Fact]
    [ManualRow("B135")]
    public void Restitution_FromNoneToAll_GivesBackThatShare()
    {
        for (int i = 0; i <= 20; i++)
        {
            float restitution = i / 20f;
            b2World world = Bench.World(0);
            Bench.Static(world, 5, 0, 0.5f, 20);
            b2Body ball = Bench.Ball(world, 0, 0, 0.5f, restitution);
            ball.SetLinearVelocity(new b2Vec2(8, 3));
            Bench.Step(world, 60);

            Assert.Equal(restitution, ball.GetShapeList()!.GetRestitution());
            Assert.Equal(-8 * restitution, ball.GetLinearVelocity().x, 1e-3);
        }
    }

    [Fact]
    [ManualRow("B136-B139")]
    public void Restitution_IsTheGreater_AndSlowImpactsDoNotBounce()
    {
        b2World world = Bench.World(0);
        Bench.Static(world, 5, 0, 0.5f, 20);
        b2Body quick = Bench.Ball(world, 0, 0, 0.5f, 0.5f);
        b2Body slow = Bench.Ball(world, 3.5f, 5, 0.5f, 0.5f);
        quick.SetLinearVelocity(new b2Vec2(5, 0));
        slow.SetLinearVelocity(new b2Vec2(0.9f, 0));
        Bench.Step(world, 90);

        Assert.Equal(-2.5, quick.GetLinearVelocity().x, 0.01);
        Assert.Equal(0, slow.GetLinearVelocity().x, 0.01);
        Assert.Equal(0, new b2CircleDef().restitution);
    }

    [Fact]
    [ManualRow("B141-B150", "B293", "B294")]
    public void Filter_ByGroupFirst_ThenByCategoriesBothWays()
    {
        b2World world = Bench.World();
        b2ContactFilter rule = b2ContactFilter.b2_defaultFilter;
        b2Shape Shape(uint category, uint mask, int group)
        {
            b2CircleDef def = new();
            def.filter.categoryBits = category;
            def.filter.maskBits = mask;
            def.filter.groupIndex = group;
            return world.CreateBody(new b2BodyDef()).CreateShape(def);
        }

        Assert.True(rule.ShouldCollide(Shape(2, 4, 0), Shape(4, 2, 0)));
        Assert.False(rule.ShouldCollide(Shape(2, 4, 0), Shape(4, 8, 0)));
        Assert.True(rule.ShouldCollide(Shape(2, 0, 3), Shape(2, 0, 3)));
        Assert.False(rule.ShouldCollide(Shape(2, 2, -3), Shape(2, 2, -3)));
        Assert.True(rule.ShouldCollide(Shape(2, 4, -3), Shape(4, 2, -4)));
        Assert.True(rule.ShouldCollide(Shape(0x8000, 0xFFFF, 0), Shape(1, 0xFFFF, 0)));
        b2FilterData data = new();
        Assert.Equal((1u, 0xFFFFu, 0), (data.categoryBits, data.maskBits, data.groupIndex));
    }

    [Fact]
    [ManualRow("B152")]
    public void ShapesOfOneBody_DoNotCollide()
    {
        b2World world = Bench.World();
        b2Body body = Bench.Dynamic(world, 0, 0);
        body.CreateShape(Bench.BoxDef(0.4f, 0.4f, 1));
        body.SetMassFromShapes();
        Bench.Step(world, 30);

        Assert.Equal(0, world.GetContactCount());
        Assert.Equal(0, body.GetPosition().x, 1e-6);
    }

    [Fact]
    [ManualRow("B153", "B178", "B179")]
    public void JoinedBodies_CollideOnRequestOnly()
    {
        foreach (bool collide in new[] { false, true })
        {
            b2World world = Bench.World();
            b2Body low = Bench.Static(world, 0, 0, 1, 0.5f);
            b2Body high = Bench.Dynamic(world, 0, 1.5f);
            b2DistanceJointDef def = new() { collideConnected = collide };
            Assert.False(new b2RevoluteJointDef().collideConnected);
            def.Initialize(low, high, new b2Vec2(0, 20), new b2Vec2(0, 1.5f));
            def.frequencyHz = 0.1f;
            world.CreateJoint(def);
            Bench.Step(world, 40);

            Assert.Equal(collide, high.GetPosition().y > 0.9);
            Assert.Equal(!collide, high.IsConnected(low));
        }
    }

    [Fact]
    [ManualRow("B154-B156")]
    public void ChangedFilter_CountsAfterRefilter()
    {
        b2World world = Bench.World();
        Bench.Static(world, 0, -0.5f, 10, 0.5f);
        b2Body stays = Bench.Dynamic(world, -3, 0.4975f);
        b2Body falls = Bench.Dynamic(world, 3, 0.4975f);
        Bench.Step(world, 10);
        foreach (b2Body body in new[] { stays, falls })
        {
            b2FilterData filter = body.GetShapeList()!.GetFilterData();
            filter.maskBits = 0;
            body.GetShapeList()!.SetFilterData(filter);
        }

        world.Refilter(falls.GetShapeList()!);
        Bench.Step(world, 30);

        Assert.True(stays.GetPosition().y > 0.4);
        Assert.True(falls.GetPosition().y < 0);
        Assert.Equal(0u, falls.GetShapeList()!.GetFilterData().maskBits);
    }

    [Fact]
    [ManualRow("B157-B159")]
    public void Sensor_NoticesAndDoesNotPush()
    {
        b2World world = Bench.World();
        Counter counter = new();
        world.SetContactListener(counter);
        b2PolygonDef zone = Bench.BoxDef(2, 0.5f, 0);
        zone.isSensor = true;
        Bench.Body(world, 0, 0, zone);
        b2Body ball = Bench.Ball(world, 0, 3);
        Bench.Step(world, 90);

        Assert.True(ball.GetPosition().y < -5);
        Assert.Equal((1, 1, 0), (counter.Added, counter.Removed, counter.Results));
        Assert.False(new b2CircleDef().isSensor);
    }

    [Fact]
    [ManualRow("B160-B162", "B175")]
    public void Circle_HasRadiusAndPlace()
    {
        b2World world = Bench.World(0);
        b2CircleDef def = new() { radius = 1.5f, density = 1 };
        def.localPosition.Set(1, 0);
        b2Body body = Bench.Body(world, 0, 0, def);
        b2CircleShape circle = (b2CircleShape)body.GetShapeList()!;

        Assert.Equal(1.5f, circle.GetRadius());
        Assert.Equal(1, circle.GetLocalPosition().x);
        Assert.Equal(1, body.GetLocalCenter().x, 1e-6f);
        Assert.Equal(b2Shape.e_circleShape, circle.GetType());
        Assert.Equal(1, new b2CircleDef().radius);
        Assert.Equal(b2Shape.e_polygonShape, Bench.Dynamic(world, 9, 0).GetShapeList()!.GetType());
    }

    [Fact]
    [ManualRow("B028", "B029", "B165-B172")]
    public void Polygon_MustBeConvexCounterClockwiseAndWithoutRepetition()
    {
        b2World world = Bench.World(0);
        b2Body body = world.CreateBody(new b2BodyDef());
        b2PolygonDef triangle = new() { vertexCount = 3 };
        triangle.vertices[0].Set(-1, 0);
        triangle.vertices[1].Set(1, 0);
        triangle.vertices[2].Set(0, 2);
        b2PolygonShape shape = (b2PolygonShape)body.CreateShape(triangle);

        Assert.Equal(3, shape.GetVertexCount());
        Assert.Equal(2.0 / 3, shape.GetCentroid().y, 1e-6);
        Assert.Throws<ArgumentException>(() => body.CreateShape(new b2PolygonDef()));
        Assert.Throws<ArgumentException>(() => body.CreateShape(Polygon((-1, 0), (0, 2), (1, 0))));
        Assert.Throws<ArgumentException>(() => body.CreateShape(Polygon((0, 0), (2, 0), (1, 0.1f), (1, 2))));
        Assert.Throws<ArgumentException>(() => body.CreateShape(Polygon((0, 0), (1, 0), (1, 0), (0, 1))));
        Assert.Throws<ArgumentOutOfRangeException>(() => body.CreateShape(Polygon((0, 0), (float.NaN, 0), (0, 1))));
        b2PolygonDef turned = new();
        turned.SetAsOrientedBox(1, 2, new b2Vec2(3, 0), 0.5f * b2Settings.b2_pi);
        b2Vec2[] corners = ((b2PolygonShape)body.CreateShape(turned)).GetVertices();
        Assert.Equal(5, corners.Max(c => c.x), 1e-5);
        Assert.Equal(1, corners.Max(c => c.y), 1e-5);
        Assert.Throws<ArgumentOutOfRangeException>(() => turned.SetAsBox(0, 1));
    }

    [Fact]
    public void Polygon_OfTwentyCorners_IsAllowed()
    {
        b2World world = Bench.World(0);
        (float, float)[] corners = [.. Enumerable.Range(0, 20)
            .Select(i => ((float)Math.Cos(i * Math.PI / 10), (float)Math.Sin(i * Math.PI / 10)))];
        b2Body body = Bench.Body(world, 0, 0, Polygon(corners));

        Assert.Equal(20, ((b2PolygonShape)body.GetShapeList()!).GetVertexCount());
    }

    [Fact]
    [ManualRow("B176")]
    public void TestPoint_AndTestSegment_UseTheTransform()
    {
        b2World world = Bench.World(0);
        b2Body body = Bench.Dynamic(world, 5, 0, 1, 1);
        b2Shape shape = body.GetShapeList()!;
        float[] lambda = new float[1];
        b2Vec2 normal = new();
        b2Segment line = new() { p1 = new b2Vec2(0, 0), p2 = new b2Vec2(10, 0) };

        Assert.True(shape.TestPoint(body.GetXForm(), new b2Vec2(5.9f, 0.9f)));
        Assert.False(shape.TestPoint(body.GetXForm(), new b2Vec2(6.1f, 0)));
        Assert.True(shape.TestSegment(body.GetXForm(), lambda, normal, line, 1));
        Assert.Equal(0.4, lambda[0], 1e-6);
        Assert.Equal(-1, normal.x, 1e-6);
        Assert.False(shape.TestSegment(body.GetXForm(), lambda, normal, line, 0.3f));
        Assert.Throws<ArgumentException>(() => shape.TestSegment(body.GetXForm(), [], normal, line, 1));
        Assert.Throws<ArgumentNullException>(() => shape.TestPoint(null!, normal));
    }

    private static b2PolygonDef Polygon(params (float X, float Y)[] corners) => new()
    {
        density = 1,
        vertexCount = corners.Length,
        vertices = [.. corners.Select(c => new b2Vec2(c.X, c.Y))],
    };

    private sealed class Counter : b2ContactListener
    {
        public int Added { get; private set; }

        public int Removed { get; private set; }

        public int Results { get; private set; }

        public override void Add(b2ContactPoint point) => Added++;

        public override void Remove(b2ContactPoint point) => Removed++;

        public override void Result(Box2D.Dynamics.Contacts.b2ContactResult point) => Results++;
    }
}
