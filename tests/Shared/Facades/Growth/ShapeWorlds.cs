using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using static Farseer.Tests.Shared.Growth.GrowthWorlds;

namespace Farseer.Tests.Shared.Growth;

/// <summary>Shapes of many points, below a few balls, and controllers of many geoms.</summary>
internal static class ShapeWorlds
{
    private const int Balls = 20;

    public static IReadOnlyList<GrowthWorld> All { get; } =
    [
        new("a chain of many points as the ground", "points", ChainGround),
        new("a polygon of many corners, wavy", "corners", (s, n) => Polygon(s, Wave(n))),
        new("a polygon of many corners, a comb of spikes", "corners", (s, n) => Polygon(s, Spikes(n))),
        new("a polygon of many corners, a spiral", "corners", (s, n) => Polygon(s, Spiral(n))),
        new("outlines of a bitmap, spots", "pixels", Spots),
        new("outlines of a bitmap, a sieve", "pixels", Sieve),
        new("balls in a fluid", "balls", Fluid),
    ];

    /// <summary>A circle whose radius goes up and down.</summary>
    public static Vertices Wave(int n) => new(Enumerable.Range(0, n).Select(i =>
    {
        double angle = 2 * Math.PI * i / n;
        double radius = 20 + (2 * Math.Sin(angle * Math.Max(1, n / 16)));
        return new Vector2((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle)));
    }).ToArray());

    /// <summary>A bar with a tooth for each two corners.</summary>
    public static Vertices Spikes(int n)
    {
        List<Vector2> points = Enumerable.Range(0, n - 2).Select(i => new Vector2(i, i % 2 == 0 ? 0 : -10)).ToList();
        points.Add(new Vector2(n - 3, 2));
        points.Add(new Vector2(0, 2));
        return new Vertices(points.ToArray());
    }

    /// <summary>A band that is rolled up, by more turns the more corners it has.</summary>
    public static Vertices Spiral(int n)
    {
        int half = n / 2;
        IEnumerable<Vector2> Edge(float width) => Enumerable.Range(0, half).Select(i =>
        {
            double angle = 2 * Math.PI * i / 24;
            double radius = 5 + (0.1 * angle) + width;
            return new Vector2((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle)));
        });
        return new Vertices(Edge(0.3f).Concat(Edge(0).Reverse()).ToArray());
    }

    private static Action ChainGround(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        Body ground = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        ground.IsStatic = true;
        var points = new Vertices(Enumerable.Range(0, n).Select(i => new Vector2(i - (0.5f * n), 0.2f * (i % 3))).ToArray());
        GeomFactory.Instance.CreateChainGeom(simulator, ground, points, false);
        return DropBalls(simulator, -1);
    }

    private static Action Polygon(PhysicsSimulator simulator, Vertices outline)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        Body ground = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        ground.IsStatic = true;
        GeomFactory.Instance.CreatePolygonGeom(simulator, ground, outline, 0);
        return DropBalls(simulator, -24);
    }

    /// <summary>Spots of which many touch each other.</summary>
    private static Action Spots(PhysicsSimulator simulator, int n)
    {
        Random chance = Chance();
        return Outlines(n, (_, _) => chance.NextDouble() < 0.4);
    }

    /// <summary>One thing with a hole wherever it can have one.</summary>
    private static Action Sieve(PhysicsSimulator simulator, int n) => Outlines(n, (x, y) => x % 2 == 0 || y % 2 == 0);

    private static Action Outlines(int n, Func<int, int, bool> isSolid)
    {
        int side = ((int)Math.Sqrt(n) / 2 * 2) + 1;
        uint[] bits = new uint[side * side];
        for (int i = 0; i < bits.Length; i++)
        {
            bits[i] = isSolid(i % side, i / side) ? 0xFF000000 : 0;
        }

        return () => Vertices.CreatePolygons(bits, side, side, Vector2.Zero, 20, 0);
    }

    private static Action Fluid(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        float side = 2 * MathF.Ceiling(MathF.Sqrt(n));
        var water = new FluidDragController();
        water.Initialize(
            new AABBFluidContainer(new AABB(new Vector2(-side, -2 * side), new Vector2(side, side))), 0.5f, 0.1f, 0.1f,
            new Vector2(0, Gravity));
        foreach (Vector2 place in Square(n, 2))
        {
            water.AddGeom(Ball(simulator, place));
        }

        simulator.Add(water);
        return GrowthWorld.Nothing;
    }

    private static Action DropBalls(PhysicsSimulator simulator, float bottom)
    {
        foreach (Vector2 place in Square(Balls, 1.1f, bottom))
        {
            Ball(simulator, place);
        }

        return GrowthWorld.Nothing;
    }
}
