using System;
using System.Numerics;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Settings;
using Farseer.Engine.Solver;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Islands, and the substeps that solve their rows, joints and springs.</summary>
internal sealed class SolveStage : WorldPhase
{
    private readonly IslandClasses _classes = new IslandClasses();
    private readonly CarriedPushes _carriedPushes = new CarriedPushes();
    private readonly FeedForwardSettings _feedForward = new FeedForwardSettings();
    private readonly SagForecast _sagForecast = new SagForecast();
    private readonly BodyStage _bodyStage;
    private readonly SleepStage _sleep;
    private readonly ContactStage _contactStage;
    private readonly AccuracyStage _accuracy;
    private readonly PushReport _pushes;

    /// <summary>
    /// The substep at whose rate depths are taken back: the longest of late. The sag under a load goes by the square of the substep; a
    /// short one after a long one would close it at a speed larger by their ratio. It stays for as long as such a sag takes to go, and then
    /// comes down as fast.
    /// </summary>
    private float _recovery;

    /// <summary>Seconds since a substep was as long.</summary>
    private float _recoveryAge;

    [NotState(Why.OfOneStep)]
    private ContactCoefficients _coefficients;

    /// <summary>Bodies lie deep in others.</summary>
    [NotState(Why.OfOneStep)]
    private bool _anyDeep;

    public SolveStage(
        WorldStores stores, BodyStage bodyStage, SleepStage sleep, ContactStage contactStage, AccuracyStage accuracy, PushReport pushes)
        : base(stores)
    {
        _bodyStage = bodyStage;
        _sleep = sleep;
        _contactStage = contactStage;
        _accuracy = accuracy;
        _pushes = pushes;
    }

    /// <summary>Seconds of a substep of the step under way.</summary>
    public float Substep => _coefficients.Substep;

    /// <summary>Sorts the rows of large worlds.</summary>
    public IslandGroups IslandGroups { get; } = new IslandGroups();

    /// <summary>Puts the rows of a colour in the order of their bodies.</summary>
    public RowOrder RowOrder { get; } = new RowOrder();

    /// <summary>Parts the rows of large worlds for two workers.</summary>
    public RowHalves RowHalves { get; } = new RowHalves();

    /// <summary>Callbacks may have woken bodies, whose rows are back then, or changed which bodies move.</summary>
    public void UpdateAfterCallbacks(float dt)
    {
        bool switched = _bodyStage.SortSwitched(dt);
        if (switched || _graph.Changed)
        {
            UpdateIslands(dt, switched);
        }
    }

    /// <summary>The rows of the step are known.</summary>
    public void BeginIslands(float dt) => UpdateIslands(dt, _bodyStage.SortSwitched(dt));

    /// <summary>The length of a substep is known, and what contacts are to be with it.</summary>
    public unsafe ContactUpdateInput BeginContacts(float dt)
    {
        float substep = dt / _stores.Substeps;
        ContactUpdateInput input;
        input.Shapes = _shapes;
        input.Bodies = _bodies;
        input.Contacts = _contacts;
        input.Fat = _proxies.Fat.Pointer;
        input.Proxies = _proxies.Info.Pointer;
        input.Sides = null;
        input.Hulls = null;
        input.Pairs = null;
        input.Moves = _lists.Moves;
        input.Throws = null;
        input.Settings = _settings;
        input.Scratch = _stores.Scratch;
        input.Dt = dt;
        float ratio = !_settings.KeepImpulses ? 0 : _stores.LastSubstep > 0 ? substep / _stores.LastSubstep : 1f;
        input.ImpulseScale = Math.Min(1f, ratio);
        input.LoadGrowth = Math.Max(0f, ratio - 1f);
        FindRecovery(dt, substep);
        Vector2 g = _settings.Gravity;
        float gravity = (float)Math.Sqrt(((double)g.X * g.X) + ((double)g.Y * g.Y));
        float coarseness = WorldSettings.DefaultSubsteps / (float)_stores.Substeps;
        _coefficients = new ContactCoefficients(
            substep, gravity, _settings.BounceThreshold, coarseness, _recovery, _stores.DrivenBoundOf(dt));
        input.Coefficients = _coefficients;
        return input;
    }

    /// <summary>
    /// The longest substep of late, at whose rate depths go: held for as long as the sag that came of it takes to go, then down at its
    /// pace. Without the hold, steps of two lengths in turn would give a stack another height each time.
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

    public unsafe void SortRows()
    {
        RowHalves.Part(_graph, _contacts.Records, _bodies.Ids.End, _lists.Moves, _stores.Scratch);
        RowOrder.Sort(_stores.Runner, _graph, _contacts.Records, _bodies.Ids.End, _lists.Moves, _stores.Scratch);
    }

    /// <param name="dt">The step.</param>
    /// <param name="switched">Other bodies move than when the islands were last brought up to date.</param>
    private unsafe void UpdateIslands(float dt, bool switched)
    {
        bool rebuilt = false;
        _anyDeep = false;
        if (_graph.RowCount == 0)
        {
            return;
        }

        if (_graph.Changed || switched)
        {
            if (switched || !_islands.Keep(_graph, _contacts.Records, _lists.Moves))
            {
                _islands.Build(_stores.Runner, _graph, _bodies.Ids.End, _lists.Moves, _stores.Scratch);
                rebuilt = true;
            }

            _graph.ForgetChanges();
            _sleep.GroupsChanged = true;
        }

        if (!_contactStage.AnyBounce && _joints.Count == 0 && _springs.Count == 0)
        {
            IslandGroups.Sort(_islands, _graph, _contacts.Records, _lists.Moves, _stores.Scratch);
        }

        // Of steps that take turns the longest decides, or an island would change its substeps with each.
        float longest = Substep < _recovery ? _recovery * _stores.Substeps : dt;
        float timeToSleep = _settings.AllowSleep ? _settings.TimeToSleep : float.PositiveInfinity;
        _sagForecast.Begin(_islands, _graph, _bodies, longest, _settings.Gravity, timeToSleep, rebuilt);
        _anyDeep = _feedForward.Apply(_stores.Runner, _islands, _graph, _coefficients, _contactStage.ColdStart, _stores.Scratch);
    }

    /// <summary>The substeps of all bodies that contacts, joints or springs hold; the others fly free.</summary>
    public unsafe void Solve(float dt)
    {
        float substep = Substep;
        _accuracy.Audit?.BeginMotion(_settings.Gravity);
        bool anyJoints = BeginJoints(dt, substep);
        if (_stores.JointSolver?.Collection.BrokenCount > 0)
        {
            UpdateAfterCallbacks(dt);
            anyJoints = anyJoints && _stores.JointSolver.Collection.Renew();
        }

        bool anyUserJoints = _stores.AnyUserJoints;
        _springs.Prepare(_bodies, _lists.Moves, _graph.Degrees, anyJoints ? _stores.JointSolver : null, anyUserJoints, substep);
        _contactStage.Lone.SetAside(_stores, _contacts, _graph, _lists.Moves);
        _lists.Split(_stores.Runner, _bodies, _graph, _springs, anyJoints ? _stores.JointSolver : null, anyUserJoints);
        _lists.FlyFree(_stores.Runner, _bodies, _settings.Gravity, dt, substep, _stores.Scratch);
        if (_lists.SolverCount == 0)
        {
            return;
        }

        JointSolver? joints = anyJoints ? _stores.JointSolver : null;
        _lists.PrepareDrives(_stores.Runner, _bodies, _lists.Solver, _lists.SolverCount, _settings.Gravity, substep);
        SolverInput input;
        input.Runner = _stores.Runner;
        input.Bodies = _bodies;
        input.Colors = _graph.Solved;
        input.RowCount = _graph.RowCount;
        input.BundleRoom = _graph.Arena.Capacity;
        input.MiddleBody = _graph.Groups.Middle;
        input.Islands = _islands;
        input.List = _lists.Solver;
        input.PaddedCount = _lists.PaddedSolverCount;
        input.Saved = _stores.Scratch.Take<Vector4>(SolverUnits.MostListed(_lists.SolverCount, _graph.Groups.Count));
        input.Pushes = _carriedPushes.Begin(_anyDeep, _feedForward, _islands, _bodies.Ids.End);
        input.Substeps = _stores.Substeps;
        input.Substep = substep;
        input.Coefficients = _coefficients with { AnyFar = _feedForward.AnyFar };
        input.Recovery = _settings.CorrectPositions ? _settings.Recovery : 0;
        input.Springs = _springs;
        input.AnyDeep = _anyDeep;
        input.AnyBounce = _contactStage.AnyBounce;
        input.AnySmall = _islands.AnySmaller(SmallIslands.MostContacts);
        input.GravityVector = _settings.Gravity;
        input.Degrees = _graph.Degrees;
        input.ColdStart = _contactStage.ColdStart;
        input.Joints = joints;
        input.UserJoints = anyUserJoints ? _stores.UserJoints : null;
        int mark = _stores.Scratch.Mark;
        bool classes = !anyUserJoints && FindClasses(joints, _coefficients);
        _stores.Scratch.Release(mark);
        if (classes)
        {
            _classes.Borrow(substep);
            input.List = _classes.List(0);
            input.PaddedCount = _classes.PaddedCount(0);
        }

        joints?.Collection.Select(0, substep, 1);
        _queries.PosesChange = anyUserJoints;
        input.Audit = _accuracy.Audit;
        input.Impulses = _pushes.Impulses;
        input.Surfaces = _contacts.Surfaces.AnySpecial ? _contacts.Surfaces : null;
        if (input.PaddedCount > 0)
        {
            _accuracy.BeginSolve(input);
            SolverUnits units = _stores.Tools.Units;
            if (!classes && ByUnits(input) && units.Find(_stores.Runner, _graph, _lists.Moves, _lists.Solver, _lists.SolverCount))
            {
                units.Solve(input, _stores.Tools.Solver);
            }
            else
            {
                _stores.Tools.Solver.Solve(input);
            }
        }

        _queries.PosesChange = false;
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
        && _springs.Count == 0 && !_bodyStage.SwitchedWithin;

    private unsafe bool FindClasses(JointSolver? joints, in ContactCoefficients c)
    {
        var input = new IslandClassInput
        {
            Joints = joints,
            Graph = _graph,
            Islands = _islands,
            Forecast = _sagForecast,
            Bodies = _bodies,
            Moves = _lists.Moves,
            List = _lists.Solver,
            Count = _lists.SolverCount,
        };
        if (!_classes.Find(input, _settings.AdaptSubsteps, _feedForward, c, _stores.Scratch))
        {
            return false;
        }

        _classes.Split(input, _springs);
        return true;
    }

    /// <summary>
    /// The islands that need more substeps than the others: solved by themselves, their rows taken out of the graph meanwhile.
    /// </summary>
    private unsafe void SolveClasses(SolverInput input, JointSolver? joints, float dt)
    {
        for (int index = 1; index < IslandClasses.Count; index++)
        {
            if (_classes.PaddedCount(index) == 0)
            {
                continue;
            }

            int fineness = 1 << index;
            float substep = dt / (_stores.Substeps * fineness);
            _classes.RewindKinematic(index, _bodies, dt);
            _lists.PrepareDrives(_stores.Runner, _bodies, _classes.List(index), _classes.BodyCount(index), _settings.Gravity, substep);
            input.List = _classes.List(index);
            input.PaddedCount = _classes.PaddedCount(index);
            input.Colors = _classes.Colors(index);
            input.RowCount = _classes.RowCount(index);
            input.Substeps = _stores.Substeps * fineness;
            input.Substep = substep;
            ref readonly ContactCoefficients c = ref input.Coefficients;
            input.Coefficients = new ContactCoefficients(
                substep, c.Gravity, c.BounceThreshold, 1f, _recovery / fineness, c.Driven) { AnyFar = c.AnyFar };
            input.Springs = null;
            _classes.Ease(index, _sagForecast, _islands, input.Coefficients);
            joints?.Collection.Select(index, substep, fineness);
            _accuracy.BeginSolve(input);
            _stores.Tools.Solver.Solve(input);
        }

        _classes.GiveBack();
    }

    private unsafe bool BeginJoints(float dt, float substep)
    {
        if (_joints.Count == 0 && !_joints.Changed)
        {
            return false;
        }

        JointStep step;
        step.Runner = _stores.Runner;
        step.Bodies = _bodies;
        step.Moves = _lists.Moves;
        step.Touches = _graph.Degrees;
        step.ContactRoom = _contacts.Records.Capacity;
        step.Dt = dt;
        step.Substep = substep;
        step.Audited = _accuracy.Audit != null || _pushes.Impulses != null || _contacts.Surfaces.AnySpecial;
        step.Impulses = _pushes.Impulses;
        step.Watched = step.Audited || _stores.AnyUserJoints || _springs.Count > 0;
        step.BreaksLate = _settings.JointsBreakLate;
        step.ImpulseScale = !_settings.KeepImpulses ? 0 : _stores.LastSubstep > 0 ? (double)substep / _stores.LastSubstep : 1;
        step.ErrorScale = (double)substep / Math.Max(substep, _recovery);
        step.Drifts = !_settings.CorrectPositions;
        JointSolver solver = _stores.MadeJointSolver;
        solver.Collection.Begin(step);
        for (int i = 0; i < solver.Collection.BrokenCount; i++)
        {
            _stores.UserJoints?.Broke(solver.Collection.Broken(i));
        }

        return solver.Any;
    }

    /// <summary>Makes room for more bodies.</summary>
    public void ReserveBodies(int capacity)
    {
        _sagForecast.Reserve(capacity);
        _feedForward.Reserve(capacity);
        _carriedPushes.Reserve(capacity);
    }

    /// <summary>Makes room for more rows.</summary>
    public void ReserveRows(int capacity) => _stores.Tools.Solver.Reserve(capacity);

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _feedForward.Visit(s.Of(nameof(_feedForward)));
        _sagForecast.Visit(s.Of(nameof(_sagForecast)));
        _classes.Visit(s.Of(nameof(_classes)));
        _carriedPushes.Visit(s.Of(nameof(_carriedPushes)));
        IslandGroups.Visit(s.Of(nameof(IslandGroups)));
        RowOrder.Visit(s.Of(nameof(RowOrder)));
        RowHalves.Visit(s.Of(nameof(RowHalves)));
        s.Of(nameof(SolveStage)).Value(ref _recovery);
        s.Value(ref _recoveryAge);
    }
}
