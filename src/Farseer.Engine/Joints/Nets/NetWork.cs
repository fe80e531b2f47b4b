using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// The passes of nets in ranges for the workers: of bodies, and of the bundles of a colour. Rows of the overflow may share bodies, and
/// those at something that cannot move share that: they are few, and one thread does them.
/// </summary>
internal sealed unsafe class NetWork : IStageWork
{
    /// <summary>Bundles, of rows or of bodies, that are worth another worker's while, some 0.5 µs.</summary>
    private const int LeastBundles = 16;

    private readonly NetSolver _solver;
    private readonly NetBodies _bodies;
    private NetColor _color = null!;
    private JointStep _step;
    private JointForest _forest = null!;
    private NetSoftness _softness;
    private Pass _pass;

    public NetWork(NetSolver solver, NetBodies bodies)
    {
        _solver = solver;
        _bodies = bodies;
    }

    public enum Pass
    {
        StartBodies,
        Start,
        EnterBodies,
        WarmStart,
        Solve,
        MoveBodies,
        TurnAndRelax,
    }

    public void Begin(in JointStep step, JointForest forest)
    {
        _step = step;
        _forest = forest;
    }

    public void Run(Pass pass)
    {
        _pass = pass;
        _step.Runner.Run(this, _bodies.PaddedCount / WideLanes.BundleLanes, LeastBundles);
    }

    public void Run(Pass pass, NetColor color, bool shared, in NetSoftness softness)
    {
        _pass = pass;
        _color = color;
        _softness = softness;
        _step.Runner.Run(this, color.BundleCount, shared ? LeastBundles : int.MaxValue);
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        int count = to - from;
        int body = from * WideLanes.BundleLanes;
        int end = to * WideLanes.BundleLanes;
        BodyState* states = _step.Bodies.State.Pointer;
        switch (_pass)
        {
            case Pass.StartBodies:
                _bodies.Start(_step, _forest, body, end);
                break;
            case Pass.Start:
                _solver.Place(_color, from, to);
                NetKernel.Begin(_color.Bundles + from, count, states);
                break;
            case Pass.EnterBodies:
                _bodies.Enter(_step.Bodies, body, end);
                break;
            case Pass.WarmStart:
                NetKernel.WarmStart(_color.Bundles + from, count, states);
                break;
            case Pass.Solve:
                NetKernel.Solve(_color.Bundles + from, count, states, _softness);
                break;
            case Pass.MoveBodies:
                _bodies.Moved(_step.Bodies, body, end);
                break;
            case Pass.TurnAndRelax:
                NetKernel.TurnAndRelax(_color.Bundles + from, count, states);
                break;
        }
    }
}
