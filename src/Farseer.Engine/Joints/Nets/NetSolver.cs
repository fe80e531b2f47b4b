using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Constraints;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// The pivots of nets, on lanes. A pivot keeps its row, with its impulses, for as long as it belongs to a net; what it did in a step is
/// read from there when somebody asks. Everything else that a net has (limits, motors, springs, other kinds) is iterated row by row
/// by <see cref="JointPass"/> after these.
/// </summary>
internal sealed unsafe partial class NetSolver
{
    private readonly JointStore _store;
    private readonly BodyColors _bodyColors = new BodyColors();
    private readonly NetColor[] _colors = new NetColor[BodyColors.Count];
    private readonly NetBodies _bodies = new NetBodies();
    private readonly NetWork _work;
    private JointStep _step;
    private bool _runs;

    public NetSolver(JointStore store)
    {
        _store = store;
        _work = new NetWork(this, _bodies);
        for (int i = 0; i < _colors.Length; i++)
        {
            _colors[i] = new NetColor(i >= BodyColors.Masked);
        }
    }

    public bool Any => _members.Count > 0;

    /// <summary>A pivot of a net is at the body.</summary>
    public bool Holds(int body) => _bodies.Holds(body);

    /// <summary>Pivots on lanes; <see cref="Member"/> names their joints.</summary>
    public int Count => _members.Count;

    public int Member(int index) => _members[index];

    /// <summary>Nets keep to the substeps of the step.</summary>
    public void Select(int index) => _runs = Any && index == 0;

    /// <summary>Starts the substeps: arms in the middle of the step, and what the bodies weigh.</summary>
    public void Start(in JointStep step, JointForest forest)
    {
        if (!_runs)
        {
            return;
        }

        _step = step;
        _work.Begin(step, forest);
        _work.Run(NetWork.Pass.StartBodies);
        Sweep(NetWork.Pass.Start, NetSoftness.Hard);
    }

    /// <summary>After the velocities took gravity and forces: bodies move by h·v from here on, and the last impulses act again.</summary>
    public void Enter()
    {
        if (_runs)
        {
            _work.Run(NetWork.Pass.EnterBodies);
            Sweep(NetWork.Pass.WarmStart, NetSoftness.Hard);
        }
    }

    public void SolveBiased() => Sweep(NetWork.Pass.Solve, NetSoftness.Soft(_step.Substep));

    /// <summary>After the positions moved.</summary>
    public void Moved()
    {
        if (_runs)
        {
            _work.Run(NetWork.Pass.MoveBodies);
        }
    }

    /// <param name="again">The arms have been turned in this substep.</param>
    public void Relax(bool again) => Sweep(again ? NetWork.Pass.Solve : NetWork.Pass.TurnAndRelax, NetSoftness.Hard);

    /// <summary>Arms, errors and masses of the rows of some bundles at the start of the step.</summary>
    internal void Place(NetColor color, int from, int to)
    {
        int end = Math.Min(color.FirstRowOf(to), color.RowCount);
        for (int row = color.FirstRowOf(from); row < end; row++)
        {
            Place(color.BundleOf(row), color.LaneOf(row), color.AnchorsOf(row), (float)_step.ImpulseScale);
        }
    }

    private void Sweep(NetWork.Pass pass, in NetSoftness softness)
    {
        for (int k = 0; _runs && k < _colors.Length; k++)
        {
            int color = BodyColors.InOrder(k);
            _work.Run(pass, _colors[color], color < BodyColors.Dynamic, softness);
        }
    }

    /// <summary>Arms, errors and masses of a row at the start of the step.</summary>
    private void Place(NetBundle* row, int lane, in NetAnchors anchors, float impulseScale)
    {
        NetPose* a = _bodies.Poses + row->BodyA[lane];
        NetPose* b = _bodies.Poses + row->BodyB[lane];
        double ax = (a->Cos * anchors.AX) - (a->Sin * anchors.AY);
        double ay = (a->Sin * anchors.AX) + (a->Cos * anchors.AY);
        double bx = (b->Cos * anchors.BX) - (b->Sin * anchors.BY);
        double by = (b->Sin * anchors.BX) + (b->Cos * anchors.BY);
        row->MiddleAX[lane] = (float)ax;
        row->MiddleAY[lane] = (float)ay;
        row->MiddleBX[lane] = (float)bx;
        row->MiddleBY[lane] = (float)by;
        row->BaseX[lane] = (float)((b->X - a->X) + (bx - ax));
        row->BaseY[lane] = (float)((b->Y - a->Y) + (by - ay));

        float response = a->InverseMass + b->InverseMass;
        float inverse = response > 0 ? 1 / response : 0;
        float scale = row->Response[lane] > 0 ? impulseScale * (response / row->Response[lane]) : 0;
        row->Response[lane] = response;
        row->ShareA[lane] = a->InverseMass * inverse;
        row->ShareB[lane] = b->InverseMass * inverse;
        row->TurnA[lane] = a->InverseInertia * inverse;
        row->TurnB[lane] = b->InverseInertia * inverse;
        float x = row->ImpulseX[lane] * scale;
        float y = row->ImpulseY[lane] * scale;
        row->ImpulseX[lane] = x;
        row->ImpulseY[lane] = y;

        // The first warm start counts these as given; they were, in the step before.
        row->SumX[lane] = -x;
        row->SumY[lane] = -y;
    }
}
