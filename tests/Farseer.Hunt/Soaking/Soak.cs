using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using Box2D.Dynamics;
using FarseerGames.FarseerPhysics;

namespace Farseer.Hunt.Soaking;

/// <summary>
/// Worlds on many threads, made and dropped while their workers run, and warm-ups beside them, in rounds: after each nothing of them may be
/// left.
/// </summary>
internal sealed class Soak(TextWriter output)
{
    /// <summary>What the first rounds leave is what a process makes once: compiled code, pools of threads and arrays.</summary>
    private const int WarmRounds = 3;

    /// <summary>Bytes that the runtime itself comes and goes by.</summary>
    private const long ManagedSlack = 2 << 20;
    private const long ResidentSlack = 64 << 20;

    /// <summary>Threads and handles of the runtime's own pool.</summary>
    private const int CountSlack = 4;

    private static readonly TimeSpan _longestWait = TimeSpan.FromSeconds(20);

    private readonly List<Gauge> _gauges = new();
    private Exception? _failure;
    private long _worlds;
    private long _bodySteps;

    private readonly record struct Gauge(long BodySteps, long Worlds, long Managed, long Resident, int Threads, int Handles);

    /// <summary>Runs until so much time is over or so many body-steps are made.</summary>
    /// <returns>What was left behind, or null.</returns>
    public string? Run(TimeSpan time, long bodySteps, int threads, TimeSpan round)
    {
        output.WriteLine("body-steps, worlds, managed KiB, resident KiB, threads, handles");
        long start = Stopwatch.GetTimestamp();
        while (Stopwatch.GetElapsedTime(start) < time && _bodySteps < bodySteps && _failure is null)
        {
            Round(threads, round);
            Read();
        }

        return _failure is not null ? _failure.ToString() : Left();
    }

    private void Round(int threads, TimeSpan time)
    {
        long start = Stopwatch.GetTimestamp();
        Thread[] all = Enumerable.Range(0, threads).Select(t => new Thread(() => Work(start, time, t))).ToArray();
        Array.ForEach(all, t => t.Start());
        Array.ForEach(all, t => t.Join());
    }

    private void Work(long start, TimeSpan time, int thread)
    {
        try
        {
            for (int turn = 0; Stopwatch.GetElapsedTime(start) < time && _failure is null; turn++)
            {
                if (thread == 0 && turn % 20 == 0)
                {
                    PhysicsSimulator.WarmUp();
                    b2World.WarmUp();
                }

                Interlocked.Add(ref _bodySteps, SoakWorlds.Run(Interlocked.Increment(ref _worlds)));
            }
        }
        catch (Exception exception)
        {
            _failure = exception;
        }
    }

    /// <summary>
    /// Looks at what is there, over and over until no more is left than after the warm rounds: threads of dropped worlds end when the
    /// collector has found them and a processor is free for them, and the process may hold things of others for a while. What leaks stays,
    /// however long one waits.
    /// </summary>
    private void Read()
    {
        Gauge gauge;
        long start = Stopwatch.GetTimestamp();
        do
        {
            for (int i = 0; i < 5; i++)
            {
                GC.Collect();
                GC.WaitForPendingFinalizers();
                Thread.Sleep(100);
            }

            gauge = Gauged();
            output.WriteLine(string.Create(CultureInfo.InvariantCulture,
                $"{gauge.BodySteps:N0}, {gauge.Worlds}, {gauge.Managed >> 10}, {gauge.Resident >> 10}, {gauge.Threads}, {gauge.Handles}"));
        }
        while (_gauges.Count >= WarmRounds && Left(_gauges[WarmRounds - 1], gauge) is not null
            && Stopwatch.GetElapsedTime(start) < _longestWait);

        _gauges.Add(gauge);
    }

    private Gauge Gauged()
    {
        using var process = Process.GetCurrentProcess();
        int handles = Directory.Exists("/proc/self/fd") ? Directory.GetFileSystemEntries("/proc/self/fd").Length : process.HandleCount;
        long managed = GC.GetTotalMemory(forceFullCollection: true);
        return new Gauge(_bodySteps, _worlds, managed, process.WorkingSet64, process.Threads.Count, handles);
    }

    /// <summary>What leaks is there after every round, so the least of the later half counts.</summary>
    private string? Left()
    {
        List<Gauge> late = _gauges.Skip(Math.Max(WarmRounds, (_gauges.Count + WarmRounds) / 2)).ToList();
        return late.Count == 0 ? null : Left(_gauges[WarmRounds - 1], new Gauge(_bodySteps, _worlds, late.Min(g => g.Managed),
            late.Min(g => g.Resident), late.Min(g => g.Threads), late.Min(g => g.Handles)));
    }

    private static string? Left(Gauge first, Gauge last) =>
        last.Managed > first.Managed + ManagedSlack ? "managed memory grew"
        : last.Resident > first.Resident + ResidentSlack ? "resident memory grew"
        : last.Threads > first.Threads + CountSlack ? "threads are left"
        : last.Handles > first.Handles + CountSlack ? "handles are left"
        : null;
}
