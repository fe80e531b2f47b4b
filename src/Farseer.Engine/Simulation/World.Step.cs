using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Settings;
using Farseer.Engine.Solver;
using Farseer.Engine.Stepping;

namespace Farseer.Engine.Simulation;

/// <summary>The table of contents of a step: one line a phase.</summary>
internal sealed partial class World
{
    private readonly IslandClasses _classes = new IslandClasses();
    private readonly SolverUnits _units = new SolverUnits();
    private readonly CarriedPushes _carriedPushes = new CarriedPushes();

    /// <summary>Sorts the rows of large worlds.</summary>
    public IslandGroups IslandGroups { get; } = new IslandGroups();

    /// <summary>Puts the rows of a colour in the order of their bodies.</summary>
    public RowOrder RowOrder { get; } = new RowOrder();

    /// <summary>Parts the rows of large worlds for two workers.</summary>
    public RowHalves RowHalves { get; } = new RowHalves();

    private unsafe void RunStages(float dt)
    {
        Profile.Begin();
        PurgeNow();
        BeginAccuracy();
        BeginImpulses();
        WakeWhatChanged(dt);
        CollectBodies();
        _bodiesSwitched = false;
        _switchedWithin = false;
        WakeByDriven();
        _lists.Foresee(_runner, Bodies, dt);
        Profile.End(StepStage.DeferredChanges);

        ForgetMoves();
        _boxes.Update(this, _runner, dt);
        FindPairs();
        RefreshSurfaces();
        Profile.End(StepStage.BroadPhase);

        SortRows();
        _lightened.ScaleImpulses(_graph, Bodies.Ids.End);
        float substep = dt / _substeps;
        _runner.Call();
        ContactUpdateInput contacts = ContactInput(dt, substep);
        _contactStage.Update(_runner, this, contacts, _graph, Joints, UserJoints != null && UserJoints.Any);
        _events.Raise(this, _contacts, _graph, _contactStage.AnyHeard);
        MakeRoomAhead();
        MakeRoomForImpulses();
        Profile.End(StepStage.NarrowPhase);

        bool anyDeep = UpdateIslands(dt, contacts.Coefficients, SortSwitched(dt));
        Profile.End(StepStage.GraphAndIslands);

        ApplyForces(dt);
        anyDeep = UpdateAfterCallbacks(dt, contacts.Coefficients, anyDeep);

        if (_contactStage.AnyHeard)
        {
            CollectStaticsAfterCallbacks();
        }

        Profile.End(StepStage.Forces);

        if (_makesEnergy)
        {
            _bounceBound.Begin(Bodies, _lists.Moves);
        }

        _graph.RecallShared(_contacts.Records);
        Solve(dt, anyDeep, contacts.Coefficients);
        _contactStage.Lone.PutBack(_contacts, _graph);
        Profile.End(StepStage.Solve);

        FinishBodiesOfStep();
        _lastSubstep = substep;
        Profile.End(StepStage.Finish);

        _sweepGathered = false;
        ForgetBeyond();
        if (_contactStage.Lone.Count > 0)
        {
            FlyLonePairs(dt, substep);
            Profile.End(StepStage.Continuous);
        }

        if (Settings.Continuous && _lists.Fast.Count > 0)
        {
            SweepFastBodies(dt, substep);
        }

        if (_makesEnergy)
        {
            _bounceBound.End(Bodies, _lists.Moves, Settings.Gravity, dt, DrivenBoundOf(dt));
        }

        Profile.End(StepStage.Continuous);

        StopSwitched();
        EndAccuracy(dt);
        RaisePushes(substep);
        Profile.End(StepStage.Finish);

        FallAsleep(dt);
        _lists.UseUpForces(_runner, Bodies);
        Profile.End(StepStage.Sleep);
    }

    private void ApplyForces(float dt)
    {
        _springs.Clear();
        Hooks?.ApplyForces(dt);
    }

    /// <summary>A body that was enabled, disabled or made static by a callback moves, or stays, from this step on.</summary>
    /// <returns>True if there was one.</returns>
    private unsafe bool SortSwitched(float dt)
    {
        if (!_bodiesSwitched)
        {
            return false;
        }

        _bodiesSwitched = false;
        _switchedWithin = true;
        int before = _lists.OutcastCount;
        _lists.CollectAgain(_runner, Bodies, dt);
        if (_lists.OutcastCount > before)
        {
            Isolate();
        }

        foreach (GraphColor color in _graph.Used)
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                ContactRowWriter.HoldStill(row, _lists.Moves);
            }
        }

        return true;
    }

    /// <summary>A body that was made static when the step was solved already has got its velocity back from there.</summary>
    private unsafe void StopSwitched()
    {
        for (int i = 0; _bodiesSwitched && i < _lists.ActiveCount; i++)
        {
            int body = _lists.Active[i];
            if ((Bodies.Flags[body] & BodyFlags.Static) != 0)
            {
                Bodies.State[body].LinearVelocity = Vector2.Zero;
                Bodies.State[body].AngularVelocity = 0;
            }
        }
    }

    /// <summary>Callbacks may have woken bodies, whose rows are back then, or changed which bodies move.</summary>
    private bool UpdateAfterCallbacks(float dt, in ContactCoefficients coefficients, bool anyDeep)
    {
        bool switched = SortSwitched(dt);
        return switched || _graph.Changed ? UpdateIslands(dt, coefficients, switched) : anyDeep;
    }

    private unsafe ContactUpdateInput ContactInput(float dt, float substep)
    {
        ContactUpdateInput input;
        input.Shapes = Shapes;
        input.Bodies = Bodies;
        input.Contacts = _contacts;
        input.Fat = Proxies.Fat.Pointer;
        input.Proxies = Proxies.Info.Pointer;
        input.Sides = null;
        input.Hulls = null;
        input.Pairs = null;
        input.Moves = _lists.Moves;
        input.Throws = null;
        input.Settings = Settings;
        input.Scratch = Scratch;
        input.Dt = dt;
        float ratio = !Settings.KeepImpulses ? 0 : _lastSubstep > 0 ? substep / _lastSubstep : 1f;
        input.ImpulseScale = Math.Min(1f, ratio);
        input.LoadGrowth = Math.Max(0f, ratio - 1f);
        FindRecovery(dt, substep);
        System.Numerics.Vector2 g = Settings.Gravity;
        float gravity = (float)Math.Sqrt(((double)g.X * g.X) + ((double)g.Y * g.Y));
        float coarseness = WorldSettings.DefaultSubsteps / (float)_substeps;
        input.Coefficients = new ContactCoefficients(
            substep, gravity, Settings.BounceThreshold, coarseness, _recovery, DrivenBoundOf(dt));
        return input;
    }

    private DrivenBound DrivenBoundOf(float dt) => new DrivenBound(dt, _substeps, Settings.MostDrivenSpeed, Settings.MostDrivenSpin);

    /// <summary>
    /// The longest substep of late, at whose rate depths go: held for as long as the sag that came of it takes to go, then down at its pace.
    /// Without the hold, steps of two lengths in turn would give a stack another height each time.
    /// </summary>
    private void FindRecovery(float dt, float substep)
    {
        _recoveryAge += dt;
        if (substep >= _recovery)
        {
            _recovery = substep;
            _recoveryAge = 0;
        }
        else if (_recoveryAge * ContactCoefficients.RecoveryShare > _recovery)
        {
            _recovery = Math.Max(substep, _recovery - (dt * ContactCoefficients.RecoveryShare));
        }
    }

    private unsafe void SortRows()
    {
        RowHalves.Part(_graph, _contacts.Records, Bodies.Ids.End, _lists.Moves, Scratch);
        RowOrder.Sort(_runner, _graph, _contacts.Records, Bodies.Ids.End, _lists.Moves, Scratch);
    }

    /// <param name="dt">The step.</param>
    /// <param name="coefficients">Of its contacts.</param>
    /// <param name="switched">Other bodies move than when the islands were last brought up to date.</param>
    private unsafe bool UpdateIslands(float dt, in ContactCoefficients coefficients, bool switched)
    {
        bool rebuilt = false;
        if (_graph.RowCount == 0)
        {
            return false;
        }

        if (_graph.Changed || switched)
        {
            if (switched || !_islands.Keep(_graph, _contacts.Records, _lists.Moves))
            {
                _islands.Build(_runner, _graph, Bodies.Ids.End, _lists.Moves, Scratch);
                rebuilt = true;
            }

            _graph.ForgetChanges();
            _groupsChanged = true;
        }

        if (!_contactStage.AnyBounce && Joints.Count == 0 && _springs.Count == 0)
        {
            IslandGroups.Sort(_islands, _graph, _contacts.Records, _lists.Moves, Scratch);
        }

        // Of steps that take turns the longest decides, or an island would change its substeps with each.
        float longest = coefficients.Substep < _recovery ? _recovery * _substeps : dt;
        float timeToSleep = Settings.AllowSleep ? Settings.TimeToSleep : float.PositiveInfinity;
        _sagForecast.Begin(_islands, _graph, Bodies, longest, Settings.Gravity, timeToSleep, rebuilt);
        return _feedForward.Apply(_runner, _islands, _graph, coefficients, _contactStage.ColdStart, Scratch);
    }

    private unsafe void Solve(float dt, bool anyDeep, in ContactCoefficients coefficients)
    {
        float substep = coefficients.Substep;
        Audit?.BeginMotion(Settings.Gravity);
        bool anyJoints = BeginJoints(dt, substep);
        if (_jointSolver?.BrokenCount > 0)
        {
            anyDeep = UpdateAfterCallbacks(dt, coefficients, anyDeep);
            anyJoints = anyJoints && _jointSolver.Renew();
        }

        bool anyUserJoints = UserJoints != null && UserJoints.Any;
        _springs.Prepare(Bodies, _lists.Moves, _graph.Degrees, anyJoints ? _jointSolver : null, anyUserJoints, substep);
        _contactStage.Lone.SetAside(this, _contacts, _graph, _lists.Moves);
        _lists.Split(_runner, Bodies, _graph, _springs, anyJoints ? _jointSolver : null, anyUserJoints, Scratch);
        _lists.FlyFree(_runner, Bodies, Settings.Gravity, dt, substep, Scratch);
        if (_lists.SolverCount == 0)
        {
            return;
        }

        JointSolver? joints = anyJoints ? _jointSolver : null;
        _lists.PrepareDrives(_runner, Bodies, _lists.Solver, _lists.SolverCount, Settings.Gravity, substep);
        SolverInput input;
        input.Runner = _runner;
        input.Bodies = Bodies;
        input.Colors = _graph.Solved;
        input.RowCount = _graph.RowCount;
        input.BundleRoom = _graph.Arena.Capacity;
        input.MiddleBody = _graph.Groups.Middle;
        input.Islands = _islands;
        input.List = _lists.Solver;
        input.PaddedCount = _lists.PaddedSolverCount;
        input.Saved = Scratch.Take<Vector4>(SolverUnits.MostListed(_lists.SolverCount, _graph.Groups.Count));
        input.Pushes = _carriedPushes.Begin(anyDeep, _feedForward, _islands, Bodies.Ids.End);
        input.Substeps = _substeps;
        input.Substep = substep;
        input.Coefficients = coefficients;
        input.Recovery = Settings.CorrectPositions ? Settings.Recovery : 0;
        input.Springs = _springs;
        input.AnyDeep = anyDeep;
        input.AnyBounce = _contactStage.AnyBounce;
        input.AnySmall = _islands.AnySmaller(SmallIslands.MostContacts);
        input.GravityVector = Settings.Gravity;
        input.Degrees = _graph.Degrees;
        input.ColdStart = _contactStage.ColdStart;
        input.Joints = joints;
        input.UserJoints = anyUserJoints ? UserJoints : null;
        int mark = Scratch.Mark;
        bool classes = !anyUserJoints && FindClasses(joints, coefficients);
        Scratch.Release(mark);
        if (classes)
        {
            _classes.Borrow(substep);
            input.List = _classes.List(0);
            input.PaddedCount = _classes.PaddedCount(0);
        }

        joints?.Select(0, substep, 1);
        Queries.PosesChange = anyUserJoints;
        input.Audit = Audit;
        input.Impulses = Impulses;
        input.Surfaces = _contacts.Surfaces.AnySpecial ? _contacts.Surfaces : null;
        if (input.PaddedCount > 0)
        {
            AuditSolve(input);
            if (!classes && ByUnits(input) && _units.Find(_runner, _graph, _lists.Moves, _lists.Solver, _lists.SolverCount))
            {
                _units.Solve(input, _solver);
            }
            else
            {
                _solver.Solve(input);
            }
        }

        Queries.PosesChange = false;
        if (classes)
        {
            SolveClasses(input, joints, dt);
        }
    }

    /// <summary>
    /// Islands are independent only while nothing but contacts holds bodies, and impacts are found among all of them. A body that only just
    /// began to move still has the rows of one that does not, in as many groups as it touches.
    /// </summary>
    private bool ByUnits(in SolverInput input) =>
        input.Joints == null && input.UserJoints == null && !input.AnyBounce && input.Audit == null
        && _springs.Count == 0 && !_switchedWithin;

    private unsafe bool FindClasses(JointSolver? joints, in ContactCoefficients c)
    {
        if (!_classes.Find(
            Settings.AdaptSubsteps, joints, _sagForecast, _islands, _feedForward, _graph, Bodies, _lists.Moves, _lists.Solver, _lists.SolverCount, c, Scratch))
        {
            return false;
        }

        _classes.Split(joints, _sagForecast, _islands, _graph, Bodies, _springs, _lists.Moves, _lists.Solver, _lists.SolverCount);
        return true;
    }

    /// <summary>The islands that need more substeps than the others: solved by themselves, their rows taken out of the graph meanwhile.</summary>
    private unsafe void SolveClasses(SolverInput input, JointSolver? joints, float dt)
    {
        for (int index = 1; index < IslandClasses.Count; index++)
        {
            if (_classes.PaddedCount(index) == 0)
            {
                continue;
            }

            int fineness = 1 << index;
            float substep = dt / (_substeps * fineness);
            _classes.RewindKinematic(index, Bodies, dt);
            _lists.PrepareDrives(_runner, Bodies, _classes.List(index), _classes.BodyCount(index), Settings.Gravity, substep);
            input.List = _classes.List(index);
            input.PaddedCount = _classes.PaddedCount(index);
            input.Colors = _classes.Colors(index);
            input.RowCount = _classes.RowCount(index);
            input.Substeps = _substeps * fineness;
            input.Substep = substep;
            ref readonly ContactCoefficients c = ref input.Coefficients;
            input.Coefficients = new ContactCoefficients(
                substep, c.Gravity, c.BounceThreshold, 1f, _recovery / fineness, c.Driven);
            input.Springs = null;
            _classes.Ease(index, _sagForecast, _islands, input.Coefficients);
            joints?.Select(index, substep, fineness);
            AuditSolve(input);
            _solver.Solve(input);
        }

        _classes.GiveBack();
    }
}
