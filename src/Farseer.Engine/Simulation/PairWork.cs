using System;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Leaves those of the pairs that were found which are new and pass the filters, in ranges, and describes these. In a net of joints nearly
/// all pairs that are found are pairs of neighbours, again in each step. Before that, forgets which boxes were new in the step before.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class PairWork : IStageWork
{
    /// <summary>Pairs that are worth another worker's while, some 2 µs.</summary>
    private const int LeastPairs = 128;

    /// <summary>Look-ups ahead for which the map is asked: a table of many pairs lies far away.</summary>
    private const int Ahead = 12;

    /// <summary>Pairs from one that is described to that whose colliders are asked for; to that whose pieces are, twice as many.</summary>
    private const int Near = 6;

    /// <summary>
    /// Pairs that are looked up before those of them that are new are judged: their pieces and colliders are asked for meanwhile.
    /// </summary>
    private const int Block = 64;

    /// <summary>Boxes that are, some 1 µs.</summary>
    private const int LeastBoxes = 256;

    private byte* _marks;
    private ContactRecord* _records;
    private int _first;
    private Part _part;
    private PairFinder _stage = null!;
    private PairBuffer _pairs = null!;

    private enum Part
    {
        Judge,
        Describe,
        Forget,
    }

    /// <summary>Leaves those of the pairs that are new and pass the filters.</summary>
    public void Run(StageRunner runner, PairFinder stage, PairBuffer pairs, Scratch scratch)
    {
        int mark = scratch.Mark;
        _marks = scratch.Take<byte>(pairs.Count);
        _stage = stage;
        _pairs = pairs;
        _part = Part.Judge;
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

    /// <summary>Writes the records of some pairs, which all pass.</summary>
    public void Describe(StageRunner runner, PairFinder stage, PairBuffer pairs, int first, int count, ContactRecord* records)
    {
        _stage = stage;
        _pairs = pairs;
        _first = first;
        _records = records;
        _part = Part.Describe;
        runner.Run(this, count, LeastPairs);
    }

    /// <summary>The boxes that were new in the last step are new no longer. One may be listed twice, which alters nothing.</summary>
    public void Forget(StageRunner runner, PairFinder stage)
    {
        _stage = stage;
        _part = Part.Forget;
        runner.Run(this, stage.MovedProxies.Count, LeastBoxes);
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget()
    {
        _stage = null!;
        _pairs = null!;
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        switch (_part)
        {
            case Part.Judge:
                for (int block = from; block < to; block += Block)
                {
                    Judge(block, Math.Min(block + Block, to));
                }

                break;
            case Part.Describe:
                Describe(from, to);
                break;
            case Part.Forget:
                _stage.ForgetMoves(from, to);
                break;
        }
    }

    private void Describe(int from, int to)
    {
        ulong* pairs = _pairs.Pointer + _first;
        for (int i = from; i < to; i++)
        {
            if (Prefetch.IsUseful)
            {
                _stage.AskForColliders(pairs[Math.Min(i + Near, to - 1)]);
                _stage.AskForPieces(pairs[Math.Min(i + (2 * Near), to - 1)]);
            }

            _records[i] = _stage.Describe(pairs[i]);
        }
    }

    private void Judge(int from, int to)
    {
        PairMap known = _stage.KnownPairs;
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
                _stage.AskForPieces(pairs[i]);
            }
        }

        for (int i = from; i < to && Prefetch.IsUseful; i++)
        {
            if (_marks[i] != 0)
            {
                _stage.AskForColliders(pairs[i]);
            }
        }

        for (int i = from; i < to; i++)
        {
            if (_marks[i] != 0 && !_stage.MayTouch(pairs[i]))
            {
                _marks[i] = 0;
                _stage.NoteRefused(pairs[i]);
            }
        }
    }
}
