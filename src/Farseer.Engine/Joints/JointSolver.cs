using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Chains;
using Farseer.Engine.Joints.Nets;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>What the joints see of a step.</summary>
[NotState(Why.OfOneStep)]
internal unsafe struct JointStep
{
    public StageRunner Runner;
    public BodyStore Bodies;

    /// <summary>1 for a body that the solver may move.</summary>
    public byte* Moves;
    public double Dt;
    public double Substep;

    /// <summary>Contact rows at each body.</summary>
    public int* Touches;

    /// <summary>Contacts that there is room for.</summary>
    public int ContactRoom;

    /// <summary>Ratio of this step's substep to the last one's.</summary>
    public double ImpulseScale;

    /// <summary>
    /// The share of the last impulses to start from: those of a longer substep by the ratio, those of a shorter one as they are. Of an impulse
    /// nothing says how much was a blow, which does not go by the length of the substep; a step of 1/60 s after one of 10⁻⁴ s would repeat
    /// it 167 times as hard.
    /// </summary>
    public readonly double StartScale => Math.Min(1, ImpulseScale);

    /// <summary>Errors stay: joints only stop what would make them larger.</summary>
    public bool Drifts;

    /// <summary>Somebody asks for the work of motors and springs, or for what contacts give.</summary>
    public bool Audited;

    /// <summary>Sums what contacts give, if somebody reads it.</summary>
    public ContactImpulses? Impulses;

    /// <summary>Others look at velocities between the passes, or change them: springs, joints that a user wrote, accounts.</summary>
    public bool Watched;

    /// <summary>A joint that breaks still acts in the step.</summary>
    public bool BreaksLate;
}

/// <summary>
/// The joints' part of a substep. Hard rows of a tree and the limits that hold are eliminated exactly; all other rows (contacts,
/// motors, springs, joints that close a loop) are iterated against the tree's own inverse mass, so that a heavy body at the end of
/// a light chain is felt as heavy. Then positions are corrected along the same directions, which makes the motion symplectic: it
/// keeps its energy. Velocities are double here; the store's floats are read and written once a pass.
/// </summary>
internal sealed unsafe partial class JointSolver : IStageWork
{
    private readonly JointStore _store;
    private readonly JointForest _forest = new JointForest();
    private readonly Column<ActiveJoint> _active = new Column<ActiveJoint>();
    private readonly Column<JointRows> _rows = new Column<JointRows>();
    private readonly JointPass _pass = new JointPass();
    private readonly TreeContactPass _contactPass = new TreeContactPass();
    private readonly TreeLoops _loops;
    private readonly JointKinds _kinds = new JointKinds();
    private readonly NetSolver _nets;
    private JointStep _step;
    private int _count;

    public JointSolver(JointStore store)
    {
        _store = store;
        _loops = new TreeLoops(_forest, _active, _rows);
        _nets = new NetSolver(store);
        _chains = new ChainSolver(store);
    }

    /// <summary>Joints act in this step.</summary>
    public bool Any => _count > 0 || _nets.Any;

    /// <summary>The pivots of nets, which have rows on lanes.</summary>
    public NetSolver Nets => _nets;

    /// <summary>Joints of nets have errors from outside: <see cref="PullNets"/> is to give displacements, and <see cref="NetsPulled"/> follows them.</summary>
    public bool NetsDisturbed => _nets.Disturbed;

    public void PullNets() => _nets.Pull();

    /// <summary>Single bodies that also take part as trees follow the displacements of their nets.</summary>
    public void NetsPulled()
    {
        _nets.Displaced();
        for (int at = 0; at < _nodeCount; at++)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            if (_nets.Search.IsNet(node->Body))
            {
                LoadMove(node);
            }
        }
    }

    /// <summary>True if the solver must move a body because of its joints.</summary>
    public bool Holds(int body) => _forest.NodeOf(body) >= 0 || _nets.Holds(body);

    /// <summary>Starts the substeps: contacts with trees have been taken.</summary>
    public void Start(in ContactCoefficients coefficients)
    {
        _chains.Select(_class, _step);
        FreeOverruns();
        AdmitTouched();
        int own = _nodeCount;
        Collate();
        _pass.Enter(_forest.View, _step.Bodies.State.Pointer);
        _contactPass.Enter(_forest.View, _step.Bodies, coefficients, _fineness);
        for (int at = 0; at < _jointCount; at++)
        {
            int i = _joints[at];
            ref JointState state = ref _store.States[_active[i].Joint];
            for (int k = 0; k < JointRows.Most; k++)
            {
                _active[i].Lambda[k] = state.Impulse[k] * _step.StartScale / _fineness;
            }

            _active[i].Given[0] = 0;
            _active[i].Given[1] = 0;
            _active[i].Given[2] = 0;
            if (!_forest.Trees[TreeOf(_active[i].Ends)].HasRows)
            {
                ForgetBends(_active.Pointer + i);
            }
        }

        MarkFree();
        BoundWishes();

        // Nothing has moved since the rows were written, unless somebody was told of a broken joint; guests are new.
        LoadMoves(BrokenCount > 0 ? 0 : own);
        RecallGaps();
        TakeToLanes();
        TakeToChains();
        _chains.Start();
        Factor();
        PrepareOnLanes(false);
        _nets.Start(_step);
    }

    /// <summary>
    /// After the velocities took gravity and forces: the noted change is dropped, so that positions move by plain h·v. The exact
    /// law for steady acceleration would feed energy into anything that swings.
    /// </summary>
    public void Enter()
    {
        BodyMotion* motions = _step.Bodies.Motion.Pointer;
        _lanes.Enter();
        WarmStartOnLanes();
        if (_loose.Any)
        {
            _loose.Enter();
        }

        _chains.Enter();
        MarkExact();
        for (int at = 0; at < _nodeCount; at++)
        {
            int i = _nodes[at];
            TreeNode* node = _forest.Nodes + i;
            if (_forest.Trees[node->Tree].Exact)
            {
                BodyMotion* motion = motions + node->Body;
                motion->ChangeX = 0;
                motion->ChangeY = 0;
                motion->ChangeW = 0;
            }

            for (int k = 0; k < 3; k++)
            {
                node->StartMove[k] = node->Move[k];
            }
        }

        Foresee();
        DriveDoubles();
        Kick(-0.5f);
        LoadVelocities();
        _chains.EnterPressed();
        WarmStart(_trees, _treeCount, _agenda, _agendaCount);
        _chains.TakeWarmStart();

        ForgetLimits();
        HoldWheels();
        StoreVelocities();
        _nets.Enter();
    }

    /// <summary>The biased pass: rows of errors and bias.</summary>
    /// <param name="again">The pass has been made in this substep.</param>
    /// <param name="sweeps">Over the rows.</param>
    public void Solve(bool again, int sweeps)
    {
        _nets.SolveBiased();
        SolveLanes(Pass.Biased, again, sweeps);
        SolvePressed(false, again);
        LoadVelocities();
        Run(TargetKind.Biased, Pass.Biased, again, sweeps);
    }

    /// <summary>The relax pass at the new positions: no errors, no bias.</summary>
    /// <param name="again">The pass has been made in this substep.</param>
    /// <param name="rub">With friction; of several sweeps in the second half of them.</param>
    /// <param name="sweeps">Over the rows.</param>
    public void Relax(bool again, bool rub, int sweeps)
    {
        _nets.Relax(again);
        Pass pass = rub ? Pass.Relaxed : Pass.RelaxedSmooth;
        SolveLanes(pass, again, sweeps);
        SolvePressed(true, again);
        LoadVelocities();
        Run(TargetKind.Relaxed, pass, again, sweeps);
    }

    /// <summary>Keeps the impulses for the next step.</summary>
    public void Finish()
    {
        _chains.Finish();
        FinishLanes();
        for (int at = 0; at < _jointCount; at++)
        {
            int i = _joints[at];
            ref JointState state = ref _store.States[_active[i].Joint];
            for (int k = 0; k < JointRows.Most; k++)
            {
                state.Impulse[k] = k < _rows[i].Count ? _active[i].Lambda[k] * _fineness : 0;
            }

            if (_active[i].Kind == JointKind.Gear && _rows[i].Hard > 0)
            {
                Mesh(_active.Pointer + i);
            }

            if (_active[i].Limited)
            {
                KeepRange(i);
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

        KeepMoves();
        NoteGaps();
        GiveContactsBack();
        _contactCount = 0;
        _wheelContactCount = 0;
        _forest.ClearGuests();
    }

    private enum Pass
    {
        Biased,
        Relaxed,
        RelaxedSmooth,
        Impact,
        Settle,
        Correction,
        PushOut,
        Pull,
    }

    /// <summary>
    /// The trees, then the rows. Where rows pushed at limits, which then are to be held or let go, both once more: a contact that opens
    /// a limit would have a whole substep for it otherwise.
    /// </summary>
    private void Run(TargetKind kind, Pass pass, bool again, int sweeps)
    {
        SolveTrees(kind, again);
        bool kept = KeepBeforeRows();
        Sweep(pass, sweeps);
        if (_agendaCount > 0 && SolveTrees(kind, true))
        {
            Sweep(pass, some: true);
            if (kept)
            {
                AskAgainWithoutLimits(kind, pass, sweeps);
            }
        }

        StoreVelocities();
    }

    /// <summary>
    /// Sweeps over all iterated rows, in the order of the trees. Several are one walk: the bodies between the rows wait for their velocities
    /// until the last of them.
    /// </summary>
    /// <param name="pass">What the rows do.</param>
    /// <param name="sweeps">How often; friction waits for the second half.</param>
    /// <param name="some">Only in the groups of trees that are marked: what others do is no concern of a tree that no row ties to them.</param>
    private void Sweep(Pass pass, int sweeps = 1, bool some = false)
    {
        if (_agendaCount == 0)
        {
            return;
        }

        JointForestView view = _forest.View;
        bool chains = _chains.AnyPressed && (pass <= Pass.RelaxedSmooth || pass == Pass.Correction);
        if (chains)
        {
            _chains.BeginWalks(some);
        }

        Walk(_trees, _treeCount, _agenda, _agendaCount, pass, sweeps, some);
        if (chains)
        {
            _chains.EndWalks(some, pass == Pass.Correction);
        }

        for (int at = 0; at < _treeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            if (tree->HasRows && Acts(tree, some) && tree->Carries)
            {
                if (pass < Pass.PushOut)
                {
                    TreeReactions.EndWalk(_forest, tree, _active.Pointer, _rows.Pointer);
                }
                else
                {
                    TreeWalk.End(view, tree);
                }
            }
        }
    }

    /// <summary>Begins a walk of trees and sweeps over their rows.</summary>
    private void Walk(Column<int> trees, int treeCount, Column<int> agenda, int agendaCount, Pass pass, int sweeps, bool some)
    {
        JointForestView view = _forest.View;
        for (int at = 0; at < treeCount; at++)
        {
            JointTree* tree = _forest.Trees + trees[at];
            if (tree->HasRows && Acts(tree, some))
            {
                TreeWalk.Begin(view, tree);
            }
        }

        for (int sweep = 0; sweep < sweeps; sweep++)
        {
            SweepOnce(agenda, agendaCount, pass == Pass.Relaxed && sweep * 2 < sweeps - 1 ? Pass.RelaxedSmooth : pass, some);
        }
    }

    private void SweepOnce(Column<int> agenda, int agendaCount, Pass pass, bool some)
    {
        for (int i = 0; i < agendaCount; i++)
        {
            int item = agenda[i];
            if (some && !_forest.Trees[_forest.Trees[TreeOf(EndsOf(item))].Group].GroupActs)
            {
                continue;
            }

            if (_anyWishes && pass <= Pass.RelaxedSmooth && (GroupAt(item)->Wishes && IsWish(item)) != _wishing)
            {
                continue;
            }

            if (item < 0)
            {
                Solve(_contacts.Pointer + ~item, pass);
            }
            else
            {
                if (_active[item].LeadsLoops)
                {
                    _loops.Sweep(_forest.Trees + TreeOf(_active[item].Ends));
                }

                Solve(_active.Pointer + item, _rows.Pointer + item, pass);
            }
        }
    }

    private bool Acts(JointTree* tree, bool some) => !some || _forest.Trees[tree->Group].GroupActs;

    private void ClearGroups()
    {
        for (int at = 0; at < _treeCount; at++)
        {
            _forest.Trees[_trees[at]].GroupActs = false;
        }

        _chains.ClearGroups();
    }

    private ref RowEnds EndsOf(int item) => ref item < 0 ? ref _contacts[~item].Ends : ref _active[item].Ends;

    private void Solve(TreeContact* contact, Pass pass)
    {
        if (contact->Held && pass != Pass.Impact)
        {
            return;
        }

        switch (pass)
        {
            case Pass.Biased:
                _contactPass.SolveBiased(contact);
                break;
            case Pass.Relaxed:
            case Pass.RelaxedSmooth:
                _contactPass.Relax(contact, pass == Pass.Relaxed);
                break;
            case Pass.Impact:
                _contactPass.Strike(contact);
                break;
            case Pass.Correction:
                _contactPass.Hold(contact);
                break;
            case Pass.PushOut:
                _contactPass.PushOut(contact, _pushRate);
                break;
            case Pass.Pull:
                _contactPass.Block(contact);
                break;
        }
    }

    private void Solve(ActiveJoint* joint, JointRows* rows, Pass pass)
    {
        switch (pass)
        {
            case Pass.Biased:
            case Pass.Relaxed:
            case Pass.RelaxedSmooth:
            case Pass.Settle:
                _pass.Solve(joint, rows, _step, pass == Pass.Biased);
                break;
            case Pass.Correction:
                _pass.HoldPoint(joint, rows);
                break;
            case Pass.Pull:
                _pass.Pull(joint, rows, _step);
                break;
        }
    }

    private void Factor()
    {
        for (int at = 0; at < _treeCount; at++)
        {
            int i = _trees[at];
            JointTree* tree = _forest.Trees + i;
            Factor(tree);
            if (tree->HasRows)
            {
                TreeFactor.CompleteMasses(_forest, tree);
            }

            tree->Refactored = false;
        }

        PrepareFrom(0);
    }

    private void Prepare(int item)
    {
        if (item < 0)
        {
            _contactPass.Prepare(_contacts.Pointer + ~item);
        }
        else
        {
            _pass.Prepare(_active.Pointer + item, _rows.Pointer + item, _step.Substep);
        }
    }
}
