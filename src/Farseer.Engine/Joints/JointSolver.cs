using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>What the joints see of a step.</summary>
internal unsafe struct JointStep
{
    public BodyStore Bodies;

    /// <summary>1 for a body that the solver may move.</summary>
    public byte* Moves;
    public double Dt;
    public double Substep;

    /// <summary>Contact rows at each body.</summary>
    public int* Touches;

    /// <summary>Ratio of this step's substep to the last one's.</summary>
    public double ImpulseScale;

    /// <summary>A joint that breaks still acts in the step.</summary>
    public bool BreaksLate;
}

/// <summary>
/// The joints' part of a substep. Hard rows of a tree are eliminated exactly; all other rows (limits, motors, springs, joints that
/// close a loop) are iterated against the tree's own inverse mass, so that a heavy body at the end of a light chain is felt as
/// heavy. Then positions are corrected along the same directions, which makes the motion symplectic: it keeps its energy.
/// Velocities are double here; the store's floats are read and written once a pass.
/// </summary>
internal sealed unsafe partial class JointSolver
{
    private readonly JointStore _store;
    private readonly JointForest _forest = new JointForest();
    private readonly Column<ActiveJoint> _active = new Column<ActiveJoint>();
    private readonly Column<JointRows> _rows = new Column<JointRows>();
    private readonly Column<byte> _builtMoves = new Column<byte>();
    private readonly Column<ulong> _keys = new Column<ulong>();
    private readonly Column<int> _order = new Column<int>();
    private readonly Column<int> _broken = new Column<int>();
    private readonly RadixSort _sort = new RadixSort();
    private readonly JointPass _pass = new JointPass();
    private readonly JointKinds _kinds = new JointKinds();
    private JointStep _step;
    private int _count;
    private int _collected;
    private bool _anyRows;

    public JointSolver(JointStore store) => _store = store;

    /// <summary>Joints act in this step.</summary>
    public bool Any => _count > 0;

    /// <summary>True if the solver must move a body because of its joints.</summary>
    public bool Holds(int body) => _forest.NodeOf(body) >= 0;

    /// <summary>Joints that broke in the last <see cref="Begin"/>, in their order.</summary>
    public int BrokenCount { get; private set; }

    public int Broken(int index) => _broken[index];

    /// <summary>
    /// Finds the joints that act, and the trees they make, if anything about them changed; then their errors and rows. A joint
    /// whose error passed its breaking point is switched off.
    /// </summary>
    public void Begin(in JointStep step)
    {
        _step = step;
        BrokenCount = 0;
        if (!Look())
        {
            return;
        }

        if (Break() && !step.BreaksLate && !Look())
        {
            return;
        }

        for (int i = 0; i < _count; i++)
        {
            ref JointState state = ref _store.States[_active[i].Joint];
            for (int k = 0; k < JointRows.Most; k++)
            {
                _active[i].Lambda[k] = state.Impulse[k] * step.ImpulseScale;
            }

            _active[i].Given[0] = 0;
            _active[i].Given[1] = 0;
            _active[i].Given[2] = 0;
        }

        MarkFree();
        Factor();
    }

    private bool Look()
    {
        if (_store.Changed || BodiesChanged())
        {
            Collect();
        }

        if (_count == 0)
        {
            return false;
        }

        for (int i = 0; i < _count; i++)
        {
            // A copy: a callback may change the joint while the step goes on.
            _active[i].Settings = _store.Settings[_active[i].Joint];
            _active[i].Flags = _store.Flags[_active[i].Joint];
        }

        LoadMasses();
        LoadPoses();
        WriteRows(true);
        if (BlocksChanged())
        {
            Build();
            LoadMasses();
            LoadPoses();
        }

        return true;
    }

    private bool Break()
    {
        _broken.EnsureCapacity(_count);
        for (int i = 0; i < _count; i++)
        {
            int joint = _active[i].Joint;
            ref JointState state = ref _store.States[joint];
            state.Error = _rows[i].JointError;
            double breakpoint = _active[i].Settings.Breakpoint;
            if (!double.IsInfinity(breakpoint))
            {
                state.Error += state.Error < 0 ? -state.Drift : state.Drift;
            }

            double force = Math.Sqrt((state.ForceX * state.ForceX) + (state.ForceY * state.ForceY));
            if (Math.Abs(state.Error) > breakpoint || force > _active[i].Settings.BreakForce)
            {
                _store.Flags[joint] &= ~JointFlags.Enabled;
                _store.Changed = true;
                _broken[BrokenCount++] = joint;
            }
        }

        return BrokenCount > 0;
    }

    /// <summary>
    /// After the velocities took gravity and forces: the noted change is dropped, so that positions move by plain h·v. The exact
    /// law for steady acceleration would feed energy into anything that swings.
    /// </summary>
    public void Enter()
    {
        BodyMotion* motions = _step.Bodies.Motion.Pointer;
        for (int i = 0; i < _forest.Count; i++)
        {
            BodyMotion* motion = motions + _forest.Nodes[i].Body;
            motion->ChangeX = 0;
            motion->ChangeY = 0;
            motion->ChangeW = 0;
            ReadMove(_forest.Nodes + i, _forest.Nodes[i].StartMove);
        }

        Kick(-0.5f);
        LoadVelocities();
        if (_anyRows)
        {
            _pass.WarmStart(_forest, _active.Pointer, _rows.Pointer, _count);
            StoreVelocities();
        }
    }

    /// <summary>The biased pass: rows of errors and bias.</summary>
    public void Solve()
    {
        LoadVelocities();
        SetTargets(TargetKind.Biased);
        TreeSolve.Run(_forest, false);
        TreeReactions.AddSolve(_forest, _active.Pointer, _rows.Pointer);
        Iterate(true);
        StoreVelocities();
    }

    /// <summary>The relax pass at the new positions: no errors, no bias.</summary>
    public void Relax()
    {
        LoadVelocities();
        SetTargets(TargetKind.Relaxed);
        TreeSolve.Run(_forest, false);
        TreeReactions.AddSolve(_forest, _active.Pointer, _rows.Pointer);
        Iterate(false);
        StoreVelocities();
    }

    /// <summary>Keeps the impulses for the next step.</summary>
    public void Finish()
    {
        for (int i = 0; i < _count; i++)
        {
            ref JointState state = ref _store.States[_active[i].Joint];
            for (int k = 0; k < JointRows.Most; k++)
            {
                state.Impulse[k] = k < _rows[i].Count ? _active[i].Lambda[k] : 0;
            }

            double* given = _active.Pointer[i].Given;
            if (!double.IsInfinity(_active[i].Settings.Breakpoint))
            {
                state.Drift = (state.Drift * (1 - Math.Min(1, _active[i].Settings.BiasFactor))) + StraightDrift(i);
            }

            state.ForceX = given[0] / _step.Dt;
            state.ForceY = given[1] / _step.Dt;
            state.Torque = (given[2] - ((_rows[i].ArmX * given[1]) - (_rows[i].ArmY * given[0]))) / _step.Dt;
        }
    }

    private void Iterate(bool biased)
    {
        if (!_anyRows)
        {
            return;
        }

        TreeWalk.Begin(_forest);
        _pass.Sweep(_forest, _active.Pointer, _rows.Pointer, _count, _step, biased);
        TreeWalk.End(_forest);
        TreeReactions.AddWalk(_forest, _active.Pointer, _rows.Pointer);
    }

    private void Factor()
    {
        TreeFactor.Run(_forest, _active.Pointer, _rows.Pointer);
        if (_anyRows)
        {
            TreeFactor.CompleteMasses(_forest);
            _pass.Prepare(_forest, _active.Pointer, _rows.Pointer, _count, _step);
        }
    }

    private bool BodiesChanged()
    {
        for (int i = 0; i < _collected; i++)
        {
            ref JointLink link = ref _store.Links[_order[i]];
            int now = _step.Moves[link.BodyA] | (_step.Moves[link.BodyB] << 1);
            if (now != _builtMoves[i])
            {
                return true;
            }
        }

        return false;
    }

    private bool BlocksChanged()
    {
        for (int i = 0; i < _count; i++)
        {
            if (_rows[i].Hard != _active[i].BuiltHard)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The enabled joints in their order, and of them those with a body that moves.</summary>
    private void Collect()
    {
        _store.Changed = false;
        int end = _store.Ids.End;
        _keys.EnsureCapacity(end);
        _order.EnsureCapacity(end);
        _builtMoves.EnsureCapacity(end);
        _active.EnsureCapacity(end);
        _rows.EnsureCapacity(end);
        _collected = 0;
        for (int joint = 0; joint < end; joint++)
        {
            const JointFlags Acts = JointFlags.Alive | JointFlags.Enabled;
            if ((_store.Flags[joint] & Acts) == Acts)
            {
                _keys[_collected] = (uint)_store.Links[joint].Order;
                _order[_collected++] = joint;
            }
        }

        _sort.Sort(_keys.Pointer, _order.Pointer, _collected);
        _count = 0;
        for (int i = 0; i < _collected; i++)
        {
            ref JointLink link = ref _store.Links[_order[i]];
            int moves = _step.Moves[link.BodyA] | (_step.Moves[link.BodyB] << 1);
            _builtMoves[i] = (byte)moves;
            if (moves != 0)
            {
                _active[_count] = default;
                _active[_count].Joint = _order[i];
                _active[_count].Kind = link.Kind;
                _active[_count].BodyA = link.BodyA;
                _active[_count].BodyB = link.BodyB;
                _active[_count].NodeA = -1;
                _active[_count].NodeB = -1;
                _active[_count++].BuiltHard = -1;
            }
        }

        // The rows are not known yet: the first build makes nodes for the poses, the second the trees.
        _forest.Build(_active.Pointer, _count, _step.Bodies.Mass.Pointer, _step.Moves, _step.Bodies.Ids.End);
    }

    private void Build()
    {
        for (int i = 0; i < _count; i++)
        {
            _active[i].BuiltHard = _rows[i].Hard;
        }

        _forest.Build(_active.Pointer, _count, _step.Bodies.Mass.Pointer, _step.Moves, _step.Bodies.Ids.End);
        _anyRows = false;
        for (int i = 0; i < _count; i++)
        {
            ref ActiveJoint joint = ref _active[i];
            joint.HasRows = joint.Role == JointRole.Iterated || _rows[i].Count > _rows[i].Hard;
            _anyRows |= joint.HasRows;
        }
    }
}
