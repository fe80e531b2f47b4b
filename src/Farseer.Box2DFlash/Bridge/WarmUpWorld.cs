using System;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace Box2D.Bridge;

/// <summary>
/// Worlds that meet, in a few steps, the code that most worlds come to: kernels of the usual pairs of shapes on all lanes there are,
/// contacts that begin, rest and end, overlaps, joints, a bullet and a bounce. What they leave out a world waits for when it gets there.
/// Steps are few: after thirty calls the runtime optimises a method for what it has seen until then, and that should be the user's world.
/// </summary>
internal sealed class WarmUpWorld
{
    private const int Steps = 4;
    private const float TimeStep = 1f / 60f;
    private const int Iterations = 10;

    /// <summary>
    /// Columns that stand side by side: more than the longest vectors have lanes, so that there are full records of rows and others.
    /// </summary>
    private const int Columns = 20;

    /// <summary>Bodies of a column: more bodies in all than are looked through without a grid.</summary>
    private const int Levels = 7;
    private const float Spacing = 1.5f;

    /// <summary>Radians a second, at which arms are turned no further than a limit.</summary>
    private const float FastSpin = 60f;

    private readonly b2World _world;

    private WarmUpWorld()
    {
        var region = new b2AABB();
        region.lowerBound.Set(-200f, -200f);
        region.upperBound.Set(200f, 200f);
        _world = new b2World(region, new b2Vec2(0f, -10f), true);
        b2Body ground = _world.CreateBody(At(0f, -0.5f));
        ground.CreateShape(BoxShape(100f, 0.5f, 0f));
    }

    public static void Run()
    {
        var boxes = new WarmUpWorld();
        AddColumns(boxes.Box);
        boxes.AddTrianglesOnTop();
        boxes.AddPairsOfShapes();
        boxes.AddJointed();
        boxes.AddFlying();
        boxes.Step();
        var circles = new WarmUpWorld();
        AddColumns((x, y) => circles.Circle(x, y));
        circles.Step();
        var few = new WarmUpWorld();
        few.AddFew();
        few.Step();
        var fewCircles = new WarmUpWorld();
        fewCircles.AddFewCircles();
        fewCircles.Step();
    }

    private static b2BodyDef At(float x, float y)
    {
        var def = new b2BodyDef();
        def.position.Set(x, y);
        return def;
    }

    private static b2PolygonDef BoxShape(float halfWidth, float halfHeight, float density)
    {
        var def = new b2PolygonDef { density = density, friction = 0.6f };
        def.SetAsBox(halfWidth, halfHeight);
        return def;
    }

    /// <summary>Columns of one shape, a unit wide and high, and two that overlap by half, one of which spins.</summary>
    private static void AddColumns(Func<float, float, b2Body> add)
    {
        for (int i = 0; i < Columns * Levels; i++)
        {
            add(i % Columns * Spacing, 0.5f + (i / Columns));
        }

        add(Columns * Spacing, 0.5f);
        add((Columns + 0.3f) * Spacing, 0.5f).SetAngularVelocity(FastSpin);
    }

    private void Step()
    {
        for (int i = 0; i < Steps; i++)
        {
            _world.Step(TimeStep, Iterations);
        }

        var near = new b2AABB();
        near.lowerBound.Set(-1f, 0f);
        near.upperBound.Set(1f, 2f);
        _world.Query(near, new b2Shape[Columns], Columns);
        _world.DestroyBody(_world.GetBodyList()!);
        _world.Step(TimeStep, Iterations);
    }

    private b2Body Body(float x, float y, b2ShapeDef shape)
    {
        b2Body body = _world.CreateBody(At(x, y));
        body.CreateShape(shape);
        body.SetMassFromShapes();
        return body;
    }

    private b2Body Box(float x, float y) => Body(x, y, BoxShape(0.5f, 0.5f, 1f));

    private b2Body Circle(float x, float y, float restitution = 0f) =>
        Body(x, y, new b2CircleDef { radius = 0.5f, density = 1f, friction = 0.6f, restitution = restitution });

    private b2Body Triangle(float x, float y)
    {
        var def = new b2PolygonDef { density = 1f, friction = 0.6f, vertexCount = 3 };
        def.vertices[0].Set(-0.5f, 0f);
        def.vertices[1].Set(0.5f, 0f);
        def.vertices[2].Set(0f, 1f);
        return Body(x, y, def);
    }

    private void AddTrianglesOnTop()
    {
        for (int i = 0; i < Columns; i++)
        {
            Triangle(i * Spacing, Levels);
        }
    }

    private void AddPairsOfShapes()
    {
        Circle(-4f, 0.5f);
        Circle(-3.8f, 1.45f);
        Triangle(-6f, 0f);
        Circle(-8f, 0.5f);
        Box(-10f, 0.5f);
        Circle(-10f, 1.5f);
    }

    /// <summary>A rope of four links, and pairs of bodies with a joint.</summary>
    private void AddJointed()
    {
        const float Height = 20f;
        b2Body before = _world.GetGroundBody();
        for (int i = 0; i < 4; i++)
        {
            b2Body link = Box(i * Spacing, Height);
            var hinge = new b2RevoluteJointDef();
            hinge.Initialize(before, link, new b2Vec2((i - 0.5f) * Spacing, Height));
            _world.CreateJoint(hinge);
            before = link;
        }

        var rod = new b2DistanceJointDef();
        rod.Initialize(Box(0f, Height + 3f), Box(2f, Height + 3f), new b2Vec2(0f, Height + 3f), new b2Vec2(2f, Height + 3f));
        _world.CreateJoint(rod);
        var slide = new b2PrismaticJointDef();
        slide.Initialize(Box(0f, Height + 6f), Box(2f, Height + 6f), new b2Vec2(0f, Height + 6f), new b2Vec2(1f, 0f));
        _world.CreateJoint(slide);
    }

    /// <summary>Bodies that hit another at once and faster than their size a step, and one that bounces.</summary>
    private void AddFlying()
    {
        const float Height = 8f;
        _world.CreateBody(At(55f, Height)).CreateShape(BoxShape(0.5f, 0.5f, 0f));
        b2Body bullet = Circle(50f, Height);
        bullet.SetBullet(true);
        bullet.SetLinearVelocity(new b2Vec2(190f, 0f));
        Circle(50f, Height + 2f).SetLinearVelocity(new b2Vec2(100f, 0f));
        Box(52f, Height + 2f);
        Circle(-20f, 0.6f, restitution: 0.5f).SetLinearVelocity(new b2Vec2(0f, -10f));
    }

    /// <summary>A stack, and boxes that spin fast on each other: fewer than the shortest vectors have lanes.</summary>
    private void AddFew()
    {
        for (int i = 0; i < 3; i++)
        {
            Box(0f, 0.5f + i);
        }

        Box(10f, 0.5f);
        Box(10f, 1.5f).SetAngularVelocity(FastSpin);
    }

    private void AddFewCircles()
    {
        for (int i = 0; i < 3; i++)
        {
            Circle(0f, 0.5f + i);
            Circle(5f, 0.5f + (0.5f * i)).SetAngularVelocity(FastSpin);
        }
    }
}
