using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using Farseer.Engine.Stepping;
using Xunit;

namespace Farseer.Engine.Tests.Stepping;

public class StageRunnerTests
{
    // A step that is worth waking anybody, nanoseconds.
    private const double Large = 1e9;

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(8)]
    [InlineData(StageRunner.MostWorkers)]
    public void Run_DoesEveryItemOnce_InEachOfManyPhases(int workers)
    {
        using StageRunner runner = new(workers, null);
        Counting work = new(1000);
        for (int step = 0; step < 20; step++)
        {
            runner.Begin(Large);
            for (int phase = 0; phase < 50; phase++)
            {
                runner.Run(work, 1 + ((phase * 41) % 1000), 1 + (phase % 7));
            }

            runner.End();
        }

        int[] expected = new int[1000];
        for (int phase = 0; phase < 50; phase++)
        {
            for (int i = 0; i < 1 + ((phase * 41) % 1000); i++)
            {
                expected[i] += 20;
            }
        }

        Assert.Equal(expected, work.Counts);
        Assert.True(work.HighestWorker < workers);
        Assert.False(work.Shared, "Two calls at a time had the same worker.");
    }

    [Theory]
    [InlineData(2)]
    [InlineData(5)]
    public void RunEach_AndRunOfManyItems_DoEveryItemOnce(int workers)
    {
        const int Many = 100_000;
        using StageRunner runner = new(workers, null);
        Counting work = new(Many);
        runner.Begin(Large);
        for (int i = 0; i < 10; i++)
        {
            runner.Run(work, Many, 1);
            runner.RunEach(work, Many);
            runner.RunEach(work, 3);
        }

        runner.End();

        for (int i = 0; i < Many; i++)
        {
            Assert.Equal(i < 3 ? 30 : 20, work.Counts[i]);
        }
    }

    /// <summary>Once with an odd number, of which no half is whole: a block was empty, and another one had two.</summary>
    [Theory]
    [InlineData(3)]
    [InlineData(8)]
    [InlineData(101)]
    public void RunEach_OfAnyNumber_GivesEachBlockOneItem(int items)
    {
        using StageRunner runner = new(2, null);
        Counting work = new(items);
        runner.Begin(Large);
        AwaitHelper(runner);
        runner.RunEach(work, items);
        runner.End();

        Assert.Equal(1, work.Largest);
        Assert.All(work.Counts, count => Assert.Equal(1, count));
    }

    /// <summary>
    /// Rows of phases of different lengths, by turns with single phases, over lists that are made anew between them while helpers may still
    /// look at the last one.
    /// </summary>
    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(8)]
    public void RunAll_DoesEveryItemOnce_AndNoneBeforeThePhaseBeforeItIsDone(int workers)
    {
        using StageRunner runner = new(workers, null);
        Counting single = new(100);
        StageList stages = new();
        int singles = 0;
        int rows = 0;

        // While other programs have the processors no helper comes, for as long as they take them.
        var clock = System.Diagnostics.Stopwatch.StartNew();
        for (int step = 0; step < 200 || (rows == 0 && clock.Elapsed.TotalSeconds < 30); step++)
        {
            runner.Begin(Large);
            AwaitHelper(runner);
            int[] sizes = new int[1 + (step * 7 % 40)];
            runner.Clear(stages);
            for (int i = 0; i < sizes.Length; i++)
            {
                sizes[i] = 1 + ((step + i) * 41 % 100);
                stages.Add(sizes[i], i % 3 == 2 ? 1 : runner.BlocksOf(sizes[i], 1 + (i % 5)), (step + (7 * i)) % (sizes[i] + 1));
            }

            for (int again = 0; again < 5; again++)
            {
                Marching work = new(sizes);
                if (runner.RunAll(work, stages))
                {
                    rows++;
                    Assert.Equal(sizes, work.Done);
                    Assert.False(work.Early, "A phase began before the one before it was done.");
                }

                runner.Run(single, 100, 17 * again, 1);
                singles++;
            }

            runner.End();
        }

        Assert.True(rows > 0, "No helper was there in half a minute.");
        Assert.All(single.Counts, c => Assert.Equal(singles, c));
    }

    [Fact]
    public void RunAll_WithoutHelpers_DoesNothing()
    {
        using StageRunner runner = new(2, (_, _) => { });
        StageList stages = new();
        stages.Add(100, 8);
        runner.Begin(Large);
        Assert.False(runner.RunAll(new Marching([100]), stages));
        runner.End();
    }

    [Fact]
    public void ExceptionInARowOfPhases_ComesOutOnTheCallingThread_AndTheRunnerGoesOn()
    {
        using StageRunner runner = new(2, null);
        StageList stages = new();
        stages.Add(100, 8);
        stages.Add(100, 8);
        runner.Begin(Large);
        AwaitHelper(runner);
        bool silent = false;
        try
        {
            silent = runner.RunAll(new Stumbling(), stages);
        }
        catch (FormatException)
        {
        }

        Assert.False(silent, "Nothing came out.");

        Marching work = new([100, 100]);
        bool shared = runner.RunAll(work, stages);
        runner.End();
        Assert.True(!shared || (work.Done[0] == 100 && work.Done[1] == 100));
    }

    [Fact]
    public void Patience_AfterLongWaits_LetsStepsBeDoneAlone_AndAsksAgain()
    {
        CrewPatience patience = new();
        Assert.True(patience.MayShare(1e6));
        patience.Look(true);
        Thread.Sleep(20);
        patience.Found();
        patience.End();
        int alone = 0;
        while (!patience.MayShare(1e6))
        {
            alone++;
        }

        Assert.InRange(alone, 4, 256);
        patience.End();
        Assert.True(patience.MayShare(1e6), "A step without waiting is followed by another one that is shared.");
    }

    /// <summary>
    /// Processors far from each other, or two halves of one: what is quicker goes on, but for a few steps that try the other way.
    /// </summary>
    [Theory]
    [InlineData(3, 1, 0, 30)]
    [InlineData(1, 3, 170, 200)]
    public void Patience_WhereOneWayIsQuicker_GoesThatWay(int shared, int alone, int least, int most)
    {
        CrewPatience patience = new();
        int sharedSteps = 0;
        for (int step = 0; step < 300; step++)
        {
            bool shares = patience.MayShare(1e5);
            long end = Stopwatch.GetTimestamp() + ((shares ? shared : alone) * Stopwatch.Frequency / 10_000);
            while (Stopwatch.GetTimestamp() < end)
            {
            }

            if (shares)
            {
                patience.End();
            }
            else
            {
                patience.EndAlone();
            }

            sharedSteps += shares && step >= 100 ? 1 : 0;
        }

        Assert.InRange(sharedSteps, least, most);
    }

    [Fact]
    public void Run_WithHelpers_LetsThemWork()
    {
        using StageRunner runner = new(2, null);
        Meeting work = new();
        runner.Begin(Large);
        for (int i = 0; i < 10_000 && work.Threads.Count < 2; i++)
        {
            runner.Call();
            runner.Run(work, 64, 1);
        }

        runner.End();
        Assert.Equal(2, work.Threads.Count);
    }

    /// <summary>What a helper that comes late did not find was done by one thread alone, whatever was left of it.</summary>
    [Fact]
    public void RunEach_WithAHelperThatComesLate_LetsItWork()
    {
        Action? late = null;
        using StageRunner runner = new(2, (_, help) => late = help);
        Beckoning work = new(() => new Thread(() => late!()).Start());
        runner.Begin(Large);
        runner.RunEach(work, 1000);
        runner.End();
        Assert.True(work.ByHelper > 0, "The helper found nothing to do.");
        Assert.Equal(1000, work.Done);
    }

    [Fact]
    public void SmallStep_WakesNobody()
    {
        int asked = 0;
        using StageRunner runner = new(4, (count, _) => asked += count);
        runner.Begin(1000);
        runner.Call();
        runner.Run(new Counting(10), 10, 1);
        runner.End();

        Assert.Equal(0, asked);
    }

    [Fact]
    public void Run_OfNoItems_DoesNothing()
    {
        using StageRunner runner = new(2, null);
        runner.Begin(Large);
        runner.Run(new Failing(), 0, 1);
        runner.End();
    }

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    public void ExceptionOfAnItem_ComesOutOnTheCallingThread_AndTheRunnerGoesOn(int workers)
    {
        using StageRunner runner = new(workers, null);
        Counting work = new(1000);
        runner.Begin(Large);
        for (int i = 0; i < 100; i++)
        {
            Assert.Equal("item", Assert.Throws<FormatException>(() => runner.Run(new Failing(), 1000, 1)).Message);
            runner.Run(work, 1000, 1);
        }

        runner.End();
        runner.ThrowSchedulerError();
        Assert.All(work.Counts, c => Assert.Equal(100, c));
    }

    [Fact]
    public void HelpOutsideOfSteps_ReturnsAtOnce()
    {
        List<Action> calls = [];
        using StageRunner runner = new(3, (_, help) => calls.Add(help));
        Counting work = new(100);
        for (int i = 0; i < 3; i++)
        {
            runner.Begin(Large);
            runner.Run(work, 100, 1);
            runner.End();
            calls.ForEach(help => help());
        }

        Assert.Equal(3, calls.Count);
        Assert.All(work.Counts, c => Assert.Equal(3, c));
    }

    [Fact]
    public void Disposed_WithinAStep_GoesOnAlone()
    {
        StageRunner runner = new(4, null);
        Counting work = new(1000);
        runner.Begin(Large);
        runner.Run(work, 1000, 1);
        runner.Dispose();
        runner.Run(work, 1000, 1);
        runner.End();
        runner.Begin(Large);
        runner.Run(work, 1000, 1);
        runner.End();
        runner.Dispose();

        Assert.All(work.Counts, c => Assert.Equal(3, c));
    }

    /// <summary>A helper has just done something when this returns, so it is most likely there.</summary>
    private static void AwaitHelper(StageRunner runner) => runner.RunEach(new Beckoning(() => { }), 1000);

    private sealed class Counting(int count) : IStageWork
    {
        private readonly int[] _busy = new int[StageRunner.MostWorkers];
        private int _highest;
        private int _largest;

        public int[] Counts { get; } = new int[count];

        public int HighestWorker => _highest;

        public bool Shared { get; private set; }

        /// <summary>Items of the largest block.</summary>
        public int Largest => _largest;

        public void Run(int worker, int from, int to)
        {
            Shared |= Interlocked.Increment(ref _busy[worker]) != 1;
            for (int seen = _largest; to - from > seen; seen = _largest)
            {
                Interlocked.CompareExchange(ref _largest, to - from, seen);
            }

            _highest = Math.Max(_highest, worker);
            for (int i = from; i < to; i++)
            {
                Counts[i]++;
            }

            Interlocked.Decrement(ref _busy[worker]);
        }
    }

    /// <summary>Items that wait a little, so that a helper finds some.</summary>
    private sealed class Meeting : IStageWork
    {
        public HashSet<int> Threads { get; } = [];

        public void Run(int worker, int from, int to)
        {
            lock (Threads)
            {
                Threads.Add(Environment.CurrentManagedThreadId);
            }

            Thread.Sleep(from < 8 ? 1 : 0);
        }
    }

    /// <summary>The first item calls for help, and the calling thread goes on slowly until it has come.</summary>
    private sealed class Beckoning(Action call) : IStageWork
    {
        private int _byHelper;
        private int _done;

        public int ByHelper => _byHelper;

        public int Done => _done;

        public void Run(int worker, int from, int to)
        {
            if (Interlocked.Add(ref _done, to - from) == to - from)
            {
                call();
            }

            if (worker > 0)
            {
                Interlocked.Increment(ref _byHelper);
            }
            else if (Volatile.Read(ref _byHelper) == 0)
            {
                Thread.Sleep(1);
            }
        }
    }

    /// <summary>Counts what is done of each phase, and looks whether all of the one before is.</summary>
    private sealed class Marching(int[] sizes) : ISequenceWork
    {
        private bool _early;

        public int[] Done { get; } = new int[sizes.Length];

        public bool Early => _early;

        public void Run(int worker, int stage, int from, int to)
        {
            if (stage > 0 && Volatile.Read(ref Done[stage - 1]) != sizes[stage - 1])
            {
                _early = true;
            }

            Interlocked.Add(ref Done[stage], to - from);
        }
    }

    private sealed class Stumbling : ISequenceWork
    {
        public void Run(int worker, int stage, int from, int to) => throw new FormatException("item");
    }

    private sealed class Failing : IStageWork
    {
        public void Run(int worker, int from, int to) => throw new FormatException("item");
    }
}
