using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using static Farseer.Tests.Shared.Growth.GrowthWorlds;

namespace Farseer.Tests.Shared.Growth;

/// <summary>Worlds of which a part is another one in each update.</summary>
internal static class ChangingWorlds
{
    /// <summary>One in so many goes, and one comes.</summary>
    private const int Share = 16;

    public static IReadOnlyList<GrowthWorld> All { get; } =
    [
        new("bodies that come and go", "bodies", Bodies),
        new("joints that come and go between pairs", "joints", Joints),
        new("joints of one chain that come and go", "joints", ChainJoints),
        new("two halves of a chain that merge and split", "links", Halves),
        new("poses set by hand", "bodies", Poses),
        new("geoms that change their outline", "geoms", Outlines),
    ];

    private static Action Bodies(PhysicsSimulator simulator, int n)
    {
        simulator.Gravity = new Vector2(0, Gravity);
        var bodies = new Queue<Body>(Square(n, 2).Select(p => Box(simulator, p).Body));
        return () =>
        {
            for (int i = 0; i < n / Share; i++)
            {
                Body old = bodies.Dequeue();
                Vector2 place = old.Position;
                old.Dispose();
                bodies.Enqueue(Box(simulator, place).Body);
            }
        };
    }

    private static Action Joints(PhysicsSimulator simulator, int n)
    {
        var pairs = new Queue<(Body A, Body B, RevoluteJoint Joint)>(Square(n, 5).Select(p =>
        {
            Body a = Ball(simulator, p).Body;
            Body b = Ball(simulator, p + new Vector2(2, 0)).Body;
            return (a, b, Tie(simulator, a, b));
        }));
        return () =>
        {
            for (int i = 0; i < n / Share; i++)
            {
                (Body a, Body b, RevoluteJoint joint) = pairs.Dequeue();
                joint.Dispose();
                pairs.Enqueue((a, b, Tie(simulator, a, b)));
            }
        };
    }

    private static Action ChainJoints(PhysicsSimulator simulator, int n)
    {
        Body[] links = Enumerable.Range(0, n + 1).Select(i => Ball(simulator, new Vector2(i, 0), 0.4f).Body).ToArray();
        Joint[] joints = Enumerable.Range(0, n).Select(i => Tie(simulator, links[i], links[i + 1])).ToArray();
        int next = 0;
        return () =>
        {
            for (int i = 0; i < n / Share; i++)
            {
                // All over the chain, not end to end.
                next = (next + (n / 3) + 1) % n;
                joints[next].Dispose();
                joints[next] = Tie(simulator, links[next], links[next + 1]);
            }
        };
    }

    private static Action Halves(PhysicsSimulator simulator, int n)
    {
        Body[] links = Enumerable.Range(0, n).Select(i => Ball(simulator, new Vector2(i, 0), 0.4f).Body).ToArray();
        for (int i = 1; i < n; i++)
        {
            if (i != n / 2)
            {
                Tie(simulator, links[i - 1], links[i]);
            }
        }

        Joint? middle = null;
        return () =>
        {
            middle?.Dispose();
            middle = middle is null ? Tie(simulator, links[(n / 2) - 1], links[n / 2]) : null;
        };
    }

    private static Action Poses(PhysicsSimulator simulator, int n)
    {
        Body[] bodies = Square(n, 2).Select(p => Box(simulator, p).Body).ToArray();
        return () =>
        {
            foreach (Body body in bodies)
            {
                body.Position += new Vector2(0.01f, 0);
                body.Rotation += 0.01f;
            }
        };
    }

    private static Action Outlines(PhysicsSimulator simulator, int n)
    {
        Geom[] geoms = Square(n, 3).Select(p => Box(simulator, p)).ToArray();
        int turn = 0;
        return () =>
        {
            float size = 1 + (0.1f * (turn++ % 2));
            foreach (Geom geom in geoms)
            {
                geom.SetVertices(Vertices.CreateRectangle(size, size));
            }
        };
    }

    private static RevoluteJoint Tie(PhysicsSimulator simulator, Body a, Body b) =>
        JointFactory.Instance.CreateRevoluteJoint(simulator, a, b, 0.5f * (a.Position + b.Position));
}
