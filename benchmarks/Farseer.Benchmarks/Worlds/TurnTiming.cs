using System;
using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using Farseer.Benchmarks.Memory;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Worlds;

/// <summary>
/// The verb <c>turns</c>: many small worlds stepped in turn, beside the same worlds stepped one after the other. In turn each finds the
/// caches full of the others.
/// </summary>
internal static class TurnTiming
{
    private const int DefaultWorlds = 256;
    private const int Steps = 64;
    private const int Rounds = 15;
    private const float Dt = 1f / 60;

    private static readonly Argument<int> _count = Verb.Maybe("worlds", "how many", DefaultWorlds);

    public static Command Create() =>
        Verb.Of("turns", "Many small worlds stepped in turn, beside the same stepped one after the other.", Run, _count);

    private static int Run(ParseResult result)
    {
        int count = Math.Max(1, result.GetValue(_count));
        var worlds = new PhysicsSimulator[count];
        for (int i = 0; i < count; i++)
        {
            worlds[i] = WorldMemory.Room();
        }

        double inTurn = double.MaxValue;
        double consecutive = double.MaxValue;
        for (int round = 0; round < Rounds; round++)
        {
            long start = Stopwatch.GetTimestamp();
            foreach (PhysicsSimulator world in worlds)
            {
                for (int step = 0; step < Steps; step++)
                {
                    world.Update(Dt);
                }
            }

            consecutive = Math.Min(consecutive, Stopwatch.GetElapsedTime(start).TotalMicroseconds);
            start = Stopwatch.GetTimestamp();
            for (int step = 0; step < Steps; step++)
            {
                foreach (PhysicsSimulator world in worlds)
                {
                    world.Update(Dt);
                }
            }

            inTurn = Math.Min(inTurn, Stopwatch.GetElapsedTime(start).TotalMicroseconds);
        }

        double steps = (double)count * Steps;
        result.Output().WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{count} worlds of ten boxes, us a step: {consecutive / steps:F2} one after the other, {inTurn / steps:F2} in turn, "
                + $"{inTurn / consecutive:F2} times"));
        return 0;
    }
}
