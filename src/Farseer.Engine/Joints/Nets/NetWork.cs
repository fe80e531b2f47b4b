using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Nets;

/// <summary>The passes of nets in ranges for the workers: of bodies, and of the bundles of a form and colour.</summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class NetWork : IStageWork, ISequenceWork
{
    /// <summary>Bundles, of rows or of bodies, that are worth another worker's while, some 0.5 µs.</summary>
    private const int LeastBundles = 16;

    private readonly NetBodies _bodies;
    private readonly StageList _stages = new StageList();
    private NetRows[] _solved = null!;
    private NetRows _rows = null!;
    private JointStep _step;
    private NetSoftness _softness;
    private Pass _pass;

    public NetWork(NetBodies bodies) => _bodies = bodies;

    public enum Pass
    {
        StartBodies,
        Start,
        EnterBodies,
        WarmStart,
        Solve,
        MoveBodies,
        TurnAndRelax,
        Turn,
        Pull,
        Displaced,
    }

    /// <param name="step">The step.</param>
    /// <param name="solved">Rows of each form and colour, in the order of solving.</param>
    /// <param name="count">How many of them there are.</param>
    public void Begin(in JointStep step, NetRows[] solved, int count)
    {
        _step = step;
        _solved = solved;
        step.Runner.Clear(_stages);
        _stages.Reserve(solved.Length);
        for (int i = 0; i < count; i++)
        {
            _stages.Add(solved[i].BundleCount, solved[i].IsShared ? step.Runner.BlocksOf(solved[i].BundleCount, LeastBundles) : 1);
        }
    }

    public void Run(Pass pass)
    {
        _pass = pass;
        _step.Runner.Run(this, _bodies.PaddedCount / WideLanes.BundleLanes, LeastBundles);
    }

    /// <summary>A pass over all rows.</summary>
    public void Run(Pass pass, in NetSoftness softness)
    {
        _pass = pass;
        _softness = softness;
        if (_step.Runner.RunAll(this, _stages))
        {
            return;
        }

        for (int i = 0; i < _stages.Count; i++)
        {
            _rows = _solved[i];
            _step.Runner.Run(this, _rows.BundleCount, _rows.IsShared ? LeastBundles : int.MaxValue);
        }
    }

    void IStageWork.Run(int worker, int from, int to) => Run(_rows, from, to);

    void ISequenceWork.Run(int worker, int stage, int from, int to) => Run(_solved[stage], from, to);

    private void Run(NetRows rows, int from, int to)
    {
        int count = to - from;
        int body = from * WideLanes.BundleLanes;
        int end = to * WideLanes.BundleLanes;
        var motion = new NetMotion(_step.Bodies);
        switch (_pass)
        {
            case Pass.StartBodies:
                _bodies.Start(_step, body, end);
                break;
            case Pass.Start:
                rows.Place(from, count, _bodies.Poses, (float)_step.StartScale);
                if (rows.Begin(from, count, motion, NetShift.Keep(_step.ImpulseScale)))
                {
                    rows.Disturbed = true;
                }

                break;
            case Pass.EnterBodies:
                _bodies.Enter(_step.Bodies, body, end);
                break;
            case Pass.WarmStart:
                rows.WarmStart(from, count, motion);
                break;
            case Pass.Solve:
                rows.Solve(from, count, motion, _softness);
                break;
            case Pass.MoveBodies:
                _bodies.Moved(_step.Bodies, body, end);
                break;
            case Pass.TurnAndRelax:
                rows.TurnAndRelax(from, count, motion);
                break;
            case Pass.Turn:
            case Pass.Displaced:
                rows.Turn(from, count, motion, _pass == Pass.Displaced);
                break;
            case Pass.Pull:
                rows.Pull(from, count, motion, _softness);
                break;
        }
    }
}
