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
        PairMap known = _world.KnownPairs;
        int asked = from;
        for (int i = from; i < to; i++)
        {
            for (; Prefetch.IsUseful && asked < to && asked < i + Ahead; asked++)
            {
                known.AskFor(_pairs[asked]);
            }

            _marks[i] = _world.IsNewPair(_pairs[i]) ? (byte)1 : (byte)0;
        }
    }
}
