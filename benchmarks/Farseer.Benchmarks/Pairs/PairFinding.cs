using System;
using System.Diagnostics;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;

namespace Farseer.Benchmarks.Pairs;

/// <summary>
/// Time of one Collect in ns a body, median of repeated frames after warm-up. Boxes of side 1 to 1.2 at about one a
/// unit area, so that each overlaps about four others; the moves themselves are not timed.
/// </summary>
internal static class PairFinding
{
    // The runtime compiles hot code anew in the background, some 100 ms after it was found hot: fewer frames time half-compiled code.
    private const double WarmMilliseconds = 700;
    private const int WarmFrames = 30;

    private static readonly (string Name, Func<IBroadPhase> Make, int MaxCount)[] Finders =
    {
        ("LevelGrid", () => new LevelGrid(), int.MaxValue),
        ("SelectiveSweep", () => new SelectiveSweep(), int.MaxValue),
        ("SweepAndPrune", () => new SweepAndPrune(), 10_000),
        ("BruteForce", () => new BruteForce(), 2_000),
    };

    private static readonly (string Name, double Moving, double Large, bool World)[] Scenes =
    {
        ("all move", 1, 0, false),
        ("all move, 1 % 3-16 x larger", 1, 0.01, false),
        ("all move, one of world size", 1, 0, true),
        ("10 % move", 0.1, 0, false),
        ("1 % moves", 0.01, 0, false),
        ("none moves", 0, 0, false),
    };

    public static int Run()
    {
        foreach ((string sceneName, double moving, double large, bool world) in Scenes)
        {
            Console.WriteLine($"{sceneName} (ns a body of all)");
            foreach (int count in new[] { 2_000, 8_000, 10_000, 100_000 })
            {
                foreach ((string name, Func<IBroadPhase> make, int maxCount) in Finders)
                {
                    if (count <= maxCount)
                    {
                        (double median, double least, double pairs) = Measure(make(), count, moving, large, world);
                        Console.WriteLine($"  {count,7} {name,-16} {median,9:F1} (least {least:F1})   {pairs:F2} pairs a body");
                    }
                }
            }
        }

        return 0;
    }

    private static (double Median, double Least, double Pairs) Measure(
        IBroadPhase finder, int count, double moving, double large, bool world)
    {
        var random = new Random(1);
        float side = MathF.Sqrt(count) * 1.1f;
        var proxies = new ProxyStore();
        proxies.Set.EnsureCapacity(count);
        proxies.End = count;
        var velocity = new (float X, float Y)[count];
        for (int i = 0; i < count; i++)
        {
            float x = (float)random.NextDouble() * side;
            float y = (float)random.NextDouble() * side;
            float size = 1 + ((float)random.NextDouble() * 0.2f);
            size *= random.NextDouble() < large ? 3 + ((float)random.NextDouble() * 13) : 1;
            proxies.Fat[i] = world && i == 0 ? new Box(0, 0, side, side) : new Box(x, y, x + size, y + size);
            proxies.Info[i] = new ProxyInfo { Body = i, Flags = ProxyFlags.Alive | ProxyFlags.Moved };
            velocity[i] = ((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f);
            finder.Added(proxies, i);
        }

        int frames = count > 50_000 ? 25 : 101;
        var times = new double[frames];
        var pairs = new PairBuffer();
        long begin = Stopwatch.GetTimestamp();
        int warm = WarmFrames;
        for (int frame = 0; frame < frames + warm; frame++)
        {
            pairs.Clear();
            long start = Stopwatch.GetTimestamp();
            finder.Collect(proxies, pairs);
            if (frame >= warm)
            {
                times[frame - warm] = Stopwatch.GetElapsedTime(start).TotalNanoseconds / count;
            }
            else if (frame == warm - 1 && Stopwatch.GetElapsedTime(begin).TotalMilliseconds < WarmMilliseconds)
            {
                warm++;
            }

            Move(proxies, velocity, random, moving, side);
        }

        Array.Sort(times);
        return (times[frames / 2], times[0], (double)pairs.Count / count);
    }

    private static void Move(ProxyStore proxies, (float X, float Y)[] velocity, Random random, double moving, float side)
    {
        for (int i = 0; i < velocity.Length; i++)
        {
            ref ProxyInfo info = ref proxies.Info[i];
            info.Flags &= ~ProxyFlags.Moved;
            if (moving < 1 && random.NextDouble() >= moving)
            {
                continue;
            }

            ref Box box = ref proxies.Fat[i];
            ref (float X, float Y) v = ref velocity[i];
            v.X = box.MinX < 0 ? MathF.Abs(v.X) : box.MaxX > side ? -MathF.Abs(v.X) : v.X;
            v.Y = box.MinY < 0 ? MathF.Abs(v.Y) : box.MaxY > side ? -MathF.Abs(v.Y) : v.Y;
            box = new Box(box.MinX + (v.X * 0.1f), box.MinY + (v.Y * 0.1f), box.MaxX + (v.X * 0.1f), box.MaxY + (v.Y * 0.1f));
            info.Flags |= ProxyFlags.Moved;
        }
    }
}
