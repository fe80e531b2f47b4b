using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Solver;
using Farseer.Engine.Springs;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Which bodies the phases of this step work on: those that can move, those with constraints, those in free flight.</summary>
internal sealed unsafe class BodyLists
{
    /// <summary>
    /// Bodies that are moved before those of them that were fast are listed: few are, and room for where all began was a tenth of a
    /// large world.
    /// </summary>
    private const int BodiesAtOnce = 4096;

    private readonly Column<byte> _moves = new Column<byte>();
    private readonly Column<byte> _wasActive = new Column<byte>();
    private readonly Column<int> _active = new Column<int>();
    private readonly IndexList _driven = new IndexList();
    private readonly Column<int> _solver = new Column<int>();
    private readonly Column<int> _free = new Column<int>();
    private readonly Column<QuarantineRecord> _outcasts = new Column<QuarantineRecord>();

    /// <summary>Does the work on them, while a step runs.</summary>
    [NotState(Why.OfOneStep)]
    public BodyWork Work { get; set; } = null!;

    /// <summary>1 for each body that forces and contacts may move.</summary>
    public byte* Moves => _moves.Pointer;

    /// <summary>Bodies that can move, kinematic ones included.</summary>
    public int* Active => _active.Pointer;

    public int ActiveCount { get; private set; }

    public int* Solver => _solver.Pointer;

    public int SolverCount { get; private set; }

    /// <summary>Count of <see cref="Solver"/> filled up to whole bundles with body 0.</summary>
    public int PaddedSolverCount { get; private set; }

    public int FreeCount { get; private set; }

    /// <summary>Bodies of this step whose state left its range.</summary>
    public int OutcastCount { get; private set; }

    /// <summary>Bodies that moved by more than their size in this step.</summary>
    public FastList Fast { get; } = new FastList();

    /// <summary>Kinematic and static bodies that have a velocity: what touches them does not rest.</summary>
    public IndexList Driven => _driven;

    public QuarantineRecord Outcast(int index) => _outcasts[index];

    public void ForgetOutcasts() => OutcastCount = 0;

    /// <summary>Sorts the bodies; those whose state is out of range are left out and become outcasts.</summary>
    public void Collect(StageRunner runner, BodyStore bodies)
    {
        int end = bodies.Ids.End;
        _moves.EnsureCapacity(end);
        _active.EnsureCapacity(end);
        int words = Work.Sort(runner, bodies, _moves.Pointer);
        ActiveCount = 0;
        _driven.Clear();
        for (int word = 0; word < words; word++)
        {
            BodySorts sorts = Work.Sorts[word];
            int first = word * BitSet.WordBits;
            for (ulong active = sorts.Active; active != 0; active &= active - 1)
            {
                _active[ActiveCount++] = first + BitSet.LowestBit(active);
            }

            for (ulong special = sorts.Special; special != 0; special &= special - 1)
            {
                int body = first + BitSet.LowestBit(special);
                if (!StateRange.Holds(bodies.State[body], bodies.Pose[body]))
                {
                    CastOut(bodies, body, QuarantineCause.SetFromOutside);
                }
                else
                {
                    _driven.Add(body);
                }
            }
        }
    }

    /// <summary>A body woke within the step: it moves from now on.</summary>
    public void Join(BodyStore bodies, int body, float dt)
    {
        _active.EnsureCapacity(ActiveCount + 1);
        _active[ActiveCount] = body;
        Foresight.Begin(bodies, _active.Pointer + ActiveCount, 1, dt);
        ActiveCount++;
    }

    /// <summary>Notes that contacts and joints may move a body, or that it sleeps.</summary>
    public void SetMoving(int body, bool value)
    {
        _moves.EnsureCapacity(body + 1);
        _moves[body] = value ? (byte)1 : (byte)0;
    }

    /// <summary>Sorts the bodies anew within a step: those that were not foreseen at its start are foreseen now.</summary>
    public void CollectAgain(StageRunner runner, BodyStore bodies, float dt)
    {
        _wasActive.EnsureCapacity(bodies.Ids.End);
        for (int i = 0; i < bodies.Ids.End; i++)
        {
            _wasActive[i] = 0;
        }

        for (int i = 0; i < ActiveCount; i++)
        {
            _wasActive[_active[i]] = 1;
        }

        Collect(runner, bodies);
        for (int i = 0; i < ActiveCount; i++)
        {
            if (_wasActive[_active[i]] == 0)
            {
                Foresight.Begin(bodies, _active.Pointer + i, 1, dt);
            }
        }
    }

    /// <summary>Finds static bodies to which a callback of this step gave a velocity out of range: contacts read it.</summary>
    public void CollectStatics(BodyStore bodies)
    {
        int end = bodies.Ids.End;
        BodyFlags* flags = bodies.Flags.Pointer;
        for (int i = 0; i < end; i++)
        {
            if ((flags[i] & BodyFlags.Static) != 0 && !StateRange.Holds(bodies.State[i]))
            {
                CastOut(bodies, i, QuarantineCause.SetFromOutside);
            }
        }
    }

    /// <summary>
    /// Impulses that are infinite times an inverse mass of 0 leave no number in a static body either: it did nothing and is not
    /// cast out, but must not hand it on.
    /// </summary>
    public static void StopStatics(BodyStore bodies)
    {
        int end = bodies.Ids.End;
        for (int i = 0; i < end; i++)
        {
            if ((bodies.Flags[i] & BodyFlags.Static) != 0 && !StateRange.Holds(bodies.State[i]))
            {
                bodies.State[i].LinearVelocity = Vector2.Zero;
                bodies.State[i].AngularVelocity = 0;
            }
        }
    }

    /// <summary>Foresees where the bodies will have turned by the middle of the step.</summary>
    public void Foresee(StageRunner runner, BodyStore bodies, float dt) =>
        Work.Foresee(runner, bodies, _active.Pointer, ActiveCount, dt);

    /// <summary>Bodies with rows, springs or joints go to the solver; the others fly free and cost nothing there.</summary>
    public void Split(
        StageRunner runner, BodyStore bodies, ConstraintGraph graph, SpringStore springs, JointSolver? joints, bool all)
    {
        _solver.EnsureCapacity(bodies.State.Capacity + WideLanes.BundleLanes);
        _free.EnsureCapacity(bodies.State.Capacity + 1);
        Work.FindHeld(
            runner, bodies, _active.Pointer, ActiveCount, new Holders { Graph = graph, Springs = springs, Joints = joints, All = all });
        byte* marks = Work.Marks;
        int* active = _active.Pointer;
        int* solver = _solver.Pointer;
        int* free = _free.Pointer;
        int solved = 0;
        for (int i = 0; i < ActiveCount; i++)
        {
            // Which it is cannot be foreseen: both are written, and one of the two counts on.
            solver[solved] = active[i];
            free[i - solved] = active[i];
            solved += marks[i];
        }

        SolverCount = solved;
        FreeCount = ActiveCount - solved;
        PaddedSolverCount = (solved + WideLanes.BundleLanes - 1) & -WideLanes.BundleLanes;
        for (int i = solved; i < PaddedSolverCount; i++)
        {
            solver[i] = 0;
        }
    }

    public void FlyFree(StageRunner runner, BodyStore bodies, Vector2 gravity, float dt, float substep, Scratch scratch)
    {
        if (FreeCount > 0)
        {
            bodies.EnsureResiduals();
        }

        for (int first = 0; first < FreeCount; first += BodiesAtOnce)
        {
            int count = System.Math.Min(BodiesAtOnce, FreeCount - first);
            Fast.MakeRoom(scratch, count);
            int mark = scratch.Mark;
            FlightStart* starts = scratch.Take<FlightStart>(count);
            if (Work.FlyFree(runner, bodies, _free.Pointer + first, count, gravity, dt, substep, starts))
            {
                SortFlown(bodies, _free.Pointer + first, count, starts);
            }

            scratch.Release(mark);
        }
    }

    /// <summary>Casts out those that flew out of range, and notes the fast ones.</summary>
    private void SortFlown(BodyStore bodies, int* list, int count, FlightStart* starts)
    {
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            if (Work.Marks[i] == 0)
            {
                continue;
            }

            ref FlightStart start = ref starts[i];
            if (!StateRange.Holds(bodies.State[body], bodies.Pose[body]))
            {
                bodies.Pose[body] = start.Pose;
                CastOut(bodies, body, QuarantineCause.Forces);
            }
            else if (FastList.IsLookedAfter(bodies, body))
            {
                Fast.Add(FastList.Begin(body, start.Pose, start.State, isFree: true));
            }
        }
    }

    public void PrepareDrives(StageRunner runner, BodyStore bodies, int* list, int listCount, Vector2 gravity, float substep)
    {
        if (Work.PrepareDrives(runner, bodies, list, listCount, gravity, substep))
        {
            for (int i = 0; i < listCount; i++)
            {
                if (Work.Marks[i] != 0)
                {
                    CastOut(bodies, list[i], QuarantineCause.Forces);
                }
            }
        }
    }

    /// <summary>Takes over the solver's displacements.</summary>
    public void Finish(StageRunner runner, BodyStore bodies, Scratch scratch)
    {
        for (int first = 0; first < SolverCount; first += BodiesAtOnce)
        {
            int* list = _solver.Pointer + first;
            int count = System.Math.Min(BodiesAtOnce, SolverCount - first);
            FastMotion* starts = Fast.MakeRoom(scratch, count);
            if (Work.Finish(runner, bodies, list, count, starts))
            {
                SortFinished(bodies, list, count, starts);
            }
        }

        Work.FinishFree(runner, bodies, _free.Pointer, FreeCount);
    }

    private void SortFinished(BodyStore bodies, int* list, int count, FastMotion* starts)
    {
        byte* marks = Work.Marks;
        for (int i = 0; i < count; i++)
        {
            if (marks[i] == FinishBodies.MovedFast)
            {
                Fast.Add(starts[i]);
            }
            else if (marks[i] != 0)
            {
                FinishBodies.Forget(bodies, list[i]);
                CastOut(bodies, list[i], QuarantineCause.Solver);
            }
        }
    }

    public void UseUpForces(StageRunner runner, BodyStore bodies) => Work.UseUpForces(runner, bodies);

    /// <summary>The first cause that is found for a body counts.</summary>
    private void CastOut(BodyStore bodies, int body, QuarantineCause cause)
    {
        if ((bodies.Flags[body] & BodyFlags.Quarantined) == 0)
        {
            bodies.Flags[body] |= BodyFlags.Quarantined;
            _outcasts.EnsureCapacity(OutcastCount + 1);
            _outcasts[OutcastCount++] = new QuarantineRecord { Body = body, Cause = cause };
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_moves);
        s.Column(_wasActive);
        s.Column(_active);
        _driven.Visit(s);
        s.Column(_solver);
        s.Column(_free);
        s.Column(_outcasts);
        ActiveCount = s.Value(ActiveCount);
        SolverCount = s.Value(SolverCount);
        PaddedSolverCount = s.Value(PaddedSolverCount);
        FreeCount = s.Value(FreeCount);
        OutcastCount = s.Value(OutcastCount);
    }
}
