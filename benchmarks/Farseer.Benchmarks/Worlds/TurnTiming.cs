using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using Farseer.Benchmarks.Memory;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Worlds;

/// <summary>
/// The verb <c>turns</c>: many small worlds stepped in turn, beside the same worlds stepped one after the other. In turn each finds the caches full of the
/// others.
/// </summary>
internal static class TurnTiming
{
    public const string Usage = "turns [WORLDS]";
    private const int DefaultWorlds = 256;
    private const int Steps = 64;
    private const int Rounds = 15;
    private const float Dt = 1f / 60;

    public static int Run(ReadOnlySpan<string> args, TextWriter output, TextWriter errors)
    {
        int count = DefaultWorlds;
        if (args.Length > 0 && (!int.TryParse(args[0], NumberStyles.None, CultureInfo.InvariantCulture, out count) || count < 1))
        {
            errors.WriteLine($"usage: {Usage}");
            return 2;
        }

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
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{count} worlds of ten boxes, us a step: {consecutive / steps:F2} one after the other, {inTurn / steps:F2} in turn, {inTurn / consecutive:F2} times"));
        return 0;
    }
}
