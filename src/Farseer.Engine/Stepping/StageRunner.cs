using System;
using System.Runtime.CompilerServices;
using System.Runtime.ExceptionServices;
using System.Threading;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Stepping;

/// <summary>
/// Shares the phases of a step among workers. The thread that steps is worker 0; the others help while the step is open, and the step
/// never waits for one that has not come: a phase is cut into blocks, each worker begins with a share of its own, and whoever is
/// done takes blocks from the ends of the others' shares. So a helper that wakes late, or that the system holds back, costs no more
/// than the block that it has in hand. Which worker did what is never visible: see <see cref="IStageWork"/>.
/// </summary>
/// <remarks>
/// A word that one processor writes and another one reads takes 0.1 to 0.3 µs to get there, so what is counted here is how often workers
/// wait for such a word. A share is one word: the number of the phase, the next block, one past the last. Taking a block is one
/// compare-and-swap. Nobody hands shares out: a word of an older phase stands for the whole share, so it stays with its owner. It cannot be
/// mistaken: as long as a share is not taken its phase is not over, and the number keeps a worker that looks at an old phase from taking a
/// block of a new one. What a phase does is read after a block of it has been taken: until that is reported as done the phase cannot end.
/// Each worker reports in a word of its own, which only ever grows. In a row of phases (<see cref="StageList"/>) each worker goes from one
/// to the next as soon as the reports add up, without being told. Tried and left: fixed halves with a counter to spin on, which is 0.1 µs a
/// phase faster on idle cores and loses all of it, and more, whenever something else runs on one of them.
/// </remarks>
[NotState(Why.Running)]
internal sealed partial class StageRunner : IDisposable
{
    /// <summary>Most workers: a bit for each in <see cref="CrewPlace"/>, and one for "open".</summary>
    public const int MostWorkers = 62;

    /// <summary>
    /// Blocks that a worker's own share of a phase is cut into: what is left of the last one is what a phase waits for. So those of a long
    /// phase are no larger than so many times what is worth another thread's while.
    /// </summary>
    private const int BlocksAShare = 4;
    private const int LargestBlock = 16;
    private const int MostBlocks = short.MaxValue;

    /// <summary>
    /// A helper that has found nothing to do for so many looks, some 0.8 ms, goes to sleep. What one thread does alone within a step of 10
    /// ms takes 0.2 to 0.7 ms at a time, and a helper that slept meanwhile missed what came next, until it was called again and awake.
    /// </summary>
    private const int MostIdleLooks = 24_000;

    /// <summary>
    /// Looks at a counter after which a waiting thread lets others run: what it waits for has been held back by the system.
    /// </summary>
    private const int PatientLooks = 2000;

    /// <summary>
    /// A step that takes one worker less than this, in nanoseconds as estimated from counts, wakes nobody: waking costs 50 to 100 µs.
    /// </summary>
    private const double LeastCost = 2e5;

    private const long Open = 1;

    /// <summary>Longs from one word that threads write to the next: two cache lines, which processors fetch together.</summary>
    private const int Spread = 16;

    /// <summary>Places of words in <see cref="_words"/>; the shares of the workers stand behind them.</summary>
    private const int PhasePlace = Spread;
    private const int SizePlace = PhasePlace + 1;
    private const int MiddlePlace = PhasePlace + 2;
    private const int CrewPlace = 2 * Spread;
    private const int CamePlace = 3 * Spread;
    private const int FirstShare = 4 * Spread;

    /// <summary>
    /// Looks, some 0.3 µs, at the reports of the others before a worker that has done its share looks at theirs: nearly always they are
    /// about to be done, and to look at a share takes it away from its owner for a while.
    /// </summary>
    private const int PoliteLooks = 8;

    /// <summary>Phases after which they are counted from 0 again, long before the numbers end.</summary>
    private const uint MostNumbers = 1 << 30;

    /// <summary>Longest row of phases.</summary>
    private const int MostStages = short.MaxValue;

    private readonly Action _help;
    private readonly long[] _words;
    private readonly Action<int, Action>? _scheduler;
    private readonly int _firstReport;
    // Null: nobody helps.
    private readonly CrewPatience? _patience;
    private volatile bool _stopped;
    private bool _isOpen;
    private long _asked;
    private uint _number;
    private uint _done;
    private IStageWork? _work;
    private ISequenceWork? _sequence;
    private StageList? _stages;
    private Exception? _error;
    private Exception? _schedulerError;

    /// <param name="workers">From 1 to <see cref="MostWorkers"/>.</param>
    /// <param name="scheduler">
    /// Starts so many calls of the action on other threads and returns; null: the runner has threads of its own, which sleep between steps.
    /// </param>
    public StageRunner(int workers, Action<int, Action>? scheduler)
    {
        Workers = workers;
        _scheduler = scheduler;
        _firstReport = FirstShare + (workers * Spread);
        _words = workers > 1 ? new long[_firstReport + ((workers + 1) * Spread)] : Array.Empty<long>();
        _help = Help;
        if (workers > 1)
        {
            _patience = new CrewPatience();
        }
        else
        {
            // It never has threads: thousands of worlds need not wait to be finalized.
            GC.SuppressFinalize(this);
        }
    }

    /// <summary>Stops the threads of a runner that was dropped.</summary>
    ~StageRunner() => StopThreads(false);

    /// <summary>The thread that steps, and those that may help it.</summary>
    public int Workers { get; }

    /// <summary>Who starts the helpers; null: the runner has threads of its own.</summary>
    public Action<int, Action>? Scheduler => _scheduler;

    /// <summary>Starts a step.</summary>
    /// <param name="cost">What it would take one worker, nanoseconds.</param>
    public void Begin(double cost)
    {
        if (Workers > 1 && cost >= LeastCost && !_stopped && _patience!.MayShare(cost))
        {
            if (_number > MostNumbers)
            {
                CountAnew();
            }

            _isOpen = true;
            _asked = Volatile.Read(ref _words[CamePlace]);
            Volatile.Write(ref _words[CrewPlace], Open);
            Call();
        }
    }

    /// <summary>Calls the helpers that have gone to sleep since the step began, because phases for all follow.</summary>
    public void Call()
    {
        if (!_isOpen)
        {
            return;
        }

        int missing = Workers - 1 - HelpersHere();
        if (missing == 0)
        {
            return;
        }

        if (_scheduler == null)
        {
            WakeThreads();
            return;
        }

        // Those that were asked for in this step and have not come yet are not asked for again.
        missing -= (int)(_asked - Volatile.Read(ref _words[CamePlace]));
        if (missing <= 0)
        {
            return;
        }

        try
        {
            _asked += missing;
            _scheduler(missing, _help);
        }
        catch (Exception exception)
        {
            _asked -= missing;
            _schedulerError ??= exception;
        }
    }

    /// <summary>Ends the step: the helpers have left when it returns.</summary>
    public void End()
    {
        if (!_isOpen)
        {
            _patience?.EndAlone();
            return;
        }

        _isOpen = false;
        long crew = Volatile.Read(ref _words[CrewPlace]);
        while (!Replace(ref crew, crew & ~Open))
        {
        }

        for (int looks = 0; Volatile.Read(ref _words[CrewPlace]) != 0; looks++)
        {
            Wait(looks);
        }

        _patience?.End();
    }

    /// <summary>What a host's scheduler threw comes out of here, after the step.</summary>
    public void ThrowSchedulerError() => Rethrow(ref _schedulerError);

    /// <summary>Whether a phase of so many items may be shared: if not, it is all done by worker 0.</summary>
    public bool IsShared(int count, int least) => _isOpen && count / least > 1;

    /// <summary>Does a phase and returns when all of it is done.</summary>
    /// <param name="work">The phase.</param>
    /// <param name="count">Its items.</param>
    /// <param name="least">Items that are worth being done by another thread.</param>
    /// <remarks>
    /// Who calls it knows which class its work is, so in a step of one thread that is a plain call: looking it up at one place for all took
    /// 1.4 % of a step with 20 boxes.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Run(IStageWork work, int count, int least) => Run(work, count, count / 2, least);

    /// <summary>
    /// The same where the first half of the workers is to begin with the items below <paramref name="middle"/>, which are near to it, and
    /// the others with the rest.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Run(IStageWork work, int count, int middle, int least)
    {
        if (_isOpen)
        {
            RunShared(work, count, middle, least);
        }
        else if (count > 0)
        {
            work.Run(0, 0, count);
        }
    }

    /// <summary>The same where nobody may be there to share it.</summary>
    /// <param name="runner">Who shares the phase; null: the calling thread does it.</param>
    /// <param name="work">The phase.</param>
    /// <param name="count">Its items.</param>
    /// <param name="least">Items that are worth being done by another thread.</param>
    public static void Share(StageRunner? runner, IStageWork work, int count, int least)
    {
        if (runner == null)
        {
            work.Run(0, 0, count);
        }
        else
        {
            runner.Run(work, count, least);
        }
    }

    /// <summary>The same for items of which each takes some 100 µs: one a block.</summary>
    public void RunEach(IStageWork work, int count)
    {
        Call();
        RunBlocks(work, count, count / 2, Math.Min(count, MostBlocks), isLong: true);
    }

    private void RunShared(IStageWork work, int count, int middle, int least)
    {
        int blocks = BlocksOf(count, least);
        RunBlocks(work, count, middle, blocks, blocks > BlocksAShare * Workers);
    }

    /// <param name="work">The phase.</param>
    /// <param name="count">Its items.</param>
    /// <param name="middle">Those of the first half of the blocks.</param>
    /// <param name="blocks">Into how many blocks it may be cut.</param>
    /// <param name="isLong">Helpers that are on their way may come before it is done.</param>
    private void RunBlocks(IStageWork work, int count, int middle, int blocks, bool isLong)
    {
        if (!_isOpen || blocks < 2 || (!isLong && HelpersHere() == 0))
        {
            if (count > 0)
            {
                work.Run(0, 0, count);
            }

            return;
        }

        if (!ReferenceEquals(_work, work))
        {
            _work = work;
        }

        Publish(0, count, middle, blocks);
        Complete();
    }

    /// <summary>
    /// Into how many blocks <see cref="Run(IStageWork, int, int)"/> would cut a phase, as many for each worker if there are enough; 1: it
    /// is not worth sharing.
    /// </summary>
    public int BlocksOf(int count, int least)
    {
        int usual = BlocksAShare * Workers;
        int blocks = Math.Max(1, Math.Min(count / least, Math.Min(Math.Max(usual, count / least / LargestBlock), MostBlocks)));
        return blocks < Workers ? blocks : blocks - (blocks % Workers);
    }

    /// <summary>
    /// Empties a list of phases. A helper that comes late may be looking at it for a row that is over: from now on it finds none.
    /// </summary>
    public void Clear(StageList stages)
    {
        if (Workers > 1)
        {
            Volatile.Write(ref _words[PhasePlace], 0);
        }

        stages.Clear();
    }

    /// <summary>Does a row of phases, each when the one before is done.</summary>
    /// <returns>False: nobody is there to help, and nothing has been done.</returns>
    public bool RunAll(ISequenceWork work, StageList stages)
    {
        if (!_isOpen || stages.Count is 0 or > MostStages || HelpersHere() == 0)
        {
            return false;
        }

        if (!ReferenceEquals(_sequence, work))
        {
            _sequence = work;
        }

        if (!ReferenceEquals(_stages, stages))
        {
            Volatile.Write(ref _words[PhasePlace], 0);
            Volatile.Write(ref _stages, stages);
        }

        Publish(stages.Count, 0, 0, 0);
        Complete();
        return true;
    }

    /// <summary>Ends the threads. Within a step it goes on alone.</summary>
    public void Dispose()
    {
        StopThreads(true);
        GC.SuppressFinalize(this);
    }

    /// <summary>What a helper does while the step is open. Called too late, too often or on a wrong thread it does no harm.</summary>
    private void Help()
    {
        Interlocked.Increment(ref _words[CamePlace]);
        int worker = Enter();
        if (worker < 0)
        {
            return;
        }

        long seen = 0;
        for (int looks = 0; looks < MostIdleLooks && !_stopped && (Volatile.Read(ref _words[CrewPlace]) & Open) != 0; looks++)
        {
            long header = Volatile.Read(ref _words[PhasePlace]);
            if (header == seen || header == 0)
            {
                Thread.SpinWait(1);
                continue;
            }

            seen = header;
            long size = Volatile.Read(ref _words[SizePlace]);
            int middle = (int)Volatile.Read(ref _words[MiddlePlace]);
            int done = Volatile.Read(ref _words[PhasePlace]) == header ? Walk(worker, header, size, middle) : 0;
            if (done < 0)
            {
                break;
            }

            looks = done > 0 ? 0 : looks;
        }

        Leave(worker);
    }

    /// <returns>The place of a helper, or -1: no step is open, or all places are taken.</returns>
    private int Enter()
    {
        long crew = Volatile.Read(ref _words[CrewPlace]);
        while ((crew & Open) != 0)
        {
            int worker = 1;
            while (worker < Workers && (crew & (1L << worker)) != 0)
            {
                worker++;
            }

            if (worker >= Workers)
            {
                return -1;
            }

            if (Replace(ref crew, crew | (1L << worker)))
            {
                return worker;
            }
        }

        return -1;
    }

    private void Leave(int worker)
    {
        long crew = Volatile.Read(ref _words[CrewPlace]);
        while (!Replace(ref crew, crew & ~(1L << worker)))
        {
        }
    }

    /// <returns>False if another thread was faster; <paramref name="seen"/> is then what it left.</returns>
    private bool Replace(ref long seen, long value)
    {
        long before = Interlocked.CompareExchange(ref _words[CrewPlace], value, seen);
        bool replaced = before == seen;
        seen = before;
        return replaced;
    }

    private int HelpersHere()
    {
        long crew = Volatile.Read(ref _words[CrewPlace]) & ~Open;
        int here = 0;
        for (; crew != 0; crew &= crew - 1)
        {
            here++;
        }

        return here;
    }

    private static void Rethrow(ref Exception? error)
    {
        if (error != null)
        {
            ExceptionDispatchInfo thrown = ExceptionDispatchInfo.Capture(error);
            error = null;
            thrown.Throw();
        }
    }
}
