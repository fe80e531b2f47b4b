using System;
using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using Farseer.Benchmarks.Memory;
using Farseer.Benchmarks.Scenes;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.Worlds;

/// <summary>
/// The verb <c>turns</c>: many small worlds stepped in turn, beside the same worlds stepped one after the other. In turn each finds the
/// caches full of the others.
/// </summary>
internal static class TurnTiming
{
    private const int DefaultWorlds = 256;

    /// <summary>Worlds stepped one after the other in a slice, and steps of each of them. Of all worlds in turn a slice has one.</summary>
    private const int Few = 16;
    private const int StepsOfFew = 16;
    private const int Slices = 600;
    private const float Dt = 1f / 60;

    private static readonly Argument<int> _count = Verb.Maybe("worlds", "how many", DefaultWorlds);

    public static Command Create() =>
        Verb.Of("turns", "Many small worlds stepped in turn, beside the same stepped one after the other.", Run, _count);

    /// <summary>Steps worlds in both ways, a slice of a millisecond of each by turns.</summary>
    public static (StepTimes Consecutive, StepTimes InTurn) Measure(int count)
    {
        var worlds = new PhysicsSimulator[count];
        for (int i = 0; i < count; i++)
        {
            worlds[i] = WorldMemory.Room();
        }

        var consecutive = new StepTimes(1);
        var inTurn = new StepTimes(1);
        for (int slice = 0; slice < Slices; slice++)
        {
            int few = Math.Min(Few, count);
            long start = Stopwatch.GetTimestamp();
            for (int i = 0; i < few; i++)
            {
                Step(worlds[((slice * few) + i) % count], StepsOfFew);
            }

            Note(consecutive, start, few * StepsOfFew);
            start = Stopwatch.GetTimestamp();
            foreach (PhysicsSimulator world in worlds)
            {
                Step(world, 1);
            }

            Note(inTurn, start, count);
        }

        return (consecutive, inTurn);
    }

    private static void Step(PhysicsSimulator world, int steps)
    {
        for (int i = 0; i < steps; i++)
        {
            world.Update(Dt);
        }
    }

    private static void Note(StepTimes times, long start, int steps)
    {
        times.Add(0, Stopwatch.GetElapsedTime(start).TotalMicroseconds / steps);
        times.EndRun();
    }

    private static int Run(ParseResult result)
    {
        int count = Math.Max(1, result.GetValue(_count));
        (StepTimes consecutive, StepTimes inTurn) = Measure(count);
        result.Output().WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{count} worlds of ten boxes, us a step one after the other and in turn: "
                + $"quiet {consecutive.LeastRun:F2}, {inTurn.LeastRun:F2}, {inTurn.LeastRun / consecutive.LeastRun:F2} times; "
                + $"median {consecutive.MedianRun:F2}, {inTurn.MedianRun:F2}, "
                + $"{inTurn.MedianRun / consecutive.MedianRun:F2} times"));
        return 0;
    }
}
