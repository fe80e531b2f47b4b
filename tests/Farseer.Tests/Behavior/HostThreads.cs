using System;
using System.Collections.Concurrent;
using System.Threading;
using FarseerGames.FarseerPhysics.Interfaces;

namespace Farseer.Tests.Behavior;

/// <summary>A host's own threads, as many as a test wants, whatever processors there are.</summary>
internal sealed class HostThreads : IStepScheduler, IDisposable
{
    private readonly BlockingCollection<Action> _calls = [];
    private readonly Thread[] _threads;
    private int _failures;

    public HostThreads(int count)
    {
        _threads = new Thread[count];
        for (int i = 0; i < count; i++)
        {
            _threads[i] = new Thread(Work) { IsBackground = true };
            _threads[i].Start();
        }
    }

    /// <summary>Calls that were asked for.</summary>
    public int Asked { get; private set; }

    /// <summary>Calls that threw, which none may.</summary>
    public int Failures => Volatile.Read(ref _failures);

    public void Start(int count, Action help)
    {
        Asked += count;
        for (int i = 0; i < count; i++)
        {
            _calls.Add(help);
        }
    }

    public void Dispose()
    {
        _calls.CompleteAdding();
        foreach (Thread thread in _threads)
        {
            thread.Join();
        }
    }

    private void Work()
    {
        foreach (Action help in _calls.GetConsumingEnumerable())
        {
            try
            {
                help();
            }
            catch (Exception)
            {
                Interlocked.Increment(ref _failures);
            }
        }
    }
}
