using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using static Farseer.Tests.Shared.Growth.GrowthWorlds;

namespace Farseer.Tests.Shared.Growth;

/// <summary>Bodies that touch: many, or one of them many.</summary>
internal static class ContactWorlds
{
    public static IReadOnlyList<GrowthWorld> All { get; } =
    [
        new("one pile", "balls", Pile),
        new("one tower", "boxes", Tower),
        new("one body with many geoms, on a floor", "geoms", ManyGeoms),
        new("one plank below many boxes", "boxes", Plank),
        new("one sensor around many balls", "balls", Sensor),
        new("balls that meet and part in a row", "balls", Gas),
        new("bodies at one point", "bodies", OnePoint, GrowthWorld.Pairs),
    ];

    private static Action Pile(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        float side = 1.05f * MathF.Ceiling(MathF.Sqrt(n));
        Floor(simulator, side + 10);
        Block(simulator, new Vector2((-0.5f * side) - 2, -side), 2, 2 * side);
        Block(simulator, new Vector2((0.5f * side) + 1, -side), 2, 2 * side);
        int i = 0;
        foreach (Vector2 place in Square(n, 1.05f, -0.5f))
        {
            Ball(simulator, place + new Vector2(0.01f * (i++ % 7), 0));
        }

        return GrowthWorld.Nothing;
    }

    private static Action Tower(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        Floor(simulator, 100);
        for (int i = 0; i < n; i++)
        {
            Box(simulator, new Vector2(0, -0.5f - i));
        }

        return GrowthWorld.Nothing;
    }

    private static Action ManyGeoms(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        Floor(simulator, n + 10);
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, n, 1, n);
        body.Position = new Vector2(0, -0.5f);
        for (int i = 0; i < n; i++)
        {
            GeomFactory.Instance.CreateCircleGeom(simulator, body, 0.5f, 16, new Vector2(i - (0.5f * n), 0), 0);
        }

        return GrowthWorld.Nothing;
    }

    private static Action Plank(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        Floor(simulator, (1.5f * n) + 20);
        Box(simulator, new Vector2(0, -0.5f), (1.5f * n) + 10, 1);
        for (int i = 0; i < n; i++)
        {
            Box(simulator, new Vector2(1.5f * (i - (0.5f * n)), -1.5f));
        }

        return GrowthWorld.Nothing;
    }

    private static Action Sensor(PhysicsSimulator simulator, int n)
    {
        float side = 2 * MathF.Ceiling(MathF.Sqrt(n));
        Random chance = Chance();
        foreach (Vector2 place in Square(n, 2))
        {
            Ball(simulator, place).Body.LinearVelocity.X = (float)chance.NextDouble() - 0.5f;
        }

        Body zone = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        zone.IsStatic = true;
        zone.Position = new Vector2(0, -0.5f * side);
        Geom sensor = GeomFactory.Instance.CreateRectangleGeom(simulator, zone, side, side);
        sensor.IsSensor = true;
        return GrowthWorld.Nothing;
    }

    private static Action Gas(PhysicsSimulator simulator, int n)
    {
        Random chance = Chance();
        Block(simulator, new Vector2((-0.75f * n) - 2, 0), 2, 4);
        Block(simulator, new Vector2((0.75f * n) + 2, 0), 2, 4);
        for (int i = 0; i < n; i++)
        {
            Geom ball = Ball(simulator, new Vector2(1.5f * (i - (0.5f * n)), 0));
            ball.Body.LinearVelocity.X = (float)(10 * chance.NextDouble()) - 5;
            ball.RestitutionCoefficient = 1;
        }

        return GrowthWorld.Nothing;
    }

    private static Action OnePoint(PhysicsSimulator simulator, int n)
    {
        for (int i = 0; i < n; i++)
        {
            Ball(simulator, Vector2.Zero);
        }

        return GrowthWorld.Nothing;
    }
}
