using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;

namespace Farseer.Benchmarks.Sleeping;

/// <summary>Time of a step of a world asleep beside the same world awake, and what it costs to allow sleep where nothing rests.</summary>
internal static class SleepTiming
{
    private const float Dt = 1f / 60;
    private const int Steps = 401;
    private const ColliderFlags Solid = ColliderFlags.CollisionEnabled | ColliderFlags.ResponseEnabled;

    public static int Run()
    {
        foreach (int bodies in new[] { 100, 1_000, 10_000, 100_000 })
        {
            Compare("hanging in the air", bodies, Hanging);
            Compare("stacks of two", bodies, Stacks);
        }

        foreach (int bodies in new[] { 1_000, 10_000 })
        {
            Unused(bodies);
        }

        return 0;
    }

    private static void Compare(string name, int bodies, Action<World, int> build)
    {
        World awake = Make(false);
        World asleep = Make(true);
        build(awake, bodies);
        build(asleep, bodies);
        int steps = 0;
        for (; steps < 600 && asleep.Sleep.AsleepCount < bodies; steps++)
        {
            asleep.Step(Dt);
        }

        double wide = Median(asleep, Steps);
        double full = Median(awake, bodies > 20_000 ? 41 : Steps);
        Console.WriteLine($"{bodies,7} {name,-20} asleep {asleep.Sleep.AsleepCount,7} after {steps,4} steps: {wide,8:F1} us a step, awake "
            + $"{full,10:F1} us");
    }

    /// <summary>A heap of balls that bounce without end: the same steps with and without sleep allowed, by turns.</summary>
    private static void Unused(int bodies)
    {
        World[] worlds = { Make(false), Make(true) };
        foreach (World world in worlds)
        {
            Bounce(world, bodies);
        }

        var ratios = new List<double>();
        for (int step = 0; step < 300; step++)
        {
            var ticks = new long[2];
            for (int turn = 0; turn < 2; turn++)
            {
                int which = (turn + step) & 1;
                long start = Stopwatch.GetTimestamp();
                worlds[which].Step(Dt);
                ticks[which] = Stopwatch.GetTimestamp() - start;
            }

            if (step >= 60)
            {
                ratios.Add((double)ticks[1] / ticks[0]);
            }
        }

        ratios.Sort();
        bool same = worlds[0].Bodies.MotionHash() == worlds[1].Bodies.MotionHash();
        Console.WriteLine($"{bodies,7} balls that bounce, none asleep ({worlds[1].Sleep.AsleepCount}): time with sleep allowed "
            + $"{ratios[ratios.Count / 2]:F4} of that without, {(same ? "same bits" : "OTHER BITS")}");
    }

    private static World Make(bool allowSleep)
    {
        var world = new World();
        world.Settings.Gravity = new Vector2(0, -10);
        world.Settings.AllowSleep = allowSleep;
        return world;
    }

    private static void Hanging(World world, int bodies)
    {
        for (int i = 0; i < bodies; i++)
        {
            Add(world, ShapeBuilder.Box(1, 1), (i % 100) * 1.5, i / 100 * 1.5, BodyFlags.IgnoreGravity, 0);
        }
    }

    private static void Stacks(World world, int bodies)
    {
        Add(world, ShapeBuilder.Box(2 * bodies, 1), 0, -0.5, BodyFlags.Static, 0);
        for (int i = 0; i < bodies; i++)
        {
            Add(world, ShapeBuilder.Box(1, 1), (i / 2 * 1.5) - (bodies * 0.375), (i % 2) + 0.5, BodyFlags.None, 0);
        }
    }

    private static void Bounce(World world, int bodies)
    {
        Add(world, ShapeBuilder.Box(1000, 2), 0, -1, BodyFlags.Static, 0.9f);
        for (int i = 0; i < bodies; i++)
        {
            Add(
                world,
                ShapeBuilder.Circle(0.5f),
                ((i % 100) * 1.3) - 60 + (0.1 * (i / 100 % 3)),
                3 + (i / 100 * 1.3),
                BodyFlags.None,
                0.9f);
        }
    }

    private static void Add(World world, ShapeGeometry shape, double x, double y, BodyFlags flags, float restitution)
    {
        var body = world.CreateBody(new BodyDef { X = x, Y = y, Mass = 1, Inertia = 1f / 6, Flags = BodyFlags.Enabled | flags });
        world.CreateCollider(
            body, shape, new ColliderDef { Flags = Solid, Friction = 0.6f, Restitution = restitution, Categories = 1, CollidesWith = 1 });
    }

    private static double Median(World world, int steps)
    {
        var times = new double[steps];
        for (int i = -steps; i < steps; i++)
        {
            long start = Stopwatch.GetTimestamp();
            world.Step(Dt);
            if (i >= 0)
            {
                times[i] = Stopwatch.GetElapsedTime(start).TotalMicroseconds;
            }
        }

        Array.Sort(times);
        return times[steps / 2];
    }
}
