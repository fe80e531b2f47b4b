using System;
using System.Runtime;
using System.Runtime.CompilerServices;
using FarseerGames.FarseerPhysics;

namespace Farseer.Tests.Shared.Growth;

/// <summary>What a world of one size takes.</summary>
/// <param name="Size">Its size.</param>
/// <param name="BuildSeconds">For making it, with the first update, which takes everything in.</param>
/// <param name="StepSeconds">For an update, with what is done before it.</param>
/// <param name="Bytes">What it keeps after the last.</param>
internal sealed record GrowthFigures(int Size, double BuildSeconds, double StepSeconds, long Bytes)
{
    private const float Dt = 1 / 60f;

    /// <param name="world">The kind.</param>
    /// <param name="size">Its size.</param>
    /// <param name="steps">Updates that are timed, after as many that are not.</param>
    /// <param name="runs">
    /// The world is run so many times. As it does the same in each, the least of each step counts: what else the machine did is not in it.
    /// </param>
    public static GrowthFigures Measure(GrowthWorld world, int size, int steps, int runs)
    {
        double[] least = new double[steps];
        Array.Fill(least, double.PositiveInfinity);
        double build = double.PositiveInfinity;
        long before = GC.GetTotalMemory(forceFullCollection: true);
        long with = Run(world, size, least, ref build, measureMemory: true);

        // What others left behind may be freed meanwhile, and the thread may keep what it steps with: a world has what came with it or
        // what goes with it, whichever is more.
        long bytes = Math.Max(with - before, with - GC.GetTotalMemory(forceFullCollection: true));
        for (int run = 1; run < runs; run++)
        {
            Run(world, size, least, ref build, measureMemory: false);
        }

        double sum = 0;
        Array.ForEach(least, s => sum += s);
        return new GrowthFigures(size, build, sum / steps, bytes);
    }

    /// <summary>The same world measured twice: the better of each figure, for whatever disturbs a measurement makes it worse.</summary>
    public GrowthFigures BestWith(GrowthFigures other) => this with
    {
        BuildSeconds = Math.Min(BuildSeconds, other.BuildSeconds),
        StepSeconds = Math.Min(StepSeconds, other.StepSeconds),
        Bytes = Math.Min(Bytes, other.Bytes),
    };

    /// <summary>
    /// The power of the work by which an amount grew between two sizes: 1 if in proportion to it, 2 if with its square.
    /// </summary>
    public static double Power(GrowthWorld world, GrowthFigures small, GrowthFigures large, Func<GrowthFigures, double> amount) =>
        Math.Log(amount(large) / amount(small)) / Math.Log(world.WorkOf(large.Size) / world.WorkOf(small.Size));

    // A method of its own, so that nothing of the world lives after it.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static long Run(GrowthWorld world, int size, double[] least, ref double build, bool measureMemory)
    {
        int steps = least.Length;

        // Each run gets its memory fresh from the system: what an earlier one left would be enough for a small world and not for a large
        // one. And none is collected meanwhile: a whole collection looks at everything that the process keeps, whatever the world is.
        GC.Collect(GC.MaxGeneration, GCCollectionMode.Aggressive, blocking: true, compacting: true);
        GCLatencyMode usual = GCSettings.LatencyMode;
        GCSettings.LatencyMode = GCLatencyMode.LowLatency;
        double start = GrowthClock.Seconds();
        using var simulator = new PhysicsSimulator();
        Action act = world.Build(simulator, size);
        simulator.Update(Dt);
        build = Math.Min(build, GrowthClock.Seconds() - start);
        GCSettings.LatencyMode = usual;
        for (int step = -steps; step < steps; step++)
        {
            start = GrowthClock.Seconds();
            act();
            simulator.Update(Dt);
            if (step >= 0)
            {
                least[step] = Math.Min(least[step], GrowthClock.Seconds() - start);
            }
        }

        long with = measureMemory ? GC.GetTotalMemory(forceFullCollection: true) : 0;
        GC.KeepAlive(act);
        return with;
    }
}
