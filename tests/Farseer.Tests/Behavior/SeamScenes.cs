using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Tests.Behavior;

/// <summary>
/// Random worlds of static pieces that lie side by side, and of walls that are thin. Each returns by how much it went wrong.
/// </summary>
internal static class SeamScenes
{
    private const float Dt = 1 / 60f;
    private static readonly float[] Depths = [0, 0.001f, 0.005f, 0.05f];

    /// <summary>What falls on a floor of pieces while it moves along; the share of its speed that it loses or gains.</summary>
    public static float Landing(int seed)
    {
        var random = new Random(seed);
        float depth = Depths[seed % Depths.Length];
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = depth };
        float tile = Range(random, 0.4f, 2);
        Floor(simulator, random.Next(4), tile, 40);
        float size = Range(random, 0.3f, 1.2f);
        bool round = random.Next(3) == 0;
        Body body = Mover(simulator, round, size, turns: random.Next(2) == 0 && !round);
        float speed = Range(random, 0.5f, 8) * (random.Next(2) == 0 ? 1 : -1);
        body.Position = new Vector2(Range(random, -2, 2), (size / 2) + (random.Next(4) == 0 ? 0 : Range(random, 0, 0.2f)));
        body.LinearVelocity = new Vector2(speed, -Range(random, 0, 8));
        return WorstLoss(simulator, body, speed, 40);
    }

    /// <summary>The same by more than its size a step.</summary>
    public static float FastLanding(int seed)
    {
        var random = new Random(seed);
        float depth = Depths[seed % Depths.Length];
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = depth };
        float tile = Range(random, 0.4f, 2);
        Floor(simulator, random.Next(4), tile, 200);
        float size = Range(random, 0.3f, 1.2f);
        Body body = Mover(simulator, random.Next(3) == 0, size, turns: false);
        float speed = Range(random, 20, 100);
        body.Position = new Vector2(Range(random, -2, 2), (size / 2) + (random.Next(4) == 0 ? 0 : Range(random, 0, 1)));
        body.LinearVelocity = new Vector2(speed, -Range(random, 0, 30));
        return WorstLoss(simulator, body, speed, 40);
    }

    /// <summary>What slides on a floor against a piece that stands higher; by which share of its size it gets into that.</summary>
    public static float Ledge(int seed)
    {
        var random = new Random(seed);
        float depth = Depths[seed % Depths.Length];
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = depth };
        float tile = Range(random, 0.4f, 2);
        int kind = random.Next(4);
        Floor(simulator, kind, tile, 40);
        float size = Range(random, 0.3f, 1.2f);
        float height = Range(random, 0.03f, 1.5f) * size;
        float side = random.Next(5) * tile;
        bool stands = random.Next(2) == 0;
        Body ledge = Ground(simulator, new Vector2(side + 1, stands ? height / 2 : height - 1));
        Smooth(GeomFactory.Instance.CreateRectangleGeom(simulator, ledge, 2, stands ? height : 2));
        bool tapers = random.Next(3) == 0;
        Body body = tapers ? Tapered(simulator, size) : Mover(simulator, false, size, turns: false);
        float speed = Range(random, 0.5f, 5);
        body.Position = new Vector2(side - size, size / 2);
        body.LinearVelocity = new Vector2(speed, 0);
        float worst = 0;
        for (int i = 0; i < 90; i++)
        {
            if (random.Next(10) == 0)
            {
                body.LinearVelocity.X = speed;
            }

            simulator.Update(Dt);
            worst = Math.Max(worst, (body.Position.X + (size / 2) - side) / size);
        }

        return worst;
    }

    /// <summary>What is pressed on a wall of pieces while it falls along it; by which share of its way it lags behind.</summary>
    public static float Pressed(int seed)
    {
        var random = new Random(seed);
        float depth = Depths[seed % Depths.Length];
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = depth };
        float tile = Range(random, 0.4f, 2);
        Wall(simulator, random.Next(4), tile, 40);
        float size = Range(random, 0.3f, 1.2f);
        bool round = random.Next(3) == 0;
        Body body = Mover(simulator, round, size, turns: false);
        bool byForce = random.Next(2) == 0;
        float push = byForce ? Range(random, 1, 100) : Range(random, 0.2f, 5);
        body.Position = new Vector2(-(size / 2) - (random.Next(2) == 0 ? 0 : Range(random, 0, 0.05f)), Range(random, 1, 3));
        float start = body.Position.Y;
        const int Steps = 60;
        for (int i = 0; i < Steps; i++)
        {
            if (byForce)
            {
                body.ApplyForce(new Vector2(push, 0));
            }
            else
            {
                body.LinearVelocity.X = push;
            }

            simulator.Update(Dt);
        }

        float fall = 0.5f * 10 * (Steps * Dt) * (Steps * Dt);
        return 1 - ((start - body.Position.Y) / fall);
    }

    /// <summary>
    /// What walks over a floor at a velocity along that is set in each step; by which share of its way it lags behind, or how fast it hops.
    /// </summary>
    public static float Walking(int seed)
    {
        var random = new Random(seed);
        float depth = Depths[seed % Depths.Length];
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = depth };
        float tile = Range(random, 0.4f, 2);
        Floor(simulator, random.Next(4), tile, 60);
        float size = Range(random, 0.3f, 1.2f);
        Body body = Mover(simulator, random.Next(3) == 0, size, turns: false);
        float speed = Range(random, 0.5f, 8);
        body.Position = new Vector2(Range(random, -2, 0), size / 2);
        float start = body.Position.X;
        const int Steps = 180;
        float hop = 0;
        for (int i = 0; i < Steps; i++)
        {
            body.LinearVelocity.X = speed;
            if (random.Next(30) == 0)
            {
                body.LinearVelocity.Y = -Range(random, 0, 6);
            }

            simulator.Update(Dt);
            hop = Math.Max(hop, body.LinearVelocity.Y / speed);
        }

        return Math.Max(1 - ((body.Position.X - start) / (speed * Steps * Dt)), hop);
    }

    /// <summary>What slides over two slabs, the second of which leads down; the share of its speed that it loses.</summary>
    public static float Bend(int seed)
    {
        var random = new Random(seed);
        float degrees = 1 + (seed % 45);
        float depth = Depths[random.Next(Depths.Length)];
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = depth };
        float turn = -degrees * MathF.PI / 180;
        bool lines = random.Next(3) == 0;
        if (lines)
        {
            Segment(simulator, new Vector2(-6, 0), Vector2.Zero);
            Segment(simulator, Vector2.Zero, 20 * new Vector2(MathF.Cos(turn), MathF.Sin(turn)));
        }
        else
        {
            Slab(simulator, -3, -0.5f, 6, 0);
            float x = (10 * MathF.Cos(turn)) + (0.5f * MathF.Sin(turn));
            Slab(simulator, x, (10 * MathF.Sin(turn)) - (0.5f * MathF.Cos(turn)), 20, turn);
        }

        float size = Range(random, 0.3f, 1.2f);
        Body body = Mover(simulator, random.Next(3) == 0, size, turns: random.Next(3) > 0);
        float speed = Range(random, 0.5f, 8);
        body.Position = new Vector2(-Range(random, 0.7f, 1.5f), size / 2);
        body.LinearVelocity = new Vector2(speed, 0);
        float worst = 0;
        for (int i = 0; i < 100; i++)
        {
            simulator.Update(Dt);
            worst = Math.Max(worst, 1 - (body.LinearVelocity.X / speed));
        }

        return worst;
    }

    /// <summary>
    /// What lies corner on corner with the pieces: a box as wide as they are that slides off, or falls along their side. The share lost.
    /// </summary>
    public static float Aligned(int seed)
    {
        var random = new Random(seed);
        float depth = Depths[seed % Depths.Length];
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = depth };
        float tile = random.Next(2) == 0 ? 1 : Range(random, 0.4f, 2);
        int kind = random.Next(4);
        bool falls = random.Next(2) == 0;
        Body body = Mover(simulator, false, tile, turns: random.Next(2) == 0);
        float start = random.Next(4) * tile;
        if (falls)
        {
            Wall(simulator, kind, tile, 40);
            body.Position = new Vector2(-tile / 2, start + (tile / 2));
            start = body.Position.Y;
            for (int i = 0; i < 60; i++)
            {
                simulator.Update(Dt);
            }

            return 1 - ((start - body.Position.Y) / 5);
        }

        Floor(simulator, kind, tile, 40);
        float speed = Range(random, 0.5f, 8);
        body.Position = new Vector2(start + (tile / 2), (tile / 2) - (random.Next(2) == 0 ? 0 : depth));
        body.LinearVelocity = new Vector2(speed, -Range(random, 0, 4));
        return WorstLoss(simulator, body, speed, 60);
    }

    /// <summary>A small ball shot at something thin; true if it passed.</summary>
    public static bool Passes(int seed)
    {
        var random = new Random(seed);
        float depth = seed % 3 == 0 ? 0.05f : seed % 3 == 1 ? 0.01f : 0;
        using var simulator = new PhysicsSimulator { AllowedPenetration = depth };
        float radius = 0.005f * MathF.Pow(24, (float)random.NextDouble());
        float speed = 5 * MathF.Pow(200, (float)random.NextDouble());
        float width = Range(random, 0.02f, 0.06f);
        Body ball = Mover(simulator, true, 2 * radius, turns: true);
        ball.IsBullet = random.Next(2) == 0;
        float gap = Range(random, 0, 1) * speed * Dt * 3;
        ball.Position = new Vector2(-gap - radius - width, 0);
        ball.LinearVelocity = new Vector2(speed, 0);
        Body wall;
        int kind = random.Next(5);
        if (kind == 3)
        {
            wall = Segment(simulator, new Vector2(0, -1), new Vector2(0, 1));
        }
        else if (kind == 4)
        {
            // Only a bullet is looked after against what can move.
            ball.IsBullet = true;
            wall = Mover(simulator, true, Range(random, 0.1f, 0.4f), turns: true);
        }
        else
        {
            wall = BodyFactory.Instance.CreateRectangleBody(simulator, width, 2, 1e6f);
            GeomFactory.Instance.CreateRectangleGeom(simulator, wall, width, 2).RestitutionCoefficient = 0;
            wall.IsStatic = kind == 0;
            wall.IsKinematic = kind == 1;
            ball.IsBullet |= kind == 2;
        }

        int steps = (int)(gap / (speed * Dt)) + 12;
        for (int i = 0; i < steps; i++)
        {
            simulator.Update(Dt);
        }

        return ball.Position.X > wall.Position.X;
    }

    /// <summary>A box of 1 m over a hole that is narrower; how deep it fell.</summary>
    public static float Hole(int seed)
    {
        var random = new Random(seed);
        float hole = seed % 2 == 0 ? 0.9f : 0.99f;
        float depth = Depths[seed / 2 % Depths.Length];
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = depth };
        Brink(simulator, (-hole / 2) - 5, random.Next(2) == 0);
        Brink(simulator, (hole / 2) + 5, random.Next(2) == 0);
        Body box = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        Sandbox.WithoutDrag(box);
        GeomFactory.Instance.CreateRectangleGeom(simulator, box, 1, 1).FrictionCoefficient = random.Next(2) == 0 ? 0 : 0.5f;
        box.Position = new Vector2(Range(random, -0.4f, 0.4f) * (1 - hole), 0.5f + (random.Next(3) == 0 ? 0 : Range(random, 0, 3)));
        for (int i = 0; i < 240; i++)
        {
            simulator.Update(Dt);
        }

        return 0.5f - box.Position.Y;
    }

    private static float WorstLoss(PhysicsSimulator simulator, Body body, float speed, int steps)
    {
        float worst = 0;
        for (int i = 0; i < steps; i++)
        {
            simulator.Update(Dt);
            worst = Math.Max(worst, Math.Abs(1 - (body.LinearVelocity.X / speed)));
        }

        return worst;
    }

    private static float Range(Random random, float least, float most) => least + ((most - least) * (float)random.NextDouble());

    private static Body Mover(PhysicsSimulator simulator, bool round, float size, bool turns)
    {
        Body body;
        Geom geom;
        if (round)
        {
            body = BodyFactory.Instance.CreateCircleBody(simulator, size / 2, 1);
            geom = GeomFactory.Instance.CreateCircleGeom(simulator, body, size / 2, 16);
        }
        else
        {
            body = BodyFactory.Instance.CreateRectangleBody(simulator, size, size, 1);
            geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, size, size);
        }

        Sandbox.WithoutDrag(body);
        Smooth(geom);
        if (!turns)
        {
            body.MomentOfInertia = 1e20f;
        }

        return body;
    }

    /// <summary>A body that is wider below than above: its foremost corners are its lowest.</summary>
    private static Body Tapered(PhysicsSimulator simulator, float size)
    {
        float half = size / 2;
        Vertices outline = Sandbox.Outline(-half, -half, half, -half, 0.7f * half, half, -0.7f * half, half);
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1e20f);
        Sandbox.WithoutDrag(body);
        var geom = new Geom(body, outline, Vector2.Zero, 0, 0);
        Smooth(geom);
        simulator.Add(geom);
        return body;
    }

    /// <summary>
    /// Pieces along the x axis whose upper sides are at 0: boxes of a body each, of one body, segments, boxes that overlap.
    /// </summary>
    private static void Floor(PhysicsSimulator simulator, int kind, float tile, int count)
    {
        Body? ground = kind == 1 ? Ground(simulator, Vector2.Zero) : null;
        for (int i = -count / 2; i < count; i++)
        {
            if (kind == 2)
            {
                Segment(simulator, new Vector2(i * tile, 0), new Vector2((i + 1) * tile, 0));
            }
            else
            {
                var centre = new Vector2((i + 0.5f) * tile, -tile / 2);
                float width = kind == 3 ? 1.1f * tile : tile;
                Smooth(ground != null
                    ? GeomFactory.Instance.CreateRectangleGeom(simulator, ground, width, tile, centre, 0)
                    : GeomFactory.Instance.CreateRectangleGeom(simulator, Ground(simulator, centre), width, tile));
            }
        }
    }

    /// <summary>The same along the y axis, their sides at x = 0 and to the right of it.</summary>
    private static void Wall(PhysicsSimulator simulator, int kind, float tile, int count)
    {
        Body? ground = kind == 1 ? Ground(simulator, Vector2.Zero) : null;
        for (int i = -count; i < count / 2; i++)
        {
            if (kind == 2)
            {
                Segment(simulator, new Vector2(0, i * tile), new Vector2(0, (i + 1) * tile));
            }
            else
            {
                var centre = new Vector2(tile / 2, (i + 0.5f) * tile);
                float height = kind == 3 ? 1.1f * tile : tile;
                Smooth(ground != null
                    ? GeomFactory.Instance.CreateRectangleGeom(simulator, ground, tile, height, centre, 0)
                    : GeomFactory.Instance.CreateRectangleGeom(simulator, Ground(simulator, centre), tile, height));
            }
        }
    }

    private static void Brink(PhysicsSimulator simulator, float x, bool inTiles)
    {
        for (int i = 0; i < (inTiles ? 10 : 1); i++)
        {
            float width = inTiles ? 1 : 10;
            Body body = Ground(simulator, new Vector2(inTiles ? x - 4.5f + i : x, -0.5f));
            GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, 1).FrictionCoefficient = 0.5f;
        }
    }

    private static void Slab(PhysicsSimulator simulator, float x, float y, float width, float turn)
    {
        Body body = Ground(simulator, new Vector2(x, y));
        body.Rotation = turn;
        Smooth(GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, 1));
    }

    private static Body Segment(PhysicsSimulator simulator, Vector2 from, Vector2 to)
    {
        Vector2 centre = 0.5f * (from + to);
        Body body = Ground(simulator, centre);
        Smooth(GeomFactory.Instance.CreateSegmentGeom(simulator, body, from - centre, to - centre));
        return body;
    }

    private static Body Ground(PhysicsSimulator simulator, Vector2 place)
    {
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        body.IsStatic = true;
        body.Position = place;
        return body;
    }

    private static void Smooth(Geom geom)
    {
        geom.FrictionCoefficient = 0;
        geom.RestitutionCoefficient = 0;
    }
}
