using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;

namespace Farseer.Engine.Joints.Nets;

/// <summary>The passes of nets in ranges for the workers: of bodies, and of the bundles of a form and colour.</summary>
internal sealed unsafe class NetWork : IStageWork
{
    /// <summary>Bundles, of rows or of bodies, that are worth another worker's while, some 0.5 µs.</summary>
    private const int LeastBundles = 16;

    private readonly NetBodies _bodies;
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

    public void Begin(in JointStep step) => _step = step;

    public void Run(Pass pass)
    {
        _pass = pass;
        _step.Runner.Run(this, _bodies.PaddedCount / WideLanes.BundleLanes, LeastBundles);
    }

    public void Run(Pass pass, NetRows rows, in NetSoftness softness)
    {
        _pass = pass;
        _rows = rows;
        _softness = softness;
        _step.Runner.Run(this, rows.BundleCount, rows.IsShared ? LeastBundles : int.MaxValue);
    }

    void IStageWork.Run(int worker, int from, int to)
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
                _rows.Place(from, count, _bodies.Poses, (float)_step.StartScale);
                if (_rows.Begin(from, count, motion, NetShift.Keep(_step.ImpulseScale)))
                {
                    _rows.Disturbed = true;
                }

                break;
            case Pass.EnterBodies:
                _bodies.Enter(_step.Bodies, body, end);
                break;
            case Pass.WarmStart:
                _rows.WarmStart(from, count, motion);
                break;
            case Pass.Solve:
                _rows.Solve(from, count, motion, _softness);
                break;
            case Pass.MoveBodies:
                _bodies.Moved(_step.Bodies, body, end);
                break;
            case Pass.TurnAndRelax:
                _rows.TurnAndRelax(from, count, motion);
                break;
            case Pass.Turn:
            case Pass.Displaced:
                _rows.Turn(from, count, motion, _pass == Pass.Displaced);
                break;
            case Pass.Pull:
                _rows.Pull(from, count, motion, _softness);
                break;
        }
    }
}
