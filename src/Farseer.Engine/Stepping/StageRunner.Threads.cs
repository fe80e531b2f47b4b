using System;
using System.Runtime.CompilerServices;
using System.Threading;

namespace Farseer.Engine.Stepping;

/// <content>The runner's own threads, where the host brings none. They are made when the first step is worth them.</content>
internal sealed partial class StageRunner
{
    private WorkerThread[] _threads = Array.Empty<WorkerThread>();

    private void WakeThreads()
    {
        if (_threads.Length == 0)
        {
            _threads = new WorkerThread[Workers - 1];
            for (int i = 0; i < _threads.Length; i++)
            {
                _threads[i] = new WorkerThread(this);
            }
        }

        for (int i = 0; i < _threads.Length; i++)
        {
            _threads[i].Wake();
        }
    }

    private void StopThreads(bool wait)
    {
        _stopped = true;
        for (int i = 0; i < _threads.Length; i++)
        {
            _threads[i].Stop();
        }

        for (int i = 0; wait && i < _threads.Length; i++)
        {
            _threads[i].Join();
        }
    }

    /// <summary>
    /// A thread that sleeps until it is called. It knows the runner by a weak reference only: a simulator that is dropped without being
    /// disposed goes, and its threads with it.
    /// </summary>
    private sealed class WorkerThread
    {
        private readonly WeakReference<StageRunner> _runner;
        private readonly object _gate = new object();
        private readonly Thread _thread;
        private bool _called;
        private bool _stopped;

        public WorkerThread(StageRunner runner)
        {
            _runner = new WeakReference<StageRunner>(runner);
            _thread = new Thread(Live) { IsBackground = true, Name = "Farseer worker" };
            _thread.Start();
        }

        public void Wake()
        {
            lock (_gate)
            {
                _called = true;
                Monitor.Pulse(_gate);
            }
        }

        public void Stop()
        {
            lock (_gate)
            {
                _stopped = true;
                Monitor.Pulse(_gate);
            }
        }

        public void Join() => _thread.Join();

        private void Live()
        {
            while (Sleep())
            {
                HelpOnce();
            }
        }

        /// <returns>False if the thread is to end.</returns>
        private bool Sleep()
        {
            lock (_gate)
            {
                while (!_called && !_stopped)
                {
                    Monitor.Wait(_gate);
                }

                _called = false;
                return !_stopped;
            }
        }

        // A method of its own, so that nothing on the stack keeps the runner while the thread sleeps.
        [MethodImpl(MethodImplOptions.NoInlining)]
        private void HelpOnce()
        {
            if (_runner.TryGetTarget(out StageRunner? runner))
            {
                runner.Help();
            }
        }
    }
}
