using System;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Leaves those of the pairs that were found which are new and pass the filters, in ranges. In a net of joints nearly all pairs that are
/// found are pairs of neighbours, again in each step.
/// </summary>
internal sealed unsafe class PairWork : IStageWork
{
    /// <summary>Pairs that are worth another worker's while, some 2 µs.</summary>
    private const int LeastPairs = 128;

    /// <summary>Look-ups ahead for which the map is asked: a table of many pairs lies far away.</summary>
    private const int Ahead = 12;

    /// <summary>Pairs that are looked up before those of them that are new are judged: their pieces and colliders are asked for meanwhile.</summary>
    private const int Block = 64;

    private byte* _marks;
    private World _world = null!;
    private PairBuffer _pairs = null!;

    public void Run(StageRunner runner, World world, PairBuffer pairs, Scratch scratch)
    {
        int mark = scratch.Mark;
        _marks = scratch.Take<byte>(pairs.Count);
        _world = world;
        _pairs = pairs;
        runner.Run(this, pairs.Count, LeastPairs);
        ulong* next = pairs.Pointer;
        int count = pairs.Count;
        for (int i = 0; i < count; i++)
        {
            *next = pairs[i];
            next += _marks[i];
        }

        pairs.SetEnd(next);
        scratch.Release(mark);
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        for (int block = from; block < to; block += Block)
        {
            Judge(block, Math.Min(block + Block, to));
        }
    }

    private void Judge(int from, int to)
    {
        PairMap known = _world.KnownPairs;
        ulong* pairs = _pairs.Pointer;
        for (int i = from; i < to; i++)
        {
            if (Prefetch.IsUseful)
            {
                known.AskFor(pairs[Math.Min(i + Ahead, _pairs.Count - 1)]);
            }

            bool isNew = !known.Contains(pairs[i]);
            _marks[i] = isNew ? (byte)1 : (byte)0;
            if (isNew)
            {
                _world.AskForPieces(pairs[i]);
            }
        }

        for (int i = from; i < to && Prefetch.IsUseful; i++)
        {
            if (_marks[i] != 0)
            {
                _world.AskForColliders(pairs[i]);
            }
        }

        for (int i = from; i < to; i++)
        {
            if (_marks[i] != 0 && !_world.MayTouch(pairs[i]))
            {
                _marks[i] = 0;
                _world.NoteRefused(pairs[i]);
            }
        }
    }
}
