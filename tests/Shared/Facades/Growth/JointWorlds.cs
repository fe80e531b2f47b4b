using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using static Farseer.Tests.Shared.Growth.GrowthWorlds;

namespace Farseer.Tests.Shared.Growth;

/// <summary>Bodies that joints and springs hold together.</summary>
internal static class JointWorlds
{
    public static IReadOnlyList<GrowthWorld> All { get; } =
    [
        new("one hanging chain", "links", Chain),
        new("one ring of links", "links", Ring),
        new("a hub with many joints", "joints", Hub),
        new("a comb: a chain of which each link carries another", "links", Comb),
        new("a cloth of hinges", "discs", Cloth),
        new("a cloth of springs", "balls", Springs),
        new("many ragdolls of four", "bodies", Groups),
        new("chains on a floor", "links", ChainsOnAFloor),
    ];

    private static void Hinge(PhysicsSimulator simulator, Body a, Body b) =>
        JointFactory.Instance.CreateRevoluteJoint(simulator, a, b, 0.5f * (a.Position + b.Position));

    private static Body[] Row(PhysicsSimulator simulator, int n, Vector2 start)
    {
        var links = new Body[n];
        for (int i = 0; i < n; i++)
        {
            links[i] = Ball(simulator, start + new Vector2(i, 0), 0.4f).Body;
            if (i > 0)
            {
                Hinge(simulator, links[i - 1], links[i]);
            }
        }

        return links;
    }

    private static Action Chain(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        Body[] links = Row(simulator, n, Vector2.Zero);
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, links[0], new Vector2(-0.5f, 0));
        return GrowthWorld.Nothing;
    }

    private static Action Ring(PhysicsSimulator simulator, int n)
    {
        float radius = n / (2 * MathF.PI);
        var links = new Body[n];
        for (int i = 0; i < n; i++)
        {
            double angle = 2 * Math.PI * i / n;
            links[i] = Ball(simulator, radius * new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle)), 0.4f).Body;

            // The rim is as fast at any size: faster links would have more contacts ahead of them.
            links[i].LinearVelocity = new Vector2(-(float)Math.Sin(angle), (float)Math.Cos(angle));
            if (i > 0)
            {
                Hinge(simulator, links[i - 1], links[i]);
            }
        }

        Hinge(simulator, links[n - 1], links[0]);
        return GrowthWorld.Nothing;
    }

    private static Action Hub(PhysicsSimulator simulator, int n)
    {
        float radius = n / 5f;
        Random chance = Chance();
        Body hub = Ball(simulator, Vector2.Zero, 1).Body;
        hub.Mass = n;
        for (int i = 0; i < n; i++)
        {
            double angle = 2 * Math.PI * i / n;
            Body spoke = Ball(simulator, radius * new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle))).Body;
            spoke.LinearVelocity.X = (float)chance.NextDouble();
            JointFactory.Instance.CreateRevoluteJoint(simulator, hub, spoke, spoke.Position);
        }

        return GrowthWorld.Nothing;
    }

    private static Action Comb(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        Body[] links = Row(simulator, n / 2, Vector2.Zero);
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, links[0], new Vector2(-0.5f, 0));
        foreach (Body link in links)
        {
            Hinge(simulator, link, Ball(simulator, link.Position + new Vector2(0, 1), 0.4f).Body);
        }

        return GrowthWorld.Nothing;
    }

    private static Action Cloth(PhysicsSimulator simulator, int n) => Net(simulator, n, (a, b) => Hinge(simulator, a, b));

    private static Action Springs(PhysicsSimulator simulator, int n) => Net(simulator, n, (a, b) =>
        SpringFactory.Instance.CreateLinearSpring(simulator, a, Vector2.Zero, b, Vector2.Zero, 1000, 1));

    private static Action Net(PhysicsSimulator simulator, int n, Action<Body, Body> tie)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        int side = (int)Math.Sqrt(n);
        var net = new Body[side, side];
        for (int y = 0; y < side; y++)
        {
            for (int x = 0; x < side; x++)
            {
                net[x, y] = Ball(simulator, new Vector2(x, y), 0.4f).Body;
                net[x, y].IsStatic = y == 0 && x % 10 == 0;
                if (x > 0)
                {
                    tie(net[x - 1, y], net[x, y]);
                }

                if (y > 0)
                {
                    tie(net[x, y - 1], net[x, y]);
                }
            }
        }

        return GrowthWorld.Nothing;
    }

    private static Action Groups(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        Floor(simulator, (8 * MathF.Sqrt(n)) + 20);
        foreach (Vector2 place in Square(n / 4, 6, -0.5f))
        {
            Row(simulator, 4, place);
        }

        return GrowthWorld.Nothing;
    }

    private static Action ChainsOnAFloor(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        Floor(simulator, (2f * n) + 20);
        Row(simulator, n, new Vector2(-0.5f * n, -0.4f));
        return GrowthWorld.Nothing;
    }
}
