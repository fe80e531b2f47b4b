using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>Which joints act, and the trees they make.</summary>
internal sealed unsafe partial class JointCollection : JointPart, IStageWork
{
    /// <summary>Joints that are worth another worker's while, some 2 µs.</summary>
    private const int LeastJoints = 512;
    private readonly Column<byte> _builtMoves = new Column<byte>();
    private readonly Column<ulong> _keys = new Column<ulong>();
    private readonly Column<int> _order = new Column<int>();
    private readonly Column<int> _broken = new Column<int>();
    private int _collected;
    private bool _bodiesChanged;

    public JointCollection(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>Joints that broke in the last <see cref="Begin"/>, in their order.</summary>
    public int BrokenCount { get; private set; }

    public int Broken(int index) => _broken[index];

    /// <summary>
    /// Finds the joints that act, and the trees they make, if anything about them changed; then their errors and rows. A joint
    /// whose error passed its breaking point is switched off.
    /// </summary>
    public void Begin(in JointStep step)
    {
        _work.Step = step;
        BrokenCount = 0;
        _work.ContactCount = 0;
        _forest.ClearGuests();
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            _forest.Trees[i].Pulled = false;
            _forest.Trees[i].Strung = false;
        }

        if (Look() && Break() && !step.BreaksLate)
        {
            Look();
        }

        _solver.Overruns.FindOverruns();
        _solver.Contacts.FindWheels();
    }

    /// <summary>
    /// After somebody was told of joints that broke: other bodies may move now than when the trees were built. Joints that break late act
    /// until the step ends.
    /// </summary>
    /// <returns>True if joints act.</returns>
    public bool Renew()
    {
        if ((_store.Changed && !_work.Step.BreaksLate) || BodiesChanged())
        {
            _forest.ClearGuests();
            Look();
            _solver.Overruns.FindOverruns();
            _solver.Contacts.FindWheels();
        }

        return _solver.Any;
    }

    private bool Look()
    {
        if (_store.Changed || BodiesChanged())
        {
            Collect();
        }

        if (_work.Count == 0)
        {
            return false;
        }

        LookAtErrors();
        _solver.Chains.LookAtChains();
        CopySettings();
        WriteAll();
        if (BlocksChanged(out bool known))
        {
            if (known)
            {
                // A joint took another form: nets may have come or gone.
                Collect();
                CopySettings();
                WriteAll();
            }

            Build();
            LookAtErrors();
            _solver.Chains.LookAtChains();
            Choose(All);
            _solver.Bodies.LoadMasses();
            _solver.Bodies.LoadMoves(0);
            _solver.Bodies.LoadPoses();
        }

        return true;
    }

    /// <summary>From which size on errors count as put there from outside.</summary>
    private void LookAtErrors()
    {
        double outside = _work.Step.IsFarShorter
            ? Math.Max(TreePositions.Tolerance, TreePositions.Failed * _work.Step.ErrorScale)
            : TreeRows.Small;
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            _forest.Trees[i].Outside = outside;
        }
    }

    /// <summary>A copy: a callback may change a joint while the step goes on.</summary>
    public void CopySettings()
    {
        for (int i = 0; i < _work.Count && _chains.QuietJoints < _work.Count; i++)
        {
            if (!_solver.Chains.IsQuiet(i))
            {
                CopySettings(i);
            }
        }
    }

    public void CopySettings(int index)
    {
        _active[index].Settings = _store.Settings[_active[index].Joint];
        _active[index].Flags = _store.Flags[_active[index].Joint];
        _active[index].Pivot = _kinds.Of(_active[index].Kind).PivotOf(_active[index].Settings, _active[index].Flags);
    }

    private void WriteAll()
    {
        Choose(All);
        _solver.Bodies.LoadMasses();
        _solver.Bodies.LoadMoves(0);
        _solver.Bodies.LoadPoses();
        _solver.Rows.WriteRows(true);
    }

    private bool Break()
    {
        _broken.EnsureCapacity(_work.Count);
        for (int i = 0; i < _work.Count && _chains.QuietJoints < _work.Count; i++)
        {
            if (_solver.Chains.IsQuiet(i))
            {
                continue;
            }

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
                _store.NoteTie(joint);
                _store.Changed = true;
                _broken[BrokenCount++] = joint;
            }
        }

        return BrokenCount > 0;
    }

    private bool BodiesChanged()
    {
        _bodiesChanged = false;
        _work.Step.Runner.Run(this, _collected, LeastJoints);
        return _bodiesChanged;
    }

    /// <summary>Whether joints of a range hold bodies that may move now and could not, or the other way round.</summary>
    void IStageWork.Run(int worker, int from, int to)
    {
        JointLink* links = _store.Links.Pointer;
        for (int i = from; i < to; i++)
        {
            JointLink* link = links + _order[i];
            if ((_work.Step.Moves[link->BodyA] | (_work.Step.Moves[link->BodyB] << 1)) != _builtMoves[i])
            {
                _bodiesChanged = true;
                return;
            }
        }
    }

    /// <param name="known">The rows of a joint are others than those that it was collected with.</param>
    private bool BlocksChanged(out bool known)
    {
        bool changed = false;
        known = false;
        for (int i = 0; i < _work.Count && _chains.QuietJoints < _work.Count; i++)
        {
            if (_solver.Chains.IsQuiet(i))
            {
                continue;
            }

            if (_rows[i].Hard != _active[i].BuiltHard || _rows[i].Count != _active[i].BuiltCount || IsLimited(i) != _active[i].Limited)
            {
                changed = true;
                known |= _active[i].BuiltHard >= 0;
            }
        }

        return changed;
    }

    /// <summary>It has a limit that a block can hold: one without compliance.</summary>
    private bool IsLimited(int index)
    {
        JointRows* rows = _rows.Pointer + index;
        for (int k = rows->Hard; k < rows->Count; k++)
        {
            if (rows->Type[k] == (byte)RowType.Limit && rows->Damping[k] == 0)
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
        _forest.Reserve(end, _work.Step.Bodies.Ids.End);
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
        _nets.Renew(_order.Pointer, _collected, _work.Step.Moves, _work.Step.Bodies.Ids.End);
        _work.Count = 0;
        for (int i = 0; i < _collected; i++)
        {
            ref JointLink link = ref _store.Links[_order[i]];
            int moves = _work.Step.Moves[link.BodyA] | (_work.Step.Moves[link.BodyB] << 1);
            _builtMoves[i] = (byte)moves;
            if (moves != 0 && !_nets.Has(_order[i]))
            {
                _active[_work.Count] = default;
                _active[_work.Count].Joint = _order[i];
                _active[_work.Count].Kind = link.Kind;
                _active[_work.Count].Ends.BodyA = link.BodyA;
                _active[_work.Count].Ends.BodyB = link.BodyB;
                _active[_work.Count].Ends.NodeA = -1;
                _active[_work.Count].Ends.NodeB = -1;
                _active[_work.Count++].BuiltHard = -1;
            }
        }

        // The rows are not known yet: the first build makes nodes for the poses, the second the trees.
        _forest.Build(
            _active.Pointer, _work.Count, _work.Step.Bodies.Mass.Pointer, _work.Step.Moves, _nets.Search, _work.Step.Bodies.Ids.End);
        _chains.Choice.Forget();
    }

    private void Build()
    {
        for (int i = 0; i < _work.Count; i++)
        {
            _active[i].BuiltHard = _rows[i].Hard;
            _active[i].BuiltCount = _rows[i].Count;
            _active[i].Limited = IsLimited(i);
        }

        _forest.Build(
            _active.Pointer, _work.Count, _work.Step.Bodies.Mass.Pointer, _work.Step.Moves, _nets.Search, _work.Step.Bodies.Ids.End);
        for (int i = 0; i < _work.Count; i++)
        {
            _active[i].BlockLimits = _active[i].Limited && HasRoom(i);
        }

        _loops.Build(_work.Count);

        CountSprings();
        _chains.Choice.Renew(_forest, _active.Pointer, _rows.Pointer, _work.Count);
        _lanes.Choice.Begin(_forest, _active.Pointer, _rows.Pointer, _work.Step);
        _lanes.Choice.Reserve();
        _loose.Begin(_forest, _active.Pointer, _rows.Pointer, _work.Step);
        _loose.Reserve(_work.Count);
    }

    private void CountSprings()
    {
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            _forest.Trees[i].SpringRows = 0;
        }

        for (int i = 0; i < _work.Count; i++)
        {
            int springs = 0;
            for (int k = _rows[i].Hard; k < _rows[i].Count; k++)
            {
                springs += _rows[i].Type[k] == (byte)RowType.Spring ? 1 : 0;
            }

            ref RowEnds ends = ref _active[i].Ends;
            int treeA = ends.NodeA >= 0 ? _forest.Nodes[ends.NodeA].Tree : -1;
            int treeB = ends.NodeB >= 0 ? _forest.Nodes[ends.NodeB].Tree : -1;
            if (treeA >= 0)
            {
                _forest.Trees[treeA].SpringRows += springs;
            }

            if (treeB >= 0 && treeB != treeA)
            {
                _forest.Trees[treeB].SpringRows += springs;
            }
        }
    }

    /// <summary>The block of a joint, if it has one, has room for a limit.</summary>
    public bool HasRoom(int index)
    {
        ref ActiveJoint joint = ref _active[index];
        if (joint.Role != JointRole.Edge)
        {
            return joint.Role == JointRole.Loop || (joint.Role == JointRole.Anchor && joint.BuiltHard < TreeFactor.MostRows);
        }

        TreeNode* a = _forest.Nodes + joint.Ends.NodeA;
        TreeNode* b = _forest.Nodes + joint.Ends.NodeB;
        return (a->Parent == joint.Ends.NodeB ? a : b)->HasLimits;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_builtMoves);
        s.Column(_keys);
        s.Column(_order);
        s.Column(_broken);
        s.Value(ref _collected);
        s.Value(ref _bodiesChanged);
        BrokenCount = s.Value(BrokenCount);
    }
}
