using System;
using Farseer.Engine.Continuous;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// The parts of the sweep that workers share: which pairs fast bodies are looked after in, and which of these bodies meet nothing, so that
/// the sweep itself, which goes from body to body in their order, passes over most of them.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class SweepWork : IStageWork
{
    /// <summary>Records of a block, some 2 µs, and bodies that are worth another worker's while, some 4 µs.</summary>
    private const int BlockRecords = 1024;
    private const int LeastBodies = 4;

    private FastBodySweep[] _sweeps = Array.Empty<FastBodySweep>();
    private SweepStage _stage = null!;
    private ulong* _marks;
    private byte* _clear;
    private int _records;
    private float _dt;
    private float _substep;
    private bool _asksBodies;

    /// <summary>Marks the pairs of fast bodies with what they are looked after against, a bit each.</summary>
    /// <returns>The marks, in scratch memory.</returns>
    public ulong* MarkPairs(StageRunner runner, SweepStage stage, int records, Scratch scratch)
    {
        int blocks = (records + BlockRecords - 1) / BlockRecords;
        _marks = scratch.Take<ulong>(blocks * (BlockRecords / BitSet.WordBits));
        _stage = stage;
        _records = records;
        _asksBodies = false;
        runner.Run(this, blocks, 1);
        return _marks;
    }

    /// <summary>Finds the fast bodies that meet nothing.</summary>
    /// <param name="runner">Who shares the work out.</param>
    /// <param name="stage">Whose sweep it is.</param>
    /// <param name="bodies">How many fast bodies there are.</param>
    /// <param name="most">Pairs that one of them is looked after in.</param>
    /// <param name="dt">The step, seconds.</param>
    /// <param name="substep">A substep of it.</param>
    /// <param name="scratch">Where the answers are.</param>
    /// <returns>1 for each that meets nothing; null: it is not worth anybody's while.</returns>
    public byte* FindClear(StageRunner runner, SweepStage stage, int bodies, int most, float dt, float substep, Scratch scratch)
    {
        if (!runner.IsShared(bodies, LeastBodies))
        {
            return null;
        }

        if (_sweeps.Length != runner.Workers)
        {
            _sweeps = new FastBodySweep[runner.Workers];
            for (int i = 0; i < _sweeps.Length; i++)
            {
                _sweeps[i] = new FastBodySweep();
            }
        }

        foreach (FastBodySweep sweep in _sweeps)
        {
            sweep.Reserve(most);
        }

        stage.ListImmovable();
        _clear = scratch.Take<byte>(bodies);
        _stage = stage;
        _dt = dt;
        _substep = substep;
        _asksBodies = true;
        runner.Run(this, bodies, LeastBodies);
        return _clear;
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget() => _stage = null!;

    void IStageWork.Run(int worker, int from, int to)
    {
        if (!_asksBodies)
        {
            _stage.MarkSwept(_marks, from * BlockRecords, Math.Min(to * BlockRecords, _records));
            return;
        }

        for (int i = from; i < to; i++)
        {
            _clear[i] = _stage.MeetsNothing(_sweeps[worker], i, _dt, _substep) ? (byte)1 : (byte)0;
        }
    }
}
