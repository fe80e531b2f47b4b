using System;
using System.Diagnostics;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Queries;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;

namespace Farseer.Benchmarks.Queries;

/// <summary>
/// Time of single queries against a field of boxes and circles, half of them static, one in four square units. Median over batches after
/// warm-up; the ways and boxes differ from query to query. World and queries come from a plain linear congruence, so that a program in
/// another language can ask another engine the same.
/// </summary>
internal static class QueryTiming
{
    private const int Batches = 400;
    private const int BatchSize = 250;

    private delegate bool Question(World world, in RayInput ray);

    public static int Run()
    {
        Console.WriteLine("ns a query, median (least); share of queries with an answer; bytes a query");
        foreach (int bodies in new[] { 100, 1_000, 10_000, 100_000 })
        {
            (World world, float side) = Field(bodies);
            var found = new IndexList();
            Console.WriteLine($"{bodies} bodies");
            Measure(
                "ray, closest, any length", world, side, side, (World w, in RayInput r) => w.Queries.CastRay(r, QueryFilter.All, out _));
            Measure("ray, closest, 10 long", world, side, 10, (World w, in RayInput r) => w.Queries.CastRay(r, QueryFilter.All, out _));
            Measure("ray, all, 10 long", world, side, 10, (World w, in RayInput r) => w.Queries.CastRayAll(r, QueryFilter.All) > 0);
            Measure("box 2 x 2", world, side, 0, (World w, in RayInput r) =>
            {
                w.Queries.FindInBox(Box.FromDouble(r.X - 1, r.Y - 1, r.X + 1, r.Y + 1), QueryFilter.All, found);
                return found.Count > 0;
            });
            Measure("disc of radius 1, overlap", world, side, 0, (World w, in RayInput r) =>
            {
                w.Queries.SetDisc(r.X, r.Y, 1);
                w.Queries.FindOverlapping(QueryFilter.All, found);
                return found.Count > 0;
            });
            Measure("disc of radius 0.5, cast 10", world, side, 10, (World w, in RayInput r) =>
            {
                w.Queries.SetDisc(r.X, r.Y, 0.5);
                return w.Queries.CastShape(r.DirectionX, r.DirectionY, QueryFilter.All, out _);
            });
            Measure(
                "nearest within 5", world, side, 0, (World w, in RayInput r) => w.Queries.FindNearest(r.X, r.Y, 5, QueryFilter.All, out _));
            MeasureRefresh(world, bodies);
        }

        return 0;
    }

    private static (World World, float Side) Field(int bodies)
    {
        var random = new Sequence(1);
        float side = MathF.Sqrt(bodies) * 2;
        var world = new World();
        for (int i = 0; i < bodies; i++)
        {
            Handle body = world.CreateBody(new BodyDef
            {
                X = random.Next() * side,
                Y = random.Next() * side,
                Angle = random.Next() * 6,
                LinearVelocity = i % 2 == 0 ? default : new Vector2((float)random.Next() - 0.5f, (float)random.Next() - 0.5f),
                Mass = 1,
                Inertia = 1,
                Flags = BodyFlags.Enabled | (i % 2 == 0 ? BodyFlags.Static : BodyFlags.None),
            });
            ShapeGeometry shape = i % 3 == 0 ? ShapeBuilder.Circle(0.5f) : ShapeBuilder.Box(1, 0.6f);
            world.CreateCollider(body, shape, new ColliderDef { Categories = 1 });
        }

        return (world, side);
    }

    private static void Measure(string name, World world, float side, float length, Question question)
    {
        var random = new Sequence(2);
        var rays = new RayInput[BatchSize];
        var times = new double[Batches];
        int answers = 0;
        long bytes = 0;
        for (int batch = -Batches; batch < Batches; batch++)
        {
            for (int i = 0; i < BatchSize; i++)
            {
                double angle = random.Next() * 2 * Math.PI;
                double way = length * random.Next();
                rays[i] = new RayInput
                {
                    X = random.Next() * side,
                    Y = random.Next() * side,
                    DirectionX = way * Math.Cos(angle),
                    DirectionY = way * Math.Sin(angle),
                };
            }

            long allocated = GC.GetAllocatedBytesForCurrentThread();
            long start = Stopwatch.GetTimestamp();
            int yes = 0;
            for (int i = 0; i < BatchSize; i++)
            {
                yes += question(world, rays[i]) ? 1 : 0;
            }

            if (batch >= 0)
            {
                times[batch] = Stopwatch.GetElapsedTime(start).TotalNanoseconds / BatchSize;
                bytes += GC.GetAllocatedBytesForCurrentThread() - allocated;
                answers += yes;
            }
        }

        Array.Sort(times);
        double total = (double)Batches * BatchSize;
        Console.WriteLine($"  {name,-28} {times[Batches / 2],8:F0} ({times[0]:F0})  {answers / total:P0}  {bytes / total:F0}");
    }

    /// <summary>What the first query after a step costs more: the boxes are brought up to the poses.</summary>
    private static void MeasureRefresh(World world, int bodies)
    {
        const int Steps = 60;
        var times = new double[Steps];
        for (int i = -Steps; i < Steps; i++)
        {
            world.Step(1f / 60);
            long start = Stopwatch.GetTimestamp();
            world.Queries.CastRay(new RayInput { DirectionX = 1e-3 }, QueryFilter.All, out _);
            if (i >= 0)
            {
                times[i] = Stopwatch.GetElapsedTime(start).TotalMicroseconds;
            }
        }

        Array.Sort(times);
        Console.WriteLine(
            $"  first query after a step     {times[Steps / 2],8:F1} us, the worst {times[Steps - 1]:F1} us ({bodies / 2} bodies move)");
    }

    /// <summary>Numbers in [0, 1): the upper 53 bits of x = 6364136223846793005 x + 1442695040888963407 modulo 2⁶⁴.</summary>
    private sealed class Sequence(ulong state)
    {
        private ulong _state = state;

        public double Next()
        {
            _state = unchecked((_state * 6364136223846793005UL) + 1442695040888963407UL);
            return (_state >> 11) * (1.0 / (1UL << 53));
        }
    }
}
