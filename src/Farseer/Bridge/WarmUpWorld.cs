using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Worlds that meet, in a few updates, the code that most worlds come to: kernels of the usual pairs of shapes on all lanes there are,
/// contacts that begin, rest and end, overlaps, joints and springs, a bullet, a bounce and queries. What they leave out a scene waits for
/// when it gets there. Updates are few: after thirty calls the runtime optimises a method for what it has seen until then, and that should
/// be the user's scene.
/// </summary>
internal sealed class WarmUpWorld
{
    private const int Updates = 4;
    private const float Dt = 1f / 60f;

    /// <summary>
    /// Columns that stand side by side: more than the longest vectors have lanes, so that there are full records of rows and others.
    /// </summary>
    private const int Columns = 20;

    /// <summary>
    /// Of circles, so that with the bodies beside them there is an even number of bundles of contacts with the ground, and of boxes an odd
    /// one.
    /// </summary>
    private const int CircleColumns = 28;

    /// <summary>Bodies of a column: more bodies in all than are looked through without a grid.</summary>
    private const int Levels = 7;
    private const float Spacing = 1.5f;

    /// <summary>Radians a second, at which arms are turned no further than a limit.</summary>
    private const float FastSpin = 60f;

    private readonly PhysicsSimulator _simulator = new PhysicsSimulator(new Vector2(0f, -10f));

    private WarmUpWorld(bool inGrid = false)
    {
        if (inGrid)
        {
            _simulator.BroadPhaseCollider = new GridCollider(_simulator);
        }

        Body ground = BodyFactory.Instance.CreateRectangleBody(_simulator, 200f, 1f, 1f);
        ground.Position = new Vector2(0f, -0.5f);
        ground.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(_simulator, ground, 200f, 1f);
    }

    public static void Run()
    {
        var mixed = new WarmUpWorld();
        AddColumns(mixed.Box, Columns);
        mixed.AddColumnsOfPolygons();
        mixed.AddPairsOfShapes(new Vector2(-4f, 0f));
        mixed.AddJointed(new Vector2(0f, 20f));
        mixed.AddNet(new Vector2(20f, 30f));
        mixed.AddFlying(new Vector2(50f, 8f));
        mixed.Update();
        var circles = new WarmUpWorld(inGrid: true);
        AddColumns((x, y) => circles.Circle(x, y), CircleColumns);
        circles.Update();
        var few = new WarmUpWorld();
        few.AddFew();
        few.Update();
        var fewCircles = new WarmUpWorld();
        fewCircles.AddFewCircles();
        fewCircles.Update();
    }

    private void Update()
    {
        using (_simulator)
        {
            for (int i = 0; i < Updates; i++)
            {
                _simulator.Update(Dt);
            }

            _simulator.RayCast(new Vector2(-3f, 5f), new Vector2(-3f, -5f), out _);
            _simulator.QueryPoint(new Vector2(0f, 0.5f), new List<Geom>());
            _simulator.BodyList[_simulator.BodyList.Count - 1].Dispose();
            _simulator.Update(Dt);
        }
    }

    private Body Box(float x, float y)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(_simulator, 1f, 1f, 1f);
        body.Position = new Vector2(x, y);
        GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 1f, 1f);
        return body;
    }

    private Body Circle(float x, float y, float restitution = 0f)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(_simulator, 0.5f, 1f);
        body.Position = new Vector2(x, y);
        Geom geom = GeomFactory.Instance.CreateCircleGeom(_simulator, body, 0.5f, 12);
        geom.RestitutionCoefficient = restitution;
        return body;
    }

    private Body Polygon(float x, float y)
    {
        Vertices corners = Vertices.CreateCircle(0.5f, 6);
        Body body = BodyFactory.Instance.CreatePolygonBody(_simulator, corners, 1f);
        body.Position = new Vector2(x, y);
        GeomFactory.Instance.CreatePolygonGeom(_simulator, body, corners, 0f);
        return body;
    }

    /// <summary>Columns of one shape, a unit wide and high, and two that overlap by half, one of which spins.</summary>
    private static void AddColumns(Func<float, float, Body> add, int columns)
    {
        for (int i = 0; i < columns * Levels; i++)
        {
            add(i % columns * Spacing, 0.5f + (i / columns));
        }

        add(columns * Spacing, 0.5f);
        add((columns + 0.3f) * Spacing, 0.5f).AngularVelocity = FastSpin;
    }

    private void AddColumnsOfPolygons()
    {
        for (int i = 0; i < Columns; i++)
        {
            Polygon(i * Spacing, Levels + 0.4f);
            Polygon(i * Spacing, Levels + 1.2f);
        }
    }

    /// <summary>
    /// A stack, one that sleeps until it is struck, and boxes that spin fast on each other: fewer than the shortest vectors have lanes.
    /// </summary>
    private void AddFew()
    {
        _simulator.AllowSleep = true;
        for (int i = 0; i < 3; i++)
        {
            Box(0f, 0.5f + i);
            Box(5f, 0.5f + i).Awake = false;
        }

        Box(3f, 1f).LinearVelocity = new Vector2(20f, 0f);

        Box(10f, 0.5f);
        Box(10f, 1.5f).AngularVelocity = FastSpin;
    }

    private void AddFewCircles()
    {
        for (int i = 0; i < 3; i++)
        {
            Circle(0f, 0.5f + i);
            Circle(5f, 0.5f + (0.5f * i)).AngularVelocity = FastSpin;
        }
    }

    private void AddPairsOfShapes(Vector2 at)
    {
        Circle(at.X, 0.5f);
        Circle(at.X + 0.2f, 1.45f);
        Polygon(at.X - 2f, 0.5f);
        Circle(at.X - 2f, 1.4f);
        Box(at.X - 4f, 0.5f);
        Circle(at.X - 4f, 1.5f);
        Box(at.X - 6f, 0.5f);
        Polygon(at.X - 6f, 1.4f);
        Body capsule = BodyFactory.Instance.CreateRectangleBody(_simulator, 1f, 0.5f, 1f);
        capsule.Position = new Vector2(at.X - 8f, 0.25f);
        GeomFactory.Instance.CreateCapsuleGeom(_simulator, capsule, new Vector2(-0.3f, 0f), new Vector2(0.3f, 0f), 0.25f);
    }

    /// <summary>A rope of four links, a driven wheel, and pairs of bodies with a joint or a spring.</summary>
    private void AddJointed(Vector2 at)
    {
        JointFactory joints = JointFactory.Instance;
        Body before = Box(at.X, at.Y);
        joints.CreateFixedRevoluteJoint(_simulator, before, at);
        for (int i = 1; i < 4; i++)
        {
            Body link = Box(at.X + (i * Spacing), at.Y);
            joints.CreateRevoluteJoint(_simulator, before, link, at + new Vector2((i - 0.5f) * Spacing, 0f));
            before = link;
        }

        Body wheel = Circle(at.X - 2f, at.Y);
        FixedRevoluteJoint axle = joints.CreateFixedRevoluteJoint(_simulator, wheel, wheel.Position);
        axle.IsMotorEnabled = true;
        axle.MotorSpeed = 1f;
        axle.MaxMotorTorque = 10f;
        Body first = Box(at.X, at.Y + 3f);
        Body second = Box(at.X + 2f, at.Y + 3f);
        joints.CreatePinJoint(_simulator, first, Vector2.Zero, second, Vector2.Zero);
        joints.CreateAngleJoint(_simulator, first, second);
        first = Box(at.X, at.Y + 6f);
        second = Box(at.X + 2f, at.Y + 6f);
        joints.CreateSliderJoint(_simulator, first, Vector2.Zero, second, Vector2.Zero, 1f, 3f);
        SpringFactory.Instance.CreateLinearSpring(_simulator, first, Vector2.Zero, second, Vector2.Zero, 10f, 1f);
    }

    /// <summary>Rows of bodies, each joined with its neighbours.</summary>
    private void AddNet(Vector2 at)
    {
        const int Side = 6;
        var bodies = new Body[Side * Side];
        for (int i = 0; i < bodies.Length; i++)
        {
            Vector2 place = at + new Vector2(i % Side * Spacing, i / Side * Spacing);
            bodies[i] = Circle(place.X, place.Y);
            if (i % Side > 0)
            {
                JointFactory.Instance.CreateRevoluteJoint(_simulator, bodies[i - 1], bodies[i], place - new Vector2(0.5f * Spacing, 0f));
            }

            if (i >= Side)
            {
                JointFactory.Instance.CreateRevoluteJoint(_simulator, bodies[i - Side], bodies[i], place - new Vector2(0f, 0.5f * Spacing));
            }
        }
    }

    /// <summary>Bodies that hit another at once and faster than their size an update, and one that bounces.</summary>
    private void AddFlying(Vector2 at)
    {
        Body wall = Box(at.X + 5f, at.Y);
        wall.IsStatic = true;
        Body bullet = Circle(at.X, at.Y);
        bullet.LinearVelocity = new Vector2(300f, 0f);
        Body other = Circle(at.X, at.Y + 2f);
        other.LinearVelocity = new Vector2(100f, 0f);
        Box(at.X + 2f, at.Y + 2f);
        Body ball = Circle(-20f, 0.6f, restitution: 0.5f);
        ball.LinearVelocity = new Vector2(0f, -10f);
    }
}
