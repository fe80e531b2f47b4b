using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Chains;
using Farseer.Engine.Joints.Lanes;
using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Nets;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>
/// The joints' part of a substep. Hard rows of a tree and the limits that hold are eliminated exactly; all other rows (contacts,
/// motors, springs, joints that close a loop) are iterated against the tree's own inverse mass, so that a heavy body at the end of
/// a light chain is felt as heavy. Then positions are corrected along the same directions, which makes the motion symplectic: it
/// keeps its energy. Velocities are double here; the store's floats are read and written once a pass.
/// </summary>
internal sealed unsafe class JointSolver
{
    private readonly JointWork _work;
    private readonly Column<ActiveJoint> _active;
    private readonly Column<int> _agenda;
    private readonly ChainSolver _chains;
    private readonly TreeContactPass _contactPass;
    private readonly JointForest _forest;
    private readonly Column<int> _joints;
    private readonly TreeLanes _lanes;
    private readonly LooseSolver _loose;
    private readonly NetSolver _nets;
    private readonly Column<int> _nodes;
    private readonly JointPass _pass;
    private readonly Column<JointRows> _rows;
    private readonly JointStore _store;
    private readonly Column<int> _trees;

    public JointSolver(JointWork work)
    {
        _work = work;
        _active = work.Active;
        _agenda = work.Agenda;
        _chains = work.Chains;
        _contactPass = work.ContactPass;
        _forest = work.Forest;
        _joints = work.Joints;
        _lanes = work.Lanes;
        _loose = work.Loose;
        _nets = work.Nets;
        _nodes = work.Nodes;
        _pass = work.Pass;
        _rows = work.Rows;
        _store = work.Store;
        _trees = work.Trees;
        Collection = new JointCollection(this, work);
        Bodies = new TreeBodies(this, work);
        Rows = new TreeRows(this, work);
        Limits = new TreeLimits(this, work);
        LoopLimits = new LoopLimits(this, work);
        Responses = new TreeResponses(this, work);
        Positions = new TreePositions(this, work);
        Projection = new TreeProjection(this, work);
        Tension = new TreeTension(this, work);
        Overruns = new JointOverruns(this, work);
        Impacts = new TreeImpacts(this, work);
        Contacts = new TreeContacts(this, work);
        Wishes = new JointWishes(this, work);
        Loads = new JointLoads(this, work);
        Lanes = new TreesOnLanes(this, work);
        Chains = new TreesAsChains(this, work);
        Sweeps = new TreeSweeps(this, work);
    }

    /// <summary>Which joints act, and the trees they make.</summary>
    public JointCollection Collection { get; }

    /// <summary>Bodies of trees: masses, poses and velocities in double.</summary>
    public TreeBodies Bodies { get; }

    /// <summary>Rows, their errors and their targets.</summary>
    public TreeRows Rows { get; }

    /// <summary>Which limits hold.</summary>
    public TreeLimits Limits { get; }

    /// <summary>The same of joints that close loops.</summary>
    public LoopLimits LoopLimits { get; }

    /// <summary>What a tree answers to impulses.</summary>
    public TreeResponses Responses { get; }

    /// <summary>Corrections of positions, and displacements.</summary>
    public TreePositions Positions { get; }

    /// <summary>Trees whose corrections went astray.</summary>
    public TreeProjection Projection { get; }

    /// <summary>Bodies that joints under tension hold in line.</summary>
    public TreeTension Tension { get; }

    /// <summary>Limits that were passed.</summary>
    public JointOverruns Overruns { get; }

    /// <summary>Impacts of bodies of trees.</summary>
    public TreeImpacts Impacts { get; }

    /// <summary>Contacts with bodies of trees.</summary>
    public TreeContacts Contacts { get; }

    /// <summary>What motors and springs would do, which contacts may forbid.</summary>
    public JointWishes Wishes { get; }

    /// <summary>Which trees need more substeps than others.</summary>
    public JointLoads Loads { get; }

    /// <summary>Trees of equal form, solved side by side.</summary>
    public TreesOnLanes Lanes { get; }

    /// <summary>Trees that are chains of hinges.</summary>
    public TreesAsChains Chains { get; }

    /// <summary>The passes over the trees.</summary>
    public TreeSweeps Sweeps { get; }

    /// <summary>Joints act in this step.</summary>
    public bool Any => _work.Count > 0 || _nets.Any;

    /// <summary>The pivots of nets, which have rows on lanes.</summary>
    public NetSolver Nets => _nets;

    /// <summary>
    /// Joints of nets have errors from outside: <see cref="PullNets"/> is to give displacements, and <see cref="NetsPulled"/> follows them.
    /// </summary>
    public bool NetsDisturbed => _nets.Disturbed;

    public void PullNets() => _nets.Pull();

    /// <summary>Single bodies that also take part as trees follow the displacements of their nets.</summary>
    public void NetsPulled()
    {
        _nets.Displaced();
        for (int at = 0; at < _work.NodeCount; at++)
        {
            TreeNode* node = _forest.Nodes + _nodes[at];
            if (_nets.Search.IsNet(node->Body))
            {
                Bodies.LoadMove(node);
            }
        }
    }

    /// <summary>True if the solver must move a body because of its joints.</summary>
    public bool Holds(int body) => _forest.NodeOf(body) >= 0 || _nets.Holds(body);

    /// <summary>Starts the substeps: contacts with trees have been taken.</summary>
    public void Start(in ContactCoefficients coefficients)
    {
        _chains.Choice.Select(_work.Class, _work.Step);
        Overruns.FreeOverruns();
        Chains.AdmitTouched();
        int own = _work.NodeCount;
        Contacts.Collate();
        _pass.Enter(_forest.View, _work.Step.Bodies.State.Pointer);
        _contactPass.Enter(_forest.View, _work.Step.Bodies, coefficients, _work.Fineness);
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            ref JointState state = ref _store.States[_active[i].Joint];
            for (int k = 0; k < JointRows.Most; k++)
            {
                _active[i].Lambda[k] = state.Impulse[k] * _work.Step.StartScale / _work.Fineness;
            }

            // As if the substep before had given what the last step gave on average: see TreeTension.
            _active[i].GivenBefore[0] = -state.ForceX * _work.Step.Substep;
            _active[i].GivenBefore[1] = -state.ForceY * _work.Step.Substep;
            _active[i].Given[0] = 0;
            _active[i].Given[1] = 0;
            _active[i].Given[2] = 0;
            if (!_forest.Trees[_forest.TreeOf(_active[i].Ends)].HasRows)
            {
                TreePositions.ForgetBends(_active.Pointer + i);
            }
        }

        Bodies.MarkFree();
        Wishes.BoundWishes();

        // Nothing has moved since the rows were written, unless somebody was told of a broken joint; guests are new.
        Bodies.LoadMoves(Collection.BrokenCount > 0 ? 0 : own);
        Contacts.RecallGaps();
        Lanes.TakeToLanes();
        Chains.TakeToChains();
        _chains.Start();
        Sweeps.FactorAll();
        Lanes.PrepareOnLanes(false);
        _nets.Start(_work.Step);
    }

    /// <summary>
    /// After the velocities took gravity and forces: the noted change is dropped, so that positions move by plain h·v. The exact
    /// law for steady acceleration would feed energy into anything that swings.
    /// </summary>
    public void Enter()
    {
        BodyMotion* motions = _work.Step.Bodies.Motion.Pointer;
        _lanes.Enter();
        Tension.StiffenOnLanes();
        Lanes.WarmStartOnLanes();
        if (_loose.Any)
        {
            _loose.Enter();
        }

        _chains.Enter();
        Bodies.MarkExact();
        for (int at = 0; at < _work.NodeCount; at++)
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

        Bodies.ForeseeRows();
        Bodies.DriveDoubles();
        Bodies.Kick(-0.5f);
        Bodies.LoadVelocities();
        Tension.Stiffen();
        _chains.Pressed.Enter();
        Contacts.WarmStart(_trees, _work.TreeCount, _agenda, _work.AgendaCount);
        _chains.Pressed.TakeWarmStart();

        Limits.ForgetLimits();
        Contacts.HoldWheels();
        Bodies.StoreVelocities();
        _nets.Enter();
    }

    /// <summary>The biased pass: rows of errors and bias.</summary>
    /// <param name="again">The pass has been made in this substep.</param>
    /// <param name="sweeps">Over the rows.</param>
    public void Solve(bool again, int sweeps)
    {
        _nets.SolveBiased();
        Lanes.SolveLanes(SweepKind.Biased, again, sweeps);
        Chains.SolvePressed(false, again);
        Bodies.LoadVelocities();
        Sweeps.RunPass(TargetKind.Biased, SweepKind.Biased, again, sweeps);
    }

    /// <summary>The relax pass at the new positions: no errors, no bias.</summary>
    /// <param name="again">The pass has been made in this substep.</param>
    /// <param name="rub">With friction; of several sweeps in the second half of them.</param>
    /// <param name="sweeps">Over the rows.</param>
    public void Relax(bool again, bool rub, int sweeps)
    {
        _nets.Relax(again);
        SweepKind pass = rub ? SweepKind.Relaxed : SweepKind.RelaxedSmooth;
        Lanes.SolveLanes(pass, again, sweeps);
        Chains.SolvePressed(true, again);
        Bodies.LoadVelocities();
        Sweeps.RunPass(TargetKind.Relaxed, pass, again, sweeps);
    }

    /// <summary>Keeps the impulses for the next step.</summary>
    public void Finish()
    {
        _chains.Finish();
        Lanes.FinishLanes();
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            ref JointState state = ref _store.States[_active[i].Joint];
            for (int k = 0; k < JointRows.Most; k++)
            {
                state.Impulse[k] = k < _rows[i].Count ? _active[i].Lambda[k] * _work.Fineness : 0;
            }

            if (_active[i].Kind == JointKind.Gear && _rows[i].Hard > 0)
            {
                Bodies.Mesh(_active.Pointer + i);
            }

            if (_active[i].Limited)
            {
                Overruns.KeepRange(i);
            }

            double* given = _active.Pointer[i].Given;
            if (!double.IsInfinity(_active[i].Settings.Breakpoint))
            {
                state.Drift = (state.Drift * (1 - Math.Min(1, _active[i].Settings.BiasFactor))) + Rows.StraightDrift(i);
            }

            state.ForceX = given[0] / _work.Step.Dt;
            state.ForceY = given[1] / _work.Step.Dt;
            state.Torque = (given[2] - ((_rows[i].ArmX * given[1]) - (_rows[i].ArmY * given[0]))) / _work.Step.Dt;
        }

        Bodies.KeepMoves();
        Contacts.NoteGaps();
        Contacts.GiveContactsBack();
        _work.ContactCount = 0;
        _work.WheelContactCount = 0;
        _forest.ClearGuests();
    }

    /// <summary>
    /// Work of the motors and springs of the joints in the substep that has just ended: impulse times mean speed of each row. What is no
    /// number was done to a body that is about to be taken out.
    /// </summary>
    /// <param name="before">Velocities at the substep's start, three numbers a body of the solver.</param>
    public double MotorWork(double* before)
    {
        double work = 0;
        for (int at = 0; at < _work.JointCount; at++)
        {
            int i = _joints[at];
            ActiveJoint* joint = _active.Pointer + i;
            JointRows* rows = _rows.Pointer + i;
            ref JointLink link = ref _store.Links[joint->Joint];
            for (int k = rows->Hard; k < rows->Count; k++)
            {
                RowType type = (RowType)rows->Type[k];
                if (type == RowType.Motor || type == RowType.Spring)
                {
                    double a = MeanSpeed(link.BodyA, rows->A + (k * 3), before);
                    double b = MeanSpeed(link.BodyB, rows->B + (k * 3), before);
                    double done = joint->Lambda[k] * (a + b);
                    work += FloatBits.IsFinite(done) ? done : 0;
                }
            }
        }

        return work;
    }

    /// <summary>A body that cannot be moved keeps its velocity through the substep; no energy of it is counted.</summary>
    private double MeanSpeed(int body, double* j, double* before)
    {
        if (_work.Step.Moves[body] == 0)
        {
            return 0;
        }

        ref BodyState s = ref _work.Step.Bodies.State[body];
        double* v = before + (body * 3);
        return 0.5 * ((j[0] * (v[0] + s.LinearVelocity.X)) + (j[1] * (v[1] + s.LinearVelocity.Y)) + (j[2] * (v[2] + s.AngularVelocity)));
    }

    /// <summary>
    /// Writes, or reads, what later steps read of it: the trees and what was found out about them, last impulses and errors.
    /// </summary>
    public void Visit(StateStream s)
    {
        _work.Visit(s);
        Collection.Visit(s);
        Bodies.Visit(s);
        Impacts.Visit(s);
        Contacts.Visit(s);
        Loads.Visit(s);
        Lanes.Visit(s);
        Chains.Visit(s);
    }
}
