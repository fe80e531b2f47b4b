using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes.Performance;

/// <summary>Adds bodies of one geom; sizes are half sizes, as in the published definitions.</summary>
internal sealed class Bricks
{
    private const float Friction = 0.6f;
    private readonly PhysicsSimulator _simulator;

    public Bricks(PhysicsSimulator simulator) => _simulator = simulator;

    public void StaticBox(float x, float y, float halfWidth, float halfHeight)
    {
        Body body = AddBody(x, y, 1f, 1f);
        body.IsStatic = true;
        Finish(GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 2f * halfWidth, 2f * halfHeight));
    }

    /// <summary>A level static segment.</summary>
    public void StaticSegment(float y, float length)
    {
        Body body = AddBody(0f, y, 1f, 1f);
        body.IsStatic = true;
        var reach = new Vector2(0.5f * length, 0f);
        Finish(GeomFactory.Instance.CreateSegmentGeom(_simulator, body, -reach, reach));
    }

    public void Box(float x, float y, float halfWidth, float halfHeight)
    {
        float mass = 4f * halfWidth * halfHeight;
        float inertia = mass * ((halfWidth * halfWidth) + (halfHeight * halfHeight)) / 3f;
        Body body = AddBody(x, y, mass, inertia);
        Finish(GeomFactory.Instance.CreateRectangleGeom(_simulator, body, 2f * halfWidth, 2f * halfHeight));
    }

    public void Circle(float x, float y, float radius)
    {
        float mass = (float)Math.PI * radius * radius;
        Body body = AddBody(x, y, mass, 0.5f * mass * radius * radius);
        Finish(GeomFactory.Instance.CreateCircleGeom(_simulator, body, radius, 16));
    }

    private static void Finish(Geom geom) => geom.FrictionCoefficient = Friction;

    private Body AddBody(float x, float y, float mass, float inertia)
    {
        Body body = BodyFactory.Instance.CreateBody(_simulator, mass, inertia);
        body.LinearDragCoefficient = 0f;
        body.RotationalDragCoefficient = 0f;
        body.Position = new Vector2(x, y);
        return body;
    }
}
