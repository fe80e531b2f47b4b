using System;
using System.Threading;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Something that is done for many numbers, each by whichever thread comes to it, in any order. It does not throw.</summary>
internal interface IBatchWork
{
    void Run(int index);
}

/// <summary>
/// Threads that share out numbers, each taking the next one that nobody has: the calling one, and helpers of its own that sleep meanwhile.
/// They know the work only while it is done, so that what it belongs to can be collected; who drops the crew calls <see cref="Stop"/>.
/// </summary>
internal sealed class BatchCrew
{
    private readonly SemaphoreSlim _start = new SemaphoreSlim(0);
    private readonly SemaphoreSlim _done = new SemaphoreSlim(0);
    private readonly int _helpers;
    private bool _began;
    private volatile bool _stopped;
    private IBatchWork? _work;
    private int _count;
    private int _next;

    /// <param name="workers">The calling thread and its helpers, 1 or more.</param>
    public BatchCrew(int workers) => _helpers = workers - 1;

    /// <summary>Does it for all numbers below <paramref name="count"/>, and returns when that is done.</summary>
    public void Run(IBatchWork work, int count)
    {
        _work = work;
        _count = count;
        _next = 0;
        int helpers = Math.Min(_helpers, count - 1);
        if (helpers > 0)
        {
            Begin();
            _start.Release(helpers);
        }

        Drain();
        for (int i = 0; i < helpers; i++)
        {
            _done.Wait();
        }

        _work = null;
    }

    /// <summary>Ends the threads.</summary>
    public void Stop()
    {
        _stopped = true;
        if (_began)
        {
            _start.Release(_helpers);
        }
    }

    private void Begin()
    {
        if (_began)
        {
            return;
        }

        _began = true;
        for (int i = 0; i < _helpers; i++)
        {
            new Thread(Live) { IsBackground = true, Name = "Farseer batch" }.Start();
        }
    }

    private void Live()
    {
        while (true)
        {
            _start.Wait();
            if (_stopped)
            {
                return;
            }

            Drain();
            _done.Release();
        }
    }

    private void Drain()
    {
        IBatchWork work = _work!;
        int count = _count;
        for (int index = Interlocked.Increment(ref _next) - 1; index < count; index = Interlocked.Increment(ref _next) - 1)
        {
            work.Run(index);
        }
    }
}
