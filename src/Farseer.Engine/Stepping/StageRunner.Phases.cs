using System;
using System.Threading;

namespace Farseer.Engine.Stepping;

/// <content>How a phase is said, taken block by block, reported and waited for.</content>
internal sealed partial class StageRunner
{
    private static void Wait(int looks)
    {
        if (looks < PatientLooks)
        {
            Thread.SpinWait(1);
        }
        else
        {
            Thread.Yield();
        }
    }

    private static long Share(uint number, int next, int end) => ((long)number << 32) | ((long)next << 16) | (uint)end;

    /// <summary>No helper is here.</summary>
    private void CountAnew()
    {
        _number = 0;
        Volatile.Write(ref _words[PhasePlace], 0);
        for (int worker = 0; worker < Workers; worker++)
        {
            Volatile.Write(ref _words[FirstShare + (worker * Spread)], 0);
        }
    }

    /// <summary>
    /// Says what is to be done, in three words next to each other: who finds the first one unchanged after it has read the others has
    /// read three that belong together.
    /// </summary>
    private void Publish(int stages, int count, int middle, int blocks)
    {
        uint number = _number + 1;
        _number += (uint)Math.Max(stages, 1);
        Volatile.Write(ref _words[PhasePlace], 0);
        Volatile.Write(ref _words[SizePlace], ((long)count << 32) | _done);
        Volatile.Write(ref _words[MiddlePlace], middle);
        Volatile.Write(ref _words[PhasePlace], ((long)number << 32) | ((long)stages << 16) | (uint)blocks);
    }

    /// <summary>Does what was published last, and returns when all of it is done.</summary>
    private void Complete()
    {
        Walk(0, _words[PhasePlace], _words[SizePlace], (int)_words[MiddlePlace]);
        Rethrow(ref _error);
    }

    /// <summary>Does blocks of what was published, its own first, as long as there are any.</summary>
    /// <param name="worker">Who.</param>
    /// <param name="header">The first of the words.</param>
    /// <param name="size">The second.</param>
    /// <param name="middle">The third.</param>
    /// <returns>How many it did; -1: it waited in vain and may go.</returns>
    private int Walk(int worker, long header, long size, int middle)
    {
        Phase phase;
        int stages = (int)(header >> 16) & 0xFFFF;
        phase.Number = (uint)(header >> 32);
        phase.Stage = stages == 0 ? -1 : 0;
        phase.Count = (int)(size >> 32);
        phase.Middle = middle;
        phase.Blocks = (int)header & 0xFFFF;
        phase.Target = (uint)size;
        int done = 0;
        while (true)
        {
            if (phase.Stage >= 0 && !Read(ref phase, header, worker))
            {
                return done;
            }

            phase.Target += (uint)phase.Blocks;
            int here = Take(worker, worker, phase);
            int waited = Await(worker, phase, header, phase.Stage >= stages - 1, ref here);
            done += here;
            if (waited < 0)
            {
                return -1;
            }

            if (waited == 0 || ++phase.Stage >= stages)
            {
                break;
            }

            phase.Number++;
        }

        if (worker == 0)
        {
            _done = phase.Target;
        }

        return done;
    }

    /// <summary>Reads the size of a phase of a row.</summary>
    /// <returns>False: the row is over, and what was read may be of another.</returns>
    private bool Read(ref Phase phase, long header, int worker)
    {
        StageList? stages = Volatile.Read(ref _stages);
        if (stages == null || !stages.TryRead(phase.Stage, out phase.Count, out phase.Middle, out phase.Blocks))
        {
            return false;
        }

        return worker == 0 || Volatile.Read(ref _words[PhasePlace]) == header;
    }

    /// <summary>Waits until a phase is done, and does what others have left of it.</summary>
    /// <returns>1: it is done; 0: nothing is left to be done for a helper; -1: it waited in vain.</returns>
    private int Await(int worker, in Phase phase, long header, bool isLast, ref int done)
    {
        for (int looks = 0; !IsDone(phase.Target); looks++)
        {
            if (looks == PoliteLooks)
            {
                int taken = TakeOthers(worker, phase);
                done += taken;
                if (taken > 0)
                {
                    looks = 0;
                    continue;
                }
            }

            if (worker == 0)
            {
                _patience?.Look(looks == PatientLooks);
                Wait(looks);
                continue;
            }

            if ((isLast && looks > PoliteLooks) || Volatile.Read(ref _words[PhasePlace]) != header)
            {
                return 0;
            }

            if (looks >= MostIdleLooks || _stopped)
            {
                return -1;
            }

            Thread.SpinWait(1);
        }

        if (worker == 0)
        {
            _patience?.Found();
        }

        return 1;
    }

    private bool IsDone(uint target)
    {
        uint sum = 0;
        for (int worker = 0; worker < Workers; worker++)
        {
            sum += (uint)Volatile.Read(ref _words[_firstReport + (worker * Spread)]);
        }

        return (int)(sum - target) >= 0;
    }

    private int TakeOthers(int worker, in Phase phase)
    {
        int done = 0;
        for (int i = 1; i < Workers; i++)
        {
            int owner = worker + i;
            done += Take(worker, owner < Workers ? owner : owner - Workers, phase);
        }

        return done;
    }

    /// <summary>Does what is left of a share, and reports it.</summary>
    private int Take(int worker, int owner, in Phase phase)
    {
        int done = 0;
        int block;

        // Of the two halves of a phase both begin far from the middle, so that what is left for the other one is near to what it has done
        // itself.
        bool fromEnd = (owner != worker) != ((owner & 1) != 0);
        while ((block = TakeBlock(owner, phase, fromEnd)) >= 0)
        {
            RunBlock(worker, block, phase);
            done++;
        }

        if (done > 0)
        {
            ref long report = ref _words[_firstReport + (worker * Spread)];
            Volatile.Write(ref report, (uint)report + (uint)done);
        }

        return done;
    }

    private int TakeBlock(int owner, in Phase phase, bool fromEnd)
    {
        ref long share = ref _words[FirstShare + (owner * Spread)];
        long seen = Volatile.Read(ref share);
        while (true)
        {
            int next = (int)(seen >> 16) & 0xFFFF;
            int end = (int)seen & 0xFFFF;
            uint number = (uint)(seen >> 32);
            if (number < phase.Number)
            {
                // The first worker has one that cannot be halved.
                next = ((phase.Blocks * owner) + Workers - 1) / Workers;
                end = ((phase.Blocks * (owner + 1)) + Workers - 1) / Workers;
            }

            if (number > phase.Number || next >= end)
            {
                return -1;
            }

            long left = fromEnd ? Share(phase.Number, next, end - 1) : Share(phase.Number, next + 1, end);
            long before = Interlocked.CompareExchange(ref share, left, seen);
            if (before == seen)
            {
                return fromEnd ? end - 1 : next;
            }

            seen = before;
        }
    }

    /// <summary>Of the two halves of a phase each has half of the blocks; all are alike if it is cut in the middle.</summary>
    private static int FirstItem(in Phase phase, int block)
    {
        if (phase.Middle == phase.Count / 2)
        {
            return (int)((long)phase.Count * block / phase.Blocks);
        }

        int above = (2 * block) - phase.Blocks;
        return above <= 0
            ? (int)((long)phase.Middle * 2 * block / phase.Blocks)
            : phase.Middle + (int)((long)(phase.Count - phase.Middle) * above / phase.Blocks);
    }

    private void RunBlock(int worker, int block, in Phase phase)
    {
        try
        {
            int from = FirstItem(phase, block);
            int to = FirstItem(phase, block + 1);
            if (phase.Stage < 0)
            {
                _work!.Run(worker, from, to);
            }
            else
            {
                _sequence!.Run(worker, phase.Stage, from, to);
            }
        }
        catch (Exception exception)
        {
            Interlocked.CompareExchange(ref _error, exception, null);
        }
    }

    /// <summary>A phase as a worker has read it.</summary>
    private struct Phase
    {
        public uint Number;

        /// <summary>Its place in a row of phases; -1: it stands alone.</summary>
        public int Stage;
        public int Count;

        /// <summary>Items of the first half of its blocks.</summary>
        public int Middle;
        public int Blocks;

        /// <summary>What the reports add up to when it is done.</summary>
        public uint Target;
    }
}
