using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using static Farseer.Tests.Shared.Growth.GrowthWorlds;

namespace Farseer.Tests.Shared.Growth;

/// <summary>Bodies that hardly touch, and questions about them.</summary>
internal static class BodyWorlds
{
    private const int Movers = 50;

    public static IReadOnlyList<GrowthWorld> All { get; } =
    [
        new("bodies far apart", "bodies", FarApart),
        new("static geoms below a few balls", "static geoms", StaticGeoms),
        new("bodies asleep beside a few awake", "bodies", Asleep),
        new("queries: a ray, a point, a box and a circle for each body", "bodies", Queries),
        new("a state captured and restored", "bodies", States),
    ];

    private static Action FarApart(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        foreach (Vector2 place in Square(n, 10))
        {
            Box(simulator, place);
        }

        return GrowthWorld.Nothing;
    }

    private static Action StaticGeoms(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        foreach (Vector2 place in Square(n, 2))
        {
            Block(simulator, place, 1, 1);
        }

        foreach (Vector2 place in Square(Movers, 2.3f, -1))
        {
            Ball(simulator, place, 0.4f);
        }

        return GrowthWorld.Nothing;
    }

    private static Action Asleep(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        simulator.AllowSleep = true;
        simulator.TimeToSleep = 0.1f;
        Floor(simulator, (3f * n) + 300);
        for (int i = 0; i < n; i++)
        {
            Box(simulator, new Vector2(3 * (i - (0.5f * n)), -0.5f));
        }

        // They fall asleep within the updates that are not timed.
        for (int i = 0; i < 60; i++)
        {
            simulator.Update(1 / 60f);
        }

        for (int i = 0; i < Movers; i++)
        {
            Ball(simulator, new Vector2((1.5f * n) + 10 + (2 * i), -0.5f)).Body.LinearVelocity.X = 1;
        }

        return GrowthWorld.Nothing;
    }

    private static Action Queries(PhysicsSimulator simulator, int n)
    {
        Vector2[] places = Square(n, 2).ToArray();
        foreach (Vector2 place in places)
        {
            Ball(simulator, place);
        }

        var found = new List<Geom>();
        var reach = new Vector2(3, 1);
        return () =>
        {
            foreach (Vector2 place in places)
            {
                found.Clear();
                simulator.RayCast(place - reach, place + reach, out _);
                simulator.QueryPoint(place, found);
                simulator.Query(new AABB(place - reach, place + reach), found);
                simulator.QueryCircle(place, 1.4f, found);
            }
        };
    }

    private static Action States(PhysicsSimulator simulator, int n)
    {
        FarApart(simulator, n);
        PhysicsSimulatorState? state = null;
        return () =>
        {
            state ??= simulator.Capture();
            simulator.Capture(state);
            simulator.Restore(state);
        };
    }
}
