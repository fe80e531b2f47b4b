using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Tests;

/// <summary>Parts of small scenes in pixels, y down.</summary>
internal static class Sandbox
{
    public const float Step = 0.01f;

    /// <summary>A simulator in which things fall, y down.</summary>
    public static PhysicsSimulator Falling(float gravity = 100) => new PhysicsSimulator(new Vector2(0, gravity));

    /// <summary>A simulator in which things fall on <see cref="Floor"/>.</summary>
    public static PhysicsSimulator WithFloor(out Geom floor)
    {
        PhysicsSimulator simulator = Falling();
        floor = Floor(simulator);
        return simulator;
    }

    /// <summary>A static floor, 400 wide, whose surface is at y = 0.</summary>
    public static Geom Floor(PhysicsSimulator simulator)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 400, 20, 1);
        body.IsStatic = true;
        body.Position = new Vector2(0, 10);
        return GeomFactory.Instance.CreateRectangleGeom(simulator, body, 400, 20);
    }

    public static Geom Box(PhysicsSimulator simulator, Vector2 place, float width = 20, float height = 20, float mass = 1)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, mass);
        body.Position = place;
        WithoutDrag(body);
        return GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height);
    }

    public static Geom Ball(PhysicsSimulator simulator, Vector2 place, float radius = 5, float mass = 1, int edges = 16)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, radius, mass);
        body.Position = place;
        WithoutDrag(body);
        return GeomFactory.Instance.CreateCircleGeom(simulator, body, radius, edges);
    }

    public static void WithoutDrag(Body body)
    {
        body.LinearDragCoefficient = 0;
        body.RotationalDragCoefficient = 0;
    }

    public static void Run(PhysicsSimulator simulator, int steps, float dt = Step)
    {
        for (int i = 0; i < steps; i++)
        {
            simulator.Update(dt);
        }
    }

    public static Vertices Outline(params float[] coordinates)
    {
        var outline = new Vertices();
        for (int i = 0; i < coordinates.Length; i += 2)
        {
            outline.Add(new Vector2(coordinates[i], coordinates[i + 1]));
        }

        return outline;
    }
}
