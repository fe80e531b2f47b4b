using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>
/// Bodies with one geom each. Drag is off, because the outcomes are compared with closed forms without air;
/// a body belongs to its geom, so only the geom is handed back.
/// </summary>
internal static class Make
{
    /// <summary>What a resting place may be off by, in the scenes that are built in metres, or a share of it.</summary>
    public const float Tolerance = 0.001f;

    public const float Gravity = 10f;

    /// <summary>y up, 10 m/s².</summary>
    public static void Metres(PhysicsSimulator simulator)
    {
        simulator.Gravity = new Vector2(0f, -Gravity);
    }

    public static Geom Box(PhysicsSimulator simulator, Vector2 position, float width, float height, float friction = 0.5f)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, width * height);
        return Finish(GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height), position, friction);
    }

    public static Geom Circle(PhysicsSimulator simulator, Vector2 position, float radius, float friction = 0.5f)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, radius, 3.14159265f * radius * radius);
        return Finish(GeomFactory.Instance.CreateCircleGeom(simulator, body, radius, 24), position, friction);
    }

    /// <summary>Any simple outline; <paramref name="position"/> is where its centroid goes.</summary>
    public static Geom Polygon(PhysicsSimulator simulator, Vector2 position, Vector2[] outline, float mass, float friction = 0.5f)
    {
        Body body = BodyFactory.Instance.CreatePolygonBody(simulator, new Vertices(outline), mass);
        return Finish(GeomFactory.Instance.CreatePolygonGeom(simulator, body, new Vertices(outline), 0f), position, friction);
    }

    /// <summary>A static box.</summary>
    public static Geom Wall(
        PhysicsSimulator simulator, Vector2 position, float width, float height, float rotation = 0f, float friction = 0.5f)
    {
        Geom geom = Box(simulator, position, width, height, friction);
        geom.Body.Rotation = rotation;
        geom.Body.IsStatic = true;
        return geom;
    }

    /// <summary>Static ground whose top is the line y = 0.</summary>
    public static Geom Floor(PhysicsSimulator simulator, float width, float centreX = 0f, float friction = 0.5f) =>
        Wall(simulator, new Vector2(centreX, -0.5f), width, 1f, 0f, friction);

    public static void NoDrag(Body body)
    {
        body.LinearDragCoefficient = 0f;
        body.RotationalDragCoefficient = 0f;
    }

    private static Geom Finish(Geom geom, Vector2 position, float friction)
    {
        geom.Body.Position = position;
        NoDrag(geom.Body);
        geom.FrictionCoefficient = friction;
        return geom;
    }
}
