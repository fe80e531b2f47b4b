using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Tests.Shared.Growth;

/// <summary>The kinds of worlds, and what they are made of: metres, y down.</summary>
internal static class GrowthWorlds
{
    public const float Gravity = 10;

    public static IReadOnlyList<GrowthWorld> All { get; } =
        [.. BodyWorlds.All, .. ContactWorlds.All, .. JointWorlds.All, .. ChangingWorlds.All, .. ShapeWorlds.All];

    public static GrowthWorld Find(string name) => All.Single(w => w.Name == name);

    public static Geom Ball(PhysicsSimulator simulator, Vector2 place, float radius = 0.5f) =>
        GeomFactory.Instance.CreateCircleGeom(
            simulator, At(BodyFactory.Instance.CreateCircleBody(simulator, radius, 1), place), radius, 16);

    public static Geom Box(PhysicsSimulator simulator, Vector2 place, float width = 1, float height = 1) =>
        GeomFactory.Instance.CreateRectangleGeom(
            simulator, At(BodyFactory.Instance.CreateRectangleBody(simulator, width, height, width * height), place), width, height);

    /// <summary>A static box.</summary>
    public static Body Block(PhysicsSimulator simulator, Vector2 place, float width, float height)
    {
        Body body = Box(simulator, place, width, height).Body;
        body.IsStatic = true;
        return body;
    }

    /// <summary>A static box as wide as it must be whose surface is at y = 0.</summary>
    public static void Floor(PhysicsSimulator simulator, float width) => Block(simulator, new Vector2(0, 1), width, 2);

    /// <summary>Places in a square with its lower edge at a height, from below.</summary>
    public static IEnumerable<Vector2> Square(int count, float spacing, float bottom = 0)
    {
        int columns = (int)Math.Ceiling(Math.Sqrt(count));
        for (int i = 0; i < count; i++)
        {
            yield return new Vector2(((i % columns) - (0.5f * columns)) * spacing, bottom - (spacing * (i / columns)));
        }
    }

    /// <summary>The same each time, on every machine.</summary>
    public static Random Chance() => new(7);

    private static Body At(Body body, Vector2 place)
    {
        body.Position = place;
        body.LinearDragCoefficient = 0;
        body.RotationalDragCoefficient = 0;
        return body;
    }
}
