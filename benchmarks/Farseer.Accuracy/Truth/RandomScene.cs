using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Accuracy.Truth;

/// <summary>A small random scene that is the same each time that it is built from one seed.</summary>
internal sealed class RandomScene : IDisposable
{
    /// <summary>Kinds of scenes, taken in turn.</summary>
    public static readonly string[] Kinds =
        ["thrown", "stack", "heap", "bounce", "pendulum", "rope", "springs", "mixed", "sleep", "pencil"];

    private readonly Random _random;

    private RandomScene(int seed)
    {
        Kind = Kinds[seed % Kinds.Length];
        _random = new Random(seed);
        Simulator = new PhysicsSimulator(new Vector2(0, -10));
        Dt = Pick(1f / 60, 1f / 60, 1f / 120, 1f / 30);
        Simulator.AllowedPenetration = Pick(0f, 0f, 0.001f, 0.05f);
        Simulator.Iterations = _random.Next(3, 11);
    }

    /// <summary>One of <see cref="Kinds"/>.</summary>
    public string Kind { get; }

    public PhysicsSimulator Simulator { get; }

    /// <summary>Bodies that can move.</summary>
    public List<Body> Bodies { get; } = [];

    public float Dt { get; }

    /// <summary>Updates before the one that is looked at.</summary>
    public int Lead { get; private set; }

    public static RandomScene Build(int seed)
    {
        var scene = new RandomScene(seed);
        scene.Fill();
        return scene;
    }

    public void Dispose() => Simulator.Dispose();

    private void Fill()
    {
        float friction = Pick(0f, 0.3f, 0.6f, 1f);
        float restitution = Pick(0f, 0f, 0.3f, 0.8f, 1f);
        Lead = _random.Next(1, 120);
        switch (Kind)
        {
            case "thrown":
                Ground(friction, restitution);
                Throw(Shape(Between(-2, 2), Between(1, 3), friction, restitution), 5, 5);
                break;
            case "stack":
                Ground(0.6f, 0);
                for (int i = 0, n = _random.Next(2, 9); i < n; i++)
                {
                    Box(0, i + 0.5f, 1, 1, 0, 0.6f, 0);
                }

                break;
            case "heap":
                Ground(friction, 0);
                for (int i = 0, n = _random.Next(3, 13); i < n; i++)
                {
                    Shape(Between(-1, 1), 0.8f + (1.2f * i), friction, 0);
                }

                break;
            case "bounce":
                Ground(friction, restitution);
                for (int i = 0, n = _random.Next(2, 7); i < n; i++)
                {
                    Throw(Shape(Between(-4, 4), 0.8f + (1.2f * i), friction, restitution), 4, 4);
                }

                break;
            case "pendulum":
                Chain(_random.Next(1, 4), Between(0.3f, 1), 0);
                break;
            case "rope":
                Chain(_random.Next(4, 16), Between(0.2f, 0.5f), Pick(0f, 10f, 100f));
                break;
            case "springs":
                Springs();
                break;
            case "pencil":
                Pencil();
                break;
            default:
                Mixed(friction, restitution);
                break;
        }
    }

    private void Mixed(float friction, float restitution)
    {
        Ground(friction, restitution);
        for (int i = 0, n = _random.Next(2, 7); i < n; i++)
        {
            Shape(Between(-3, 3), 0.8f + i, friction, restitution);
        }

        if (Kind == "sleep")
        {
            Simulator.AllowSleep = true;
            Lead += 200;
            return;
        }

        Chain(_random.Next(2, 6), 0.5f, 0);
        SpringFactory.Instance.CreateLinearSpring(
            Simulator, Bodies[0], Vector2.Zero, Bodies[1], new Vector2(0.1f, 0), Between(10, 1000), Between(0, 2));
    }

    private void Chain(int links, float length, float load)
    {
        Body before = Static(0, 6);
        float angle = Between(-3, 3);
        Vector2 end = before.Position;
        for (int i = 0; i < links; i++)
        {
            angle += i > 0 ? Between(-0.3f, 0.3f) : 0;
            var along = new Vector2(MathF.Cos(angle), MathF.Sin(angle));
            float mass = i == links - 1 && load > 0 ? load : 1;
            Body link = Loose(end + (along * (length / 2)), mass, mass * length * length / 12);
            link.Rotation = angle;
            JointFactory.Instance.CreateRevoluteJoint(Simulator, before, link, end);
            before = link;
            end += along * length;
        }
    }

    private void Springs()
    {
        Body before = Static(-3, 0);
        int n = _random.Next(1, 6);
        float stiffness = MathF.Pow(10, Between(1, 4));
        for (int i = 0; i < n; i++)
        {
            Body body = Loose(new Vector2(-2 + i + Between(-0.2f, 0.2f), Between(-0.5f, 0.5f)), 1, 0.1f);
            SpringFactory.Instance.CreateLinearSpring(
                Simulator, before, new Vector2(0, 0.1f), body, new Vector2(0, 0.1f), stiffness, Pick(0f, 0f, 1f)).RestLength = 0.8f;
            before = body;
        }
    }

    private void Pencil()
    {
        Ground(5, 0);
        float angle = Between(0.02f, 0.3f);
        Body rod = Box(0, 0, 0.05f, 1, angle, 5, 0);
        rod.Position = new Vector2(-0.5f * MathF.Sin(angle), (0.5f * MathF.Cos(angle)) + (0.025f * MathF.Sin(angle)));
        Simulator.AllowedPenetration = 0;
    }

    private Body Shape(float x, float y, float friction, float restitution)
    {
        if (_random.Next(3) == 0)
        {
            float radius = Between(0.2f, 0.5f);
            Body ball = BodyFactory.Instance.CreateCircleBody(Simulator, radius, MathF.PI * radius * radius);
            ball.Position = new Vector2(x, y);
            Attach(GeomFactory.Instance.CreateCircleGeom(Simulator, ball, radius, 24), friction, restitution);
            return Note(ball);
        }

        return Box(x, y, Between(0.3f, 1), Between(0.3f, 1), Between(-0.5f, 0.5f), friction, restitution);
    }

    private Body Box(float x, float y, float width, float height, float angle, float friction, float restitution)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(Simulator, width, height, width * height);
        body.Position = new Vector2(x, y);
        body.Rotation = angle;
        Attach(GeomFactory.Instance.CreateRectangleGeom(Simulator, body, width, height), friction, restitution);
        return Note(body);
    }

    private void Throw(Body body, float speed, float spin)
    {
        body.LinearVelocity = new Vector2(Between(-speed, speed), Between(-speed, speed));
        body.AngularVelocity = Between(-spin, spin);
    }

    private void Ground(float friction, float restitution)
    {
        Body ground = Static(0, -0.5f);
        Attach(GeomFactory.Instance.CreateRectangleGeom(Simulator, ground, 60, 1), friction, restitution);
    }

    private Body Static(float x, float y)
    {
        Body body = BodyFactory.Instance.CreateBody(Simulator, 1, 1);
        body.IsStatic = true;
        body.Position = new Vector2(x, y);
        return body;
    }

    private Body Loose(Vector2 position, float mass, float inertia)
    {
        Body body = BodyFactory.Instance.CreateBody(Simulator, mass, inertia);
        body.Position = position;
        return Note(body);
    }

    private Body Note(Body body)
    {
        body.LinearDragCoefficient = 0;
        body.RotationalDragCoefficient = 0;
        Bodies.Add(body);
        return body;
    }

    private static void Attach(Geom geom, float friction, float restitution)
    {
        geom.FrictionCoefficient = friction;
        geom.RestitutionCoefficient = restitution;
    }

    private float Between(float low, float high) => low + ((high - low) * _random.NextSingle());

    private T Pick<T>(params T[] values) => values[_random.Next(values.Length)];
}
