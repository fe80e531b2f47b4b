using System;
using Farseer.Engine.Constraints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// The rigid joints of nets, on lanes. A joint keeps its row, with its impulses, for as long as it belongs to a net; what it did in a
/// step is read from there when somebody asks. Everything else that a net has (limits, motors, springs, other kinds) is iterated row by
/// row by <see cref="JointPass"/> after these.
/// </summary>
internal sealed unsafe partial class NetSolver
{
    private const int Forms = 3;
    private const int PullSweeps = 4;

    private readonly JointStore _store;
    private readonly BodyColors _bodyColors = new BodyColors();
    private readonly NetBodies _bodies = new NetBodies();
    private readonly NetWork _work;

    // By colour, and within it by form; made once there is a row, and none before there is a net.
    private NetRows?[] _rows = Array.Empty<NetRows?>();

    // Those that have rows, in the order of solving.
    [NotState(Why.OfOneStep)]
    private NetRows[] _solved = Array.Empty<NetRows>();
    private int _solvedCount;
    private JointStep _step;
    private bool _runs;

    public NetSolver(JointStore store)
    {
        _store = store;
        _work = new NetWork(_bodies);
    }

    /// <summary>There are nets.</summary>
    public bool Any => _bodies.Any;

    /// <summary>The body belongs to a net, or a joint of one holds on to it.</summary>
    public bool Holds(int body) => _bodies.Holds(body);

    /// <summary>Joints on lanes; <see cref="Member"/> names them.</summary>
    public int Count => _members.Count;

    public int Member(int index) => _members[index];

    /// <summary>Nets keep to the substeps of the step.</summary>
    public void Select(int index) => _runs = Any && index == 0;

    /// <summary>Errors came from outside and go by displacements.</summary>
    public bool Disturbed { get; private set; }

    /// <summary>Before <see cref="Start"/>: all nets fly, until something is said to bind them.</summary>
    public void Release() => _bodies.Release();

    /// <summary>Something acts on the body's net.</summary>
    public void Bind(int body) => _bodies.Bind(body);

    /// <summary>Starts the substeps: arms in the middle of the step, and what the bodies weigh.</summary>
    public void Start(in JointStep step)
    {
        Disturbed = false;
        if (!_runs)
        {
            return;
        }

        _step = step;
        _bodies.BindTouched(step.Touches);
        _work.Begin(step, _solved, _solvedCount);
        _work.Run(NetWork.Pass.StartBodies);
        for (int i = 0; i < _solvedCount; i++)
        {
            _solved[i].Disturbed = false;
        }

        Sweep(NetWork.Pass.Start, NetSoftness.Hard);
        for (int i = 0; i < _solvedCount; i++)
        {
            Disturbed |= _solved[i].Disturbed;
        }
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

    public void SolveBiased() => Sweep(NetWork.Pass.Solve, _step.Drifts ? NetSoftness.Hard : NetSoftness.Soft(_step));

    /// <summary>
    /// Gives the bodies, which stand still, velocities that pull disturbed joints together. <see cref="Displaced"/> follows when they have
    /// moved.
    /// </summary>
    public void Pull()
    {
        Sweep(NetWork.Pass.Turn, NetSoftness.Hard);
        for (int sweep = 0; sweep < PullSweeps; sweep++)
        {
            Sweep(NetWork.Pass.Pull, NetSoftness.Displacing(_step));
        }
    }

    /// <summary>The bodies have moved with the velocities of <see cref="Pull"/>.</summary>
    public void Displaced() => Sweep(NetWork.Pass.Displaced, NetSoftness.Hard);

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

    private static int PlaceOf(int color, NetForm form) => (color * Forms) + (int)form - 1;

    private void Sweep(NetWork.Pass pass, in NetSoftness softness)
    {
        if (_runs)
        {
            _work.Run(pass, softness);
        }
    }

    /// <summary>The rows of a colour and form, which are made if they are not there.</summary>
    private NetRows RowsOf(int list)
    {
        if (_rows.Length == 0)
        {
            _rows = new NetRows?[BodyColors.Count * Forms];
            _solved = new NetRows[BodyColors.Count * Forms];
        }

        return _rows[list] ??= MakeRows(list / Forms, list % Forms);
    }

    private static NetRows MakeRows(int color, int place)
    {
        bool sequential = color >= BodyColors.Masked;
        NetRows rows = place == PlaceOf(0, NetForm.Pivot) ? new NetPivots(sequential)
            : place == PlaceOf(0, NetForm.Weld) ? new NetWelds(sequential)
            : new NetRods(sequential);
        rows.IsShared = color < BodyColors.Dynamic;
        return rows;
    }

    private void FindSolved()
    {
        _solvedCount = 0;
        if (_rows.Length == 0)
        {
            return;
        }

        for (int k = 0; k < BodyColors.Count; k++)
        {
            for (NetForm form = NetForm.Pivot; form <= NetForm.Rod; form++)
            {
                NetRows? rows = _rows[PlaceOf(BodyColors.InOrder(k), form)];
                if (rows?.RowCount > 0)
                {
                    _solved[_solvedCount++] = rows;
                }
            }
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        // Not whether some are made: those without rows are as if they were not.
        bool any = s.Value(_members.Count > 0);
        for (int list = 0; list < BodyColors.Count * Forms && (any || _rows.Length > 0); list++)
        {
            if (any && s.Value(_rows.Length > 0 && _rows[list]?.RowCount > 0))
            {
                RowsOf(list).Visit(s);
            }
            else if (_rows.Length > 0)
            {
                _rows[list]?.Forget();
            }
        }

        _bodyColors.Visit(s);
        _bodies.Visit(s);
        s.Value(ref _solvedCount);
        s.Value(ref _runs);
        Disturbed = s.Value(Disturbed);
        _search.Visit(s);
        s.Column(_places);
        s.Column(_wanted);
        _members.Visit(s);
        s.Value(ref _end);

        // Those to solve are listed again from these.
        if (s.IsReading)
        {
            FindSolved();
        }
    }
}
